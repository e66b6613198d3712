"""How the figures of merit move with twice the modes and with half the step."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from dampen.analysis.audit.finding import Finding, Quantity
from dampen.analysis.refinement import figures_of_merit, finer, run_at
from dampen.component import ArgumentError
from dampen.simulation.kernel import MODES_AT_MOST
from dampen.simulation.result import Result
from dampen.simulation.trials import simulate

MOVES = 0.05
Figures = Mapping[tuple[str, str], float]


def resolution(result: Result) -> Iterator[Finding]:
    """A row for each figure of merit; runs the scenario twice more."""
    own = figures_of_merit(result)
    modes, why = with_twice_the_modes(result)
    step = of_a_whole_run(run_at(result.scenario, 2), result)
    for (name, unit), value in own.items():
        by_modes, by_step = (None if figures is None else figures[name, unit] for figures in (modes, step))
        if value or by_modes or by_step:  # a port that nobody pushes says nothing
            yield moved(name, unit, value, by_modes, by_step, why)


def with_twice_the_modes(result: Result) -> tuple[Figures | None, str]:
    """The figures with twice the modes; or why there are none."""
    count = 2 * result.scenario.numerics.modes
    if count > MODES_AT_MOST:
        return None, f"{count} modes are more than can be had"
    try:
        richer = simulate(finer(result.scenario, modes=count))
    except ArgumentError as error:
        return None, f"{count} modes cannot be had: {error.lines[0].rstrip('.')}"
    return of_a_whole_run(richer, result), ""


def of_a_whole_run(again: Result, result: Result) -> Figures | None:
    """The figures of a run that went as far as the result did. Raises KeyboardInterrupt where it was interrupted."""
    if again.status == "interrupted":
        raise KeyboardInterrupt
    return figures_of_merit(again) if again.trials and again.trials >= result.trials else None


def moved(name: str, unit: str, value: float, modes: float | None, step: float | None, why: str) -> Finding:
    """How far one figure moves."""
    changes = {"twice the modes": change(value, modes), "half the step": change(value, step)}
    known = {how: by for how, by in changes.items() if by is not None}
    holds = None if not known else all(abs(by) <= MOVES for by in known.values())
    told = ", ".join(f"{how} {by:+.1%}" for how, by in known.items())
    worst = max(known, key=lambda how: abs(known[how])) if known else ""
    meaning = (
        "Settled."
        if holds
        else "Not known."
        if holds is None
        else f"Not settled by {worst}: good to {abs(known[worst]):.0%} at best."
    )
    return Finding.of(
        "resolution",
        f"resolution.{name}",
        f"{name} moves by no more than {MOVES:.0%}",
        f"{value:.3g} {unit}; {told or why}",
        holds,
        meaning + (f" ({why[0].upper()}{why[1:]}.)" if why and known else ""),
        {"as it is": Quantity(value, unit), "twice the modes": Quantity(modes, unit), "half the step": Quantity(step, unit)},
    )


def change(value: float, finer: float | None) -> float | None:
    """The finer value against the value, as a share of the larger."""
    if finer is None:
        return None
    most = max(abs(value), abs(finer))
    return (finer - value) / most if most else 0.0
