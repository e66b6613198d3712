"""What the templates need of a review."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from dampen.analysis.audit.finding import Finding
from dampen.analysis.rates import Rates
from dampen.report.review import words
from dampen.report.review.tables import LIMIT_COLUMNS, audit_tables, credit_columns, credit_rows, limit_rows
from dampen.report.style import number
from dampen.studies.record import Record

LOWEST = 10  # modes of the rates' table
SLOWEST, LEFT_OUT = " (slowest)", ", left out"
ACTING = {
    "continuous": "acting continuously",
    "sampled": "acting from sample to sample",
}


@dataclass(frozen=True)
class Table:
    """A table of the page: what it shows above it, notes and figures below it."""

    heading: str
    about: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]
    notes: Sequence[str] = ()
    figures: Sequence[Any] = ()


@dataclass(frozen=True)
class Parts:
    """A review for a page: the words, the audit's tables with its figures, and the tables of the other parts."""

    sentence: str
    paragraphs: Sequence[tuple[str, Sequence[str]]]
    audit: Sequence[tuple[str, Sequence[Finding]]]
    tables: Sequence[Table]
    figures: Sequence[Any] = ()


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
        tables=list(tables(record, figures)),
        figures=named(figures, "sticking"),
    )


def named(figures: Sequence[Any], name: str) -> list[Any]:
    """The figures whose names begin so."""
    return [figure for figure in figures if figure["name"].startswith(name)]


def tables(record: Record, figures: Sequence[Any] = ()) -> list[Table]:
    """The tables of the parts beside the audit, each with its figures."""
    found = []
    if record.audit is not None and isinstance(record.audit.rates, Rates):
        found.append(rates_table(record.audit.rates))
    if record.credit is not None:
        about = (
            "The experiment with one part left out at a time. Residual: RMS error of the last five trials; effort: RMS of the "
            "delivered force over the run."
        )
        refused = [f"{v.name}: {v.meaning}" for v in record.credit.variants if v.status == "refused"]
        found.append(
            Table("Credit", about, credit_columns(record.credit), credit_rows(record.credit), refused, named(figures, "credit"))
        )
    if record.limits:
        about = (
            "The least RMS, over structure and run, that any forces at the same ports could reach, knowing the disturbance in "
            "advance: for the run's own effort (RMS of all delivered forces, a torque divided by the span), and for any."
        )
        notes = words.limited(record.limits, record.standings)
        found.append(Table("The limit", about, LIMIT_COLUMNS, limit_rows(record), notes, named(figures, "limit_")))
    return found


def rates_table(found: Rates) -> Table:
    """The closed loop mode by mode: the lowest, and after a gap the slowest and the highest."""
    told = {found.slowest, len(found.modes), *found.growing}
    shown = [m for m in found.modes if m.number <= LOWEST or m.number in told]
    known = any(not m.known for m in found.modes)
    columns = ["mode", "plant [Hz]", "plant decays [1/s]", "closed loop [Hz]", "decays [1/s]", "damping ratio"]
    rows = []
    for m in shown:
        name = f"{m.number}{SLOWEST * (m.number == found.slowest)}{LEFT_OUT * (known and not m.known)}"
        rates = (m.plant_frequency, m.plant_rate, m.frequency, m.rate, m.ratio)
        rows.append((name, *(number(value) for value in rates)))
    count = len(found.modes)
    about = f"Eigenvalues of the loop around all {count} modes, the law {ACTING[found.loop]}; {len(rows)} of the modes are shown."
    return Table("Rates", about, columns, rows, found.notes)
