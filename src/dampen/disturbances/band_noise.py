"""Noise at the ports."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.disturbances.base import Array, Content, columns, in_dict
from dampen.disturbances.clock import Clocked, NoiseTrials
from dampen.disturbances.lines import check_band, noise
from dampen.port import Site


@dataclass(frozen=True)
class BandNoise(Clocked):
    """Noise between two frequencies, of stated RMS at each port, independent from port to port, the same for the same seed.

        d_p(t) = rms_p sqrt(2/n) sum_k cos(2 pi f_k t + theta_pk),    theta_pk uniform in [0, 2 pi)

    The n frequencies are the multiples of 1/T_b in the band: over every trial, band and RMS hold exactly. Noise that runs on
    (`trials = "continue"`) has frequencies closer together, drawn by chance, so that it never repeats: band exact, RMS in the
    long run. Source: Shinozuka and Deodatis, Appl. Mech. Rev. 44 (1991), 191-204 (spectral representation).
    """

    kind: ClassVar[str] = "band-noise"

    rms: Annotated[dict[str, float], Ge(0), Unit("N, N m"), Doc("for each port the root mean square")]
    low: Annotated[float, Ge(0), Unit("Hz"), Doc("lower edge of the band")]
    high: Annotated[float, Gt(0), Unit("Hz"), Doc("upper edge of the band")]
    seed: Annotated[int, Ge(0), Doc("seed of the random numbers")] = 0
    trials: NoiseTrials = "random"

    def check(self) -> None:
        check_band(self.low, self.high)

    def ports_named(self) -> Mapping[str, str]:
        return in_dict("rms", self.rms)

    def at_ports(self, trial: int, t: Array, site: Site) -> Array:
        t, drawn, endless = self.clock(trial, t, site), trial if self.trials == "random" else 0, self.trials == "continue"
        return columns(site, t, {
            port.name: noise(self.low, self.high, self.rms[port.name], site.duration, (self.seed, drawn, p), endless).at(t)
            for p, port in enumerate(site.ports) if port.name in self.rms
        })  # fmt: skip

    @property
    def by_chance(self) -> bool:
        return self.trials != "repeat" and any(self.rms.values())

    def content(self, trial: int, site: Site) -> Content:
        return Content(port_frequency=tuple(self.high if self.rms.get(port.name) else 0.0 for port in site.ports))
