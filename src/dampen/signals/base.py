"""What every signal hands on: a signal on the clock of the trial."""

from __future__ import annotations

from abc import abstractmethod

import numpy as np

from dampen.component import ArgumentError, own_name
from dampen.family import Family

Array = np.ndarray


class Signal(Family):
    """A wanted displacement, a limit that moves, a feedforward: a function of time."""

    @abstractmethod
    def sample(self, t: Array, trial: int) -> Array:
        """(times,) values at the times `t` of a trial."""


def sampled(given: float | Signal, t: Array, trial: int) -> Array:
    """(times,) values of a number or a signal. Raises ArgumentError for a signal that gives others."""
    if not isinstance(given, Signal):
        return np.full(len(t), float(given))
    values = np.asarray(given.sample(t, trial), float)
    if values.shape != t.shape:
        raise ArgumentError(f"{own_name(given)}.sample must give values of shape {t.shape}, but gives {values.shape}.")
    return values


def smooth_step(s: Array) -> Array:
    """10 s^3 - 15 s^4 + 6 s^5 from 0 to 1, held at 0 before and at 1 after: rate and acceleration are 0 at both ends."""
    s = np.clip(s, 0.0, 1.0)
    return np.asarray(s**3 * (10 + s * (6 * s - 15)))
