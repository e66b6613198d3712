"""Backlash: the play between a command and the force that is delivered."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Ge, Gt, Le, Unit
from typing_extensions import Doc

from dampen.stage import Array, Stage, Step


def backlash_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """B_new = min(max(B_old, m (eta - B_r)), m (eta - B_l))."""
    slope, right, left = parameters[0], parameters[1], parameters[2]
    delivered = min(max(state[0], slope * (command - right)), slope * (command - left))
    new_state[0] = delivered
    return delivered


@dataclass(frozen=True)
class Backlash(Stage):
    """Rate-independent play of width `right - left`, with slope `slope`.

        B_new = min(max(B_old, slope (command - right)), slope (command - left))

    The delivered force moves only when the command has crossed the gap. B = 0 before the first trial; the state is carried
    from trial to trial. Source: He et al. 2017, equations (1)-(5); defaults are section V's.
    """

    slope: Annotated[float, Gt(0), Doc("slope m of both flanks")] = 0.3
    right: Annotated[float, Ge(0), Unit("N"), Doc("right end of the gap B_r (N m at a torque port)")] = 0.1
    left: Annotated[float, Le(0), Unit("N"), Doc("left end of the gap B_l (N m at a torque port)")] = -0.2

    kind: ClassVar[str] = "backlash"
    states: ClassVar[int] = 1
    step: ClassVar[Step] = staticmethod(backlash_step)

    def row(self, dt: float) -> tuple[float, ...]:
        return self.slope, self.right, self.left

    @property
    def gain(self) -> float:
        return self.slope

    @property
    def deviation(self) -> tuple[float, float]:
        return -self.slope * self.right, -self.slope * self.left
