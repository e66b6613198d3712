"""How a study's parameters and figures of merit are called on axes and in sentences, with their units."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import is_dataclass
from typing import Any

from dampen.analysis.merits import merit, merit_unit
from dampen.component import ArgumentError, parameters
from dampen.port import Port
from dampen.report.style import GREEK, percent, plain_text, quantity, typeset
from dampen.simulation.scenario import Scenario
from dampen.studies.lens import get
from dampen.studies.variation import Axis

LONGEST = 26
SHARES = ("peak", "residual")  # without a port: shares of the constraint
WORDS = {
    "peak": "peak error",
    "residual": "rms error",
    "largest": "largest error of all trials",
    "margin": "margin",
    "effort": "rms force",
    "chatter": "variation of the command",
    "stuck": "share of steps stuck",
    "energy": "energy",
    "unsettled": "unsettled steps",
}


def axis_names(scenario: Scenario, axes: Sequence[Axis]) -> dict[str, str]:
    """By column, a short name that tells the axes apart: the parameter's own, and before it what else is needed."""
    found = {axis.name: _short(scenario, axis, 1) for axis in axes}
    for depth in range(2, 8):
        again = [axis for axis in axes if list(found.values()).count(found[axis.name]) > 1]
        for axis, name in [(axis, _short(scenario, axis, depth)) for axis in again]:
            found[axis.name] = name
    return found


def _short(scenario: Scenario, axis: Axis, depth: int) -> str:
    """The last keys of the paths; numbers in a chain say nothing to a reader, unless a list is what is varied."""
    names = list(dict.fromkeys(_tail(scenario, path, depth) for path in axis.paths))
    text = " & ".join(names)
    if len(text) > LONGEST and len(names) > 2:
        text = f"{names[0]} ... {names[-1]}"
    return f"factor on {text}" if axis.factor else text


def _tail(scenario: Scenario, path: str, depth: int) -> str:
    keys = path.split(".")
    if "chain" in keys[2:3] and len(keys) > 4:  # a stage's parameter says little without the stage: "backlash right"
        stage = str(getattr(get(scenario, ".".join(keys[:4])), "kind", ""))
        keys = [*keys[:2], f"{stage} {'.'.join(keys[4:])}".strip()]
    own = 2 if keys[-1].isdigit() or keys[-1] in scenario.ports else 1  # the index of a list's element goes with the list
    name = "[".join(keys[-own:]) + ("]" if own == 2 else "")
    if keys[-1] in scenario.ports:
        name = " ".join(keys[-own:])
    above = [key for key in keys[:-own] if not key.isdigit() and key != "chain"]
    return " ".join([*above[len(above) - (depth - 1) :], name]) if depth > 1 else name


def math_name(name: str) -> str:
    """A parameter's name for a figure: alpha_4 as its symbol, words without underscores."""
    return re.sub(r"[A-Za-z]\w*", lambda m: _math(m[0]), plain_text(name), flags=re.ASCII)


def _math(word: str) -> str:
    letter, _, index = word.partition("_")
    if letter in GREEK and (index.isdigit() or not index):
        return rf"$\{letter}" + (rf"_{{{index}}}$" if index else "$")
    return word.replace("_", " ")


def plain_name(name: str) -> str:
    """A parameter's name in a sentence: words without underscores, alpha_4 as it is, for the page to lower its index."""
    return re.sub(r"[A-Za-z]\w*", lambda m: m[0] if m[0].partition("_")[0] in GREEK else m[0].replace("_", " "), name)


def axis_label(scenario: Scenario, axis: Axis, name: str) -> str:
    """A label for an axis, with the unit where one is declared."""
    unit = axis_unit(scenario, axis)
    return math_name(name) + (f" [{math_unit(unit)}]" if unit else "")


def math_unit(unit: str) -> str:
    """A unit with raised powers."""
    return unit.replace("^2", "²").replace("^3", "³")


def axis_unit(scenario: Scenario, axis: Axis) -> str:
    """The unit that all paths of an axis share; "" for a factor, or where none is declared."""
    units = {"" if axis.factor else path_unit(scenario, path) for path in axis.paths}
    return units.pop() if len(units) == 1 else ""


def path_unit(scenario: Scenario, path: str) -> str:
    """The declared unit of a value, or of the list it stands in; what stands by port's name has the port's unit."""
    keys = path.split(".")
    port = next((p for p in scenario.plant.ports if p.name == keys[-1]), None)
    if port is not None:
        return _port_unit(scenario, keys, port)
    if keys[:2] == ["plant", "initial"] and keys[-1] not in ("0", keys[2]):
        return ""  # a coefficient of x, x^2, ...
    for depth in range(len(keys) - 1, 0, -1):
        try:
            part: Any = get(scenario, ".".join(keys[:depth]))
        except ArgumentError:
            return ""
        if is_dataclass(part) and not isinstance(part, type):
            return next((p.unit for p in parameters(type(part)) if p.name == keys[depth]), "")
    return ""


def _port_unit(scenario: Scenario, keys: list[str], port: Port) -> str:
    """The unit of what stands by port's name: its table has one for forces and one for torques, "N, N m"."""
    if keys[0] == "bounds":
        return port.effort_unit
    try:
        part: Any = get(scenario, ".".join(keys[:-2])) if len(keys) > 2 else scenario
    except ArgumentError:
        return ""
    table = next((p for p in parameters(type(part)) if p.name == keys[-2]), None) if is_dataclass(part) else None
    force, *torque = table.unit.split(", ") if table else [""]
    return torque[0] if torque and port.kind == "torque" else force


def merit_label(name: str, scenario: Scenario) -> str:
    """A label for an axis: "peak error, tip w [m]", "peak error / constraint"."""
    kind, _, port = name.partition(".")
    words = WORDS[kind]
    if kind in SHARES and not port:
        return f"{words} / constraint" if scenario.task.constraint else f"{words}, all ports"
    unit = math_unit(merit_unit(name, scenario))
    words += " / constraint" if kind == "margin" else ""
    return (f"{words}, {typeset(port_words(port))}" if port else words) + (f" [{unit}]" if unit else "")


def merit_words(name: str) -> str:
    """The merit in a sentence: "peak error at tip w"."""
    kind, _, port = name.partition(".")
    return f"{WORDS[kind]} at {port_words(port)}" if port else WORDS[kind]


def port_words(port: str) -> str:
    """A port's name without underscores; a user's own may have a dollar sign."""
    return plain_text(port.replace("_", " "))


def merit_value(name: str, value: float, scenario: Scenario) -> str:
    """A merit's value for reading, with its unit; shares in percent."""
    if value != value:
        return "unknown"
    if value in (float("inf"), float("-inf")):
        return "diverged"
    kind, _, port = name.partition(".")
    if (kind in SHARES and not port and scenario.task.constraint) or kind in ("margin", "stuck"):
        return percent(value) + (" of the constraint" if kind in SHARES else "")
    unit = merit_unit(name, scenario)
    return quantity(value, "" if ", " in unit else math_unit(unit))  # forces and torques together have none


def is_low_better(name: str) -> bool:
    """Whether a smaller value is the better one."""
    return merit(name).better == "low"
