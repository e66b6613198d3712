"""A run: trial after trial, with everything written down."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from dampen.arguments import BENCH, PROGRESS, SCENARIO, STORE, TRUTH, takes
from dampen.controllers.base import Setting
from dampen.own import blame
from dampen.simulation.account import accounts
from dampen.simulation.bench import Bench
from dampen.simulation.digital import Sampler
from dampen.simulation.interrupt import interrupt_noted
from dampen.simulation.kernel import Record
from dampen.simulation.memory import begun, never_learned
from dampen.simulation.passes import passes
from dampen.simulation.result import Layout, Result
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import setting_of
from dampen.simulation.stores import MemoryStore, Store

Array = np.ndarray
Progress = Callable[[int, int], None]
FINE, BROKEN = 0, 1
LARGEST_FIELD = 1e38
LOST = "The constraint of"


@takes(scenario=SCENARIO, store=STORE, progress=PROGRESS, bench=BENCH, compile=TRUTH)
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
    setting = setting_of(scenario, bench=bench, compile=compile)
    unchanged = never_learned(scenario.controller, begun(scenario, setting))
    with blame(scenario.controller, "notes"):
        warnings = [*bench.warnings, *scenario.controller.notes(setting), *unchanged]
    store = store or MemoryStore()
    store.open(Layout.of(scenario, bench.x, setting), warnings)
    status, done = "complete", 0
    try:
        with interrupt_noted() as interrupted:
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


def trials(scenario: Scenario, bench: Bench, compile: bool = True) -> Iterator[dict[str, Any]]:
    """The trials of a scenario, one after the other, each as the variables that the result keeps of it.

    The arrays are used again for the next trial: copy what is to be kept.
    """
    for p in passes(scenario, bench, compile):
        yield {
            **variables(scenario, bench, p.trial, p.record, p.inputs.disturbance),
            **accounts(scenario, p.trial, p.record, p.inputs, p.ports),
            **(samples(p.sampler, p.setting) if scenario.sampled else {}),
            **p.memory,
            "status": FINE if p.done == scenario.steps and kept_in_single(p.record, bench) else BROKEN,
            "unsettled": int(p.record.unsettled[0]),
        }


def kept_in_single(record: Record, bench: Bench) -> bool:
    """Whether fields, which are kept in single precision, are within its range."""
    return not bench.shapes or float(np.abs(record.q).max(initial=0.0)) * _steepest(bench) < LARGEST_FIELD


def _steepest(bench: Bench) -> float:
    return float(max(np.abs(shapes).sum(axis=1).max() for shapes in bench.shapes.values()))


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
