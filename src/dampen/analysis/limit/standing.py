"""Where a run lies against the limit."""

from __future__ import annotations

from dataclasses import dataclass

from dampen.analysis.limit.curve import Limit
from dampen.analysis.limit.measure import effort, experiment, measured
from dampen.arguments import RESULT, of_class, takes
from dampen.component import ArgumentError
from dampen.simulation.result import Result

ROUNDING = 1e-6  # of a result's fields, which are kept in single precision


@dataclass(frozen=True)
class Standing:
    """Where a run lies against the limit of one measure.

    effort, rms: of the run [N], [unit].   peak: its largest modulus of the measure [unit], which the limit does not bound.
    bound:   what no forces of this effort can get below, certified [unit].   reached: what some forces of it do reach [unit].
    ratio:   rms / bound, None where the bound is 0.   below: whether the run is below the bound, which cannot be.
    """

    of: str
    unit: str
    effort: float
    rms: float
    peak: float
    bound: float
    reached: float
    ratio: float | None
    below: bool


@takes(limit=of_class("Limit"), result=RESULT)
def standing(limit: Limit, result: Result) -> Standing:
    """Where a run lies against a limit of the same experiment, under whatever controller.

    Raises ArgumentError for a run of another experiment, and for one that broke off.
    """
    if result.trials != limit.trials:
        raise ArgumentError(f"Argument `result` must have finished all {limit.trials} trials, but has {result.trials}.")
    if experiment(result.scenario) != limit.experiment:
        raise ArgumentError(
            f"Argument `result` must be a run of the limit's own experiment, {limit.scenario}, but plant, disturbance, task, "
            "numerics, output or ports without an actuator differ."
        )
    spent, (rms, peak) = effort(result), measured(result, limit.of)
    bound = limit.bound(spent)
    return Standing(
        of=limit.of,
        unit=limit.unit,
        effort=spent,
        rms=rms,
        peak=peak,
        bound=bound,
        reached=limit.reached(spent),
        ratio=rms / bound if bound else None,
        below=rms < (1 - ROUNDING) * bound,
    )
