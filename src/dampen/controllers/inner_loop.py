"""The inner loop of He et al. 2017: the adaptive barrier law at the ports."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, ClassVar, Literal

import numpy as np
from annotated_types import Ge, Gt, Le, Unit
from typing_extensions import Doc

from dampen.component import Component
from dampen.controllers.base import Array, Assumption, Controller, Memory, PortLaw, Setting, total
from dampen.controllers.scales import PortScale, scales, span
from dampen.port import Port
from dampen.stage import Stage, Step


@dataclass(frozen=True)
class AssumedBacklash(Component):
    """What the controller believes of the backlash in front of it; defaults are section V's true values."""

    slope: Annotated[float, Gt(0), Doc("slope m")] = 0.3
    right: Annotated[float, Ge(0), Unit("N"), Doc("right end of the gap B_r (N m at a torque port)")] = 0.1
    left: Annotated[float, Le(0), Unit("N"), Doc("left end of the gap B_l (N m at a torque port)")] = -0.2

    @property
    def width(self) -> float:
        """m (B_r - B_l): how far the law's value can be from the delivered force."""
        return self.slope * (self.right - self.left)


def flank_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """eta = command / m + B_l."""
    return command * parameters[0] + parameters[1]


@dataclass(frozen=True)
class FlankInverse(Stage):
    """Aims the actuator's input at the left flank of the assumed backlash: eta = command / m + B_l.

    With exact estimates the play then delivers command + d_b with d_b in [-m (B_r - B_l), 0], the paper's (4)-(5).
    """

    assumed: AssumedBacklash

    step: ClassVar[Step] = staticmethod(flank_step)

    def row(self, dt: float) -> tuple[float, ...]:
        return 1 / self.assumed.slope, self.assumed.left

    @property
    def gain(self) -> float:
        return 1 / self.assumed.slope

    @property
    def deviation(self) -> tuple[float, float]:
        return self.assumed.left, self.assumed.left


CHANNELS = {"force": ("alpha_4", "alpha_3", "alpha_2", "alpha_8"), "torque": ("alpha_7", "alpha_6", "alpha_5", "alpha_9")}


def channel(setting: Setting, kind: str) -> PortScale | None:
    """The scales of the first port of a channel; None where no actuator moves one."""
    return next((scale for scale in scales(setting) if scale.port.kind == kind), None)


@dataclass(frozen=True)
class InnerLoop(Controller):
    """The law within a trial; a subclass may add what it learns from trial to trial."""

    alpha_1: Annotated[float, Gt(0), Doc("gain against the distributed load, on its bound f_bar L")] = 1.0
    alpha_2: Annotated[float, Ge(1), Doc("gain on the bound of the force disturbance")] = 1.0
    alpha_3: Annotated[float, Gt(0), Unit("N m"), Doc("barrier gain of the force channel")] = 0.1
    alpha_4: Annotated[float, Gt(0), Unit("N s/m"), Doc("damping and learning gain of the force channel")] = 1.0
    alpha_5: Annotated[float, Ge(1), Doc("gain on the bound of the torque disturbance")] = 1.0
    alpha_6: Annotated[float, Gt(0), Unit("N m"), Doc("barrier gain of the torque channel")] = 0.1
    alpha_7: Annotated[float, Gt(0), Unit("N m s"), Doc("damping and learning gain of the torque channel")] = 1.0
    alpha_8: Annotated[float, Gt(0), Unit("N s/m"), Doc("observer gain of the force channel")] = 0.1
    alpha_9: Annotated[float, Gt(0), Unit("N m s"), Doc("observer gain of the torque channel; the paper's own value")] = 0.1
    barrier: Annotated[Literal["log", "tan", "none"], Doc("shape of the barrier; the paper's is log")] = "log"
    compensate: Annotated[
        bool, Doc("true: aim at the assumed backlash (the paper's analysis); false: the law drives the actuator")
    ] = True
    assumed_backlash: Annotated[AssumedBacklash, Doc("what the controller believes of the backlash")] = field(
        default_factory=AssumedBacklash
    )
    assumed_torque_backlash: Annotated[
        AssumedBacklash | None, Doc("the same at torque ports; left out: the same numbers, as in the paper")
    ] = None

    @property
    def barrier_shape(self) -> Literal["log", "tan", "none"]:
        return self.barrier

    @property
    def relies_on(self) -> tuple[Assumption, ...]:
        return ("bounds",)

    @property
    def needs_bounds(self) -> tuple[str, ...]:
        return ("f", "ports")

    def compensation(self, port: Port) -> tuple[Stage, ...]:
        return (FlankInverse(self.assumed_at(port)),) if self.compensate else ()

    def assumed_at(self, port: Port) -> AssumedBacklash:
        """What the controller believes of the backlash at a port."""
        return self.assumed_torque_backlash or self.assumed_backlash if port.kind == "torque" else self.assumed_backlash

    def search(self, setting: Setting) -> Mapping[str, str]:
        """The gains that act: of each channel that has an actuator, damping and barrier in units of the structure's scales,
        the factors on stated bounds where these are not zero. The paper asks for alpha_2, alpha_5 >= 1.

        Where several ports share a channel, the first of them has the say.
        """
        found: dict[str, str] = {}
        for kind, names in CHANNELS.items():
            scale = channel(setting, kind)
            if scale is None:
                continue
            damping, barrier, bound = names[:3]
            found[damping] = span(scale.impedance, 2e-3, 20)
            if self.barrier != "none" and np.isfinite(scale.room):
                found[barrier] = span(scale.stiffness * scale.room**2, 2e-3, 20)
            if setting.bounds.get(scale.port.name, 0.0) > 0:
                found[bound] = "1:10:log"
            if kind == "force" and setting.bounds.get("f", 0.0) > 0:
                found["alpha_1"] = "0.001:10:log"
        return found

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        return total(InnerLoop.terms(self, memory, setting))  # without what a subclass learns

    def terms(self, memory: Memory, setting: Setting) -> dict[str, PortLaw]:
        """Damping; the observer, which within a trial acts as damping; Sgn against the stated bounds; the barrier."""
        nothing = np.zeros((setting.steps, len(setting.ports)))
        return {
            "damping": PortLaw(nothing, damping=setting.by_kind(self.alpha_4, self.alpha_7)),
            "observer": PortLaw(nothing, damping=setting.by_kind(self.alpha_8, self.alpha_9)),
            "Sgn on bounds": PortLaw(nothing, coulomb=nothing + self._robust(setting)),
            "barrier": PortLaw(nothing, barrier=setting.by_kind(self.alpha_3, self.alpha_6) * (self.barrier != "none")),
        }

    def _robust(self, setting: Setting) -> Array:
        """The constant part of the switching gain, (ports,)."""
        d_bar = np.array([setting.bounds[port.name] for port in setting.ports])
        f_bar = setting.bounds["f"] * setting.length
        return setting.by_kind(2 * self.alpha_1 * f_bar, 0.0) + setting.by_kind(self.alpha_2, self.alpha_5) * d_bar
