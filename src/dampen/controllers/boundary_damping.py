"""Damping and stiffness at the ports."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, ClassVar, Literal

from annotated_types import Ge, Unit
from typing_extensions import Doc

from dampen.controllers.base import Controller, Memory, PortLaw, Setting, named
from dampen.controllers.feedforward import feedforward
from dampen.controllers.scales import feedback, scales
from dampen.port import Port
from dampen.signals.base import Signal


@dataclass(frozen=True)
class BoundaryDamping(Controller):
    """PD control at each port, with an optional feedforward and barrier.

        u = feedforward - damping e' - stiffness e - barrier V'(e),     e = y - reference

    The classical boundary control of a beam: with damping alone it only takes energy. Source: Luo, Guo and Morgul, Stability
    and Stabilization of Infinite Dimensional Systems, 1999, ch. 4.
    """

    kind: ClassVar[str] = "boundary-damping"

    damping: Annotated[dict[str, float], Ge(0), Unit("N s/m, N m s"), Doc("by port, damping")] = field(default_factory=dict)
    stiffness: Annotated[dict[str, float], Ge(0), Unit("N/m, N m/rad"), Doc("by port, stiffness")] = field(default_factory=dict)
    feedforward: Annotated[dict[str, float | Signal], Unit("N, N m"), Doc("by port, feedforward, a number or a signal")] = field(
        default_factory=dict
    )
    barrier: Annotated[Literal["log", "tan", "none"], Doc("shape of the barrier")] = "none"
    barrier_gain: Annotated[dict[str, float], Ge(0), Unit("N m"), Doc("by port, gain of the barrier")] = field(
        default_factory=dict
    )

    @property
    def barrier_shape(self) -> Literal["log", "tan", "none"]:
        return self.barrier

    def ports_named(self) -> Mapping[str, str]:
        return named(damping=self.damping, stiffness=self.stiffness, feedforward=self.feedforward, barrier_gain=self.barrier_gain)

    def has_barrier(self, port: Port) -> bool:
        return self.barrier != "none" and self.barrier_gain.get(port.name, 0.0) > 0

    def search(self, setting: Setting) -> Mapping[str, str]:
        """Damping and stiffness of every port with an actuator, in units of its impedance and static stiffness."""
        return feedback(scales(setting))

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        return PortLaw(
            feedforward=feedforward(self.feedforward, setting),
            damping=setting.by_port(self.damping),
            stiffness=setting.by_port(self.stiffness),
            barrier=setting.by_port(self.barrier_gain) * (self.barrier != "none"),
        )
