"""What a comparison has found, in plain values: a row for each contender, and the verdict."""

from __future__ import annotations

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
class Contender:
    """One controller of a comparison.

    label: its name here.   kind: of the controller.   source: "scenario" (the experiment's own law), "kind" (named by its kind:
    begins in the middle of its ranges), "object" or the name of the scenario that its controller was taken from.
    tuned: whether its gains were searched for; candidates, kept: how many were tried, and how many of them kept the constraint.
    start: what the objective was with the gains that the search began from; None where it was not tuned, or could not be had.
    gains: by path, what was searched, as it was found.   sampled: whether the law acts through samples.
    status, trials: how the run ended and after how many trials.   merits: by column, see `dampen.analysis.merits`.
    settling: the trial from which on all counted ports stay within their thresholds; None: never.
    peaks: by port, the largest |error| of each trial.   refined: None where finer numerics cannot run it.
    notes: what a reader has to know.   seconds: what it took.
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

    @property
    def held(self) -> bool:
        """Whether the run went to its end within the constraint and all its forces settled."""
        return self.status == HELD and self.merits["unsettled"] == 0

    def span(self, name: str) -> tuple[float, float]:
        """Least and largest value of a merit over the numerics that the contender was run at: what its numbers can carry."""
        values = [self.merits[name], *([self.refined.merits[name]] if self.refined is not None else [])]
        return min(values), max(values)


@dataclass(frozen=True)
class Comparison:
    """One experiment under several controllers.

    scenario, title: of the experiment.   objective, budget, seed: of every tuning.   ports: by name their units of motion and
    effort.   counted: the ports that are judged: those with a constraint, or all where none has one.
    thresholds: [m, rad] by counted port what |error| has to stay within to be settled: 5 % of the least room that the
    constraint leaves, without one 5 % of the largest error of all contenders whose motion did not diverge.
    contenders: in their order, the experiment's own law first.   left_out: by name, why a controller was not compared.
    verdict: sentences.   complete: whether all contenders are there.   results: by label the runs, those in memory.
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
    results: Mapping[str, Any] = field(default_factory=dict, repr=False, compare=False)

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
        for merits in (contender["merits"], (contender["refined"] or {}).get("merits", {})):
            merits |= {name: float("nan") for name, value in merits.items() if value is None}
    return TypeAdapter(Comparison).validate_python(table)
