"""What every disturbance hands on: forces at the ports, loads along the structure, shaking of its base; sampled when asked."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from dampen.family import Family
from dampen.port import Site

Array = np.ndarray


@dataclass(frozen=True)
class Content:
    """The fastest and the shortest that a disturbance contains in one trial: what step, modes and quadrature must resolve.

    port_frequency: Hz, for each port.   load_frequency: Hz, of loads and base.   load_wave: m, the shortest wavelength (inf
    without a distributed load).
    """

    port_frequency: tuple[float, ...] = ()
    load_frequency: float = 0.0
    load_wave: float = np.inf


class Disturbance(Family):
    """What shakes the structure in trial `trial` at times `t`, the clock of the trial, which starts at 0.

    A disturbance overrides what it has: forces at ports, one distributed load, one concentrated load that may travel, an
    acceleration of the base. A sum has several `parts`.
    """

    @property
    def parts(self) -> tuple[Disturbance, ...]:
        """What it is the sum of."""
        return (self,)

    def ports_named(self) -> Mapping[str, str]:
        """The ports that its parameters name, each by its place there, such as "force.tip_w": the plant must have them."""
        return {}

    def content(self, trial: int, site: Site) -> Content:
        """What has to be resolved in this trial; by default nothing at ports, and waves of a sixteenth of the structure."""
        return Content(load_wave=site.span / 16 if self.load_field else np.inf)

    def at_ports(self, trial: int, t: Array, site: Site) -> Array | None:
        """(times, ports) forces and torques [N, N m]; None: none."""
        return None

    @property
    def load_field(self) -> str | None:
        """The field that the distributed load acts on; None without one."""
        return None

    def load(self, trial: int, t: Array, x: Array, site: Site) -> Array:
        """(times, points) distributed load on `load_field` [N/m]; only asked where `load_field` names a field."""
        raise NotImplementedError

    @property
    def point_field(self) -> str | None:
        """The field that the concentrated load acts on; None without one."""
        return None

    def point_load(self, trial: int, t: Array, site: Site) -> tuple[Array, Array]:
        """Place x [m] and force [N] of the concentrated load, (times,) each; only asked where `point_field` names a field."""
        raise NotImplementedError

    def base_acceleration(self, trial: int, t: Array, site: Site) -> Array | None:
        """(times,) acceleration of the base across the structure [m/s^2]; None: at rest."""
        return None

    def same_as(self, trial: int) -> int:
        """The first trial in which the disturbance was what it is in `trial`, so that it need not be sampled again."""
        return trial

    @property
    def by_chance(self) -> bool:
        """Whether trials differ by chance: noise that is drawn anew in each, or runs on and never repeats."""
        return False

    def held(self) -> Disturbance:
        """The disturbance without what changes its frequencies from trial to trial: those of trial 0 stay."""
        return self


def in_dict(parameter: str, ports: Iterable[str]) -> dict[str, str]:
    """What `ports_named` says of a parameter that is a table with ports as keys."""
    return {f"{parameter}.{port}": port for port in ports}


def columns(site: Site, t: Array, forces: Mapping[str, Array]) -> Array:
    """(times, ports) forces at all ports, from the (times,) forces of those that have one."""
    return np.column_stack([forces.get(port.name, np.zeros(len(t))) for port in site.ports])
