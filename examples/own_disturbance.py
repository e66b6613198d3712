"""A disturbance of your own: a gust that comes and goes, a little stronger in each trial."""

from dataclasses import dataclass

import numpy as np

import dampen


@dataclass(frozen=True)
class Gust(dampen.Disturbance):
    """d(t) = strength (1 + growth j) (1 - cos(2 pi t / length)) / 2 for t < length, at every port."""

    strength: float = 0.5
    growth: float = 0.02
    length: float = 0.5

    def at_ports(self, trial: int, t: np.ndarray, site: dampen.Site) -> np.ndarray:
        gust = np.where(t < self.length, (1 - np.cos(2 * np.pi * t / self.length)) / 2, 0.0)
        return np.outer(self.strength * (1 + self.growth * trial) * gust, np.ones(len(site.ports)))
