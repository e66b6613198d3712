"""The inverse of a dead zone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Ge, Gt, Le, Unit
from typing_extensions import Doc

from dampen.stage import Array, Stage, Step


def dead_zone_inverse_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """u = v / m + right above zero, v / m + left below, 0 at zero."""
    if command > 0.0:
        return command / parameters[0] + parameters[1]
    if command < 0.0:
        return command / parameters[0] + parameters[2]
    return 0.0


@dataclass(frozen=True)
class DeadZoneInverse(Stage):
    """Jumps over the dead zone that it assumes: with exact estimates the dead zone behind it delivers the law's value.

        u = v / slope + right for v > 0, v / slope + left for v < 0, 0 for v = 0

    Wider estimates than the truth leave a jump at zero, which inside a continuous law acts like dry friction. Source: Tao and
    Kokotovic, Adaptive Control of Systems with Actuator and Sensor Nonlinearities, 1996, section 2.1.
    """

    slope: Annotated[float, Gt(0), Doc("assumed slope on both sides")] = 1.0
    right: Annotated[float, Ge(0), Unit("N"), Doc("assumed right end of the dead zone (N m at a torque port)")] = 0.1
    left: Annotated[float, Le(0), Unit("N"), Doc("assumed left end of the dead zone (N m at a torque port)")] = -0.1

    kind: ClassVar[str] = "dead-zone-inverse"
    step: ClassVar[Step] = staticmethod(dead_zone_inverse_step)

    def row(self, dt: float) -> tuple[float, ...]:
        return self.slope, self.right, self.left

    @property
    def gain(self) -> float:
        return 1 / self.slope

    @property
    def deviation(self) -> tuple[float, float]:
        return self.left, self.right
