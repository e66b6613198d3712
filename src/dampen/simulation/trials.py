"""The trial axis: run trial after trial, let the controller learn in between, write everything down."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from dampen.component import ArgumentError, own_name
from dampen.controllers.base import Controller, PortLaw, Setting, Trial
from dampen.own import blame
from dampen.simulation.account import accounts
from dampen.simulation.bench import Bench
from dampen.simulation.digital import Sampler
from dampen.simulation.digital_side import begin_again, idle, prepare, sampler_of
from dampen.simulation.kernel import Record
from dampen.simulation.pieces import check_memory, check_sampled
from dampen.simulation.records import empty_record, port_records
from dampen.simulation.result import Layout, Result
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import of_trial, setting_of
from dampen.simulation.stores import MemoryStore, Store

Array = np.ndarray
Progress = Callable[[int, int], None]
FINE, BROKEN = 0, 1
LOST = "The constraint of"


def simulate(
    scenario: Scenario,
    *,
    store: Store | None = None,
    progress: Progress | None = None,
    bench: Bench | None = None,
    compile: bool = True,
) -> Result:
    """Run all trials of a scenario.

    store:    where trials are written as they finish (default: memory).
    progress: called with (trials finished, trials in all) after each trial.
    bench:    a set-up to share with another run of the same plant, task and disturbance.
    compile:  False runs the kernel as the plain Python that it is, about a thousand times slower.

    An interrupt (KeyboardInterrupt) or a motion that stops being finite ends the run early: the result then has the trials
    that were finished, and its `status` says "interrupted" or "diverged". A run in which a port leaves its constraint goes on;
    its status is "constraint_lost", and a warning tells when.
    """
    bench = bench or Bench(scenario)
    bench.check_start(scenario)
    setting = setting_of(scenario, bench=bench)
    with blame(scenario.controller, "notes"):
        warnings = [*bench.warnings, *scenario.controller.notes(setting)]
    store = store or MemoryStore()
    store.open(Layout.of(scenario, bench.x, setting), warnings)
    status, done = "complete", 0
    try:
        with interrupt_between_trials() as interrupted:
            for record in trials(scenario, bench, compile):
                store.write(done, record)
                note_trouble(scenario, done, record, warnings)
                if record["status"] != FINE:
                    status = "diverged"
                    break
                done += 1
                if progress:
                    progress(done, scenario.task.trials)
                if interrupted():
                    status = "interrupted"
                    break
    except KeyboardInterrupt:
        status = "interrupted"
    if status == "complete" and any(line.startswith(LOST) for line in warnings):
        status = "constraint_lost"
    return store.close(status, done)


@contextmanager
def interrupt_between_trials() -> Iterator[Callable[[], bool]]:
    """Let a first Ctrl-C wait for the end of the trial, so that none is half written; a second one acts at once."""
    asked: list[int] = []

    def note(number: int, frame: object) -> None:
        if asked:
            raise KeyboardInterrupt
        asked.append(number)

    if threading.current_thread() is not threading.main_thread():  # only the main thread is sent signals
        yield lambda: False
        return
    before = signal.signal(signal.SIGINT, note)
    try:
        yield lambda: bool(asked)
    finally:
        signal.signal(signal.SIGINT, before)


def trials(scenario: Scenario, bench: Bench, compile: bool = True) -> Iterator[dict[str, Any]]:
    """The trials of a scenario, one after the other, each as the variables that the result keeps of it.

    The arrays are used again for the next trial: copy what is to be kept.
    """
    kernel, classes = bench.kernel(scenario, compile)
    chains = [scenario.chain(p) for p in range(len(scenario.ports))]
    setting, controller, every = setting_of(scenario, bench=bench), scenario.controller, scenario.output.every
    sampler = sampler_of(scenario, setting) if scenario.sampled else idle(len(chains))
    check_sampled(controller, setting)
    with blame(controller, "begin"):
        memory = controller.begin(setting)
    check_memory(controller, memory, memory)
    record = empty_record(scenario.steps, len(chains), bench.modes.count, every)
    for j in range(scenario.task.trials):
        if j == 0 or scenario.task.start == "reset":
            modal, (ports, stages) = bench.modal_record(j), port_records(chains, bench.step, classes)
            begin_again(sampler)
        setting = of_trial(setting, scenario, j)
        with blame(controller, "law"):
            law = controller.law(memory, setting)
        check_law(controller, law, setting)
        check_monotone(scenario, law)
        if scenario.sampled:
            sampler = prepare(sampler, scenario, setting, law, j)
            ports.soft = 0.0
        else:
            ports.damping, ports.stiffness, ports.barrier = law.damping, law.stiffness, law.barrier
        inputs = bench.inputs(scenario, j, law)
        done = kernel(modal, bench.step, inputs, sampler, ports, stages, every, record)
        with blame(controller, "learn"):
            before, memory = memory, controller.learn(memory, seen(j, scenario, record, sampler), setting)
        check_memory(controller, before, memory)
        yield {
            **variables(scenario, bench, j, record, inputs.disturbance),
            **accounts(scenario, j, record, inputs, ports),
            **(samples(sampler, setting) if scenario.sampled else {}),
            **memory,
            "status": FINE if done == scenario.steps else BROKEN,
            "unsettled": int(record.unsettled[0]),
        }


def seen(trial: int, scenario: Scenario, record: Record, sampler: Sampler) -> Trial:
    """The trial as the controller measured it: exactly, or through its samples."""
    if not scenario.sampled:
        return Trial(trial, record.y.copy(), record.v.copy(), record.command.copy())
    return Trial(trial, sampler.error.copy(), sampler.rate.copy(), sampler.issued[sampler.ahead :].copy())


def samples(sampler: Sampler, setting: Setting) -> dict[str, Array]:
    """What the result keeps of the samples."""
    reading = sampler.error[:-1] + setting.reference[:-1]
    return {"reading": reading, "rate_estimate": sampler.rate, "issued": sampler.issued[sampler.ahead :]}


def note_trouble(scenario: Scenario, trial: int, record: dict[str, Any], warnings: list[str]) -> None:
    """Add to the warnings what went wrong in a trial; each kind of trouble is told once, where it began."""
    low, high = scenario.limits(trial)
    beyond = ~((low < record["y"]) & (record["y"] < high))
    for p in np.flatnonzero(beyond.any(axis=0)):
        told = f"{LOST} {scenario.ports[p]} was lost"
        if not any(line.startswith(told) for line in warnings):
            first = np.flatnonzero(beyond[:, p])[0]
            warnings.append(f"{told}, first at t = {first * scenario.numerics.step:.4g} s of trial {trial}.")
    if record["unsettled"] and not any("did not settle" in line for line in warnings):
        warnings.append(
            f"The forces at the ports did not settle in {record['unsettled']} steps of trial {trial}: do not trust this run."
        )


def check_law(controller: Controller, law: PortLaw, setting: Setting) -> None:
    """The closure has one solution only if nothing in the law pushes the wrong way."""
    ports, whose = len(setting.ports), f"{own_name(controller)}.law"
    if not isinstance(law, PortLaw):
        raise ArgumentError(f"{whose} must return a PortLaw, but returns {type(law).__name__}.")
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


def variables(scenario: Scenario, bench: Bench, trial: int, record: Record, disturbance: Array) -> dict[str, Array]:
    """What the result keeps of a trial: signals, fields and peaks."""
    reference = scenario.reference(trial)
    y = record.y + reference
    fields = {name: record.q @ shapes.T for name, shapes in bench.shapes.items()}
    peak = [max(np.abs(fields[f.name]).max(), *_port_peaks(y, bench, f.name)) for f in bench.modes.fields]
    return {
        "y": y,
        "v": record.v,
        "command": record.command,
        "delivered": record.delivered,
        "disturbance": disturbance,
        "energy": record.energy,
        **({"reference": reference} if scenario.task.reference else {}),
        **fields,
        "peak": np.array(peak),
    }


def _port_peaks(y: Array, bench: Bench, field: str) -> list[float]:
    """Port signals see every step, snapshots do not: a field's peak is taken over both."""
    return [0.0, *(float(np.abs(y[:, p]).max()) for p, port in enumerate(bench.modes.ports) if port.field == field)]
