"""A stage: one scalar step from a command towards the delivered force. Actuators and compensations are chains of stages."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Callable
from typing import ClassVar

import numpy as np

from dampen.family import Family

Array = np.ndarray
Step = Callable[[float, Array, Array, Array], float]


class Stage(Family):
    """A scalar map from a command, held over a step, to what is delivered over that step.

    `step(command, state, parameters, new_state) -> output` is plain Python over scalars; it reads `state`, never changes it,
    and writes the state that the command leads to into `new_state`. The library compiles that very function for the kernel,
    and calls it several times with trial commands before one is accepted.

    A stage whose output does not decrease with its input may stand inside a continuous law, whatever its memory: play and
    saturation, and also a lag, as long as it delivers the mean of its output over the step. One that is not monotone may only
    follow a held command.
    """

    states: ClassVar[int] = 0
    step: ClassVar[Step]

    @abstractmethod
    def row(self, dt: float) -> tuple[float, ...]:
        """The parameters that `step` reads, in its order, for steps of `dt` seconds."""

    @property
    @abstractmethod
    def gain(self) -> float:
        """Slope of the output against the input in full, slow motion: the linear part, the rest is a bounded deviation."""

    @property
    def deviation(self) -> tuple[float, float]:
        """The least and the largest that `output - gain * input` can be, whatever the motion; infinite unless it is known."""
        return -math.inf, math.inf

    @property
    def ends(self) -> tuple[float, float]:
        """The least and the largest that it delivers, however large the input; infinite where it has no limit."""
        return -math.inf, math.inf

    @property
    def lag_time(self) -> float:
        """Time constant tau [s] with which the output follows the input, as gain / (1 + tau s); 0: at once."""
        return 0.0

    @property
    def is_linear(self) -> bool:
        """Whether the output is linear in the input, but for a constant: nothing else deviates, unless it lags."""
        return self.lag_time > 0 or self.deviation[0] == self.deviation[1]

    def feedthrough(self, dt: float) -> float:
        """Slope of the output against the input within one step: less than `gain` where the actuator lags. Must be > 0."""
        return self.gain

    def start(self) -> tuple[float, ...]:
        """The state before the first trial."""
        return (0.0,) * self.states

    @property
    def monotone(self) -> bool:
        """Whether the output never decreases with the input."""
        return True
