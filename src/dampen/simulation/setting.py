"""What a controller is told of its task, trial by trial."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from dampen.controllers.base import PortLaw, Setting
from dampen.simulation.bench import Bench
from dampen.simulation.digital import Sampler
from dampen.simulation.digital_side import idle, linear, prepare, sampler_of
from dampen.simulation.kernel import Inputs
from dampen.simulation.memory import begun
from dampen.simulation.records import empty_record, modal_record, port_records
from dampen.simulation.scenario import Scenario

Array = np.ndarray


def setting_of(scenario: Scenario, bench: Bench | None = None, like: Setting | None = None, compile: bool = True) -> Setting:
    """The setting of trial 0; without a bench, model and response have to be found out first where they are asked for.

    like:    a setting of another scenario with the same task, whose reference and limits then serve here too.
    compile: False finds the response in plain Python.
    """
    (steps, dt), unlimited = scenario.law_grid, np.empty((0, len(scenario.ports)))
    found: list[Bench] = [bench] if bench else []

    def the_bench() -> Bench:
        if not found:
            found.append(Bench(scenario))
        return found[0]

    setting = Setting(
        ports=scenario.plant.ports,
        steps=steps,
        dt=dt,
        length=scenario.plant.span,
        reference=unlimited,
        low=unlimited,
        high=unlimited,
        bounds=scenario.bounds,
        gains=np.array([math.prod(stage.gain for stage in scenario.chain(p)) for p in range(len(scenario.ports))]),
        lags=tuple(tuple(s.lag_time for s in scenario.chain(p) if s.lag_time > 0) for p in range(len(scenario.ports))),
        sampled=scenario.sampled,
        delay=scenario.sampling.delay if scenario.sampled else 0.0,
        model=lambda: the_bench().modes,
        response=once(lambda: response(scenario, the_bench(), compile)),
    )
    if like is not None:
        return replace(setting, reference=like.reference, low=like.low, high=like.high)
    return of_trial(setting, scenario, 0)


def of_trial(setting: Setting, scenario: Scenario, trial: int) -> Setting:
    """The setting with the reference and the limits of another trial."""
    if scenario.task.steady and len(setting.reference):
        return setting
    t = np.arange(setting.steps + 1) * setting.dt
    reference = scenario.task.references(scenario.ports, t, trial)
    low, high = scenario.task.limits(scenario.ports, t, trial)
    return replace(setting, reference=reference, low=low - reference, high=high - reference)


def once(compute: Callable[[], Array]) -> Callable[[], Array]:
    """`compute`, whose value is kept."""
    kept: list[Array] = []

    def get() -> Array:
        if not kept:
            kept.append(compute())
        return kept[0]

    return get


def response(scenario: Scenario, bench: Bench, compile: bool = True) -> Array:
    """(intervals, ports out, ports in): tracking errors after a unit of feedforward in the law's first interval.

    The structure from rest, nothing shaking it, under the law's own damping and stiffness, every chain of stages replaced by
    its slope in full motion, sensors and commands without noise, steps and limits: the linear experiment, run by the kernel
    itself.
    """
    setting = setting_of(scenario, bench=bench)
    law = scenario.controller.law(begun(scenario, setting), setting)
    kernel, classes = bench.kernel(scenario, compile)
    ports, n, gain = len(setting.ports), scenario.steps, setting.gains
    each = round(setting.dt / scenario.numerics.step)
    answers = np.zeros((setting.steps, ports, ports))
    for r in range(ports):
        records, stages = port_records([()] * ports, bench.step, classes)
        pulse = np.zeros((setting.steps, ports))
        pulse[0, r] = gain[r]
        records.damping, records.stiffness = gain * law.damping, gain * law.stiffness
        scaled = PortLaw(pulse, damping=gain * law.damping, stiffness=gain * law.stiffness)
        sampler: Sampler = idle(ports)
        if scenario.sampled:
            exact = linear(scenario, setting, gain)
            sampler = prepare(sampler_of(exact, setting), exact, setting, scaled, 0)
            records.damping, records.stiffness, records.soft = 0.0, 0.0, 0.0
        still, free = np.zeros((n, ports)), np.full((n, ports), np.inf)
        load = np.zeros((n, bench.modes.count))
        pushed = np.repeat(pulse, each, axis=0) if not scenario.sampled else still
        inputs = Inputs(np.ascontiguousarray(pushed), still, still, load, still, -free, free, np.zeros(ports))
        rest = np.zeros(bench.modes.count)
        modal = modal_record(bench.modes, bench.motion, bench.step, rest, rest)
        record = empty_record(n, ports, bench.modes.count, n)
        kernel(modal, bench.step, inputs, sampler, records, stages, n, record)
        answers[:, :, r] = record.y[each::each]
    return answers
