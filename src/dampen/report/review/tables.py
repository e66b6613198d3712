"""The review's tables, ready for the page and the terminal."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dampen.analysis.audit.audit import Audit
from dampen.analysis.audit.finding import Finding
from dampen.analysis.credit import Credit, Variant
from dampen.analysis.limit.curve import Limit
from dampen.report.review.words import HEADINGS
from dampen.report.style import DASH, number, percent, quantity
from dampen.studies.record import Record

Rows = Sequence[Sequence[str]]


def audit_tables(audit: Audit) -> list[tuple[str, list[Finding]]]:
    """The findings by section, each with its heading."""
    return [(HEADINGS[section], findings) for section, findings in audit.sections.items()]


def audit_rows(audit: Audit) -> list[tuple[str, str, str, str]]:
    """For the terminal: what does not hold in full, the rest of each section in a line. Section, criterion, measured, verdict."""
    rows = []
    for section, findings in audit.sections.items():
        odd = [f for f in findings if f.verdict != "PASS"]
        held, heading = len(findings) - len(odd), HEADINGS[section]
        if held == 1:
            odd = [f for f in findings if f.verdict != "n/a"]
        elif held:
            judged = sum(f.verdict in ("PASS", "FAIL") for f in findings)
            told = f"all {held} findings hold" if held == judged else f"{held} of {judged} findings hold; not these:"
            told += f"; {len(findings) - judged} cannot be judged" if held == judged < len(findings) else ""
            rows.append((heading, told, "", "PASS" if held == judged else ""))
        rows += [(heading, f.criterion, f.measured, f.verdict) for f in odd if f.verdict != "n/a"]
    return rows


def credit_columns(credit: Credit) -> list[str]:
    """Headings of the credit table."""
    ports = [one.port for one in credit.whole.ports]
    margin = ["margin"] if np.isfinite(credit.whole.margin) else []
    return ["", *(f"residual, {port}" for port in ports), *margin, *(f"effort, {port}" for port in ports), "mean energy"]


def credit_rows(credit: Credit) -> list[tuple[str, ...]]:
    """A row for each variant."""
    return [credit_row(credit, variant) for variant in credit.variants]


def credit_row(credit: Credit, variant: Variant) -> tuple[str, ...]:
    """A variant's figures; of one that could not be run, or that diverged, that."""
    if variant.status in ("refused", "diverged"):
        return (variant.name, variant.status, *([""] * (len(credit_columns(credit)) - 2)))
    margin = [percent(variant.margin)] if np.isfinite(credit.whole.margin) else []
    return (
        variant.name,
        *(quantity(one.residual, one.motion_unit) for one in variant.ports),
        *margin,
        *(quantity(one.effort, one.effort_unit) for one in variant.ports),
        quantity(variant.energy, "J"),
    )


LIMIT_COLUMNS = (
    "RMS of",
    "no control",
    "the run",
    "its effort",
    "least, at that effort",
    "the run / least",
    "least on the curve",
)


def limit_rows(record: Record) -> list[tuple[str, ...]]:
    """Where a run lies against each limit."""
    rows: list[tuple[str, ...]] = []
    for limit, at in zip(record.limits, record.standings, strict=True):
        free, own = (quantity(value, limit.unit) for value in (limit.uncontrolled, at.rms))
        least = ("no bound", DASH) if at.ratio is None else (quantity(at.bound, limit.unit), number(at.ratio))
        rows.append((limit.of, free, own, quantity(at.effort, "N"), *least, lowest(limit)))
    return rows


def lowest(limit: Limit) -> str:
    """The least root mean square of the curve's points, and the effort that it takes; more effort may get lower."""
    point = min(limit.points, key=lambda point: point.rms)
    return f"{quantity(point.rms, limit.unit)} at {quantity(point.effort, 'N')}"
