"""The ideal actuator: delivers what it is told."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from dampen.stage import Array, Stage, Step


def ideal_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """B = command."""
    return command


@dataclass(frozen=True)
class Ideal(Stage):
    """Delivers the command as it is."""

    kind: ClassVar[str] = "ideal"
    step: ClassVar[Step] = staticmethod(ideal_step)

    def row(self, dt: float) -> tuple[float, ...]:
        return ()

    @property
    def gain(self) -> float:
        return 1.0

    @property
    def deviation(self) -> tuple[float, float]:
        return 0.0, 0.0
