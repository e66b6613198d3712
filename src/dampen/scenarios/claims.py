"""From a scenario's `claims` key to the claims themselves."""

from __future__ import annotations

from collections.abc import Sequence

from dampen.analysis.claims import Claim
from dampen.arguments import NOTHING, RESULT, takes
from dampen.scenarios.figures import FigurePlan
from dampen.scenarios.he2017.claims import he2017_claims
from dampen.scenarios.he2017.figures import FIGURES, GAINS, KEY, NOTE
from dampen.simulation.result import Result


@takes(result=RESULT, baseline=RESULT | NOTHING)
def check_claims(result: Result, baseline: Result | None) -> list[Claim]:
    """The rows of the claims that the scenario names, measured on this run; `baseline` is the run without control."""
    if result.scenario.claims != "he2017" or baseline is None or not result.trials or not baseline.trials:
        return []
    return he2017_claims(result, baseline)


def figure_plan(result: Result) -> Sequence[FigurePlan] | None:
    """The figures that belong to the claims; None for a scenario without."""
    return FIGURES if result.scenario.claims == "he2017" else None


def legend(result: Result) -> str:
    """What the claims are called after."""
    return KEY if result.scenario.claims == "he2017" else ""


def note(result: Result) -> str:
    """What a reader of the results must know beforehand."""
    if result.scenario.claims != "he2017":
        return ""
    return f"{GAINS} {NOTE}" if result.scenario.controller.kind == "dual-loop-ailc" else NOTE
