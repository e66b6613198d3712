"""One link of a flexible robot: an elastic arm on a motor's hub."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, ClassVar

from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.plants.base import Damping
from dampen.plants.beams import Lump, SlenderBeam, SlenderPlant
from dampen.plants.deflection import Deflection
from dampen.plants.profile import Profile, check_profiles
from dampen.port import Port


@dataclass(frozen=True)
class FlexibleArm(SlenderPlant):
    """Euler-Bernoulli arm that turns with its hub, with a payload at its tip.

        rho w_tt + (EI w_xx)_xx = f(x, t)                               w(0, t) = 0
        J_h w_xtt - EI w_xx     = torque  at x = 0                      J w_xtt + EI w_xx     = 0      at x = L
                                                                        M w_tt  - (EI w_xx)_x = force  at x = L

    w is the total displacement, hub rotation included: w = x theta + elastic, with the hub's angle theta = w_x(0, t), small.
    The lowest mode is the rigid rotation, of zero frequency. rho and EI may vary along x.

    Ports `hub` (torque and angle at x = 0) and `tip_w` (force and displacement), fields `w` and `phi` = w_x.
    Source: Bellezza, Lanari, Ulivi, Exact modeling of the flexible slewing link, IEEE ICRA 1990.
    """

    kind: ClassVar[str] = "flexible-arm"

    mass_per_length: Annotated[Profile, Gt(0), Unit("kg/m"), Doc("mass per length rho")] = 0.47
    length: Annotated[float, Gt(0), Unit("m"), Doc("length L")] = 1.0
    hub_inertia: Annotated[float, Ge(0), Unit("kg m^2"), Doc("hub inertia J_h, about x = 0")] = 0.05
    tip_mass: Annotated[float, Ge(0), Unit("kg"), Doc("payload mass M")] = 0.1
    bending_stiffness: Annotated[Profile, Gt(0), Unit("N m^2"), Doc("bending stiffness EI")] = 4.2
    tip_inertia: Annotated[float, Ge(0), Unit("kg m^2"), Doc("payload inertia J")] = 1e-4
    damping: Annotated[Damping, Doc("proportional damping; `viscous` brakes the rotation too")] = field(default_factory=Damping)
    initial: Annotated[Deflection, Doc("shape and rate at the start of trial 0")] = field(default_factory=Deflection)

    def check(self) -> None:
        check_profiles(self, self.length)

    @property
    def ports(self) -> tuple[Port, ...]:
        return (Port("hub", "phi", 0.0, "torque"), Port("tip_w", "w", self.length, "force"))

    @property
    def beam(self) -> SlenderBeam:
        return SlenderBeam(
            length=self.length,
            pinned=True,
            mass_per_length=self.mass_per_length,
            bending_stiffness=self.bending_stiffness,
            tension=0.0,
            lumps=(Lump(0.0, 0.0, self.hub_inertia), Lump(self.length, self.tip_mass, self.tip_inertia)),
            ports=self.ports,
            damping=self.damping,
        )
