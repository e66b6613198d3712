"""A study's rows as arrays: what statistics and report read of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from dampen.studies.study import Study

Array = np.ndarray
STATUSES = ("complete", "constraint_lost", "diverged", "refused", "crashed")
JUDGED = ("complete", "constraint_lost", "diverged")  # these ran: the others say nothing about the constraint
LOST = ("constraint_lost", "diverged")


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
