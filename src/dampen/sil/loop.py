"""The loop: trial after trial, sample after sample, plant and controller in lock step, everything written down."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from dampen.arguments import BENCH, NOTHING, POSITIVE, PROGRESS, SCENARIO, STORE, TEXT, TEXTS, TRUTH, count, takes
from dampen.sil.agreement import Agreement
from dampen.sil.counterpart import Counterpart
from dampen.sil.exchanges import Exchanges
from dampen.sil.line import Lost, nothing
from dampen.sil.plant_side import PlantSide
from dampen.sil.reach import reached
from dampen.simulation.account import accounts
from dampen.simulation.bench import Bench
from dampen.simulation.interrupt import interrupt_noted
from dampen.simulation.memory import after, begun
from dampen.simulation.passes import seen
from dampen.simulation.result import Layout, Result
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import of_trial, setting_of
from dampen.simulation.stores import MemoryStore, Store
from dampen.simulation.trials import BROKEN, FINE, LOST, Progress, note_trouble, samples, variables

Array = np.ndarray


@dataclass(frozen=True)
class InTheLoop:
    """A run with a controller in the loop.

    result:    as of any run; its memories are what the scenario's own learning makes of the same readings and commands.
    exchanges: what was asked and how long it took, also where the run broke off.
    agreement: how far it is from the sampled run; None where that was not asked for, or the scenario has no law.
    failure:   what ended it early, one line; "" where nothing did.
    """

    result: Result
    exchanges: Exchanges
    agreement: Agreement | None
    failure: str


@takes(
    scenario=SCENARIO,
    controller=TEXT | TEXTS | NOTHING,
    udp=TRUTH,
    port=count(1, 65535) | NOTHING,
    drive=TRUTH,
    timeout=POSITIVE,
    compare=TRUTH,
    store=STORE,
    progress=PROGRESS,
    bench=BENCH,
)
def software_in_the_loop(
    scenario: Scenario,
    controller: str | Sequence[str] | None = None,
    *,
    udp: bool = False,
    port: int | None = None,
    drive: bool = False,
    timeout: float = 5.0,
    compare: bool = True,
    store: Store | None = None,
    progress: Progress | None = None,
    bench: Bench | None = None,
) -> InTheLoop:
    """Run a sampled scenario with a program in its law's place, in lock step; packets as in docs/how-to/sil.md.

    controller: the program to start, as a command line or its words.   udp: over loopback UDP instead of a pipe: the program is
    given `--udp PORT` and listens there.   port: where a program of this machine listens already; nothing is started.
    drive:      the program inverts the actuators, too, in place of the scenario's compensation.
    timeout:    [s] that an answer may take.   compare: with the run under the scenario's own law.
    store, progress, bench: as of :func:`dampen.simulate`.

    Commands act `sampling.delay` after the reading, however long the program takes: its time is measured, not simulated. A
    program that dies, falls silent or sends what is no answer ends the run; the result then has the trials that were finished,
    its status is "controller_lost", and `failure` says what happened. Raises ArgumentError where the run cannot begin.
    """
    bench = bench or Bench(scenario)
    with reached(scenario, controller, udp=udp, port=port, drive=drive, timeout=timeout) as counterpart:
        return in_the_loop(scenario, counterpart, bench, store or MemoryStore(), compare, progress)


def in_the_loop(
    scenario: Scenario,
    counterpart: Counterpart,
    bench: Bench,
    store: Store,
    compare: bool = True,
    progress: Progress | None = None,
) -> InTheLoop:
    """All trials of a scenario, with a controller that has said hello."""
    plant, setting = PlantSide(scenario, bench, counterpart.drives), setting_of(scenario, bench=bench)
    memory, agreement = begun(scenario, setting), None
    if compare and Agreement.possible(scenario):
        agreement = Agreement(scenario, bench)
    warnings = [f"Commands came from {counterpart.described}, not from the scenario's law.", *bench.warnings]
    store.commands_from = counterpart.described
    store.open(Layout.of(scenario, bench.x, setting), warnings)
    status, done, failure = "complete", 0, ""
    try:
        with interrupt_noted() as interrupted:
            counterpart.line.stop = stopper(interrupted)
            while status == "complete" and done < scenario.task.trials:
                status, failure = through(plant, counterpart, done)
                setting = of_trial(setting, scenario, done)
                if plant.steps == scenario.steps:
                    memory = learnt(scenario, plant, memory, setting, done)
                elif not plant.steps:
                    break
                record = written_down(scenario, plant, memory, done)
                store.write(done, record)
                note_trouble(scenario, done, up_to_the_end(record, plant.steps), warnings)
                if record["status"] != FINE:
                    break
                if agreement:
                    agreement.add(record)
                done += 1
                if progress:
                    progress(done, scenario.task.trials)
            counterpart.line.stop = nothing
            if not failure:
                counterpart.leave()
    except KeyboardInterrupt:
        status = "interrupted"
    warnings += [*counterpart.notes, *([failure] if failure else [])]
    if status == "complete" and any(line.startswith(LOST) for line in warnings):
        status = "constraint_lost"
    return InTheLoop(store.close(status, done), counterpart.exchanges, agreement, failure)


def stopper(interrupted: Callable[[], bool]) -> Callable[[], None]:
    """Raises KeyboardInterrupt where Ctrl-C has been noted."""

    def stop() -> None:
        if interrupted():
            raise KeyboardInterrupt

    return stop


def through(plant: PlantSide, counterpart: Counterpart, trial: int) -> tuple[str, str]:
    """A trial, sample by sample: how it went, "complete" or as a result's status, and the failure of the controller, if any."""
    plant.begin(trial)
    try:
        for sample in range(plant.samples):
            counterpart.line.stop()
            command, drive = counterpart.step(trial, sample, plant.read())
            if not plant.move(command, drive):
                return "diverged", ""
        counterpart.end_trial(trial, plant.read())
    except Lost as error:
        return "controller_lost", str(error)
    except KeyboardInterrupt:
        return "interrupted", ""
    return "complete", ""


def learnt(scenario: Scenario, plant: PlantSide, memory: Mapping[str, Array], setting: Any, trial: int) -> Mapping[str, Array]:
    """What the scenario's learning makes of the trial: the program's own memory is not to be seen."""
    record, sampler, _ = plant.written()
    return after(scenario.controller, memory, seen(trial, scenario, record, sampler), setting)


def written_down(scenario: Scenario, plant: PlantSide, memory: Mapping[str, Array], trial: int) -> dict[str, Any]:
    """The variables that the result keeps of the trial."""
    record, sampler, ports = plant.written()
    return {
        **variables(scenario, plant.bench, trial, record, plant.inputs.disturbance),
        **accounts(scenario, trial, record, plant.inputs, ports),
        **samples(sampler, plant.setting),
        **memory,
        "status": FINE if plant.steps == scenario.steps else BROKEN,
        "unsettled": plant.unsettled,
    }


def up_to_the_end(record: dict[str, Any], steps: int) -> dict[str, Any]:
    """The record of a trial whose rest, where it broke off, stays where it was: no port left anything there."""
    y = record["y"].copy()
    y[steps + 1 :] = y[steps]
    return {**record, "y": y}
