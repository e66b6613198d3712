"""The inverse of a backlash."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Ge, Gt, Le, Unit
from typing_extensions import Doc

from dampen.component import check_order
from dampen.stage import Array, Stage, Step


def backlash_inverse_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """u = v / m + right if v has risen, v / m + left if it has fallen, the last u if it is what it was."""
    out = state[1]
    if command > state[0]:
        out = command / parameters[0] + parameters[1]
    elif command < state[0]:
        out = command / parameters[0] + parameters[2]
    new_state[0], new_state[1] = command, out
    return out


@dataclass(frozen=True)
class BacklashInverse(Stage):
    """Jumps over the gap that it assumes whenever the law's value turns round: the exact right inverse of the play.

        u = v / slope + right while v rises, v / slope + left while v falls, the last u while v stays

    With exact estimates the backlash behind it delivers v, from the start on (v = u = 0 before the first trial). Source: Tao
    and Kokotovic, Adaptive Control of Systems with Actuator and Sensor Nonlinearities, 1996, section 2.3.
    """

    slope: Annotated[float, Gt(0), Doc("assumed slope of both flanks")] = 0.3
    right: Annotated[float, Ge(0), Unit("N"), Doc("assumed right end of the gap (N m at a torque port)")] = 0.1
    left: Annotated[float, Le(0), Unit("N"), Doc("assumed left end of the gap (N m at a torque port)")] = -0.2

    kind: ClassVar[str] = "backlash-inverse"
    states: ClassVar[int] = 2
    step: ClassVar[Step] = staticmethod(backlash_inverse_step)

    def check(self) -> None:
        check_order("left", self.left, "right", self.right)

    def row(self, dt: float) -> tuple[float, ...]:
        return self.slope, self.right, self.left

    @property
    def gain(self) -> float:
        return 1 / self.slope

    @property
    def deviation(self) -> tuple[float, float]:
        return self.left, self.right
