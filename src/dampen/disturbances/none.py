"""No disturbance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from dampen.disturbances.base import Disturbance


@dataclass(frozen=True)
class NoDisturbance(Disturbance):
    """Nothing shakes the structure but its initial state."""

    kind: ClassVar[str] = "none"

    def same_as(self, trial: int) -> int:
        return 0
