"""Saturation: the delivered force has a largest and a smallest value."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Gt, Unit
from typing_extensions import Doc

from dampen.component import check_order
from dampen.stage import Array, Stage, Step


def saturation_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """B = min(max(m u, low), high)."""
    return min(max(parameters[0] * command, parameters[1]), parameters[2])


@dataclass(frozen=True)
class Saturation(Stage):
    """Delivers slope times the command, within limits.

    B = min(max(slope command, low), high)
    """

    slope: Annotated[float, Gt(0), Doc("slope between the limits")] = 1.0
    low: Annotated[float, Unit("N"), Doc("smallest force that is delivered (N m at a torque port)")] = -1.0
    high: Annotated[float, Unit("N"), Doc("largest force that is delivered (N m at a torque port)")] = 1.0

    kind: ClassVar[str] = "saturation"
    step: ClassVar[Step] = staticmethod(saturation_step)

    def check(self) -> None:
        check_order("low", self.low, "high", self.high)

    def row(self, dt: float) -> tuple[float, ...]:
        return self.slope, self.low, self.high

    @property
    def gain(self) -> float:
        return self.slope

    @property
    def ends(self) -> tuple[float, float]:
        return self.low, self.high
