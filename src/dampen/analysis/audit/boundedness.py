"""Is every signal bounded along the trials, and how much of the constraint is left?"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from dampen.analysis.audit.finding import Finding, Quantity
from dampen.analysis.merits import LATE
from dampen.analysis.metrics import fraction_of_limit, largest
from dampen.simulation.result import Result

Array = np.ndarray
GROWTH, FEWEST = 1.05, 10
FOOLED = 0.01  # how likely chance alone may fail a row of trials that differ by chance, at most
SIGNALS = ("y", "v", "command", "delivered")


def boundedness(result: Result) -> Iterator[Finding]:
    """A row for each signal at each port, one for the energy, and one for each constraint."""
    judge = bounded_by_chance if result.scenario.by_chance else bounded
    for signal in signals(result):
        yield judge(*signal)
    for name in result.scenario.task.constraint:
        yield margin(result, name)


def signals(result: Result) -> Iterator[tuple[str, str, Array, str]]:
    """Name, port ("" for the energy), largest value of each trial and unit of each signal that is to be bounded."""
    learned = [name for name, v in result.layout.variables.items() if v.meaning.startswith("learned ")]
    for port in result.scenario.plant.ports:
        for name in (*SIGNALS, *learned):
            by_trial = largest(result, name, port.name)
            if np.any(by_trial):
                yield name, port.name, by_trial, signal_unit(name, port)
    yield "energy", "", largest(result, "energy"), "J"


def signal_unit(name: str, port: object) -> str:
    """The unit of a signal at a port; "" where only the law knows it."""
    motion, effort = getattr(port, "motion_unit", ""), getattr(port, "effort_unit", "")
    return {"y": motion, "v": f"{motion}/s", "command": effort, "delivered": effort}.get(name, "")


def late_trials(trials: int) -> int:
    """A fifth of the trials, and five at the least: those whose signals are held against what was before."""
    return max(LATE, trials // LATE)


def bounded(name: str, port: str, by_trial: Array, unit: str) -> Finding:
    """Whether the largest value of the last trials, a fifth of all and five at the least, is no more than those before.

    What grows in proportion to the trials is a quarter larger in the last fifth, however long the run.
    """
    where, few = (f" at {port}" if port else ""), len(by_trial) < FEWEST
    fifth = late_trials(len(by_trial))
    before, late = (np.inf, by_trial.max()) if few else (by_trial[:-fifth].max(), by_trial[-fifth:].max())
    finite, growth = bool(np.all(np.isfinite(by_trial))), late / before if before else 1.0 if not late else np.inf
    holds = False if not finite else None if few else bool(growth <= GROWTH)
    meaning = (
        f"Fewer than {FEWEST} trials show no trend."
        if few and finite
        else "It keeps growing along the trials."
        if not holds
        else "It does not grow along the trials."
    )
    trend = "" if few else f"; last {fifth} {growth:.0%} of those before"
    return Finding.of(
        "boundedness",
        f"bounded.{name}{'.' if port else ''}{port}",
        f"largest |{name}|{where} of the last {fifth} trials <= 105 % of those before",
        f"{by_trial.max():.3g} {unit}".rstrip() + trend,
        holds,
        meaning,
        {"largest, by trial": Quantity(tuple(map(float, by_trial)), unit)},
    )


def late_ones(trials: int) -> tuple[int, float]:
    """How many of the last fifth must pass all before for growth: more than half, and so many that chance hardly does it.

    Returns that number k and its probability, m late ones among N independent trials alike: that of the k largest of all being
    late ones, C(m, k) / C(N, k).
    """
    late = late_trials(trials)
    for k in range(late // 2 + 1, late + 1):
        chance = math.comb(late, k) / math.comb(trials, k)
        if chance <= FOOLED:
            break
    return k, chance


def bounded_by_chance(name: str, port: str, by_trial: Array, unit: str) -> Finding:
    """The same where trials differ by chance: how many of the last fifth are larger than 105 % of all before.

    The largest of a fifth of independent trials is the largest of all in a fifth of all runs, and says nothing.
    """
    trials = len(by_trial)
    if trials < FEWEST or not np.all(np.isfinite(by_trial)):
        return bounded(name, port, by_trial, unit)
    late, (most, chance) = late_trials(trials), late_ones(trials)
    above = int(np.sum(by_trial[-late:] > GROWTH * by_trial[:-late].max()))
    grows = above >= most
    likely = f"{100 * chance:.1g} %" if chance >= 1e-4 else "less than 0.01 %"
    return Finding.of(
        "boundedness",
        f"bounded.{name}{'.' if port else ''}{port}",
        f"largest |{name}|{f' at {port}' if port else ''} > 105 % of all before in fewer than {most} of the last {late} trials",
        f"{by_trial.max():.3g} {unit}".rstrip() + f"; {above} of the last {late} above 105 % of those before",
        not grows,
        f"It {'keeps growing' if grows else 'does not grow'} along the trials, which differ by chance. Where they are "
        f"independent and alike, chance alone fails this row in {likely} of runs at most.",
        {"largest, by trial": Quantity(tuple(map(float, by_trial)), unit)},
    )


def margin(result: Result, port: str) -> Finding:
    """What was left of a constraint."""
    left = 1 - fraction_of_limit(result, port)
    worst = int(np.argmin(left))
    return Finding.of(
        "boundedness",
        f"margin.{port}",
        f"{port} inside its constraint at every step",
        f"{left.min():.1%} left in trial {worst}; {left[-1]:.1%} in the last",
        bool(left.min() > 0 and result.status != "diverged"),
        "The share of the constraint that was never used." if left.min() > 0 else "The constraint was lost.",
        {"margin, by trial": Quantity(tuple(map(float, left)))},
    )
