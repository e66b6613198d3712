"""How a plant's ports and fields are called on axes and in sentences."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dampen.report.style import plain_number, plain_text, quantity, symbol
from dampen.simulation.result import Result

LONGEST = 30


@dataclass(frozen=True)
class PortNames:
    """A port in words. index: its place in the result's arrays.   motion, effort: units.

    words:  "tip displacement".   math, text: its symbol as mathtext and in plain text, "w(L, t)", or what replaces it.
    """

    index: int
    words: str
    math: str
    text: str
    motion: str
    effort: str
    effort_words: str

    @property
    def kind(self) -> str:
        """What moves: "displacement" or "rotation"."""
        return "rotation" if self.motion == "rad" else "displacement"

    @property
    def short(self) -> str:
        """For a low axis, whose caption names the port."""
        return self.math or self.kind

    @property
    def label(self) -> str:
        """For an axis; what would be too long for one is left to the caption."""
        label = f"{self.words} {self.math}".strip()
        return label if self.math or len(label) <= LONGEST else self.kind


def port_names(run: Result, name: str) -> PortNames:
    """The port `name` of the run's plant."""
    ports = run.scenario.plant.ports
    index = next((i for i, port in enumerate(ports) if port.name == name), None)
    if index is None:
        raise ValueError(f"Argument `of` must be a port of this plant ({', '.join(p.name for p in ports)}), but is {name!r}.")
    port = ports[index]
    coordinates = run.layout.coordinates
    motion, effort = str(coordinates["motion_unit"][1][index]), str(coordinates["effort_unit"][1][index])
    kind = "rotation" if motion == "rad" else "displacement"
    effort_words = "delivered torque" if effort == "N m" else "delivered force"
    if port.field not in [field for field, _ in run.scenario.plant.fields]:
        return PortNames(index, plain_text(f"{kind} at {name}"), "", f"{kind} at {name}", motion, effort, effort_words)
    at_tip = port.x == run.scenario.plant.span
    place = "L, t" if at_tip else rf"{plain_number(port.x)}\,\mathrm{{m}}, t"
    text = f"{port.field}({'L' if at_tip else plain_number(port.x) + ' m'}, t)"
    words = f"tip {kind}" if at_tip else kind
    return PortNames(index, words, symbol(port.field, place), text, motion, effort, effort_words)


def tracked(run: Result, name: str) -> bool:
    """Whether the port `name` has something to follow."""
    return name in run.scenario.task.reference


def field_unit(run: Result, name: str) -> str:
    """The unit of the field `name`."""
    fields = dict(run.scenario.plant.fields)
    if name not in fields:
        raise ValueError(f"Argument `of` must be a field of this plant ({', '.join(fields)}), but is {name!r}.")
    return str(fields[name])


def course(values: np.ndarray, unit: str, of: str = "") -> str:
    """What became of a value from trial to trial: "falls from 1.00 m in trial 0 to 0.100 m in trial 9"."""
    first, last, trial = quantity(float(values[0]), unit), quantity(float(values[-1]), unit), len(values) - 1
    verb = trend(float(values[0]), float(values[-1]))
    if verb == "stays":
        return f" is {first} in trial 0 and {last} in trial {trial}"
    return f"{of} {verb} from {first} in trial 0 to {last} in trial {trial}"


def trend(first: float, last: float) -> str:
    """The verb for what happened between two values."""
    if last < 0.95 * first:
        return "falls"
    return "rises" if last > 1.05 * first else "stays"
