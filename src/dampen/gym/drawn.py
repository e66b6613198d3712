"""A scenario drawn anew: the same experiment under other seeds."""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any

import numpy as np

from dampen.simulation.scenario import Scenario


def drawn(scenario: Scenario, random: np.random.Generator) -> Scenario:
    """The scenario with other seeds, of the sensors' noise, of resets that miss, and of disturbances."""
    sampling, task = scenario.sampling, scenario.task
    if any(sampling.noise.values()):
        sampling = replace(sampling, seed=_seed(random))
    if any(task.reset_error.values()):
        task = replace(task, seed=_seed(random))
    disturbance = _reseeded(scenario.disturbance, random)
    if (sampling, task, disturbance) == (scenario.sampling, scenario.task, scenario.disturbance):
        return scenario
    return replace(scenario, sampling=sampling, task=task, disturbance=disturbance)


def _reseeded(part: Any, random: np.random.Generator) -> Any:
    """A disturbance, or a list of them, with other seeds where it has any."""
    if isinstance(part, tuple):
        return tuple(_reseeded(one, random) for one in part)
    names = {f.name for f in fields(part)}
    if "seed" in names:
        return replace(part, seed=_seed(random))
    return replace(part, terms=_reseeded(part.terms, random)) if "terms" in names else part


def _seed(random: np.random.Generator) -> int:
    return int(random.integers(2**31))
