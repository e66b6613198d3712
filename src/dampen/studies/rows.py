"""What statistics and report read of a study: its definition, and its rows as arrays over the members."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal, Protocol

import numpy as np

from dampen.simulation.scenario import Scenario
from dampen.studies.variation import Axis

Array = np.ndarray
STATUSES = ("complete", "constraint_lost", "diverged", "refused", "crashed")
JUDGED = ("complete", "constraint_lost", "diverged")  # these ran: the others say nothing about the constraint
LOST = ("constraint_lost", "diverged")


class Definition(Protocol):
    """What a study varies and how. objectives: columns that a tuning improves.   base: rows N of a Saltelli design.

    robust_axes: of a robust tuning, what is uncertain while it tunes.
    """

    @property
    def kind(self) -> Literal["sweep", "robust", "tune"]: ...
    @property
    def scenario(self) -> Scenario: ...
    @property
    def axes(self) -> tuple[Axis, ...]: ...
    @property
    def objectives(self) -> tuple[str, ...]: ...
    @property
    def base(self) -> int: ...
    @property
    def sampler(self) -> str: ...
    @property
    def seed(self) -> int: ...
    @property
    def robust_axes(self) -> tuple[Axis, ...]: ...


class Study(Protocol):
    """Many runs of one scenario. table: a pandas DataFrame, one row for each member that is done.   members: how many in all."""

    @property
    def folder(self) -> Path | None: ...
    @property
    def definition(self) -> Definition: ...
    @property
    def members(self) -> int: ...
    @property
    def table(self) -> Any: ...
    @property
    def done(self) -> int: ...
    @property
    def version(self) -> str: ...


def column(study: Study, name: str) -> Array:
    """(rows,) a column of numbers; nan where it has none, as when every row was refused."""
    if name not in study.table.columns:
        return np.full(len(study.table), np.nan)
    return np.asarray(study.table[name], dtype=float)


def statuses(study: Study) -> Array:
    """(rows,) the status of each row, as strings."""
    return np.asarray(study.table["status"] if len(study.table) else [], dtype=str)


def counts(study: Study) -> dict[str, int]:
    """How many rows have each status; those that do not occur are left out."""
    found = statuses(study)
    return {status: n for status in STATUSES if (n := int((found == status).sum()))}


def by_member(study: Study, values: Array, missing: Any = np.nan) -> Array:
    """(members,) values of the rows at their members' places, `missing` where a member is not done."""
    placed = np.full(study.members, missing, dtype=values.dtype)
    placed[np.asarray(study.table["member"], dtype=int)] = values
    return placed
