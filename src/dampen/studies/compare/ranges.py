"""Where a contender's gains are searched, and where the search begins."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dampen.actuators.backlash import Backlash
from dampen.component import ArgumentError, is_number, own_name, parameters, shown, suggestion
from dampen.controllers.base import Controller, SampledFeedback, Setting
from dampen.controllers.inner_loop import AssumedBacklash, InnerLoop
from dampen.controllers.none import NoControl
from dampen.simulation.bench import Bench
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import setting_of
from dampen.studies.lens import get
from dampen.studies.variation import read_axis, read_range

DIGITS = 4


@dataclass(frozen=True)
class Start:
    """A scenario to begin from, the ranges around it as PATH=RANGE, and what a reader has to know of both.

    untuned: why a kind of controller has no ranges; "" if it has, or has no gains.
    """

    scenario: Scenario
    search: tuple[str, ...]
    notes: tuple[str, ...] = ()
    untuned: str = ""


def under(scenario: Scenario, controller: Controller) -> Scenario:
    """The experiment under another controller; one that acts through samples alone is given them."""
    numerics = scenario.numerics
    if isinstance(controller, SampledFeedback):
        numerics = replace(numerics, mode="sampled")
    return replace(scenario, controller=controller, numerics=numerics)


def from_kind(scenario: Scenario, kind: type[Controller], bench: Bench) -> Start:
    """A controller of a kind, its gains in the middle of their ranges. Raises ArgumentError where it cannot be run."""
    missing = [p.name for p in parameters(kind) if p.required]
    if missing:
        raise ArgumentError(f"it has no value for {', '.join(missing)}: name a scenario that has.")
    plain, notes = fitted(kind(), scenario)
    ranges = ranges_of(under(scenario, plain), bench)
    if not ranges:
        return Start(under(scenario, plain), (), notes, why_untuned(plain))
    tables: dict[str, Any] = {}
    whole = {p.name for p in parameters(kind) if p.type == "whole number"}
    for path, text in ranges.items():
        name, _, key = path.partition(".")
        value = round(middle(text)) if name in whole else middle(text)
        tables[name] = {**tables.get(name, {}), key: value} if key else value
    with told_of_search(plain, ", ".join(tables)):
        made = under(scenario, replace(plain, **tables))
    return Start(made, tried(made, ranges), notes)


def from_controller(scenario: Scenario, bench: Bench) -> Start:
    """A scenario's own controller, from its own gains on. A range that these are outside of is stretched to them; a gain that
    it does not have it is not given."""
    search, without, notes = dict[str, str](), [], []
    for path, text in ranges_of(scenario, bench).items():
        try:
            own = get(scenario, f"controller.{path}")
        except ArgumentError:
            own = None
        if own is None:
            without.append(path)
        else:
            with told_of_search(scenario.controller, path):
                search[path] = stretched(text, number(own))
            if search[path] != text:
                low, high = (float(end) for end in text.split(":")[:2])
                notes.append(f"the range of {path}, {low:g} to {high:g}, is stretched to its own value, {own:g}")
    if without and search:
        notes.append(f"not searched, since it has no value of its own: {', '.join(without)}")
    return Start(scenario, tried(scenario, search), tuple(notes))


def ranges_of(scenario: Scenario, bench: Bench) -> Mapping[str, str]:
    """What the controller itself says of where its gains may lie."""
    return ranges_said(scenario.controller, setting_of(scenario, bench=bench))


def ranges_said(controller: Controller, setting: Setting) -> Mapping[str, str]:
    """The ranges of a controller's `search`. Raises ArgumentError where one is none, or no parameter's."""
    ranges, known = controller.search(setting), [p.name for p in parameters(type(controller))]
    for path, text in ranges.items():
        name = path.partition(".")[0]
        if name not in known:
            near = suggestion(name, known) if known else "; it has none."
            raise ArgumentError(f"{own_name(controller)}.search names `{path}`, which is no parameter of it{near}")
        with told_of_search(controller, path):
            read_range("search", text, (f"controller.{path}",), text, [])
    return ranges


def tried(scenario: Scenario, ranges: Mapping[str, str]) -> tuple[str, ...]:
    """The ranges as PATH=RANGE. Raises ArgumentError for one that leads out of what the controller takes."""
    texts = {path: f"controller.{path}={text}" for path, text in ranges.items()}
    for path, text in texts.items():
        with told_of_search(scenario.controller, path):
            read_axis("search", text, scenario)
    return tuple(texts.values())


@contextmanager
def told_of_search(controller: Controller, path: str) -> Iterator[None]:
    """Complaints about a range, told of the method that said it."""
    try:
        yield
    except ArgumentError as error:
        option, line = f"Option `--search controller.{path}`", error.lines[0]
        said = f"{own_name(controller)}.search for `{path}`"
        raise ArgumentError(line.replace(option, said, 1) if option in line else f"{said}: {line}") from None


def number(value: object) -> float:
    """A gain's own value. Raises ArgumentError where it is no number."""
    if not is_number(value):
        raise ArgumentError(f"it must name a number, but names {shown(value)}.")
    return float(value)  # type: ignore[arg-type]


def why_untuned(controller: Controller) -> str:
    """Why a controller says no ranges; "" for no control, which has no gains."""
    if isinstance(controller, NoControl):
        return ""
    return "defines no `search`" if type(controller).search is Controller.search else "its `search` names no gains"


def middle(text: str) -> float:
    """The middle of a range, the geometric one where it is logarithmic, to four digits."""
    low, high, *log = text.split(":")
    ends = float(low), float(high)
    value = math.sqrt(ends[0] * ends[1]) if log else (ends[0] + ends[1]) / 2
    return float(f"{value:.{DIGITS}g}")


def stretched(text: str, own: float) -> str:
    """A range that has a value in it: its nearer end is moved there. A logarithmic range stays above zero."""
    low, high, *log = text.split(":")
    if log and own <= 0:
        return text
    ends = min(float(low), own), max(float(high), own)
    return ":".join([low if ends[0] == float(low) else repr(ends[0]), high if ends[1] == float(high) else repr(ends[1]), *log])


def fitted(controller: Controller, scenario: Scenario) -> tuple[Controller, tuple[str, ...]]:
    """A controller whose defaults are meant for another plant, told what this one has: the inner loop's barrier needs a
    constraint at every port, and what it assumes of backlash is what is there."""
    if not isinstance(controller, InnerLoop):
        return controller, ()
    notes = []
    unlimited = [port for port in scenario.ports if port not in scenario.task.constraint]
    if unlimited:
        controller = replace(controller, barrier="none")
        notes.append(f"without a barrier, since {', '.join(unlimited)} has no constraint")
    plays = {"force": plays_at(scenario, "force"), "torque": plays_at(scenario, "torque")}
    found = plays["force"] or plays["torque"]
    if found and not any(scenario.compensation.values()):
        assumed, at_torque = mean_play(found), mean_play(plays["torque"] or found)
    else:
        assumed = at_torque = AssumedBacklash(slope=1.0, right=0.0, left=0.0)
        why = "the scenario has one" if found else "there is no backlash"
        notes.append(f"without compensation of its own, since {why}")
    separate = None if at_torque == assumed else at_torque
    controller = replace(controller, assumed_backlash=assumed, assumed_torque_backlash=separate, compensate=assumed.left < 0)
    return controller, tuple(notes)


def plays_at(scenario: Scenario, kind: str) -> list[Backlash]:
    """The backlashes of all actuators at ports of one kind."""
    ports = [port.name for port in scenario.plant.ports if port.kind == kind]
    return [stage for port in ports for stage in scenario.actuators.get(port, ()) if isinstance(stage, Backlash)]


def mean_play(plays: Sequence[Backlash]) -> AssumedBacklash:
    """What they are in the mean."""
    return AssumedBacklash(*(float(np.mean([getattr(p, name) for p in plays])) for name in ("slope", "right", "left")))
