"""No disturbance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from dampen.disturbances.base import Array, Content, Disturbance
from dampen.port import Port


@dataclass(frozen=True)
class NoDisturbance(Disturbance):
    """Nothing shakes the structure but its initial state."""

    kind: ClassVar[str] = "none"

    def at_ports(self, trial: int, t: Array, ports: Sequence[Port]) -> Array:
        return np.zeros((len(t), len(ports)))

    def content(self, trial: int, duration: float, ports: Sequence[Port], length: float) -> Content:
        return Content((0.0,) * len(ports))

    def same_as(self, trial: int) -> int:
        return 0
