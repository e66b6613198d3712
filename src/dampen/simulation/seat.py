"""The seat for commands from outside: a scenario whose law is whatever is handed in, sample by sample."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, ClassVar

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
    inverts: Annotated[bool, Doc("what is handed in is for the actuators already: no compensation")] = False

    def compensation(self, port: Port) -> tuple[Stage, ...]:
        return () if self.inverts else self.instead_of.compensation(port)

    def row(self, setting: Setting) -> Array:
        return np.zeros(len(setting.ports))


def seated(scenario: Scenario, period: float | None = None, inverts: bool = False) -> Scenario:
    """The scenario with a seat where its law was.

    A sampled scenario keeps its sensors, delay and limits. A continuous one gets exact sensors, read at every time step. With
    `period` [s] commands come at these intervals instead. `inverts`: they are what goes to the actuators: no stage of the
    scenario's compensation is left, and limits of commands are the outside's own affair.
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
    if inverts:
        sampling = replace(sampling, command_limit={})
    numerics, compensation = replace(scenario.numerics, mode="sampled"), {} if inverts else scenario.compensation
    controller = Outside(scenario.controller, inverts)
    return replace(scenario, controller=controller, sampling=sampling, numerics=numerics, compensation=compensation)
