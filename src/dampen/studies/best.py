"""What a tuning has found: its best candidates, and the scenarios that they make."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dampen.analysis.merits import columns, merit, merits
from dampen.arguments import NOTHING, STUDY, TEXT, takes
from dampen.component import ArgumentError, suggestion
from dampen.simulation.batch import Batch, Tally
from dampen.simulation.scenario import Scenario
from dampen.studies.search import feasible
from dampen.studies.variation import member
from dampen.toml import to_toml

if TYPE_CHECKING:
    from dampen.studies.study import Study


def best_row(study: Study, objective: str) -> dict[str, Any] | None:
    """The row of the member that keeps the constraint and is best in one figure of merit; None: no member keeps it."""
    sign = merit(objective).sign
    rows = [row for row in study.rows.rows if feasible(row)]
    return min(rows, key=lambda row: (sign * row[objective], row["member"]), default=None)


def nominal_merits(study: Study) -> dict[str, float] | None:
    """The figures of merit of the scenario as it is; None where it cannot be run."""
    (outcome,) = Batch(study.definition.scenario).run([study.definition.scenario])
    return merits(outcome) if isinstance(outcome, Tally) else None


@takes(study=STUDY, objective=TEXT | NOTHING)
def best_scenario(study: Study, objective: str | None = None) -> Scenario:
    """The scenario of the best member, in the study's first objective unless told. Raises ArgumentError where there is none."""
    definition = study.definition
    known = columns(definition.scenario)
    if objective is not None and objective not in known:
        raise ArgumentError(f"Argument `objective` must be a figure of merit, but is {objective!r}{suggestion(objective, known)}")
    row = best_row(study, objective or (*definition.objectives, "peak")[0])
    if row is None:
        raise ArgumentError("This study has no member yet that keeps the constraint.")
    found = member(definition.scenario, definition.axes, definition.design[row["member"]] if definition.design else row)
    return replace(found, name=f"{found.name}-tuned"[:60] if definition.kind == "tune" else found.name)


def write_best(study: Study) -> list[Path]:
    """Write the best scenario of a tuning beside its table, one for each objective; returns the paths."""
    if study.definition.kind != "tune" or study.folder is None:
        return []
    several, paths = len(study.definition.objectives) > 1, []
    for objective in study.definition.objectives:
        row = best_row(study, objective)
        if row is None:
            continue
        plain = re.sub(r"[^\w.-]", "_", objective)
        path = study.folder / (f"best-{plain}.toml" if several else "best.toml")
        about = f"# Member {row['member']} of a tuning, see study.toml beside it: {objective} is {row[objective]:.4g}.\n"
        path.write_text(about + to_toml(best_scenario(study, objective)), encoding="utf-8")
        paths.append(path)
    return paths
