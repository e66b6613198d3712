"""What a tuning has found: its best candidates, and the scenarios that they make."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dampen.analysis.merits import columns, merit, merits
from dampen.arguments import NOTHING, STUDY, TEXT, takes
from dampen.component import ArgumentError, suggestion
from dampen.simulation.batch import Batch, Tally
from dampen.simulation.scenario import Scenario
from dampen.studies.definition import Definition
from dampen.studies.search import feasible, violation
from dampen.studies.variation import Axis, member
from dampen.toml import to_toml

if TYPE_CHECKING:
    from dampen.studies.study import Study

NEAR = 0.01  # of a range: that near to its end a value is at it
NEAREST = "nearest.toml"


def best_row(study: Study, objective: str) -> dict[str, Any] | None:
    """The row of the member that keeps the constraint and is best in one figure of merit; None: no member keeps it."""
    sign = merit(objective).sign
    rows = [row for row in study.rows.rows if feasible(row)]
    return min(rows, key=lambda row: (sign * row[objective], row["member"]), default=None)


def nearest_row(rows: Iterable[Mapping[str, Any]], objective: str) -> dict[str, Any] | None:
    """Where no row keeps the constraint, the one that breaks it least; None: none ran to its end."""
    sign = merit(objective).sign
    ran = [row for row in rows if row["status"] in ("complete", "constraint_lost")]
    least = min(ran, key=lambda row: (row["unsettled"] > 0, violation(row), sign * row[objective], row["member"]), default=None)
    return None if least is None else dict(least)


def at_ends(definition: Definition, row: Mapping[str, Any]) -> str:
    """In words, what of a row lies at an end of the range that was searched, if it may lie beyond; "" if nothing does."""
    found = []
    for axis in definition.axes:
        side = end_of(axis, float(row[axis.name]))
        if side and _goes_on(definition, axis, side):
            found.append(f"{axis.name} is at the {side} end of its range, {axis.low:g} to {axis.high:g}")
    return "; ".join(found) + (": a wider one may give more" if found else "")


def outcome(study: Study) -> str:
    """What a tuning tells without its report: that nothing kept the constraint, or that the best is at an end of a range."""
    if study.definition.kind != "tune":
        return ""
    objective = study.definition.objectives[0]
    best, nearest = best_row(study, objective), nearest_row(study.rows.rows, objective)
    if best is not None:
        ends = at_ends(study.definition, best)
        return f"{ends}." if ends else ""
    return "" if nearest is None else f"Of {study.done:,} runs {why_not(nearest)}."


def why_not(row: Mapping[str, Any]) -> str:
    """What the nearest row lacks."""
    beyond = violation(row)
    broke = f"none held the constraint; the nearest, member {row['member']}, broke it by {100 * beyond:.3g} %"
    return broke if beyond > 0 else f"none had forces that settled; the nearest is member {row['member']}"


def end_of(axis: Axis, value: float) -> str:
    """ "lower" or "upper" where the value is at that end of a searched range, on its scale; else ""."""
    low, high = (math.ceil(axis.low), math.floor(axis.high)) if axis.whole else (axis.low, axis.high)
    if not low < high:
        return ""
    share = math.log(value / low) / math.log(high / low) if axis.log else (value - low) / (high - low)
    return "lower" if share <= NEAR else "upper" if share >= 1 - NEAR else ""


def _goes_on(definition: Definition, axis: Axis, side: str) -> bool:
    """Whether the scenario takes values beyond an end of the range."""
    beyond = 1.0 if axis.whole else NEAR * min(axis.high - axis.low, abs(axis.low) if axis.log else math.inf)
    try:
        member(definition.scenario, (axis,), {axis.name: axis.low - beyond if side == "lower" else axis.high + beyond})
    except ArgumentError:
        return False
    return True


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
    return renamed(found, "tuned") if definition.kind == "tune" else found


def renamed(scenario: Scenario, how: str) -> Scenario:
    """The scenario, its name with what became of it behind."""
    return replace(scenario, name=f"{scenario.name}-{how}"[:60])


def write_best(study: Study) -> list[Path]:
    """Write the best scenario of a tuning beside its table, one for each objective; returns the paths.

    Where no member keeps the constraint, nearest.toml is the one that breaks it least.
    """
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
    near = study.folder / NEAREST
    if not paths:
        return _write_nearest(study, near)
    near.unlink(missing_ok=True)  # of a part of the search
    return paths


def _write_nearest(study: Study, path: Path) -> list[Path]:
    definition, row = study.definition, nearest_row(study.rows.rows, study.definition.objectives[0])
    if row is None:
        return []
    about = f"# Of a tuning, see study.toml beside it: {why_not(row)}.\n"
    found = renamed(member(definition.scenario, definition.axes, row), "nearest")
    path.write_text(about + to_toml(found), encoding="utf-8")
    return [path]
