"""A string under tension with a payload at its end: the wave equation with a boundary that moves."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.plants.base import Damping, Field
from dampen.plants.deflection import Deflection
from dampen.plants.discretisation import Discretisation
from dampen.plants.discretised import DeflectedPlant
from dampen.plants.energies import MassAndStiffness
from dampen.plants.profile import Profile, along, check_profiles, sampled
from dampen.plants.spaces import FiniteDifference, Space, Spectral, degree
from dampen.port import Port


@dataclass(frozen=True)
class String(DeflectedPlant):
    """String under tension, fixed at x = 0, with a payload at its free end.

        rho w_tt - (T w_x)_x = f(x, t)      M w_tt + T w_x = force at x = L      w(0, t) = 0

    rho and T may vary along x (a finite-difference grid takes them at its nodes and middles), as T does in a hanging cable.
    Kelvin-Voigt damping acts on the tension's restoring force.

    One port, `tip_w` (force and displacement); field `w`. Defaults: a steel wire of 1 mm at 50 N. Source: Meirovitch,
    Fundamentals of Vibrations, 2001, chapter 8.
    """

    kind: ClassVar[str] = "string"
    has_grid: ClassVar[bool] = True

    mass_per_length: Annotated[Profile, Gt(0), Unit("kg/m"), Doc("mass per length rho")] = 0.0062
    length: Annotated[float, Gt(0), Unit("m"), Doc("length L")] = 1.0
    tip_mass: Annotated[float, Ge(0), Unit("kg"), Doc("payload mass M")] = 0.01
    tension: Annotated[Profile, Gt(0), Unit("N"), Doc("tension T")] = 50.0
    damping: Annotated[Damping, Doc("proportional damping")] = field(default_factory=Damping)
    initial: Annotated[Deflection, Doc("shape and rate at the start of trial 0")] = field(default_factory=Deflection)

    def check(self) -> None:
        check_profiles(self, self.length)

    @property
    def ports(self) -> tuple[Port, ...]:
        return (Port("tip_w", "w", self.length, "force"),)

    @property
    def fields(self) -> tuple[tuple[str, str], ...]:
        return (("w", "m"),)

    def space(self, count: int, grid: int | None) -> Space:
        if grid is not None:
            return FiniteDifference(self.length, grid)
        rho, tension = (sampled(p, self.length) for p in (self.mass_per_length, self.tension))
        return Spectral(self.length, degree(count, np.sqrt(rho / tension)))

    def in_space(self, space: Space) -> Discretisation:
        tip, rho = space.at(self.length), along(self.mass_per_length)
        mass = space.gram(0, 0, rho) + self.tip_mass * tip.T @ tip
        return Discretisation(
            energies=MassAndStiffness(mass, space.gram(1, 1, along(self.tension))),
            port_vectors=tip,
            ports=self.ports,
            fields=(Field("w", "m", space.values, rho, ((self.length, self.tip_mass),)),),
            damping=self.damping,
            space=space,
            rule=space.rule,
            breaks=space.breaks,
        )
