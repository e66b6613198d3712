"""What every reference hands on: where a port is to be, sampled when asked."""

from __future__ import annotations

from abc import abstractmethod

import numpy as np

from dampen.component import Component

Array = np.ndarray


class Reference(Component):
    """Where a port is to be in trial `trial` at times `t`, the clock of the trial, which starts at 0."""

    @abstractmethod
    def sample(self, t: Array, trial: int) -> Array:
        """(times,) displacement or angle [m, rad]."""


def smooth_step(s: Array) -> Array:
    """10 s^3 - 15 s^4 + 6 s^5 from 0 to 1, held at 0 before and at 1 after: rate and acceleration are 0 at both ends."""
    s = np.clip(s, 0.0, 1.0)
    return np.asarray(s**3 * (10 + s * (6 * s - 15)))
