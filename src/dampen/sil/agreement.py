"""How far a run with a controller in the loop is from the run that the scenario's own law makes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dampen.controllers.none import NoControl
from dampen.simulation.bench import Bench
from dampen.simulation.scenario import Scenario
from dampen.simulation.trials import trials

Array = np.ndarray


@dataclass
class Agreement:
    """The sampled run goes along, trial by trial.

    command, displacement: (ports,) largest difference so far.   largest_command: (ports,) of the sampled run, to compare with.
    trials: how many have been compared.   parted: (trial, sample) of the first command that differs; None: all are equal, bit
    for bit.
    """

    scenario: Scenario
    bench: Bench
    trials: int = 0
    parted: tuple[int, int] | None = None
    command: Array = field(init=False)
    displacement: Array = field(init=False)
    largest_command: Array = field(init=False)
    along: Iterator[dict[str, Any]] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.command, self.displacement, self.largest_command = (np.zeros(len(self.scenario.ports)) for _ in range(3))
        self.along = trials(self.scenario, self.bench)

    @staticmethod
    def possible(scenario: Scenario) -> bool:
        """Whether the scenario has a law to be compared with."""
        return not isinstance(scenario.controller, NoControl)

    def add(self, record: Mapping[str, Any]) -> None:
        """Compare a finished trial."""
        own = next(self.along)
        off = np.abs(record["issued"] - own["issued"])
        differ = np.flatnonzero((off > 0).any(axis=1))
        if self.parted is None and len(differ):
            self.parted = self.trials, int(differ[0])
        self.command = np.maximum(self.command, off.max(axis=0))
        self.displacement = np.maximum(self.displacement, np.abs(record["y"] - own["y"]).max(axis=0))
        self.largest_command = np.maximum(self.largest_command, np.abs(own["issued"]).max(axis=0))
        self.trials += 1
