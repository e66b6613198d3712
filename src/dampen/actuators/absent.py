"""No actuator: the port is there, but nobody can push."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from dampen.stage import Array, Stage, Step


def absent_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """B = 0."""
    return 0.0


@dataclass(frozen=True)
class Absent(Stage):
    """Delivers nothing, whatever the command: a port where there is only a sensor, or whose actuator has failed."""

    kind: ClassVar[str] = "absent"
    step: ClassVar[Step] = staticmethod(absent_step)

    def row(self, dt: float) -> tuple[float, ...]:
        return ()

    @property
    def gain(self) -> float:
        return 0.0

    @property
    def deviation(self) -> tuple[float, float]:
        return 0.0, 0.0

    def feedthrough(self, dt: float) -> float:
        return 1.0
