"""First-order lag: the delivered force follows the command after a time."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Gt, Unit
from typing_extensions import Doc

from dampen.stage import Array, Stage, Step


def lag_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """B at the step's end, and the mean of B over the step."""
    away = command - state[0]
    new_state[0] = state[0] + parameters[0] * away
    return state[0] + parameters[1] * away


def mean_rise(h: float) -> float:
    """1 - (1 - e^-h) / h, without cancellation: how far the step's mean gets when its end gets to 1 - e^-h."""
    if h >= 1.0:
        return 1.0 + math.expm1(-h) / h
    term = total = 0.5 * h
    for k in range(3, 20):
        term *= -h / k
        total += term
    return total


@dataclass(frozen=True)
class FirstOrderLag(Stage):
    """Follows the command with a time constant.

        time_constant B' + B = command        delivered: the mean of B over the step

    Exact for a command that is held over the step: with h = dt / time_constant, B moves the share 1 - e^-h of the way to the
    command, and its mean the share 1 - (1 - e^-h) / h. B = 0 before the first trial.
    """

    time_constant: Annotated[float, Gt(0), Unit("s"), Doc("time constant tau")] = 0.01

    kind: ClassVar[str] = "lag"
    states: ClassVar[int] = 1
    step: ClassVar[Step] = staticmethod(lag_step)

    def row(self, dt: float) -> tuple[float, ...]:
        return -math.expm1(-dt / self.time_constant), self.feedthrough(dt)

    @property
    def gain(self) -> float:
        return 1.0

    @property
    def lag_time(self) -> float:
        return self.time_constant

    def feedthrough(self, dt: float) -> float:
        return mean_rise(dt / self.time_constant)
