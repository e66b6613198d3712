"""How a structure whose only motion is w(x, t) starts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from annotated_types import Unit
from typing_extensions import Doc

from dampen.component import Component, wrong
from dampen.plants.base import Array, Modes, polynomial
from dampen.port import Port

Coefficients = tuple[float, ...]


def slope(coefficients: Coefficients) -> Coefficients:
    """The coefficients of the derivative of c0 + c1 x + c2 x^2 + ..."""
    return tuple(k * c for k, c in enumerate(coefficients))[1:]


@dataclass(frozen=True)
class Deflection(Component):
    """Shape and rate of w at the start of trial 0, as polynomials c0 + c1 x + c2 x^2 + ... in x."""

    w: Annotated[Coefficients, Unit("m"), Doc("deflection w(x, 0), as coefficients of c0 + c1 x + ...")] = ()
    w_rate: Annotated[Coefficients, Unit("m/s"), Doc("rate w_t(x, 0), as coefficients")] = ()

    def check(self) -> None:
        if self.w and self.w[0] != 0:
            raise wrong("w", "start with 0, since w(0, t) = 0", self.w)

    def at_ports(self, ports: tuple[Port, ...]) -> tuple[float, ...]:
        """w, or its slope where a port sees phi, at every port."""
        seen = {"w": self.w, "phi": slope(self.w)}
        return tuple(float(polynomial(seen[port.field])(np.array([port.x]))[0]) for port in ports)

    def in_modes(self, modes: Modes) -> tuple[Array, Array]:
        """Modal coordinates and rates; with phi = w_x, where the structure has a field phi."""
        state = []
        for shape in (self.w, self.w_rate):
            part = modes.project("w", polynomial(shape))
            if any(field.name == "phi" for field in modes.fields):
                part = part + modes.project("phi", polynomial(slope(shape)))
            state.append(part)
        return state[0], state[1]
