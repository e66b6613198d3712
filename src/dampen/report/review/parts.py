"""What the templates need of a review."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from dampen.analysis.audit.finding import Finding
from dampen.report.review import words
from dampen.report.review.tables import audit_tables, credit_columns, credit_rows
from dampen.studies.record import Record


@dataclass(frozen=True)
class Table:
    """A table of the page, with what it shows above it and notes below it."""

    heading: str
    about: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]
    notes: Sequence[str] = ()


@dataclass(frozen=True)
class Parts:
    """A review for a page: the words, the audit's tables, and the tables of the other parts."""

    sentence: str
    paragraphs: Sequence[tuple[str, Sequence[str]]]
    audit: Sequence[tuple[str, Sequence[Finding]]]
    tables: Sequence[Table]
    figures: Sequence[Any] = field(default=())


def parts(record: Record, figures: Sequence[Any] = ()) -> Parts:
    """The review that a record makes; figures: as the templates have them."""
    audit = record.audit
    return Parts(
        sentence="" if audit is None else words.sentence(audit),
        paragraphs=[
            ("What holds", [] if audit is None else words.holding(audit)),
            ("What does not", [] if audit is None else words.failing(audit)),
            ("Why", words.reasons(audit, record.credit)),
        ],
        audit=() if audit is None else audit_tables(audit),
        tables=list(tables(record)),
        figures=figures,
    )


def tables(record: Record) -> list[Table]:
    """The tables of the parts beside the audit."""
    found = []
    if record.credit is not None:
        about = (
            "The experiment with one part left out at a time. Residual: RMS error of the last five trials; effort: RMS of the "
            "delivered force over the run."
        )
        refused = [f"{v.name}: {v.meaning}" for v in record.credit.variants if v.status == "refused"]
        found.append(Table("Credit", about, credit_columns(record.credit), credit_rows(record.credit), refused))
    return found
