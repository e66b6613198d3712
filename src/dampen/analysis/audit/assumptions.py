"""What the proof behind a law takes for granted, looked at as the run had it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Literal

import numpy as np

from dampen.analysis.audit.finding import Finding, Quantity
from dampen.analysis.audit.sticking import Sticking, sticking
from dampen.analysis.metrics import largest
from dampen.controllers.base import Assumption
from dampen.simulation.bench import Bench
from dampen.simulation.result import Result

Array = np.ndarray
EQUAL = 1e-9  # of the largest displacement: closer starts are equal
ROUND_OFF = 1 + 1e-12
SAME = 1e-12  # of the largest: closer samples are equal


def assumptions(result: Result, bench: Bench) -> Iterator[Finding]:
    """A row for each assumption that the law relies on, and how the ports stick."""
    for name in result.scenario.controller.relies_on:
        yield from ROWS[name](result, bench)
    if "moving ports" not in result.scenario.controller.relies_on:
        yield from moving(result, bench)


def farthest_start(result: Result, from_: Literal["last end", "first start"]) -> float:
    """How far any trial's start is from the end of the last one, or from the start of trial 0: displacements of the ports as
    shares of the largest at starts and ends, and energies likewise; the larger of the two."""
    ends = [(np.asarray(result["y"][j])[[0, -1]], np.asarray(result["energy"][j])[[0, -1], None]) for j in range(result.trials)]
    apart = 0.0
    for values in map(np.array, zip(*ends, strict=True)):
        starts, other = (values[1:, 0], values[:-1, 1]) if from_ == "last end" else (values[:, 0], values[:1, 0])
        scale = np.maximum(np.abs(values).max(axis=(0, 1)), 1e-300)
        apart = max(apart, float((np.abs(starts - other) / scale).max(initial=0.0)))
    return apart


def alignment(result: Result, bench: Bench) -> Iterator[Finding]:
    """Assumption 2: each trial starts where the last one ended."""
    jump = farthest_start(result, "last end")
    aligned = jump <= EQUAL
    lost = "Trials are put back in between: what the proof carries from trial to trial is lost with every reset."
    yield Finding.of(
        "assumptions",
        "assumption.alignment",
        "each trial starts where the last one ended (alignment)",
        "no jump" if aligned else f"{jump:.1%} of the largest displacement or energy off",
        aligned,
        "Trials are chained." if aligned else lost,
        {"largest jump": Quantity(jump)},
    )


def equal_starts(result: Result, bench: Bench) -> Iterator[Finding]:
    """Learning from a fixed start: every trial starts as trial 0 did."""
    apart = farthest_start(result, "first start")
    equal = apart <= EQUAL
    partly = "Starts differ: what is learned from one start is only partly right for the next, and the error settles above zero."
    yield Finding.of(
        "assumptions",
        "assumption.equal-starts",
        "each trial starts as trial 0 did",
        "equal" if equal else f"up to {apart:.2g} of the largest displacement or energy apart",
        equal,
        "Starts are equal." if equal else partly,
        {"largest difference": Quantity(apart)},
    )


def repetition(result: Result, bench: Bench) -> Iterator[Finding]:
    """Learning of what repeats: the same disturbance and reference in every trial."""
    task = result.scenario.task
    shaken, looked = shaken_otherwise(result, bench)
    first = result.scenario.reference(0)
    asked = [j for j in range(1, result.trials) if task.reference and np.any(result.scenario.reference(j) != first)]
    changed = sorted({*shaken, *asked})
    yield Finding.of(
        "assumptions",
        "assumption.repetition",
        "every trial has the disturbance and the reference of trial 0",
        (f"{len(changed)} of {result.trials} trials differ" if changed else "all alike") + looked,
        not changed,
        "What is to be learned repeats."
        if not changed
        else "The disturbance changes from trial to trial: learning answers the last trial's, not this one's."
        if shaken
        else "The reference changes from trial to trial: what was learned belongs to another one.",
        {"trials that differ": Quantity(tuple(changed))},
    )


def shaken_otherwise(result: Result, bench: Bench) -> tuple[list[int], str]:
    """The trials whose disturbance is not that of trial 0, and how they were looked at.

    What a disturbance does not say of itself, `same_as`, its samples say: in the first such trials, the middle and the last.
    Trials in between are as those looked at.
    """
    source = result.scenario.disturbance
    claimed = [j for j in range(1, result.trials) if source.same_as(j) != source.same_as(0)]
    if not claimed:
        return [], ""
    first = [np.array(part) for part in bench.shaking(0)[:2]]  # a bench may keep only the last
    some = sorted({*claimed[:2], claimed[len(claimed) // 2], claimed[-1]})
    differ = [j for j in some if not all(map(alike, bench.shaking(j)[:2], first))]
    if len(differ) == len(some):
        return claimed, ""
    return differ, f" of {len(some) + 1} that were looked at" if len(some) < len(claimed) else ""


def alike(one: Array, other: Array) -> bool:
    """Whether two samplings are the same to round-off."""
    scale = max(np.abs(one).max(initial=0.0), np.abs(other).max(initial=0.0))
    return bool(np.abs(one - other).max(initial=0.0) <= SAME * scale)


def bounds(result: Result, bench: Bench) -> Iterator[Finding]:
    """Assumptions 3 and 4: the disturbances stay within what the controller was told."""
    stated = result.scenario.bounds
    for port in result.scenario.plant.ports:
        if port.name in stated:
            yield within(
                f"|d| at {port.name}",
                port.name,
                float(largest(result, "disturbance", port.name).max()),
                stated[port.name],
                port.effort_unit,
            )
    if "f" in stated:
        load, uncovered = largest_load(result, bench)
        yield within("|f(x, t)|", "f", load, stated["f"], "N/m", uncovered)


def within(what: str, key: str, measured: float, stated: float, unit: str, uncovered: str = "") -> Finding:
    """One disturbance against its stated bound; `uncovered` is what no bound of that kind can cover."""
    holds = measured <= stated * ROUND_OFF and not uncovered
    return Finding.of(
        "assumptions",
        f"assumption.bound.{key}",
        f"{what} <= {stated:g} {unit}, as stated",
        f"{measured:.4g} {unit}",
        bool(holds),
        uncovered
        or (
            "The disturbance stays within what the controller was told."
            if holds
            else "The disturbance is larger than the controller was told: its switching gain is made for less."
        ),
        {"largest": Quantity(measured, unit), "stated": Quantity(stated, unit)},
    )


def largest_load(result: Result, bench: Bench) -> tuple[float, str]:
    """Largest |f(x, t)| of the distributed loads at the output points and the middles of the steps [N/m], and what a bound on it
    does not cover."""
    found, t, uncovered = 0.0, bench.midpoints, ""
    source, site = result.scenario.disturbance, bench.site
    for trial in sorted({source.same_as(j) for j in range(result.trials)}):
        total: dict[str, Array] = {}
        for part in source.parts:
            if part.load_field is not None:
                load = part.load(trial, t, bench.x, site)
                total[part.load_field] = total[part.load_field] + load if part.load_field in total else load
            if part.point_field is not None:
                uncovered = "A concentrated load acts too: no bound in N/m covers it."
            if part.base_acceleration(trial, t[:1], site) is not None:
                uncovered = "The base is shaken too: no bound in N/m covers it."
        found = max(found, *(float(np.abs(load).max()) for load in total.values()), 0.0)
    return found, uncovered


def moving(result: Result, bench: Bench) -> Iterator[Finding]:
    """Assumption 5: no port stands still for a whole trial."""
    found = sticking(result)
    relied = "moving ports" in result.scenario.controller.relies_on
    if found is None:
        if relied:
            why = "Through samples nothing sticks exactly: whether a port stands still cannot be counted."
            yield Finding.of(
                "assumptions", "assumption.moving", "no port stands still for a trial", "through samples", None, why, {}
            )
    elif relied or any(found.share):
        for i in range(len(found.ports)):
            yield still(found, i, result.scenario.task.trial_duration, relied)


def still(found: Sticking, i: int, duration: float, relied: bool) -> Finding:
    """Whether a port stands still for a whole trial."""
    port, longest, trials = found.ports[i], found.longest[i], found.still[i]
    moves = not trials and longest < duration
    through = f", through {len(trials)} whole trial{'s' * (len(trials) > 1)}" if trials else ""
    stuck = f"stuck {found.share[i]:.0%} of the time; longest {longest:.3g} s, from t = {found.longest_at[i]:.4g} s{through}"
    return Finding.of(
        "assumptions",
        f"assumption.moving.{port}",
        f"{port} does not stand still for a trial of {duration:g} s",
        stuck if longest else "never stuck",
        moves,
        ("It sticks, but never for a whole trial." if longest else "It keeps moving.")
        if moves
        else "It stands still for whole trials: nothing is measured or learned there, and no energy leaves through it.",
        {
            "share of steps stuck": Quantity(found.share[i]),
            "longest stick": Quantity(longest, "s"),
            "longest stick begins": Quantity(found.longest_at[i], "s"),
            "trials without motion": Quantity(trials),
        },
        judged=relied,
    )


ROWS: dict[Assumption, Callable[[Result, Bench], Iterator[Finding]]] = {
    "alignment": alignment,
    "equal starts": equal_starts,
    "repetition": repetition,
    "bounds": bounds,
    "moving ports": moving,
}
