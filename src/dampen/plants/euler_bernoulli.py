"""A slender beam: bending alone, without shear or rotary inertia."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, ClassVar, Literal

from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.component import wrong
from dampen.plants.base import Damping
from dampen.plants.beams import Lump, SlenderBeam, SlenderPlant
from dampen.plants.deflection import Deflection
from dampen.plants.profile import Profile, check_profiles
from dampen.port import Port


@dataclass(frozen=True)
class EulerBernoulliBeam(SlenderPlant):
    """Euler-Bernoulli beam, clamped or pinned at its base, with a tip payload and axial tension.

        rho w_tt + (EI w_xx)_xx - (T w_x)_x = f(x, t)                   w(0, t) = 0
        M w_tt - (EI w_xx)_x + T w_x = force   at x = L                 clamped: w_x(0, t) = 0
        J w_xtt + EI w_xx            = torque  at x = L                 pinned:  EI w_xx(0, t) = 0

    rho and EI may vary along x. Without tension a pinned beam turns freely: its lowest mode is rigid, of zero frequency.
    Kelvin-Voigt damping acts on the tension's restoring force too.

    Ports `tip_w` (force and displacement) and `tip_phi` (torque and slope), fields `w` and `phi` = w_x. Defaults: a steel
    ruler of 30 mm x 2 mm x 1 m. Source: Meirovitch, Fundamentals of Vibrations, 2001, chapter 8.
    """

    kind: ClassVar[str] = "euler-bernoulli"

    mass_per_length: Annotated[Profile, Gt(0), Unit("kg/m"), Doc("mass per length rho")] = 0.47
    length: Annotated[float, Gt(0), Unit("m"), Doc("length L")] = 1.0
    tip_mass: Annotated[float, Ge(0), Unit("kg"), Doc("payload mass M")] = 0.1
    bending_stiffness: Annotated[Profile, Gt(0), Unit("N m^2"), Doc("bending stiffness EI")] = 4.2
    tip_inertia: Annotated[float, Ge(0), Unit("kg m^2"), Doc("payload inertia J")] = 1e-4
    tension: Annotated[float, Ge(0), Unit("N"), Doc("axial tension T")] = 0.0
    base: Annotated[Literal["clamped", "pinned"], Doc("how it is held at x = 0")] = "clamped"
    damping: Annotated[Damping, Doc("proportional damping")] = field(default_factory=Damping)
    initial: Annotated[Deflection, Doc("shape and rate at the start of trial 0")] = field(default_factory=Deflection)

    def check(self) -> None:
        check_profiles(self, self.length)
        if self.base == "clamped" and any(self.initial.w[:2]):
            raise wrong("initial.w", "start with 0, 0, since the beam is clamped at x = 0", self.initial.w)

    @property
    def ports(self) -> tuple[Port, ...]:
        return (Port("tip_w", "w", self.length, "force"), Port("tip_phi", "phi", self.length, "torque"))

    @property
    def beam(self) -> SlenderBeam:
        return SlenderBeam(
            length=self.length,
            pinned=self.base == "pinned",
            mass_per_length=self.mass_per_length,
            bending_stiffness=self.bending_stiffness,
            tension=self.tension,
            lumps=(Lump(self.length, self.tip_mass, self.tip_inertia),),
            ports=self.ports,
            damping=self.damping,
        )
