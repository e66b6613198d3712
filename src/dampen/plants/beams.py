"""What beams without shear have in common: their energies in a basis with continuous slope."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from functools import partial

import numpy as np

from dampen.plants.base import Constant, Damping, Field
from dampen.plants.discretisation import Discretisation
from dampen.plants.discretised import DeflectedPlant
from dampen.plants.eigen import power_of_two
from dampen.plants.energies import Roots
from dampen.plants.profile import Profile, along, in_units, sampled
from dampen.plants.spaces import Bending, degree, resolved
from dampen.port import Port


@dataclass(frozen=True)
class Lump:
    """A rigid body on the beam at x: mass [kg] against w, inertia [kg m^2] against the slope."""

    x: float
    mass: float = 0.0
    inertia: float = 0.0


@dataclass(frozen=True, kw_only=True)
class SlenderBeam:
    """rho w_tt + (EI w_xx)_xx - (T w_x)_x = f on [0, length], w(0, t) = 0, and w_x(0, t) = 0 unless `pinned`.

    Lumps and ports are anywhere; a port on the field `w` is a force, one on `phi` a torque, which sees the slope.
    """

    length: float
    pinned: bool
    mass_per_length: Profile
    bending_stiffness: Profile
    tension: float
    lumps: tuple[Lump, ...]
    ports: tuple[Port, ...]
    damping: Damping

    def in_space(self, space: Bending) -> Discretisation:
        """The beam by the roots of mass and stiffness: no power of the frequency ratio is lost."""
        masses = tuple((lump.x, lump.mass) for lump in self.lumps)
        inertias = tuple((lump.x, lump.inertia) for lump in self.lumps)
        return Discretisation(
            energies=self._energies(space),
            port_vectors=np.vstack([space.at(p.x, int(p.field == "phi")) for p in self.ports]),
            ports=self.ports,
            fields=(
                Field("w", "m", space.values, along(self.mass_per_length), masses),
                Field("phi", "rad", partial(space.values, derivative=1), Constant(0.0), inertias),
            ),
            damping=self.damping,
            space=space,
            rule=space.rule,
            breaks=space.breaks,
        )

    def space(self, count: int) -> Bending:
        """A degree for waves along the beam, and for the bending layers of width sqrt(EI/T) at the ends of a taut one."""
        rho, ei = (sampled(p, self.length) for p in (self.mass_per_length, self.bending_stiffness))
        layers = resolved(4 * float(self.tension * self.length**2 / ei.min()) ** 0.25)
        return Bending(self.length, degree(count, (rho / ei) ** 0.25) + layers, self.pinned)

    def _energies(self, space: Bending) -> Roots:
        unit = power_of_two(float(sampled(self.mass_per_length, self.length).max()) * self.length)
        mass = [space.root(0, in_units(along(self.mass_per_length), unit))]
        for lump in self.lumps:
            mass += [np.sqrt(lump.mass / unit) * space.at(lump.x), np.sqrt(lump.inertia / unit) * space.at(lump.x, 1)]
        stiffness = [space.root(2, in_units(along(self.bending_stiffness), unit))]
        if self.tension:
            stiffness.append(space.root(1, Constant(self.tension / unit)))
        return Roots(np.vstack(mass), np.vstack(stiffness), unit)


class SlenderPlant(DeflectedPlant):
    """A plant that is a slender beam: needs `ports` and `beam`."""

    @property
    @abstractmethod
    def beam(self) -> SlenderBeam:
        """The beam that it is."""

    @property
    def fields(self) -> tuple[tuple[str, str], ...]:
        return (("w", "m"), ("phi", "rad"))

    def space(self, count: int, grid: int | None) -> Bending:
        return self.beam.space(count)

    def in_space(self, space: Bending) -> Discretisation:
        return self.beam.in_space(space)
