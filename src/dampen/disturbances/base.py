"""What every disturbance hands on: forces at the ports and a distributed load, sampled when asked."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dampen.component import Component
from dampen.port import Port

Array = np.ndarray


@dataclass(frozen=True)
class Content:
    """The fastest and the shortest that a disturbance contains in one trial: what step, modes and quadrature must resolve.

    port_frequency: Hz, for each port.   load_frequency: Hz.   load_wave: m, the shortest wavelength (inf without a load).
    """

    port_frequency: tuple[float, ...]
    load_frequency: float = 0.0
    load_wave: float = np.inf


class Disturbance(Component):
    """Forces at the ports and a distributed load on one field. `t` is the clock of the trial, which starts at 0."""

    @abstractmethod
    def at_ports(self, trial: int, t: Array, ports: Sequence[Port]) -> Array:
        """(times, ports) forces and torques [N, N m]."""

    @abstractmethod
    def content(self, trial: int, duration: float, ports: Sequence[Port], length: float) -> Content:
        """What has to be resolved in this trial."""

    def load(self, trial: int, t: Array, x: Array) -> Array:
        """(times, points) distributed load on `load_field` [N/m]; only asked where `load_field` names a field."""
        raise NotImplementedError

    @property
    def load_field(self) -> str | None:
        """The field that the distributed load acts on; None without one."""
        return None

    def same_as(self, trial: int) -> int:
        """The first trial in which the disturbance was what it is in `trial`, so that it need not be sampled again."""
        return trial
