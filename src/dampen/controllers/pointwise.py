"""Learning point by point: what is learned for one step and port depends on the trial at that step and port alone."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np

from dampen.controllers.base import Array, Controller, Memory, PortLaw, Setting, Trial, total

Relearn = Callable[[Any, Any, Any, Any, Any, Any], tuple[Any, Any]]


class PointwiseLearning(Controller):
    """Adds a learned feedforward and a learned coulomb term to the law of the class that it is mixed into.

    `relearn(feedforward, coulomb, error, v, command, row) -> (feedforward, coulomb)` makes both memories of the next trial
    from those of the last one and from what was seen at the same step and port; `error` is that at the end of the step. It is
    written in NumPy's arithmetic: a single run calls it once a trial with whole arrays, (steps, ports), and a batch of runs
    compiles the very same function and calls it with numbers. `row[i]` is the i-th number of `learning_row`, by port.

    `learned_terms` are the names of what the memories add, where a law is taken apart; one that the law has already is added to.
    """

    memories: ClassVar[tuple[str, str]] = ("feedforward", "coulomb")
    learned_terms: ClassVar[tuple[str, str]] = ("learned feedforward", "learned Sgn")
    relearn: ClassVar[Relearn]

    @abstractmethod
    def learning_row(self, setting: Setting) -> Array:
        """(numbers, ports) parameters that `relearn` reads, in its order."""

    def begin(self, setting: Setting) -> Memory:
        nothing = np.zeros((setting.steps, len(setting.ports)))
        return dict.fromkeys(self.memories, nothing)

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        fixed = super().law(memory, setting)  # type: ignore[safe-super]  # that of the class it is mixed into
        return total({"fixed": fixed, **self._learned(memory)})

    def terms(self, memory: Memory, setting: Setting) -> dict[str, PortLaw]:
        """The terms of the law that it is mixed into, and what both memories add."""
        terms = dict(super().terms(self.begin(setting), setting))
        for name, term in self._learned(memory).items():
            terms[name] = terms[name] + term if name in terms else term
        return terms

    def _learned(self, memory: Memory) -> dict[str, PortLaw]:
        feedforward, coulomb = (memory[name] for name in self.memories)
        learned = PortLaw(feedforward), PortLaw(np.zeros_like(coulomb), coulomb=coulomb)
        return dict(zip(self.learned_terms, learned, strict=True))

    def learn(self, memory: Memory, trial: Trial, setting: Setting) -> Memory:
        feedforward, coulomb = (memory[name] for name in self.memories)
        row = self.learning_row(setting)
        learned = type(self).relearn(feedforward, coulomb, trial.error[1:], trial.v, trial.command, row)
        return dict(zip(self.memories, learned, strict=True))
