"""The trial axis: run trial after trial, let the controller learn in between, write everything down."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from dampen.component import ArgumentError
from dampen.controllers.base import PortLaw, Trial
from dampen.simulation.closure import RELAXATION
from dampen.simulation.kernel import Record
from dampen.simulation.result import Layout, Result
from dampen.simulation.scenario import Scenario
from dampen.simulation.setup import Bench, port_records
from dampen.simulation.stores import MemoryStore, Store

Array = np.ndarray
Progress = Callable[[int, int], None]
FINE, BROKEN = 0, 1


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
    that were finished, and its `status` says "interrupted" or "diverged".
    """
    bench = bench or Bench(scenario)
    bench.check_start(scenario)
    warnings = list(bench.warnings)
    store = store or MemoryStore()
    store.open(Layout.of(scenario, bench.x), warnings)
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
    ports, stages = port_records(scenario, bench.step, classes)
    modal = bench.initial_state()
    setting, controller, every = scenario.setting, scenario.controller, scenario.output.every
    memory = controller.begin(setting)
    record = empty_record(scenario.steps, len(ports), bench.modes.count, every)
    for j in range(scenario.task.trials):
        law = controller.law(memory, setting)
        check_law(law)
        check_chains(scenario, law)
        ports.damping, ports.barrier = law.damping, law.barrier
        inputs = bench.inputs(j, law)
        done = kernel(modal, bench.step, inputs, ports, stages, every, record)
        trial = Trial(j, record.y.copy(), record.v.copy(), record.command.copy())
        memory = controller.learn(memory, trial, setting)
        yield {
            **variables(scenario, bench, record, inputs.disturbance, ports),
            **memory,
            "status": FINE if done == scenario.steps else BROKEN,
            "unsettled": int(record.unsettled[0]),
        }


def note_trouble(scenario: Scenario, trial: int, record: dict[str, Any], warnings: list[str]) -> None:
    """Add to the warnings what went wrong in a trial; each kind of trouble is told once, where it began."""
    if scenario.controller.uses_barrier:
        for p, (port, limit) in enumerate(zip(scenario.plant.ports, scenario.limits, strict=True)):
            beyond = np.flatnonzero(~(np.abs(record["y"][:, p]) < limit))
            told = f"The constraint of {port.name} was lost"
            if len(beyond) and not any(line.startswith(told) for line in warnings):
                warnings.append(f"{told}, first at t = {beyond[0] * scenario.numerics.step:.4g} s of trial {trial}.")
    if record["unsettled"] and not any("did not settle" in line for line in warnings):
        warnings.append(
            f"The forces at the ports did not settle in {record['unsettled']} steps of trial {trial}: do not trust this run."
        )


def check_law(law: PortLaw) -> None:
    """The closure has one solution only if nothing in the law pushes the wrong way."""
    for name in ("coulomb", "damping", "barrier"):
        value = getattr(law, name)
        if not np.all(value >= 0):
            raise ArgumentError(f"The controller's `{name}` must be >= 0, but its least value is {np.min(value):g}.")


def check_chains(scenario: Scenario, law: PortLaw) -> None:
    """A stage that is not monotone may only follow a command that does not depend on the force it delivers."""
    answers = (law.coulomb > 0).any(axis=0) | (law.damping > 0) | (law.barrier > 0)
    for p, port in enumerate(scenario.plant.ports):
        for stage in scenario.chain(p):
            if answers[p] and not stage.monotone:
                raise ArgumentError(
                    f"Argument `actuator.{port.name}.chain` must be monotone under a continuous law, but its "
                    f"{stage.kind or type(stage).__name__} can deliver less for a larger command."
                )


def empty_record(steps: int, ports: int, modes: int, every: int) -> Record:
    """Arrays for the kernel to fill."""
    on_times, on_steps = (steps + 1, ports), (steps, ports)
    shapes = (on_times, on_times, (steps + 1,), on_steps, on_steps, on_steps, (steps,), (steps // every + 1, modes), (1,))
    return Record(*map(np.zeros, shapes))


def variables(scenario: Scenario, bench: Bench, record: Record, disturbance: Array, ports: Any) -> dict[str, Array]:
    """What the result keeps of a trial: signals, the energy account, fields and peaks."""
    moved = np.diff(record.y, axis=0)
    fields = {name: record.q @ shapes.T for name, shapes in bench.shapes.items()}
    peak = [max(np.abs(fields[f.name]).max(), *_port_peaks(record, bench, f.name)) for f in bench.modes.fields]
    return {
        "y": record.y,
        "v": record.v,
        "command": record.command,
        "delivered": record.delivered,
        "disturbance": disturbance,
        "energy": record.energy,
        "work_control": record.delivered * moved,
        "work_actuator": (record.delivered - ports.gain * record.command) * moved,
        "work_disturbance": disturbance * moved,
        "work_load": record.work_load,
        **barrier_account(record.y, ports),
        **compliance_account(record, ports, scenario.numerics.step),
        **fields,
        "peak": np.array(peak),
    }


def _port_peaks(record: Record, bench: Bench, field: str) -> list[float]:
    """Port signals see every step, snapshots do not: a field's peak is taken over both."""
    return [float(np.abs(record.y[:, p]).max()) for p, port in enumerate(bench.modes.ports) if port.field == field]


def barrier_account(y: Array, ports: Any) -> dict[str, Array]:
    """Energy of the barrier as the actuator's slope delivers it: gain alpha V(y), V = 1/4 ln^2(C^2 / (C^2 - y^2))."""
    scaled = np.where(ports.barrier > 0, y / ports.limit, 0.0)
    inside = np.abs(scaled) < 1
    logarithm = -np.log1p(-(np.where(inside, scaled, 0.0) ** 2))
    stored = np.where(inside, ports.gain * ports.barrier * logarithm**2 / 4, np.inf if np.any(ports.barrier > 0) else 0.0)
    return {"barrier_energy": stored.sum(axis=1)}


def compliance_account(record: Record, ports: Any, dt: float) -> dict[str, Array]:
    """Energy that the ports' numerical compliance stores, at times, and what it dissipates, at steps (see `closure`)."""
    stored = ports.soft * dt * record.slow**2 / (2 * RELAXATION)
    lost = ports.soft * dt * (1 - RELAXATION / 2) * (record.delivered - record.slow[:-1]) ** 2
    return {"compliance_energy": stored.sum(axis=1), "compliance_loss": lost.sum(axis=1)}
