"""A port's constraint, as curves and in words: symmetric or uneven, fixed or moving, of the displacement or of the error."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from dampen.report.joined import Array, duration, gapped, joined
from dampen.report.style import MINUS, number, plain_number
from dampen.simulation.result import Result
from dampen.simulation.scenario import Scenario
from dampen.simulation.task import Constraint


@dataclass(frozen=True)
class Limits:
    """The constraint of one port. low, high: (times,) in trial 0, of the displacement, or of the error if that is limited."""

    index: int
    unit: str
    low: Array
    high: Array
    on_error: bool
    moving: bool

    @property
    def symmetric(self) -> bool:
        return bool(np.all(self.low == -self.high))

    @property
    def fixed(self) -> bool:
        """Whether two straight lines over the displacement show it."""
        return not (self.moving or self.on_error)

    @property
    def label(self) -> str:
        """For a legend."""
        if self.moving:
            return "constraint"
        low, high = plain_number(float(self.low[0])), plain_number(float(self.high[0]))
        about = " about reference" if self.on_error else ""
        return f"constraint ±{high} {self.unit}{about}" if self.symmetric else f"constraint {low}, {high} {self.unit}{about}"

    @property
    def words(self) -> str:
        """For a sentence: "the constraint of 0.2 m"."""
        name = "the constraint on the error" if self.on_error else "the constraint"
        if not self.moving:
            return f"{name} of {self.at(0)}"
        if np.ptp(self.low) == np.ptp(self.high) == 0:
            return f"{name}, {self.at(0)} in trial 0,"
        return f"{name}, which moves from {self.at(0)} at the start of a trial to {self.at(-1)} at its end,"

    def at(self, k: int) -> str:
        """Both limits at step k: "0.2 m", or "-0.15 m to 0.2 m"."""
        low, high = _written(float(self.low[k])), _written(float(self.high[k]))
        return f"{high} {self.unit}" if self.symmetric else f"{low} {self.unit} to {high} {self.unit}"

    def inequality(self, name: str, k: int) -> str:
        """As a formula at step k: "|y| < 0.2 m"."""
        body = f"{name} {MINUS} reference" if self.on_error else name
        low, high = _written(float(self.low[k])), _written(float(self.high[k]))
        return f"|{body}| < {high} {self.unit}" if self.symmetric else f"{low} {self.unit} < {body} < {high} {self.unit}"

    def curves(self, run: Result) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """Lower and upper limit of the displacement over all trials, each as times [s] and values."""
        if self.fixed:
            t = np.array([0.0, duration(run) * run.trials])
            return (t, np.full(2, self.low[0])), (t, np.full(2, self.high[0]))
        low, high = (gapped(run, *joined(run, _sides(run, side, self.index), run.time)) for side in (0, 1))
        return low, high


def _sides(run: Result, side: int, index: int) -> Iterator[tuple[int, Array]]:
    for trial in range(run.trials):
        yield trial, run.scenario.limits(trial)[side][None, :, index]


def _to_digits(values: Array, digits: int) -> Array:
    """Rounded to this many digits of the largest."""
    largest = float(np.abs(values[np.isfinite(values)]).max(initial=0.0))
    return np.round(values, digits - math.ceil(math.log10(largest))) if largest > 0 else values


def _written(value: float) -> str:
    """A limit as its owner wrote it, or rounded where a signal gave it."""
    text = plain_number(value)
    return text if len(text) <= 5 else number(value)


def limits_of(scenario: Scenario, name: str) -> Limits | None:
    """The constraint of the port `name`; None if it has none."""
    if name not in scenario.task.constraint:
        return None
    p, given = scenario.ports.index(name), scenario.task.constraint[name]
    on_error = isinstance(given, Constraint) and given.on == "error" and name in scenario.task.reference

    def both(trial: int) -> tuple[Array, Array]:
        low, high = scenario.limits(trial)
        about = scenario.reference(trial)[:, p] if on_error else 0.0
        return low[:, p] - about, high[:, p] - about

    # rounded, since a reference added and taken off again is back only up to round-off
    first, last = (_to_digits(np.array(both(trial)), 12) for trial in (0, scenario.task.trials - 1))
    moving = bool(np.any(first != first[:, :1]) or np.any(last != first))
    return Limits(p, scenario.plant.ports[p].motion_unit, first[0], first[1], on_error, moving)
