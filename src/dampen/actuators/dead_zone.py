"""Dead zone: small commands deliver nothing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Ge, Gt, Le, Unit
from typing_extensions import Doc

from dampen.stage import Array, Stage, Step


def dead_zone_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """B = m max(u - right, 0) + m min(u - left, 0)."""
    slope, right, left = parameters[0], parameters[1], parameters[2]
    return slope * (max(command - right, 0.0) + min(command - left, 0.0))


@dataclass(frozen=True)
class DeadZone(Stage):
    """Delivers nothing between `left` and `right`, and rises with slope `slope` beyond.

    B = slope (command - right) above right, slope (command - left) below left, 0 in between

    Source: Tao and Kokotovic, Adaptive Control of Systems with Actuator and Sensor Nonlinearities, 1996, section 2.1.
    """

    slope: Annotated[float, Gt(0), Doc("slope on both sides")] = 1.0
    right: Annotated[float, Ge(0), Unit("N"), Doc("right end of the dead zone (N m at a torque port)")] = 0.1
    left: Annotated[float, Le(0), Unit("N"), Doc("left end of the dead zone (N m at a torque port)")] = -0.1

    kind: ClassVar[str] = "dead-zone"
    step: ClassVar[Step] = staticmethod(dead_zone_step)

    def row(self, dt: float) -> tuple[float, ...]:
        return self.slope, self.right, self.left

    @property
    def gain(self) -> float:
        return self.slope

    @property
    def deviation(self) -> tuple[float, float]:
        return -self.slope * self.right, -self.slope * self.left
