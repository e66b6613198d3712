"""Shaking of the base."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Ge, Unit
from typing_extensions import Doc

from dampen.disturbances.base import Array, Content
from dampen.disturbances.clock import Clocked, NoiseTrials
from dampen.disturbances.lines import check_band, check_lines, cosines, noise
from dampen.port import Site


@dataclass(frozen=True)
class BaseShaking(Clocked):
    """The base is accelerated across the structure: sinusoids, noise between two frequencies, or both.

        a(t) = sum_k A_k cos(2 pi f_k t + theta_k) + rms sqrt(2/n) sum_m cos(2 pi g_m t + theta_m)

    Motion is then that relative to the base: every mass feels the force -a(t) per mass, payload included. The noise is that
    of :class:`BandNoise`; a recorded acceleration is a :class:`Recorded` with its `base`.
    """

    kind: ClassVar[str] = "base-shaking"

    frequencies: Annotated[tuple[float, ...], Ge(0), Unit("Hz"), Doc("frequencies f_k of the sinusoids")] = ()
    amplitudes: Annotated[tuple[float, ...], Unit("m/s^2"), Doc("amplitudes A_k, one a frequency")] = ()
    phases: Annotated[tuple[float, ...], Unit("rad"), Doc("phases theta_k; left out, all 0")] = ()
    rms: Annotated[float, Ge(0), Unit("m/s^2"), Doc("root mean square of the noise")] = 0.0
    low: Annotated[float, Ge(0), Unit("Hz"), Doc("lower edge of its band")] = 0.0
    high: Annotated[float, Ge(0), Unit("Hz"), Doc("upper edge of its band")] = 0.0
    seed: Annotated[int, Ge(0), Doc("seed of its random numbers")] = 0
    trials: NoiseTrials = "repeat"

    def check(self) -> None:
        check_lines(self.frequencies, self.phases, {"amplitudes": self.amplitudes})
        if self.rms:
            check_band(self.low, self.high)

    def base_acceleration(self, trial: int, t: Array, site: Site) -> Array:
        t, drawn, endless = self.clock(trial, t, site), trial if self.trials == "random" else 0, self.trials == "continue"
        acceleration = cosines(self.frequencies, self.amplitudes, self.phases).at(t)
        if self.rms:
            acceleration = acceleration + noise(self.low, self.high, self.rms, site.duration, (self.seed, drawn), endless).at(t)
        return acceleration

    @property
    def by_chance(self) -> bool:
        return self.trials != "repeat" and self.rms > 0

    def content(self, trial: int, site: Site) -> Content:
        heard = [f for f, amplitude in zip(self.frequencies, self.amplitudes, strict=True) if amplitude]
        return Content(load_frequency=max([*heard, self.high if self.rms else 0.0]))
