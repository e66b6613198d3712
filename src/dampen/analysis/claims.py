"""Claims: statements that a run is held against, each with its criterion, what was measured, and a verdict."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Claim:
    """One row of a claims table. `holds` is what the numbers say, never what the source says."""

    id: str
    statement: str
    criterion: str
    measured: str
    holds: bool

    @property
    def verdict(self) -> str:
        return "PASS" if self.holds else "FAIL"


def verdict_sentence(claims: list[Claim]) -> str:
    """The outcome in one sentence."""
    failed = [claim.id for claim in claims if not claim.holds]
    if not failed:
        return f"All {len(claims)} claims hold in this run."
    return f"{len(claims) - len(failed)} of {len(claims)} claims hold in this run; {', '.join(failed)} {'does' if len(failed) == 1 else 'do'} not."
