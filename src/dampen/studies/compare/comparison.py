"""What a comparison has found, in plain values: a row for each contender, and the verdict."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

HELD = "complete"


@dataclass(frozen=True)
class Refined:
    """A contender at other numerics: the same gains on a fresh set of modes, at half the step.

    modes, step: what it was run with.   status, merits: as for :class:`Contender`.
    """

    modes: int
    step: float
    status: str
    merits: dict[str, float]


@dataclass(frozen=True)
class Searched:
    """What one search of a contender's gains came to.

    seed: of the search.   kept: how many of its candidates kept the constraint.   gains: by path.
    status, merits, refined: of its best candidate, as for :class:`Contender`.
    """

    seed: int
    kept: int
    gains: dict[str, Any]
    status: str
    merits: dict[str, float]
    refined: Refined | None

    @property
    def held(self) -> bool:
        """Whether its best candidate holds at all numerics that it was run at."""
        return all(map(went_well, ends(self)))


@dataclass(frozen=True)
class Contender:
    """One controller of a comparison.

    label: its name here.   kind: of the controller.   source: "scenario" (the experiment's own law), "kind" (named by its kind:
    begins in the middle of its ranges), "object" or the name of the scenario that its controller was taken from.
    tuned: whether its gains were searched for; candidates, kept: how many were tried in all searches, and how many of them kept
    the constraint.
    start: what the objective was with the gains that the search began from; None where it was not tuned, or could not be had.
    gains: by path, what was searched, as it was found.   sampled: whether the law acts through samples.
    status, trials: how the run ended and after how many trials.   merits: by column, see `dampen.analysis.merits`.
    settling: the trial from which on all counted ports stay within their thresholds; None: never.
    peaks: by port, the largest |error| of each trial.   refined: None where finer numerics cannot run it.
    notes: what a reader has to know.   seconds: what it took.   searches: all of them; the best is what the contender is.
    paper: the paper whose law this is, if it is a paper's.   untuned: why a kind's gains could not be searched for, if so.
    """

    label: str
    kind: str
    source: str
    tuned: bool
    candidates: int
    kept: int
    start: float | None
    gains: dict[str, Any]
    sampled: bool
    status: str
    trials: int
    merits: dict[str, float]
    settling: int | None
    peaks: dict[str, tuple[float, ...]]
    refined: Refined | None
    notes: tuple[str, ...]
    seconds: float
    searches: tuple[Searched, ...] = ()
    paper: str = ""
    untuned: str = ""

    @property
    def held(self) -> bool:
        """Whether the run went to its end within the constraint and all its forces settled."""
        return went_well(self)

    @property
    def once(self) -> bool:
        """Whether its gains rest on one search: another seed may find others."""
        return self.tuned and len(self.searches) < 2

    @property
    def steady(self) -> bool:
        """Whether every search came to gains that hold at all numerics."""
        return all(one.held for one in self.searches)

    def span(self, name: str) -> tuple[float, float]:
        """Least and largest value of a merit over the searches and the numerics that the contender was run at, as far as the
        further searches held: what its numbers can carry."""
        runs = [*ends(self), *(end for one in self.searches for end in ends(one) if went_well(end))]
        values = [run.merits[name] for run in runs if math.isfinite(run.merits[name])]
        return min(values, default=math.nan), max(values, default=math.nan)

    def over_searches(self, name: str) -> tuple[float, float] | None:
        """Least and largest value of a merit over the searches that held, at the experiment's numerics; None: fewer than two."""
        values = [one.merits[name] for one in self.searches if went_well(one) and math.isfinite(one.merits[name])]
        return (min(values), max(values)) if len(values) > 1 else None


Run = Refined | Searched | Contender


def ends(one: Searched | Contender) -> list[Run]:
    """The runs that gains had: at the experiment's numerics, and at finer ones."""
    return [one, *([one.refined] if one.refined is not None else [])]


def went_well(run: Run) -> bool:
    """Whether a run went to its end within the constraint, and all its forces settled."""
    return run.status == HELD and run.merits["unsettled"] == 0


@dataclass(frozen=True)
class Comparison:
    """One experiment under several controllers.

    scenario, title: of the experiment.   objective, budget, seed: of every tuning, the seed of the first of its searches.
    ports: by name their units of motion and effort.   counted: the ports that are judged: those with a constraint, or all
    where none has one.
    thresholds: [m, rad] by counted port what |error| has to stay within to be settled: 5 % of the least room that the
    constraint leaves, without one 5 % of the largest error of all contenders whose motion did not diverge.
    contenders: in their order, the experiment's own law first.   left_out: by name, why a controller was not compared.
    verdict: sentences.   complete: whether all contenders are there.   results: by label the runs, those in memory.
    searches: of each contender that is tuned, with seeds one after the other.   experiment: the scenario as it was given, TOML.
    """

    scenario: str
    title: str
    objective: str
    budget: int
    seed: int
    ports: dict[str, tuple[str, str]]
    counted: tuple[str, ...]
    thresholds: dict[str, float]
    contenders: tuple[Contender, ...]
    left_out: dict[str, str]
    verdict: tuple[str, ...]
    complete: bool
    version: str
    searches: int = 1
    results: Mapping[str, Any] = field(default_factory=dict, repr=False, compare=False)
    experiment: str = field(default="", repr=False, compare=False)

    def __getitem__(self, label: str) -> Contender:
        """A contender by its label."""
        return next(one for one in self.contenders if one.label == label)

    @property
    def table(self) -> Any:
        """The contenders' figures of merit as a pandas DataFrame, a row each."""
        import pandas

        rows = [{"tuned": c.tuned, "status": c.status, "settling": c.settling, **c.merits} for c in self.contenders]
        return pandas.DataFrame(rows, index=pandas.Index([c.label for c in self.contenders], name="contender"))


def from_plain(table: dict[str, Any]) -> Comparison:
    """A comparison read back from what JSON has of it, without its runs. Raises ValueError for anything else."""
    from pydantic import TypeAdapter

    for contender in table["contenders"]:
        for one in (contender, *contender.get("searches", ())):
            for merits in (one["merits"], (one["refined"] or {}).get("merits", {})):
                merits |= {name: math.nan for name, value in merits.items() if value is None}
    return TypeAdapter(Comparison).validate_python(table)
