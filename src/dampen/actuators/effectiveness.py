"""Effectiveness: an actuator that loses, or regains, part of its force in the course of the experiment."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated, ClassVar

from annotated_types import Ge, Unit
from typing_extensions import Doc

from dampen.component import ArgumentError, wrong
from dampen.stage import Array, Stage, Step

KNOTS_AT_MOST = 15


def effectiveness_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """B = e(t) u with t in the middle of the step; the state is the clock at its beginning."""
    dt = parameters[0]
    new_state[0] = state[0] + dt
    return effectiveness_at(state[0] + 0.5 * dt, parameters) * command


def effectiveness_at(t: float, parameters: Array) -> float:
    """e(t), from knots (time, value) in pairs: straight lines between them, held before the first and after the last."""
    count = int(parameters[1])
    if t < parameters[2]:
        return parameters[3]
    for i in range(1, count):
        start, end = parameters[2 * i], parameters[2 * i + 2]
        if t < end:
            before, after = parameters[2 * i + 1], parameters[2 * i + 3]
            return max(before + (after - before) * ((t - start) / (end - start)), 0.0)
    return parameters[2 * count + 1]


@dataclass(frozen=True)
class Effectiveness(Stage):
    """Delivers a share of the command that changes with time: partial or total loss of effectiveness.

        B = e(t) command

    e runs in straight lines through the knots (times_i, values_i) and is held before the first and after the last; the same
    time twice is a jump. Time runs through all trials, and e is taken in the middle of each step. At most 15 knots.

    `gain`, what the energy account calls the actuator's slope, is the first value (1 if that is zero): what is lost later is
    the actuator's work.
    """

    times: Annotated[tuple[float, ...], Unit("s"), Doc("times of the knots since the experiment began, in order")] = (0.0,)
    values: Annotated[tuple[float, ...], Ge(0), Doc("effectiveness e at these times: 1 is all, 0 is none")] = (1.0,)

    kind: ClassVar[str] = "effectiveness"
    states: ClassVar[int] = 1
    step: ClassVar[Step] = staticmethod(effectiveness_step)

    def check(self) -> None:
        if not 1 <= len(self.times) <= KNOTS_AT_MOST:
            raise ArgumentError(f"Argument `times` must have 1 to {KNOTS_AT_MOST} members, but has {len(self.times)}.")
        if len(self.values) != len(self.times):
            raise ArgumentError(
                f"Argument `values` must have as many members as `times`, but has {len(self.values)} "
                f"where `times` has {len(self.times)}."
            )
        if any(a > b for a, b in pairwise(self.times)):
            raise wrong("times", "be in order", self.times)

    def row(self, dt: float) -> tuple[float, ...]:
        knots = (number for pair in zip(self.times, self.values, strict=True) for number in pair)
        return dt, float(len(self.times)), *knots

    @property
    def gain(self) -> float:
        return self.values[0] if self.values[0] > 0 else 1.0

    @property
    def deviation(self) -> tuple[float, float]:
        """None while e stays what `gain` says; what is lost or regained grows with the command."""
        return (0.0, 0.0) if all(e == self.gain for e in self.values) else super().deviation
