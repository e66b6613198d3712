"""The three families of disturbances of He et al. 2017, (26)-(28)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.disturbances.base import Array, Content, Disturbance
from dampen.port import Site


@dataclass(frozen=True)
class HarmonicFamilies(Disturbance):
    """Three harmonics each at the force ports, at the torque ports and along the structure, faster from trial to trial.

        force   d_w   = A_w   [cos(a t) + cos(2 a t) + cos(3 a t)]              a = (j + 1) 2 pi f_0 in trial j
        torque  d_phi = A_phi [cos(2 a t) + cos(4 a t) + cos(6 a t)]
        load    f     = A_f   [sin(b x t) + sin(2 b x t) + sin(3 b x t)]         b = (j + 1) kappa

    With `frozen_at = j0` every trial has the frequencies of trial j0. Source: He et al. 2017, (26)-(28), whose values are the
    defaults (f_0 = 1/2 Hz makes a = (j + 1) pi; the scan lost A_f: 1/20 follows from the stated bound 0.15 = 3 A_f).
    """

    kind: ClassVar[str] = "he2017"

    force_amplitude: Annotated[float, Ge(0), Unit("N"), Doc("amplitude A_w of each harmonic at force ports")] = 0.1
    torque_amplitude: Annotated[float, Ge(0), Unit("N m"), Doc("amplitude A_phi of each harmonic at torque ports")] = 0.1
    load_amplitude: Annotated[float, Ge(0), Unit("N/m"), Doc("amplitude A_f of each harmonic of the load")] = 0.05
    base_frequency: Annotated[float, Gt(0), Unit("Hz"), Doc("frequency f_0 of the slowest harmonic in trial 0")] = 0.5
    wavenumber_rate: Annotated[float, Ge(0), Unit("rad/(m s)"), Doc("rate kappa at which the load's wavenumber grows")] = np.pi
    frozen_at: Annotated[int | None, Ge(0), Doc("trial whose frequencies every trial has; left out, they grow")] = None

    def at_ports(self, trial: int, t: Array, site: Site) -> Array:
        a = self._growth(trial) * 2 * np.pi * self.base_frequency * t
        force = self.force_amplitude * (np.cos(a) + np.cos(2 * a) + np.cos(3 * a))
        torque = self.torque_amplitude * (np.cos(2 * a) + np.cos(4 * a) + np.cos(6 * a))
        return np.column_stack([force if port.kind == "force" else torque for port in site.ports])

    def load(self, trial: int, t: Array, x: Array, site: Site) -> Array:
        s, c = sine_and_cosine(self._growth(trial) * self.wavenumber_rate * t, x)
        return (2 * self.load_amplitude) * s * c * (1 + 2 * c)  # sin + sin 2 + sin 3 = sin 2 (1 + 2 cos)

    @property
    def load_field(self) -> str | None:
        return "w" if self.load_amplitude > 0 and self.wavenumber_rate > 0 else None

    def content(self, trial: int, site: Site) -> Content:
        growth = self._growth(trial)
        harmonic = {"force": 3 * (self.force_amplitude > 0), "torque": 6 * (self.torque_amplitude > 0)}
        fastest = 3 * growth * self.wavenumber_rate / (2 * np.pi) if self.load_field else 0.0
        return Content(
            port_frequency=tuple(growth * self.base_frequency * harmonic[port.kind] for port in site.ports),
            load_frequency=fastest * site.span,
            load_wave=1 / (fastest * site.duration) if fastest else np.inf,
        )

    def same_as(self, trial: int) -> int:
        return trial if self.frozen_at is None else 0

    def held(self) -> HarmonicFamilies:
        return replace(self, frozen_at=0) if self.frozen_at is None else self

    def _growth(self, trial: int) -> int:
        return 1 + (trial if self.frozen_at is None else self.frozen_at)


def sine_and_cosine(rate: Array, x: Array) -> tuple[Array, Array]:
    """sin and cos of rate[i] x[j]; evenly spaced rates go by the addition theorem, with few sines and many products."""
    block = int(np.sqrt(len(rate)))
    even = len(rate) > 2 and np.allclose(np.diff(rate), rate[1] - rate[0], rtol=1e-9, atol=0)
    if not even:
        angle = np.multiply.outer(rate, x)
        return np.sin(angle), np.cos(angle)
    coarse, fine = np.outer(rate[::block], x)[:, None], np.outer(rate[:block] - rate[0], x)
    sc, cc, sf, cf = np.sin(coarse), np.cos(coarse), np.sin(fine), np.cos(fine)
    shape = (-1, len(x))
    return (sc * cf + cc * sf).reshape(shape)[: len(rate)], (cc * cf - sc * sf).reshape(shape)[: len(rate)]
