"""A stage: one scalar step from a command towards the delivered force. Actuators and compensations are chains of stages."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from typing import ClassVar

import numpy as np

from dampen.component import Component

Array = np.ndarray
Step = Callable[[float, Array, Array, Array], float]


class Stage(Component):
    """A rate-independent scalar map whose output does not decrease with its input.

    `step(command, state, parameters, new_state) -> output` is plain Python over scalars; it reads `state`, never changes it,
    and writes the state that the command leads to into `new_state`. The library compiles that very function for the kernel,
    and calls it several times with trial commands before one is accepted.
    """

    states: ClassVar[int] = 0
    step: ClassVar[Step]

    @abstractmethod
    def row(self) -> tuple[float, ...]:
        """The parameters that `step` reads, in its order."""

    @property
    @abstractmethod
    def gain(self) -> float:
        """Slope of the output against the input in full motion: the linear part, of which the rest is a bounded deviation."""
