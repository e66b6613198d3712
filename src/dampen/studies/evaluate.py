"""What a worker does: make members of a study's scenario, run them side by side, and give back their rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from dampen.analysis.merits import columns, merits
from dampen.component import ArgumentError
from dampen.scenarios.read import build, parse
from dampen.simulation.batch import Batch, Outcome, Tally
from dampen.simulation.scenario import Scenario
from dampen.simulation.tally import PEAK
from dampen.studies.variation import Axis, member

Row = dict[str, Any]
Values = Mapping[str, Any]
WORST = ("refused", "crashed", "diverged", "constraint_lost", "complete")  # the worst first


@dataclass(frozen=True)
class Work:
    """Some members of a study: their numbers and what their axes take.

    scenario: as TOML text, with the folder of its modules, so that any process can make it; or the object itself.
    over:     what each member has to hold over: axes and what they take; its row is then that of the worst.
    """

    scenario: tuple[str, str] | Scenario
    axes: tuple[Axis, ...]
    members: tuple[int, ...]
    values: tuple[Values, ...]
    over_axes: tuple[Axis, ...] = ()
    over: tuple[Values, ...] = ()

    @property
    def parts(self) -> list[Work]:
        """Each member by itself."""
        split = zip(self.members, self.values, strict=True)
        return [Work(self.scenario, self.axes, (i,), (v,), self.over_axes, self.over) for i, v in split]


def evaluate(work: Work) -> list[Row]:
    """The rows of all members. A member that cannot be run is a row that says why."""
    import scipy.linalg  # noqa: F401  (loaded first, so that the limit reaches its BLAS too)
    from threadpoolctl import threadpool_limits

    with threadpool_limits(1):  # members are many enough; and sums come out alike wherever they are taken
        return _evaluate(work)


def _evaluate(work: Work) -> list[Row]:
    batch = batch_of(work)
    axes, over = (*work.axes, *work.over_axes), work.over or ({},)
    made = [attempt(batch.nominal, axes, {**values, **more}) for values in work.values for more in over]
    try:
        outcomes = run(batch, made)
    except Exception as error:
        if len(work.members) > 1:
            return [row for part in work.parts for row in _evaluate(part)]
        outcomes = [ArgumentError(f"{type(error).__name__}: {error}")] * len(made)
        return [{**gathered(batch.nominal, outcomes), "member": work.members[0], **work.values[0], "status": "crashed"}]
    groups = [outcomes[i : i + len(over)] for i in range(0, len(outcomes), len(over))]
    return [
        {"member": i, **values, **gathered(batch.nominal, group)}
        for i, values, group in zip(work.members, work.values, groups, strict=True)
    ]


def batch_of(work: Work) -> Batch:
    """The nominal scenario set up: once in a process where the scenario is text."""
    return Batch(work.scenario) if isinstance(work.scenario, Scenario) else _batch(*work.scenario)


def nominal_of(work: Work) -> Scenario:
    """The scenario that members are made from."""
    return work.scenario if isinstance(work.scenario, Scenario) else _scenario(*work.scenario)


@lru_cache(maxsize=2)
def _batch(text: str, home: str) -> Batch:
    return Batch(_scenario(text, home))


@lru_cache(maxsize=2)
def _scenario(text: str, home: str) -> Scenario:
    return build(parse(text, "scenario.toml"), Path(home))


def attempt(nominal: Scenario, axes: tuple[Axis, ...], values: Values) -> Scenario | ArgumentError:
    """A member, or why there is none."""
    try:
        return member(nominal, axes, values)
    except ArgumentError as error:
        return error


def run(batch: Batch, made: Sequence[Scenario | ArgumentError]) -> list[Outcome]:
    """The outcomes of those that could be made, in all their order."""
    ran = iter(batch.run([case for case in made if isinstance(case, Scenario)]))
    return [next(ran) if isinstance(case, Scenario) else case for case in made]


def gathered(nominal: Scenario, outcomes: Sequence[Outcome]) -> Row:
    """A row of one member: of its only outcome, or the worst of several, figure by figure."""
    rows = [row_of(nominal, outcome) for outcome in outcomes]
    if len(rows) == 1:
        return rows[0]
    worst = min(rows, key=lambda row: WORST.index(row["status"]))
    gathered = dict(worst)
    for name in columns(nominal):
        values = [row[name] for row in rows]
        gathered[name] = float(np.min(values) if name.startswith("margin") else np.max(values))
    peaks = max(rows, key=lambda row: row["peak"] if np.isfinite(row["peak"]) else np.inf)
    return gathered | {name: value for name, value in peaks.items() if name.startswith("peaks.")}


def row_of(nominal: Scenario, outcome: Outcome) -> Row:
    """Status, figures of merit and the peaks of all trials."""
    if isinstance(outcome, Tally):
        peaks = {f"peaks.{port}": outcome.by_port[:, p, PEAK].tolist() for p, port in enumerate(nominal.ports)}
        return {"status": outcome.status, "message": "", **merits(outcome), **peaks}
    nothing = dict.fromkeys(columns(nominal), np.nan)
    return {"status": "refused", "message": outcome.lines[0], **nothing, **{f"peaks.{port}": [] for port in nominal.ports}}
