"""A plant of your own: two masses on springs, pushed and watched at the second one."""

from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh

import dampen


@dataclass(frozen=True)
class TwoMasses(dampen.Plant):
    """m q'' + K q = b F with K = k [[2, -1], [-1, 1]]; one port, no fields."""

    mass: float = 1.0
    stiffness: float = 100.0

    @property
    def ports(self) -> tuple[dampen.Port, ...]:
        return (dampen.Port("second", field="", x=1.0),)

    def modes(self, count: int) -> dampen.Modes:
        square, shapes = eigh(self.stiffness * np.array([[2.0, -1.0], [-1.0, 1.0]]), self.mass * np.eye(2))
        return dampen.Modes(omega=np.sqrt(square), b=shapes[1:], ports=self.ports, decay=0.01 * np.sqrt(square))
