"""The search of a tuning: what the next generation tries, given all that came before."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from dampen.analysis.merits import merit
from dampen.component import ArgumentError
from dampen.studies.definition import Definition
from dampen.studies.evaluate import Row
from dampen.studies.lens import get
from dampen.studies.variation import Axis

BEYOND = 1e6  # what a candidate that breaks the constraint counts, and what it breaks it by comes on top
BROKEN = 1e9  # what one counts that diverges or cannot be run


class Search:
    """Optuna's CMA-ES for one objective, NSGA-II for several, one generation at a time.

    A generation is asked for as a whole before any of it is told, with a seed of its own, so that what it tries depends on the
    seed and on the rows before it alone: a study that was interrupted goes through the generations that it has again, told
    what its table says, and then on as if nothing had been.

    The constraint counts as Deb's rule has it: what breaks it comes after all that keep it, in the order of by how much. CMA-ES
    looks at ranks only; to NSGA-II it is told as a constraint. Sources: Hansen, The CMA Evolution Strategy: A Tutorial,
    arXiv:1604.00772; Deb et al., IEEE Trans. Evolutionary Computation 6, 2002.
    """

    def __init__(self, definition: Definition):
        import optuna

        optuna.logging.set_verbosity(optuna.logging.ERROR)
        self.definition = definition
        directions = [optuna.study.StudyDirection.MINIMIZE] * len(definition.objectives)
        self.study = optuna.create_study(directions=directions)
        self.asked: list[Any] = []
        self.study.enqueue_trial(start_of(definition))

    def ask(self, number: int, count: int) -> list[Mapping[str, Any]]:
        """What a generation's members try; the first of all is the scenario as it is, as far as the ranges go."""
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # experimental features are what is meant here
            self.study.sampler = self._sampler(number)
            self.asked = [self.study.ask(self._distributions()) for _ in range(count)]
        return [dict(trial.params) for trial in self.asked]

    def tell(self, rows: Sequence[Row]) -> None:
        """What came of them, in their order. Raises ArgumentError where a row is of something else than was tried."""
        for trial, row in zip(self.asked, rows, strict=True):
            if any(row[name] != value for name, value in trial.params.items()):
                raise ArgumentError(
                    f"This study's rows are not what its seed gives (member {row['member']}): they come from another version of "
                    "optuna or cmaes. It can be looked at, but not gone on with."
                )
            trial.set_user_attr("violation", violation(row))
            self.study.tell(trial, costs(row, self.definition.objectives))

    def _distributions(self) -> dict[str, Any]:
        from optuna.distributions import FloatDistribution, IntDistribution

        return {
            axis.name: IntDistribution(math.ceil(axis.low), math.floor(axis.high), log=axis.log)
            if axis.whole
            else FloatDistribution(axis.low, axis.high, log=axis.log)
            for axis in self.definition.axes
        }

    def _sampler(self, number: int) -> Any:
        from optuna.samplers import CmaEsSampler, NSGAIISampler

        definition = self.definition
        seed = int(np.random.SeedSequence([definition.seed, number]).generate_state(1)[0])
        if len(definition.objectives) > 1:
            return NSGAIISampler(
                population_size=definition.population, seed=seed, constraints_func=lambda trial: [trial.user_attrs["violation"]]
            )
        return CmaEsSampler(x0=start_of(definition), seed=seed, popsize=definition.population, n_startup_trials=1)


def start_of(definition: Definition) -> dict[str, Any]:
    """Where a search begins, by axis: the scenario's own values, or the ends of their ranges where these are outside."""
    return {axis.name: min(max(own, axis.low), axis.high) for axis, own in owned(definition)}


def owned(definition: Definition) -> list[tuple[Axis, Any]]:
    """Each axis, and the scenario's own value there."""
    return [(axis, get(definition.scenario, axis.paths[0])) for axis in definition.axes]


def clipped(definition: Definition) -> list[str]:
    """In words, where the scenario's own value lies outside the searched range, so that the search begins elsewhere."""
    starts = start_of(definition)
    return [
        f"{axis.name} is {own:g}, outside its range, {axis.low:g} to {axis.high:g}: the search begins at {starts[axis.name]:g}"
        for axis, own in owned(definition)
        if starts[axis.name] != own
    ]


def violation(row: Mapping[str, Any]) -> float:
    """By how much a member breaks the constraint, as a share of it: <= 0 where it keeps it."""
    if row["status"] not in ("complete", "constraint_lost"):
        return BROKEN
    return -float(row["margin"]) if np.isfinite(row.get("margin", np.nan)) else 0.0


def costs(row: Mapping[str, Any], objectives: Sequence[str]) -> list[float]:
    """What is made small: the objectives, or more than any of them where the constraint is broken."""
    values = [float(row[name]) * merit(name).sign for name in objectives]
    beyond = violation(row)
    kept = feasible(row) and np.all(np.isfinite(values))
    return values if kept else [BEYOND * (1 + min(max(beyond, 0.0), BROKEN))] * len(values)


def feasible(row: Mapping[str, Any]) -> bool:
    """Whether a member ran to its end within the constraint, and all its forces settled."""
    return bool(row["status"] == "complete" and row["unsettled"] == 0)
