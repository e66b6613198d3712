"""Rate limit: the delivered force can change only so fast."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Gt, Unit
from typing_extensions import Doc

from dampen.stage import Array, Stage, Step


def rate_limit_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """B at the step's end, and the mean of B over the step: a ramp towards the command, then the command."""
    reach, away = parameters[0], command - state[0]
    if away > reach:
        new_state[0] = state[0] + reach
        return state[0] + 0.5 * reach
    if away < -reach:
        new_state[0] = state[0] - reach
        return state[0] - 0.5 * reach
    new_state[0] = command
    return command - 0.5 * away * abs(away) / reach


@dataclass(frozen=True)
class RateLimit(Stage):
    """Follows the command at once, as far as its rate allows.

        |B'| <= rate, B = command otherwise        delivered: the mean of B over the step

    Exact for a command that is held over the step. B = 0 before the first trial.
    """

    rate: Annotated[float, Gt(0), Unit("N/s"), Doc("largest rate of the force (N m/s at a torque port)")] = 100.0

    kind: ClassVar[str] = "rate-limit"
    states: ClassVar[int] = 1
    step: ClassVar[Step] = staticmethod(rate_limit_step)

    def row(self, dt: float) -> tuple[float, ...]:
        return (self.rate * dt,)

    @property
    def gain(self) -> float:
        return 1.0
