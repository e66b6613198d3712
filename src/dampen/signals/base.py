"""What every signal hands on: a signal on the clock of the trial."""

from __future__ import annotations

from abc import abstractmethod

import numpy as np

from dampen.component import Component

Array = np.ndarray


class Signal(Component):
    """A wanted displacement, a limit that moves, a feedforward: a function of time."""

    @abstractmethod
    def sample(self, t: Array, trial: int) -> Array:
        """(times,) values at the times `t` of a trial."""
