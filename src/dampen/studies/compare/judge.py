"""One contender: its gains searched for, its run, its figures, and how far these depend on the numerics."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from dampen.analysis.merits import columns, merit, merits
from dampen.analysis.metrics import error_peaks
from dampen.analysis.refinement import finer
from dampen.analysis.tallied import tallied
from dampen.component import ArgumentError
from dampen.simulation.batch import alone
from dampen.simulation.bench import Bench
from dampen.simulation.kernel import MODES_AT_MOST
from dampen.simulation.result import Result
from dampen.simulation.scenario import Scenario
from dampen.simulation.stores import FileStore
from dampen.simulation.trials import simulate
from dampen.studies.best import at_ends, best_row, nearest_row
from dampen.studies.compare.comparison import Contender, Refined, Searched
from dampen.studies.compare.entries import Entry, name_of
from dampen.studies.definition import Definition
from dampen.studies.engines import Engine
from dampen.studies.evaluate import Row
from dampen.studies.lens import get
from dampen.studies.search import clipped, feasible, violation
from dampen.studies.study import Study, new_study, open_study
from dampen.studies.variation import member
from dampen.toml import to_toml

Step = Callable[[], None]


class Interrupted(Exception):
    """The user has had enough: what is finished stays."""


@dataclass(frozen=True)
class Tuned:
    """A scenario with the gains that a search has chosen: its row there, how many candidates were tried and kept the
    constraint, what the objective was at the start, and what a reader has to know."""

    scenario: Scenario
    row: Row
    seed: int
    candidates: int
    kept: int
    start: float | None
    notes: tuple[str, ...]


def judged(
    entry: Entry, definitions: Sequence[Definition], bench: Bench, folder: Path | None, engine: Engine | None, step: Step
) -> tuple[Contender, Result]:
    """A contender's row and run. definitions: of its searches, the best of which counts; none: as given.
    folder: its own, None: in memory.   step: called after each run.   Raises Interrupted."""
    begun = time.monotonic()
    tuned = [tuned_by(one, study_folder(folder, k), engine, step) for k, one in enumerate(definitions)]
    best = min(tuned, key=rank(definitions[0].objectives[0])) if tuned else None
    scenario = entry.scenario if best is None else best.scenario
    result = run(scenario, bench, folder)
    step()
    searches = [searched(one, definitions[0], step) for one in tuned]
    if best is None:
        refined = at_finer_numerics(scenario)
        step()
    else:
        refined = next(found.refined for one, found in zip(tuned, searches, strict=True) if one is best)
    contender = Contender(
        label=entry.label,
        kind=name_of(scenario.controller),
        source=entry.source,
        tuned=best is not None,
        candidates=sum(one.candidates for one in tuned),
        kept=sum(one.kept for one in tuned),
        start=None if best is None else best.start,
        gains=gains_of(scenario, definitions[0]) if definitions else {},
        sampled=scenario.sampled,
        status=result.status,
        trials=result.trials,
        merits=merits(tallied(result)),
        settling=None,
        peaks={port: tuple(map(float, error_peaks(result, port))) for port in scenario.ports},
        refined=refined,
        notes=(*entry.start.notes, *(() if best is None else (*best.notes, *range_notes(definitions[0], best.row)))),
        seconds=time.monotonic() - begun,
        searches=tuple(searches),
        paper=scenario.controller.paper,
        untuned=entry.start.untuned,
    )
    return contender, result


def range_notes(definition: Definition, row: Row) -> tuple[str, ...]:
    """What a reader has to know of where the ranges ended: a start outside of them, the best at their end."""
    told = (*clipped(definition), at_ends(definition, row))
    return tuple(text.replace("controller.", "") for text in told if text)


def study_folder(folder: Path | None, k: int) -> Path | None:
    """Where the k-th search of a contender is written."""
    return None if folder is None else folder / ("study" if k == 0 else f"study-{k + 1}")


def rank(objective: str) -> Callable[[Tuned], tuple[float, ...]]:
    """An order of searches: those first that keep the constraint, then by how much it is broken, then the objective."""
    sign = merit(objective).sign

    def key(one: Tuned) -> tuple[float, ...]:
        row, kept = one.row, feasible(one.row)
        value = sign * float(row.get(objective, np.nan))
        return (not kept, 0.0 if kept else violation(row), value if np.isfinite(value) else np.inf, one.seed)

    return key


def searched(one: Tuned, definition: Definition, step: Step) -> Searched:
    """What a search came to, with a run at finer numerics."""
    refined = at_finer_numerics(one.scenario)
    step()
    figures = {name: float(one.row.get(name, np.nan)) for name in columns(one.scenario)}
    return Searched(one.seed, one.kept, gains_of(one.scenario, definition), str(one.row["status"]), figures, refined)


def gains_of(scenario: Scenario, definition: Definition) -> dict[str, Any]:
    """By path, what a search has found."""
    paths = [path for axis in definition.axes for path in axis.paths]
    return {path.removeprefix("controller."): get(scenario, path) for path in paths}


def tuned_by(definition: Definition, folder: Path | None, engine: Engine | None, step: Step) -> Tuned:
    """The gains that a search finds. folder: of its study; one that was interrupted there is gone on with."""
    study, done = study_of(definition, folder), 0

    def progress(rows: int, *_: Any) -> None:
        nonlocal done
        for _row in range(done, rows):
            step()
        done = rows

    progress(study.done)
    study.run(engine, progress)
    if not study.complete:
        raise Interrupted
    rows = list(study.rows.rows)
    row, notes = chosen(study, definition.objectives[0])
    kept = sum(map(feasible, rows))
    found = replace(member(definition.scenario, definition.axes, row), name=f"{definition.scenario.name}-tuned"[:60])
    start = float(study.rows.by_member[0][definition.objectives[0]])
    return Tuned(found, row, definition.seed, len(rows), kept, start if np.isfinite(start) else None, notes)


def study_of(definition: Definition, place: Path | None) -> Study:
    """The study of a tuning: the one that the folder has of it, or a new one."""
    if place is not None and (place / "study.toml").exists():
        there = open_study(place)
        if there.definition.fingerprint == definition.fingerprint:
            return there
        raise ArgumentError(f"Study folder `{place}` must be another one: it holds a study of something else.")
    return new_study(definition, place)


def chosen(study: Study, objective: str) -> tuple[Row, tuple[str, ...]]:
    """The best row that keeps the constraint; where none does, the one that breaks it least; where none ran, the start."""
    best = best_row(study, objective)
    if best is not None:
        return best, ()
    least = nearest_row(study.rows.rows, objective)
    if least is None:
        return study.rows.by_member[0], ("no candidate ran to its end",)
    return least, ("no candidate keeps the constraint: the one that breaks it least",)


def run(scenario: Scenario, bench: Bench, folder: Path | None) -> Result:
    """The contender's run, in its folder if it has one. Raises Interrupted."""
    own = Bench(scenario, bench.modes)  # a kernel with what this law needs, as the tuning had it
    if folder is None:
        result = simulate(scenario, bench=own)
    else:
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "scenario.toml").write_text(to_toml(scenario), encoding="utf-8")
        (folder / "result.nc").unlink(missing_ok=True)  # not written over: an earlier result of it may be open
        result = simulate(scenario, store=FileStore(folder / "result.nc"), bench=own)
    if result.status == "interrupted":
        raise Interrupted
    return result


def at_finer_numerics(scenario: Scenario) -> Refined | None:
    """The same gains at half the step, on a set of modes of its own that has twice as many, or as many as can be had."""
    own = scenario.numerics.modes
    for modes in dict.fromkeys((min(2 * own, MODES_AT_MOST), own)):
        try:
            case = finer(scenario, 2, modes)
            bench = Bench(case)
            tally = alone(case, bench)
        except ArgumentError:
            continue
        return Refined(bench.modes.count, case.numerics.step, tally.status, merits(tally))
    return None
