"""The paper's plant: a clamped Timoshenko beam with a payload at its tip."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.component import Component, wrong
from dampen.plants.base import Array, Damping, Field, Modes, polynomial
from dampen.plants.discretisation import Discretisation
from dampen.plants.discretised import DiscretisedPlant
from dampen.plants.energies import MassAndStiffness
from dampen.plants.profile import Profile, along, check_profiles, sampled
from dampen.plants.shapes import Part
from dampen.plants.spaces import FiniteDifference, Space, Spectral, degree
from dampen.port import Port


@dataclass(frozen=True)
class BeamState(Component):
    """Shapes and rates of a beam at the start of trial 0, as polynomials c0 + c1 x + c2 x^2 + ... in x."""

    w: Annotated[tuple[float, ...], Unit("m"), Doc("deflection w(x, 0), as coefficients of c0 + c1 x + ...")] = ()
    phi: Annotated[tuple[float, ...], Unit("rad"), Doc("rotation phi(x, 0), as coefficients")] = ()
    w_rate: Annotated[tuple[float, ...], Unit("m/s"), Doc("rate w_t(x, 0), as coefficients")] = ()
    phi_rate: Annotated[tuple[float, ...], Unit("rad/s"), Doc("rate phi_t(x, 0), as coefficients")] = ()

    def check(self) -> None:
        for name in ("w", "phi"):
            shape = getattr(self, name)
            if shape and shape[0] != 0:
                raise wrong(name, "start with 0, since the beam is clamped at x = 0", shape)


@dataclass(frozen=True)
class TimoshenkoBeam(DiscretisedPlant):
    """Clamped Timoshenko beam with a tip payload.

        I_rho phi_tt - EI phi_xx + K (phi - w_x) = 0            J phi_tt + EI phi_x   = torque at x = L
        rho   w_tt   + K (phi_x - w_xx)          = f(x, t)      M w_tt - K (phi - w_x) = force  at x = L
        w(0, t) = phi(0, t) = 0

    rho, I_rho, EI and K may vary along x (a finite-difference grid takes them at its nodes and middles).

    Ports `tip_w` (force and displacement) and `tip_phi` (torque and rotation), fields `w` and `phi`. Defaults are Table I
    of He et al., IEEE Trans. Syst., Man, Cybern.: Syst., 2017, doi 10.1109/TSMC.2017.2692529, equations (6)-(11).
    """

    kind: ClassVar[str] = "timoshenko"
    has_grid: ClassVar[bool] = True

    mass_per_length: Annotated[Profile, Gt(0), Unit("kg/m"), Doc("mass per length rho")] = 1.0
    length: Annotated[float, Gt(0), Unit("m"), Doc("length L")] = 1.0
    tip_mass: Annotated[float, Ge(0), Unit("kg"), Doc("payload mass M")] = 0.1
    bending_stiffness: Annotated[Profile, Gt(0), Unit("N m^2"), Doc("bending stiffness EI")] = 35.0
    rotary_inertia: Annotated[Profile, Gt(0), Unit("kg m"), Doc("rotary inertia per length I_rho")] = 2.0
    tip_inertia: Annotated[float, Ge(0), Unit("kg m^2"), Doc("payload inertia J")] = 0.1
    shear_stiffness: Annotated[Profile, Gt(0), Unit("N"), Doc("shear stiffness K = kAG")] = 15.0
    damping: Annotated[Damping, Doc("proportional damping")] = field(default_factory=Damping)
    initial: Annotated[BeamState, Doc("shapes and rates at the start of trial 0")] = field(default_factory=BeamState)

    def check(self) -> None:
        check_profiles(self, self.length)

    @property
    def ports(self) -> tuple[Port, ...]:
        return (Port("tip_w", "w", self.length, "force"), Port("tip_phi", "phi", self.length, "torque"))

    @property
    def fields(self) -> tuple[tuple[str, str], ...]:
        return (("w", "m"), ("phi", "rad"))

    def initial_ports(self) -> tuple[float, ...]:
        tip = np.array([self.length])
        return tuple(float(polynomial(c)(tip)[0]) for c in (self.initial.w, self.initial.phi))

    def initial_state(self, modes: Modes) -> tuple[Array, Array]:
        start = self.initial
        q = modes.project("w", polynomial(start.w)) + modes.project("phi", polynomial(start.phi))
        rate = modes.project("w", polynomial(start.w_rate)) + modes.project("phi", polynomial(start.phi_rate))
        return q, rate

    def space(self, count: int, grid: int | None) -> Space:
        if grid is not None:
            return FiniteDifference(self.length, grid)
        rho, inertia, ei, k = (
            sampled(p, self.length)
            for p in (self.mass_per_length, self.rotary_inertia, self.bending_stiffness, self.shear_stiffness)
        )
        return Spectral(self.length, degree(count, np.sqrt(rho / k), np.sqrt(inertia / ei)))

    def in_space(self, space: Space) -> Discretisation:
        size, tip = space.size, space.at(self.length)[0]
        w, phi = slice(0, size), slice(size, 2 * size)
        port_vectors = np.zeros((2, 2 * size))
        port_vectors[0, w] = port_vectors[1, phi] = tip
        lumps = (((self.length, self.tip_mass),), ((self.length, self.tip_inertia),))
        return Discretisation(
            energies=self._energies(space, tip),
            port_vectors=port_vectors,
            ports=self.ports,
            fields=(
                Field("w", "m", Part(space.values, w, 2 * size), along(self.mass_per_length), lumps[0]),
                Field("phi", "rad", Part(space.values, phi, 2 * size), along(self.rotary_inertia), lumps[1]),
            ),
            damping=self.damping,
            space=space,
            rule=space.rule,
            breaks=space.breaks,
        )

    def _energies(self, space: Space, tip: Array) -> MassAndStiffness:
        """Mass and stiffness of (w, phi): kinetic energy, and EI phi_x^2/2 + K (w_x - phi)^2/2, integrated."""
        ei, k = along(self.bending_stiffness), along(self.shear_stiffness)
        nothing, at_tip, shear = np.zeros((space.size, space.size)), np.outer(tip, tip), space.gram(1, 0, k)
        mass_w = space.gram(0, 0, along(self.mass_per_length)) + self.tip_mass * at_tip
        mass_phi = space.gram(0, 0, along(self.rotary_inertia)) + self.tip_inertia * at_tip
        mass = np.block([[mass_w, nothing], [nothing, mass_phi]])
        stiffness = np.block([[space.gram(1, 1, k), -shear], [-shear.T, space.gram(1, 1, ei) + space.gram(0, 0, k)]])
        return MassAndStiffness(mass, stiffness)
