"""Trials of the sampled controller as recorded by the simulation: what the C controller must do when it reads the same."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice

import numpy as np

from dampen.simulation.bench import Bench
from dampen.simulation.digital_side import readings_of
from dampen.simulation.passes import passes
from dampen.simulation.scenario import Scenario

Array = np.ndarray


@dataclass(frozen=True)
class Recorded:
    """One trial. readings (samples + 1, ports): the last is the one after the trial; rates and commands (samples, ports)."""

    readings: Array
    rates: Array
    commands: Array


def record(scenario: Scenario, bench: Bench, trials: int | None = None) -> Iterator[Recorded]:
    """The first trials of a run, all by default."""
    for done in islice(passes(scenario, bench), trials):
        sampler = done.sampler
        readings = readings_of(sampler.error, done.setting.reference)
        yield Recorded(readings, sampler.rate.copy(), sampler.issued[sampler.ahead :].copy())
