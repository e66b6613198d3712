"""Disturbances given as functions of the user's own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, ClassVar

import numpy as np
from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.component import ArgumentError, own_name
from dampen.disturbances.base import Array, Content, columns, in_dict
from dampen.disturbances.clock import Clocked, Trials
from dampen.own import complaint, own_function
from dampen.port import Site

Function = Callable[..., Any] | str


@dataclass(frozen=True)
class FunctionDisturbance(Clocked):
    """Forces d(t) at ports and a load f(x, t) along the structure, from functions of your own.

    Each is a Python function or its name, "module:name". d is called with t (times,) and returns (times,) forces [N, N m]; f
    with x (1, points) and t (times, 1) and returns what broadcasts to (times, points) [N/m]; a single number is a constant.
    A function that knows scalars only (`math.sin`, `if t > 1`) raises TypeError or ValueError when given arrays, and is then
    called point by point, a thousand times slower. What cannot be seen from outside has to be stated: the highest frequency
    and the shortest wave that step, modes and quadrature must resolve. A scenario file knows a function by its name: only
    one at the top of a module is found again.
    """

    kind: ClassVar[str] = "function"

    highest_frequency: Annotated[float, Ge(0), Unit("Hz"), Doc("the highest frequency that there is in any of it")]
    force: Annotated[dict[str, Function], Unit("N, N m"), Doc("for each port a function d(t)")] = field(default_factory=dict)
    load_function: Annotated[Function | None, Unit("N/m"), Doc("a function f(x, t); left out, there is no load")] = None
    load_field_name: Annotated[str, Doc("field that the load acts on")] = "w"
    shortest_wave: Annotated[
        float | None, Gt(0), Unit("m"), Doc("shortest wavelength of f in x; left out, a sixteenth of the structure")
    ] = None
    trials: Trials = "repeat"

    def __post_init__(self) -> None:
        super().__post_init__()
        found = {port: _function(f, f"force.{port}") for port, f in self.force.items()}
        object.__setattr__(self, "force", found)
        object.__setattr__(self, "load_function", _function(self.load_function, "load_function"))

    def ports_named(self) -> Mapping[str, str]:
        return in_dict("force", self.force)

    def at_ports(self, trial: int, t: Array, site: Site) -> Array:
        t = self.clock(trial, t, site)
        return columns(site, t, {port: called(f, f"force.{port}", t.shape, t) for port, f in self.force.items()})

    @property
    def load_field(self) -> str | None:
        return None if self.load_function is None else self.load_field_name

    def load(self, trial: int, t: Array, x: Array, site: Site) -> Array:
        t = self.clock(trial, t, site)
        return called(self.load_function, "load_function", (len(t), len(x)), x[None, :], t[:, None])

    def content(self, trial: int, site: Site) -> Content:
        return Content(
            port_frequency=tuple(self.highest_frequency if port.name in self.force else 0.0 for port in site.ports),
            load_frequency=self.highest_frequency if self.load_field else 0.0,
            load_wave=(self.shortest_wave or site.span / 16) if self.load_field else np.inf,
        )


def called(function: Any, argument: str, shape: tuple[int, ...], *arguments: Array) -> Array:
    """`function(*arguments)` as an array of `shape`. Raises ArgumentError that names the function, and the line it fails in."""
    named = f"Argument `disturbance.{argument}` is the function `{own_name(function)}`, which"
    try:
        try:
            values = np.asarray(function(*arguments), float)
        except (TypeError, ValueError):
            values = np.vectorize(function, otypes=[float])(*arguments)
    except Exception as error:
        raise ArgumentError(f"{named} fails: {complaint(error)}.") from None
    if values.ndim not in (0, len(shape)) or any(n not in (1, m) for n, m in zip(values.shape, shape, strict=False)):
        given = ", ".join(map(str, (a.shape for a in arguments)))
        raise ArgumentError(f"{named} must return an array of shape {shape} for arguments {given}, but returns {values.shape}.")
    if not np.all(np.isfinite(values)):
        raise ArgumentError(f"{named} must return finite numbers, but returns {values[~np.isfinite(values)].flat[0]}.")
    return np.broadcast_to(values, shape)


def _function(given: Any, argument: str) -> Any:
    return own_function(given, argument) if isinstance(given, str) else given
