"""Learning point by point: what is learned for one step and port depends on the trial at that step and port alone."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from dataclasses import replace
from typing import Any, ClassVar

import numpy as np

from dampen.controllers.base import Array, Controller, Memory, PortLaw, Setting, Trial

Relearn = Callable[[Any, Any, Any, Any, Any, Any], tuple[Any, Any]]


class PointwiseLearning(Controller):
    """Adds a learned feedforward and a learned coulomb term to the law of the class that it is mixed into.

    `relearn(feedforward, coulomb, error, v, command, row) -> (feedforward, coulomb)` makes both memories of the next trial
    from those of the last one and from what was seen at the same step and port; `error` is that at the end of the step. It is
    written in NumPy's arithmetic: a single run calls it once a trial with whole arrays, (steps, ports), and a batch of runs
    compiles the very same function and calls it with numbers. `row[i]` is the i-th number of `learning_row`, by port.
    """

    memories: ClassVar[tuple[str, str]] = ("feedforward", "coulomb")
    relearn: ClassVar[Relearn]

    @abstractmethod
    def learning_row(self, setting: Setting) -> Array:
        """(numbers, ports) parameters that `relearn` reads, in its order."""

    def begin(self, setting: Setting) -> Memory:
        nothing = np.zeros((setting.steps, len(setting.ports)))
        return dict.fromkeys(self.memories, nothing)

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        fixed = super().law(memory, setting)  # type: ignore[safe-super]  # that of the class it is mixed into
        feedforward, coulomb = (memory[name] for name in self.memories)
        return replace(fixed, feedforward=fixed.feedforward + feedforward, coulomb=fixed.coulomb + coulomb)

    def learn(self, memory: Memory, trial: Trial, setting: Setting) -> Memory:
        feedforward, coulomb = (memory[name] for name in self.memories)
        row = self.learning_row(setting)
        learned = type(self).relearn(feedforward, coulomb, trial.error[1:], trial.v, trial.command, row)
        return dict(zip(self.memories, learned, strict=True))
