"""What an audit finds: rows, each with a criterion, what was measured, a verdict and what it means."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

Number = float | int | None
Values = Mapping[str, "Quantity"]
Verdict = Literal["PASS", "FAIL", "n/a", "note"]
Section = Literal[
    "energy",
    "resolution",
    "assumptions",
    "residual",
    "boundedness",
    "composite energy",
    "gain conditions",
    "rates",
    "bounds",
]


@dataclass(frozen=True)
class Quantity:
    """A number, or a row of them (one a trial, unless its name says otherwise), with its unit."""

    value: float | int | str | tuple[Number, ...] | None
    unit: str = ""


@dataclass(frozen=True)
class Finding:
    """One row. id: its name in files.   measured: as it is read; `values` has the numbers behind it, by name.

    verdict: PASS or FAIL; n/a where nothing can be said; note for what is told and not judged.
    """

    section: Section
    id: str
    criterion: str
    measured: str
    verdict: Verdict
    meaning: str
    values: Values

    @staticmethod
    def of(
        section: Section,
        id: str,
        criterion: str,
        measured: str,
        holds: bool | None,
        meaning: str,
        values: Values,
        judged: bool = True,
    ) -> Finding:
        """A row by what the numbers say: holds, does not, or (None) cannot be said."""
        verdict: Verdict = "note" if not judged else "n/a" if holds is None else "PASS" if holds else "FAIL"
        return Finding(section, id, criterion, measured, verdict, meaning, values)
