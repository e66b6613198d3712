"""What beams without shear have in common: their modes in a basis with continuous slope."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from dampen.plants.base import Array, Constant, Damping, Field, Modes
from dampen.plants.eigen import solve_roots, static_compliance
from dampen.plants.profile import Profile, along, sampled
from dampen.plants.spaces import Bending, degree
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

    def modes(self, count: int) -> Modes:
        """The lowest `count` modes, from the roots of mass and stiffness: no power of the frequency ratio is lost."""
        space = self._space(count)
        mass_root, stiffness_root = self._roots(space)
        omega, vectors = solve_roots(mass_root, stiffness_root, count)
        port_vectors = np.vstack([space.values(np.array([p.x]), int(p.field == "phi")) for p in self.ports])
        masses = tuple((lump.x, lump.mass) for lump in self.lumps)
        inertias = tuple((lump.x, lump.inertia) for lump in self.lumps)
        modes = Modes(
            omega=omega,
            b=np.ascontiguousarray(port_vectors @ vectors),
            decay=self.damping.decay(omega),
            ports=self.ports,
            fields=(
                Field("w", "m", lambda x: space.values(x) @ vectors, along(self.mass_per_length), masses),
                Field("phi", "rad", lambda x: space.values(x, 1) @ vectors, Constant(0.0), inertias),
            ),
            compliance=static_compliance(stiffness_root.T @ stiffness_root, port_vectors.T) if omega[0] > 0 else None,
            rule=space.rule,
            breaks=space.breaks,
        )
        return replace(modes, translation=modes.project("w", Constant(1.0)))

    def _space(self, count: int) -> Bending:
        """A degree for waves along the beam, and for the bending layers of width sqrt(EI/T) at the ends of a taut one."""
        rho, ei = (sampled(p, self.length) for p in (self.mass_per_length, self.bending_stiffness))
        layers = int(np.ceil(4 * (self.tension * self.length**2 / ei.min()) ** 0.25))
        return Bending(self.length, degree(count, (rho / ei) ** 0.25) + layers, self.pinned)

    def _roots(self, space: Bending) -> tuple[Array, Array]:
        """A and B, mass = A^T A and stiffness = B^T B."""
        mass = [space.root(0, along(self.mass_per_length))]
        for lump in self.lumps:
            at = np.array([lump.x])
            mass += [np.sqrt(lump.mass) * space.values(at), np.sqrt(lump.inertia) * space.values(at, 1)]
        stiffness = [space.root(2, along(self.bending_stiffness))]
        if self.tension:
            stiffness.append(space.root(1, Constant(self.tension)))
        return np.vstack(mass), np.vstack(stiffness)
