"""Claims: statements that a run is held against, each with its criterion, what was measured, and a verdict."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Claim:
    """One row of a claims table. `holds` is what the numbers say; None where they say nothing, of a short run or another law."""

    id: str
    statement: str
    criterion: str
    measured: str
    holds: bool | None

    @property
    def verdict(self) -> str:
        return "n/a" if self.holds is None else "PASS" if self.holds else "FAIL"


def verdict_sentence(claims: Sequence[Claim]) -> str:
    """The outcome in one sentence."""
    if not claims:
        return "This run is held against no claims."
    failed = [claim.id for claim in claims if claim.holds is False]
    unknown = [claim.id for claim in claims if claim.holds is None]
    sentence = f"{sum(claim.holds is True for claim in claims)} of {len(claims)} claims hold in this run"
    if failed:
        sentence += f"; {', '.join(failed)} {'does' if len(failed) == 1 else 'do'} not"
    if unknown:
        sentence += f"; {', '.join(unknown)} cannot be judged in it"
    return sentence + "."
