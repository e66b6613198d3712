"""`dampen.compare`: the same plant, disturbance and seeds under several controllers."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from dampen.arguments import CONTENDERS, ENGINE, FOLDER, PATH, PROGRESS, SCENARIO, TEXT, TEXTS, count, takes
from dampen.component import ArgumentError, wrong
from dampen.release import version
from dampen.scenarios.results import load
from dampen.simulation.bench import Bench
from dampen.simulation.scenario import Scenario
from dampen.studies.api import engine_of, for_python, home_of
from dampen.studies.compare.comparison import Comparison, Contender, from_plain
from dampen.studies.compare.entries import Entry, Given, entries_of
from dampen.studies.compare.judge import Interrupted, judged
from dampen.studies.compare.settle import counted_ports, settled, thresholds
from dampen.studies.compare.verdict import verdict
from dampen.studies.definition import Definition, check_objectives, tune_of, whole
from dampen.studies.engines import Engine
from dampen.studies.record import FILE, record, write_record
from dampen.toml import literal, to_toml

Progress = Callable[[str, int, int], None]
DEFINITION = "compare.toml"


@takes(
    scenario=SCENARIO,
    objective=TEXT,
    as_given=TEXTS,
    folder=FOLDER,
    engine=ENGINE,
    progress=PROGRESS,
    contenders=CONTENDERS,
    budget=count(),
    searches=count(1, 1000),
    seed=count(),
)
@for_python()
def compare(
    scenario: Scenario,
    contenders: Sequence[Given] | None = None,
    *,
    budget: int = 300,
    searches: int = 2,
    objective: str = "residual",
    seed: int = 0,
    as_given: Sequence[str] = (),
    folder: str | Path | None = None,
    engine: Engine | int | str | None = None,
    progress: Progress | None = None,
) -> Comparison:
    """Run one experiment under several controllers, each with gains tuned on the same budget by the same search.

    scenario:   plant, actuators, compensation, disturbance, task, bounds, numerics and seeds; its controller is the first
                contender.
    contenders: kinds of controllers ("lqg", "module:Class"), which begin in the middle of the ranges that they say; scenarios
                or their names, of which only the controller and its sampling are taken; controllers. Left out: all shipped
                kinds that can be run here.
    budget:     candidates of each search, the first of them the contender's start; 0: all as given.
    searches:   of each contender, with the seeds `seed`, `seed` + 1, ...; the best counts, and their spread tells what luck a
                search has. After one alone nobody is said to beat anybody.
    objective:  figure of merit that is made small (margin: large), the constraint kept.
    seed:       of the first search of every contender.
    as_given:   names of contenders that are not tuned: labels, kinds, scenarios.
    folder:     where to write, a contender a folder; a comparison that was interrupted there is gone on with.
    engine:     as for `tune`.   progress: called with (contender, runs done, runs in all).

    A law that acts through samples alone is given the scenario's `sampling` where the scenario is continuous. An interrupt
    ends the comparison with the contenders that are finished. Raises ArgumentError, before anything is written, for a
    contender that is another experiment or cannot be run.
    """
    plan = Plan(scenario, contenders, budget, objective, seed, tuple(as_given), searches)
    return plan.run(None if folder is None else Path(folder), engine_of(engine), progress)


@takes(folder=PATH)
def open_comparison(folder: str | Path) -> Comparison:
    """The comparison that a folder holds, with its runs. Raises ArgumentError for any other folder."""
    folder = Path(folder)
    try:
        kept = json.loads((folder / FILE).read_text(encoding="utf-8"))
        found, experiment = from_plain(kept["comparison"]), str(kept["scenario"])
    except (OSError, ValueError, KeyError, TypeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is not one of dampen's"
        raise ArgumentError(f"Comparison `{folder / FILE}` cannot be read: {reason}.") from None
    results = {one.label: load(folder / one.label / "result.nc") for one in found.contenders}
    return replace(found, results=results, experiment=experiment)


class Plan:
    """A comparison, all of it checked, before it is run. `left_out`: who is not compared, and why."""

    def __init__(
        self,
        scenario: Scenario,
        given: Sequence[Given] | None,
        budget: int,
        objective: str,
        seed: int,
        as_given: Sequence[str],
        searches: int = 1,
    ):
        if not isinstance(scenario, Scenario):
            raise wrong("scenario", "be a Scenario, as `read_scenario` gives it", scenario)
        check_objectives([objective], scenario)
        self.scenario, self.objective = scenario, objective
        self.budget, self.seed = whole("budget", budget, 0), whole("seed", seed, 0)
        self.searches = whole("searches", searches, 1)
        self.bench = Bench(scenario)
        self.entries, self.left_out = entries_of(scenario, given, self.bench)
        kept = {label for name in as_given for label in self._named(name)}
        self.definitions = {e.label: self._definitions(e) for e in self.entries if e.label not in kept}

    @property
    def runs(self) -> int:
        """How many runs there are in all: candidates, one for each contender, and a finer one for each of its searches."""
        of_each = [len(self.definitions.get(entry.label, ())) for entry in self.entries]
        return sum(count * self.budget + 1 + max(count, 1) for count in of_each)

    def run(self, folder: Path | None, engine: Engine | None, progress: Progress | None = None) -> Comparison:
        """All contenders, one after the other; what is finished is written as it comes."""
        import scipy.linalg  # noqa: F401  (loaded first, so that the limit below reaches its BLAS too)
        from threadpoolctl import threadpool_limits

        if folder is not None:
            self._make_folder(folder)
        done, results, count = list[Contender](), dict[str, Any](), 0
        found = self._comparison(done, results)
        for entry in self.entries:

            def step(entry: Entry = entry) -> None:
                nonlocal count
                count += 1
                if progress:
                    progress(entry.label, count, self.runs)

            own = None if folder is None else folder / entry.label
            try:
                with threadpool_limits(1):
                    row, result = judged(entry, self.definitions.get(entry.label, ()), self.bench, own, engine, step)
            except (Interrupted, KeyboardInterrupt):
                break
            done.append(row)
            results[entry.label] = result
            found = self._comparison(done, results)
            if folder is not None:
                write_record(folder, record(self.scenario, comparison=found))
        return found

    def _named(self, name: str) -> list[str]:
        """Labels of the contenders that a name means: the one so labelled, or all that it may mean otherwise."""
        labels = [e.label for e in self.entries if e.label == name] or [e.label for e in self.entries if name in e.names]
        if not labels:
            known = ", ".join(entry.label for entry in self.entries)
            raise ArgumentError(f"Option `--as-given` must name a contender, but names {name!r}; known here: {known}.")
        return labels

    def _definitions(self, entry: Entry) -> tuple[Definition, ...]:
        """The searches for a contender's gains; none where there is none to be made."""
        if not self.budget or not entry.start.search:
            return ()
        home = home_of(entry.scenario)
        first = tune_of(entry.scenario, entry.start.search, [self.objective], self.budget, seed=self.seed, home=home)
        return tuple(replace(first, seed=self.seed + k) for k in range(self.searches))

    def _comparison(self, done: Sequence[Contender], results: dict[str, Any]) -> Comparison:
        limits = thresholds(self.scenario, done)
        rows = tuple(replace(one, settling=settled(one, limits)) for one in done)
        return Comparison(
            scenario=self.scenario.name,
            title=self.scenario.title,
            objective=self.objective,
            budget=self.budget,
            seed=self.seed,
            ports={port.name: (port.motion_unit, port.effort_unit) for port in self.scenario.plant.ports},
            counted=counted_ports(self.scenario),
            thresholds=limits,
            contenders=rows,
            left_out=self.left_out,
            verdict=verdict(self.scenario, rows, self.objective, self.budget, self.searches),
            complete=len(rows) == len(self.entries),
            version=version(),
            searches=self.searches,
            results=dict(results),
            experiment=to_toml(self.scenario),
        )

    def _make_folder(self, folder: Path) -> None:
        """A new folder, or one that this very comparison has begun. Raises ArgumentError for any other."""
        text = self.to_toml()
        try:
            if (folder / DEFINITION).exists():
                if (folder / DEFINITION).read_text(encoding="utf-8") != text:
                    raise ArgumentError(f"Output folder `{folder}` must be another one: it holds a comparison of something else.")
                return
            folder.mkdir(parents=True, exist_ok=True)
            if any(folder.iterdir()):
                raise ArgumentError(f"Output folder `{folder}` must be empty or new, but has files in it.")
            (folder / "scenario.toml").write_text(to_toml(self.scenario), encoding="utf-8")
            (folder / DEFINITION).write_text(text, encoding="utf-8")
        except OSError as error:
            raise ArgumentError(f"Output folder `{folder}` cannot be written: {error.strerror or error}.") from None

    def to_toml(self) -> str:
        """What is compared, as text that tells this comparison from any other."""
        rows: dict[str, Any] = {"objective": self.objective, "budget": self.budget, "searches": self.searches, "seed": self.seed}
        lines = ["# A comparison by dampen of scenario.toml beside it under several controllers, each in a folder of its own."]
        lines += [f"{key} = {literal(value)}" for key, value in rows.items()]
        for entry in self.entries:
            search = [axis.text for found in self.definitions.get(entry.label, ())[:1] for axis in found.axes]
            lines += ["", "[[contender]]", f"label = {literal(entry.label)}", f"search = {literal(search)}"]
            lines.append(f"start = {literal(entry.scenario.controller)}")
        return "\n".join(lines) + "\n"
