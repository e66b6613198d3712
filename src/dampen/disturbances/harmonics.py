"""Sinusoids at the ports."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Ge, Unit
from typing_extensions import Doc

from dampen.disturbances.base import Array, Content, columns, in_dict
from dampen.disturbances.clock import Clocked, Trials
from dampen.disturbances.lines import check_lines, cosines
from dampen.port import Site


@dataclass(frozen=True)
class Harmonics(Clocked):
    """Sinusoids at ports, of the same frequencies and phases at each and of amplitudes of its own.

        d_p(t) = sum_k A_pk cos(2 pi f_k t + theta_k)

    A frequency of 0 is a constant force.
    """

    kind: ClassVar[str] = "harmonics"

    frequencies: Annotated[tuple[float, ...], Ge(0), Unit("Hz"), Doc("frequencies f_k")]
    force: Annotated[dict[str, tuple[float, ...]], Unit("N, N m"), Doc("for each port the amplitudes A_k, one a frequency")]
    phases: Annotated[tuple[float, ...], Unit("rad"), Doc("phases theta_k; left out, all 0")] = ()
    trials: Trials = "repeat"

    def check(self) -> None:
        check_lines(self.frequencies, self.phases, {f"force.{port}": given for port, given in self.force.items()})

    def ports_named(self) -> Mapping[str, str]:
        return in_dict("force", self.force)

    def at_ports(self, trial: int, t: Array, site: Site) -> Array:
        t = self.clock(trial, t, site)
        return columns(site, t, {port: cosines(self.frequencies, a, self.phases).at(t) for port, a in self.force.items()})

    def content(self, trial: int, site: Site) -> Content:
        heard = {port: np.array(self.frequencies)[np.array(a) != 0].max(initial=0.0) for port, a in self.force.items()}
        return Content(port_frequency=tuple(float(heard.get(port.name, 0.0)) for port in site.ports))
