"""The seat that a policy takes: a scenario whose law is whatever is handed in, sample by sample."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Annotated, Any, ClassVar

import numpy as np
from typing_extensions import Doc

from dampen.component import is_number, wrong
from dampen.controllers.base import Array, Controller, SampledFeedback, SampledStep, Setting
from dampen.port import Port
from dampen.simulation.sampling import Sampling
from dampen.simulation.scenario import Scenario
from dampen.stage import Stage


def handed_in(sample, state, parameters, command):  # type: ignore[no-untyped-def]
    """The command is what was handed in."""
    for p in range(len(command)):
        command[p] = parameters[p]


@dataclass(frozen=True)
class Outside(SampledFeedback):
    """Commands from outside, held from sample to sample; what stands between the law's value and the actuator stays there."""

    kind: ClassVar[str] = "outside"
    step: ClassVar[SampledStep] = staticmethod(handed_in)

    instead_of: Annotated[Controller, Doc("whose place is taken, and whose compensation of the actuators stays")]

    def compensation(self, port: Port) -> tuple[Stage, ...]:
        return self.instead_of.compensation(port)

    def row(self, setting: Setting) -> Array:
        return np.zeros(len(setting.ports))


def seated(scenario: Scenario, period: float | None = None) -> Scenario:
    """The scenario with a seat for a policy where its law was.

    A sampled scenario keeps its sensors, delay and limits. A continuous one gets exact sensors, read at every time step. With
    `period` [s] the policy acts at these intervals instead.
    """
    given, step = scenario.sampling, scenario.numerics.step
    sampling = given if scenario.sampled else replace(
        Sampling(), period=step, rate=given.rate, filter_time=given.filter_time, observer_bandwidth=given.observer_bandwidth,
        command_limit=given.command_limit,
    )  # fmt: skip
    if period is not None:
        if not (is_number(period) and period > 0):
            raise wrong("period", "be a number of seconds > 0", period)
        sampling = replace(sampling, period=float(period))
    numerics = replace(scenario.numerics, mode="sampled")
    return replace(scenario, controller=Outside(scenario.controller), sampling=sampling, numerics=numerics)


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
