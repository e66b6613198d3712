"""What a study varies: axes, each one value of the scenario or several that go together, and how they are written."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from dampen.component import NUMBER, ArgumentError, shown
from dampen.simulation.scenario import Scenario
from dampen.studies.lens import changed, get, is_whole

Array = np.ndarray
SPREAD = re.compile(rf"(?P<centre>{NUMBER})?\s*(?:\+-|±)\s*(?P<spread>{NUMBER})(?P<percent>\s*%)?(?P<normal>:normal)?")
TRUNCATED = 3.0  # standard deviations at which a normal distribution ends
FORMS = {
    "vary": "LOW:HIGH:COUNT, LOW:HIGH:log:COUNT or a list A,B,C",
    "uncertain": "+-30%, 0.1+-30%, 0.1+-0.02, any of these with :normal, LOW:HIGH or LOW:HIGH:log",
    "search": "LOW:HIGH or LOW:HIGH:log",
}
Option = Literal["vary", "uncertain", "search"]


@dataclass(frozen=True)
class Axis:
    """One thing that a study varies.

    text:   how it was written, PATH=RANGE.   paths: the values of the scenario that take what the axis takes.
    low, high: its ends, for a normal distribution three standard deviations from its middle.   log: even in the logarithm.
    values: the points of a grid; () elsewhere.   normal: not even, but normally distributed.   whole: whole numbers only.
    factor: what the axis takes is a factor on the scenario's own values, which differ from path to path.
    """

    text: str
    paths: tuple[str, ...]
    low: float = 0.0
    high: float = 0.0
    log: bool = False
    values: tuple[Any, ...] = ()
    normal: bool = False
    whole: bool = False
    factor: bool = False

    @property
    def name(self) -> str:
        """Its column in a table."""
        return ",".join(self.paths)

    def at(self, share: Array) -> Array:
        """What the axis takes at a share from 0 to 1 of its distribution; of whole numbers in an even range each is as likely."""
        if self.whole and not (self.normal or self.log or self.values):
            least, most = math.ceil(self.low), math.floor(self.high)
            return np.minimum(np.floor(least + share * (most - least + 1)), most)
        taken = self._taken(share)
        return np.round(taken) if self.whole else taken

    def _taken(self, share: Array) -> Array:
        if self.normal:
            from scipy.stats import truncnorm

            middle, deviation = (self.low + self.high) / 2, (self.high - self.low) / (2 * TRUNCATED)
            return np.asarray(middle + deviation * truncnorm.ppf(share, -TRUNCATED, TRUNCATED))
        if self.log:
            return np.asarray(np.exp(np.log(self.low) + share * (np.log(self.high) - np.log(self.low))))
        return np.asarray(self.low + share * (self.high - self.low))

    def settings(self, scenario: Scenario, value: Any) -> dict[str, Any]:
        """By path, what the scenario's values become."""
        if self.factor:
            return {path: get(scenario, path) * value for path in self.paths}
        if self.whole and self.low < self.high:
            value = round(value)
        return dict.fromkeys(self.paths, value)


def member(scenario: Scenario, axes: tuple[Axis, ...], values: Mapping[str, Any]) -> Scenario:
    """The scenario with what each axis, by name, takes. Raises ArgumentError where it may not take that."""
    settings: dict[str, Any] = {}
    for axis in axes:
        settings |= axis.settings(scenario, values[axis.name])
    return changed(scenario, settings)


def read_axis(option: Option, text: str, scenario: Scenario) -> Axis:
    """An axis from "PATH=RANGE" or "PATH,PATH=RANGE"; both ends are tried on the scenario. Raises ArgumentError."""
    names, equals, written = (part.strip() for part in text.partition("="))
    paths = tuple(name.strip() for name in names.split(","))
    if not equals or not written or not all(paths):
        raise ArgumentError(f"Option `--{option}` must look like PATH=RANGE, with a range like {FORMS[option]}, but is {text!r}.")
    if len(set(paths)) < len(paths):
        raise ArgumentError(f"Option `--{option} {names}` must name each path once.")
    own = [get(scenario, path) for path in paths]
    axis = read_range(option, text, paths, written, own)
    if axis.factor or axis.low != axis.high:
        for path, value in zip(paths, own, strict=True):
            if not isinstance(value, int | float) or isinstance(value, bool):
                raise ArgumentError(f"Option `--{option} {path}` must name a number, but it is {shown(value)}.")
    if not axis.factor and all(is_whole(scenario, path) for path in paths):
        values = tuple(dict.fromkeys(round(v) if isinstance(v, float) and axis.low < axis.high else v for v in axis.values))
        axis = replace(axis, whole=True, values=values)
        if axis.low < axis.high and math.ceil(axis.low) > math.floor(axis.high):
            raise ArgumentError(f"Option `--{option} {names}` must have a range with a whole number in it, but has {written!r}.")
    _try(option, axis, scenario)
    return axis


def read_range(option: Option, text: str, paths: tuple[str, ...], written: str, own: list[Any]) -> Axis:
    """An axis of what is written behind PATH=, whatever stands at its paths. own: the values there, which a spread is about."""
    spread = SPREAD.fullmatch(written)
    if option == "uncertain" and spread:
        return _spread(text, paths, spread, own)
    parts = written.split(":")
    log = "log" in parts[2:3]
    numbers = [part for part in parts if part != "log"]
    wanted = 3 if option == "vary" else 2
    if len(parts) > 1 and len(numbers) == wanted and len(parts) == wanted + log and all(map(_is_number, numbers)):
        return _range(option, text, paths, [float(number) for number in numbers], log)
    if option == "vary" and len(parts) == 1:
        return Axis(text, paths, values=_listed(text, written))
    raise ArgumentError(f"Option `--{option} {paths[0]}` must have a range like {FORMS[option]}, but has {written!r}.")


def _range(option: Option, text: str, paths: tuple[str, ...], numbers: list[float], log: bool) -> Axis:
    (low, high), what = numbers[:2], f"Option `--{option} {paths[0]}`"
    if not low < high:
        raise ArgumentError(f"{what} must have a range with LOW < HIGH, but has {low:g}:{high:g}.")
    if log and not low > 0:
        raise ArgumentError(f"{what} must have LOW > 0 for a logarithmic range, but has {low:g}.")
    axis = Axis(text, paths, low, high, log)
    if option != "vary":
        return axis
    count = numbers[2]
    if not (count >= 2 and count == int(count) and count <= 100_000):
        raise ArgumentError(f"{what} must have a count of points from 2 to 100000, but has {count:g}.")
    points = axis.at(np.linspace(0, 1, int(count)))
    points[-1] = high
    return Axis(text, paths, low, high, log, values=tuple(float(point) for point in points))


def _spread(text: str, paths: tuple[str, ...], found: re.Match[str], own: list[Any]) -> Axis:
    """+-30% about the scenario's own value, or about one that is given; several paths share a factor."""
    spread, normal = float(found["spread"]), bool(found["normal"])
    if not spread > 0:
        raise ArgumentError(f"Option `--uncertain {paths[0]}` must have a spread > 0, but has {spread:g}.")
    reach = spread * (TRUNCATED if normal else 1.0)
    for path, value in zip(paths, own, strict=True):
        if not isinstance(value, int | float) or isinstance(value, bool):
            raise ArgumentError(f"Option `--uncertain {path}` must name a number, but it is {shown(value)}.")
    if found["percent"] and found["centre"] is None and len(paths) > 1:
        return Axis(text, paths, 1 - reach / 100, 1 + reach / 100, normal=normal, factor=True)
    if found["centre"] is None and len(set(own)) > 1:
        raise ArgumentError(f"Option `--uncertain {','.join(paths)}` must have a spread in %, since the values differ.")
    centre = float(own[0] if found["centre"] is None else found["centre"])
    half = abs(centre) * reach / 100 if found["percent"] else reach
    if not half > 0:
        raise ArgumentError(f"Option `--uncertain {paths[0]}` must have a spread that is not in %, since the value is 0.")
    return Axis(text, paths, centre - half, centre + half, normal=normal)


def _listed(text: str, written: str) -> tuple[Any, ...]:
    try:
        values = tomllib.loads(f"values = [{written}]")["values"]
    except ValueError:
        values = [word.strip() for word in written.split(",")]
    if not values or any(isinstance(value, str) and not value for value in values):
        raise ArgumentError(f"Option `--vary` must have {FORMS['vary']}, but is {text!r}.")
    if len(values) != len(set(map(repr, values))):
        raise ArgumentError(f"Option `--vary` must name each value once, but is {text!r}.")
    return tuple(values)


def _is_number(text: str) -> bool:
    return re.fullmatch(NUMBER, text.strip()) is not None


def _try(option: Option, axis: Axis, scenario: Scenario) -> None:
    """Both ends of a range, and all values of a list, must be such that a component can be made of them."""
    for value in axis.values if axis.values else (axis.low, axis.high):
        try:
            member(scenario, (axis,), {axis.name: value})
        except ArgumentError as error:
            raise ArgumentError([f"Option `--{option} {axis.name}` cannot be {shown(value)}: {error.lines[0]}"]) from None
