"""A blow."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.component import ArgumentError, wrong
from dampen.disturbances.base import Array, Content, Disturbance, columns, in_dict
from dampen.port import Site


@dataclass(frozen=True)
class Impulse(Disturbance):
    """A half-sine pulse at ports, or at a place x along the structure; in every trial, or in one.

        F(t) = I pi / (2 d) sin(pi (t - t_0) / d)    for t_0 < t < t_0 + d,    so that int F dt = I

    Sampled in the middle of n steps a pulse, its impulse is met to within 1/n^2 of it.
    """

    kind: ClassVar[str] = "impulse"

    duration: Annotated[float, Gt(0), Unit("s"), Doc("length d of the pulse")]
    impulse: Annotated[dict[str, float], Unit("N s, N m s"), Doc("for each port the impulse I")] = field(default_factory=dict)
    blow: Annotated[float, Unit("N s"), Doc("impulse I of a blow along the structure, at `x`")] = 0.0
    x: Annotated[float | None, Ge(0), Unit("m"), Doc("place of that blow")] = None
    field: Annotated[str, Doc("field that it acts on")] = "w"
    at: Annotated[float, Ge(0), Unit("s"), Doc("time t_0 in the trial at which the pulse begins")] = 0.0
    trial: Annotated[int | None, Ge(0), Doc("trial in which it comes; left out, in every trial")] = None

    def check(self) -> None:
        if self.blow and self.x is None:
            raise ArgumentError("Argument `x` must be given: the place of the `blow`.")

    def ports_named(self) -> Mapping[str, str]:
        return in_dict("impulse", self.impulse)

    def at_ports(self, trial: int, t: Array, site: Site) -> Array:
        pulse = self._pulse(trial, t)
        return columns(site, t, {port: impulse * pulse for port, impulse in self.impulse.items()})

    @property
    def point_field(self) -> str | None:
        return self.field if self.blow else None

    def point_load(self, trial: int, t: Array, site: Site) -> tuple[Array, Array]:
        return np.full(len(t), self.x), self.blow * self._pulse(trial, t)

    def content(self, trial: int, site: Site) -> Content:
        if self.blow and self.x is not None and self.x > site.span:
            raise wrong("disturbance.x", f"be <= {site.span:g} m, the length of the structure", self.x)
        frequency = 1 / self.duration if self.trial in (None, trial) else 0.0
        at_ports = tuple(frequency if self.impulse.get(port.name) else 0.0 for port in site.ports)
        return Content(port_frequency=at_ports, load_frequency=frequency if self.blow else 0.0)

    def same_as(self, trial: int) -> int:
        if self.trial is None or trial == self.trial:
            return 0 if self.trial is None else trial
        return 1 if self.trial == 0 else 0

    def _pulse(self, trial: int, t: Array) -> Array:
        """(times,) force for an impulse of 1."""
        phase = (t - self.at) / self.duration
        struck = (phase > 0) & (phase < 1) & (self.trial in (None, trial))
        return np.where(struck, np.pi / (2 * self.duration) * np.sin(np.pi * phase), 0.0)
