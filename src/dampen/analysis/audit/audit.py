"""The audit: all findings about a run."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from dampen.analysis.audit.assumptions import assumptions
from dampen.analysis.audit.boundedness import boundedness
from dampen.analysis.audit.composite import composite
from dampen.analysis.audit.energetics import energetics
from dampen.analysis.audit.finding import Finding
from dampen.analysis.audit.loop import bound_rows, rate_rows
from dampen.analysis.audit.residual import residual
from dampen.analysis.audit.resolution import resolution
from dampen.analysis.bounds import Bounds, bounds
from dampen.analysis.rates import NoRates, Rates, rates
from dampen.arguments import BENCH, RESULT, TRUTH, takes
from dampen.component import ArgumentError
from dampen.simulation.bench import Bench
from dampen.simulation.result import Result


@dataclass(frozen=True)
class Audit:
    """What was found in a run of a scenario, section by section; the closed loop's rates, and the a-priori bounds."""

    scenario: str
    findings: tuple[Finding, ...]
    rates: Rates | NoRates
    bounds: Bounds

    def __getitem__(self, id: str) -> Finding:
        return next(finding for finding in self.findings if finding.id == id)

    @property
    def failed(self) -> tuple[Finding, ...]:
        """The findings that do not hold."""
        return tuple(finding for finding in self.findings if finding.verdict == "FAIL")

    @property
    def sections(self) -> dict[str, list[Finding]]:
        """The findings by section, in order."""
        found: dict[str, list[Finding]] = {}
        for finding in self.findings:
            found.setdefault(finding.section, []).append(finding)
        return found


@takes(result=RESULT, refine=TRUTH, bench=BENCH)
def audit(result: Result, *, refine: bool = True, bench: Bench | None = None) -> Audit:
    """Audit a run: its energy account, its resolution, the assumptions of its law, its bounds, and the proof's energy.

    refine: whether the scenario is run again with twice the modes and with half the step, which takes some six times as long
            as the run itself; without it that section is left out.
    bench:  the set-up that the run was made on, if it is at hand.

    Raises ArgumentError for a result without a finished trial.
    """
    if not result.trials:
        raise ArgumentError("Argument `result` must have a finished trial, but has none.")
    bench = bench or Bench(result.scenario)
    found, limits = rates(result.scenario, bench), bounds(result, bench)
    loop = (*rate_rows(found, result.scenario), *bound_rows(limits, result.scenario))
    whole = Audit(result.scenario.name, (*findings(result, bench), *loop), found, limits)
    return refined(whole, result) if refine else whole


def refined(found: Audit, result: Result) -> Audit:
    """The audit of a run with its section on resolution, for which the scenario is run twice more."""
    first = [finding for finding in found.findings if finding.section == "energy"]
    rest = [finding for finding in found.findings if finding.section not in ("energy", "resolution")]
    return replace(found, findings=(*first, *resolution(result), *rest))


def findings(result: Result, bench: Bench) -> Iterator[Finding]:
    """The rows of the run itself, in the order of the page."""
    yield from energetics(result, bench)
    yield from assumptions(result, bench)
    yield from residual(result, bench)
    yield from boundedness(result)
    yield from composite(result)
