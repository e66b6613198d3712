"""The trial axis: trial after trial through the kernel, the controller learning in between."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from dampen.component import ArgumentError, own_name
from dampen.controllers.base import Controller, PortLaw, Setting, Trial
from dampen.own import blame
from dampen.simulation.bench import Bench
from dampen.simulation.digital import Sampler
from dampen.simulation.digital_side import begin_again, idle, prepare, sampler_of
from dampen.simulation.kernel import Inputs, Record
from dampen.simulation.memory import after, begun, lacking
from dampen.simulation.pieces import check_sampled
from dampen.simulation.records import empty_record, port_records
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import of_trial, setting_of

Array = np.ndarray


@dataclass(frozen=True)
class Pass:
    """One trial that went through the kernel: what it was given, what it left, how many steps it did, and the controller's
    memory after it. The arrays are used again for the next trial."""

    trial: int
    setting: Setting
    inputs: Inputs
    record: Record
    ports: Any
    sampler: Sampler
    memory: Mapping[str, Array]
    done: int


def passes(scenario: Scenario, bench: Bench, compile: bool = True) -> Iterator[Pass]:
    """The trials of a scenario, one after the other."""
    kernel, classes = bench.kernel(scenario, compile)
    chains = [scenario.chain(p) for p in range(len(scenario.ports))]
    setting, controller, every = setting_of(scenario, bench=bench, compile=compile), scenario.controller, scenario.output.every
    sampler = sampler_of(scenario, setting) if scenario.sampled else idle(len(chains))
    check_sampled(controller, setting)
    memory = begun(scenario, setting)
    record = empty_record(scenario.steps, len(chains), bench.modes.count, every)
    for j in range(scenario.task.trials):
        if j == 0 or scenario.task.start == "reset":
            modal, (ports, stages) = bench.modal_record(j), port_records(chains, bench.step, classes)
            begin_again(sampler)
        setting = of_trial(setting, scenario, j)
        law = law_of(scenario, memory, setting)
        if scenario.sampled:
            sampler = prepare(sampler, scenario, setting, law, j)
            ports.soft = 0.0
        else:
            ports.damping, ports.stiffness, ports.barrier = law.damping, law.stiffness, law.barrier
        inputs = bench.inputs(scenario, j, law)
        with np.errstate(all="ignore"):  # as compiled: a motion that leaves all bounds ends the run by being no number
            done = kernel(modal, bench.step, inputs, sampler, ports, stages, every, record)
        memory = after(controller, memory, seen(j, scenario, record, sampler), setting, done == scenario.steps)
        yield Pass(j, setting, inputs, record, ports, sampler, memory, done)


def law_of(scenario: Scenario, memory: Mapping[str, Array], setting: Setting) -> PortLaw:
    """The controller's law for the coming trial, checked."""
    controller = scenario.controller
    try:
        with blame(controller, "law"):
            law = controller.law(memory, setting)
    except ArgumentError as error:
        if type(controller).begin is not Controller.begin or not isinstance(error.__cause__, KeyError):
            raise
        raise ArgumentError(f"{error.lines[0].rstrip('.')}: it {lacking(controller, 'begin')}.") from None
    check_law(controller, law, setting)
    check_monotone(scenario, law)
    return law


def seen(trial: int, scenario: Scenario, record: Record, sampler: Sampler) -> Trial:
    """The trial as the controller measured it: exactly, or through its samples."""
    if not scenario.sampled:
        return Trial(trial, record.y.copy(), record.v.copy(), record.command.copy())
    return Trial(trial, sampler.error.copy(), sampler.rate.copy(), sampler.issued[sampler.ahead :].copy())


def check_law(controller: Controller, law: PortLaw, setting: Setting) -> None:
    """The closure has one solution only if nothing in the law pushes the wrong way."""
    ports, whose = len(setting.ports), f"{own_name(controller)}.law"
    for name in ("feedforward", "coulomb", "damping", "stiffness", "barrier"):
        value = getattr(law, name)
        shape = (setting.steps, ports) if name in ("feedforward", "coulomb") else (ports,)
        if np.shape(value) != shape:
            raise ArgumentError(f"{whose} must give `{name}` of shape {shape}, but gives {np.shape(value)}.")
        if not np.all(np.isfinite(value)):
            raise ArgumentError(f"{whose} must give a finite `{name}`, but does not.")
        if name != "feedforward" and not np.all(value >= 0):
            raise ArgumentError(f"{whose} must give `{name}` >= 0, but the least is {np.min(value):g}.")


def check_monotone(scenario: Scenario, law: PortLaw) -> None:
    """Inside a continuous law every stage must be monotone; a held command goes through any."""
    if scenario.sampled:
        return
    for p, port in enumerate(scenario.ports):
        held = not (np.any(law.coulomb[:, p]) or law.damping[p] or law.stiffness[p] or law.barrier[p])
        for stage in scenario.chain(p):
            if not (held or stage.monotone):
                raise ArgumentError(
                    f"Argument `actuator.{port}` has a {type(stage).__name__} whose output can fall as its command rises: inside "
                    'a continuous law that has no unique solution; use `numerics.mode` = "sampled", or feedforward alone.'
                )
