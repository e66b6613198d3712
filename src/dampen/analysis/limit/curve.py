"""The limit: for each effort the least that any forces at the same ports could reach, with a certificate for every point."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass

import numpy as np

from dampen.analysis.limit.lifted import Lifted, effort_square, mean_square
from dampen.analysis.limit.measure import experiment, measure, measures
from dampen.analysis.limit.riccati import KEPT, gains_size, solve
from dampen.component import wrong
from dampen.simulation.bench import Bench
from dampen.simulation.cores import cores
from dampen.simulation.scenario import Scenario

Array = np.ndarray
Progress = Callable[[int, int], None]
DECADES, PER_DECADE = (1, -7), 2  # of the default weights, about the one at which forces begin to pay
SETTLED, ROUNDS = 1e-13, 6
EFFORT = "N: root of the mean over all steps of the sum over ports of the squared delivered forces, a torque divided by the span"


@dataclass(frozen=True)
class Point:
    """Forces that are best for one weight, and the certificate that none are better.

    weight: r, what the mean square of the effort counts against that of the measure [unit^2/N^2].
    effort: root mean square of these forces [N].   rms: of the measure, under them [unit].
    dual:   what rms^2 + r effort^2 is at least, for any forces whatever [unit^2].
    gap:    how far these forces are above that, relative: 0 up to round-off.
    peak:   largest modulus of the measure under these forces [unit]. It is not bounded: other forces may have a lower one.
    """

    weight: float
    effort: float
    rms: float
    dual: float
    gap: float
    peak: float


@dataclass(frozen=True)
class Limit:
    """The least root mean square of one measure against the effort, for one experiment under any forces at the same ports.

    scenario, experiment: its name, and a digest of all that a controller cannot change.   of, unit: what is measured.
    uncontrolled, uncontrolled_peak: root mean square and peak without forces [unit].
    points: from the largest weight, so with rising effort.   effort_unit: unit and meaning of efforts.
    trials, start, horizon [s], modes, step [s]: of the run.
    """

    scenario: str
    experiment: str
    of: str
    unit: str
    uncontrolled: float
    uncontrolled_peak: float
    points: tuple[Point, ...]
    effort_unit: str
    trials: int
    start: str
    horizon: float
    modes: int
    step: float

    def bound(self, effort: float) -> float:
        """What no forces of this effort [N] can get below [unit]: certified.

        Each point says rms^2 + r effort^2 >= dual for all forces; the bound is the largest that follows from any of them.
        """
        return math.sqrt(max(0.0, *(point.dual - point.weight * effort**2 for point in self.points)))

    def reached(self, effort: float) -> float:
        """What some forces of at most this effort [N] do reach [unit]: mixtures of two neighbouring points' forces.

        The limit lies between `bound` and this.
        """
        efforts = [0.0, *(point.effort**2 for point in self.points)]
        squares = [self.uncontrolled**2, *(point.rms**2 for point in self.points)]
        return float(np.sqrt(np.interp(effort**2, efforts, squares)))


def limits(
    scenario: Scenario,
    weights: Sequence[float] | None = None,
    bench: Bench | None = None,
    progress: Progress | None = None,
    threads: int | None = None,
) -> tuple[Limit, ...]:
    """The limits of all that is measured by default: ports that follow something; else all fields; without any, all ports."""
    bench, names = bench or Bench(scenario), measures(scenario)
    return tuple(limit(scenario, of, weights, bench, _part(progress, i, len(names)), threads) for i, of in enumerate(names))


def limit(
    scenario: Scenario,
    of: str | None = None,
    weights: Sequence[float] | None = None,
    bench: Bench | None = None,
    progress: Progress | None = None,
    threads: int | None = None,
) -> Limit:
    """The least root mean square of a measure that any forces could reach, against their own root mean square.

        min over all u of    mean |e|^2 + r mean |u|^2,    e = free + P u

    for a range of weights r, with the disturbance, and the trials to come, known in advance: linear-quadratic tracking with
    preview over the whole run, from the same start, under forces that are held over each step as the run's are. Actuators do not
    bound it: any force may be delivered, at each port that has an actuator.

    of:       a field (over all snapshots and output points) or a port (its tracking error, at every step); the default is the
              first of what :func:`limits` takes.
    weights:  r [unit^2/N^2]; the default covers eight decades, two points in each, about the one at which forces begin to pay.
    bench:    a set-up to share with a run of the same plant, task and disturbance.
    progress: called with (weights done, weights in all) after each.
    threads:  weights at a time (default: as many as there are cores, and memory for their gains).

    The certificate of a point is weak duality: for any e, and s > 0,  2 s <e, free> - s^2 (|e|^2 + |P* e|^2/r)  is at most the
    minimum; with the best s that is  <e, free>^2 / (|e|^2 + |P* e|^2/r),  which the optimal e brings up to the minimum.

    Raises ArgumentError for an unknown measure, weights that are not positive, and where no port has an actuator.
    Source: Anderson & Moore, Optimal Control: Linear Quadratic Methods, 1990; Boyd & Vandenberghe, Convex Optimization, ch. 5.
    """
    bench = bench or Bench(scenario)
    lifted = Lifted(scenario, bench, measure(scenario, measures(scenario)[0] if of is None else of, bench))
    free = lifted.free
    chosen = _default_weights(lifted) if weights is None else sorted((_positive(r) for r in weights), reverse=True)
    return Limit(
        scenario=scenario.name,
        experiment=experiment(scenario),
        of=lifted.measure.of,
        unit=lifted.measure.unit,
        uncontrolled=math.sqrt(mean_square(free)),
        uncontrolled_peak=float(np.max(np.abs(free))),
        points=_points(lifted, chosen, progress, threads),
        effort_unit=EFFORT,
        trials=scenario.task.trials,
        start=scenario.task.start,
        horizon=scenario.task.trial_duration * (scenario.task.trials if lifted.chained else 1),
        modes=bench.modes.count,
        step=scenario.numerics.step,
    )


def _points(lifted: Lifted, weights: Sequence[float], progress: Progress | None, threads: int | None) -> tuple[Point, ...]:
    """The points of all weights, in their order, some at a time."""
    pull = lifted.adjoint(lifted.free)
    room = max(1, 2 * KEPT // max(1, gains_size(lifted)))
    pool = ThreadPoolExecutor(min(threads or cores(), room))
    try:
        futures = [pool.submit(_point, lifted, weight, pull) for weight in weights]
        for done, _ in enumerate(as_completed(futures), 1):
            if progress:
                progress(done, len(weights))
        return tuple(future.result() for future in futures)
    finally:
        pool.shutdown(cancel_futures=True)


def _point(lifted: Lifted, weight: float, pull: Array) -> Point:
    """The best forces for one weight: solved for, and again for what round-off has left, as long as that is of use.

    pull: P* free, the gradient without forces. A gradient g is at most |g|^2/weight above the minimum.
    """
    forces, error, back = np.zeros_like(pull), lifted.free, pull
    primal = mean_square(error)
    for _ in range(ROUNDS):
        gradient = back + weight * forces
        if effort_square(gradient) <= SETTLED * weight * primal:
            break
        better = forces - solve(lifted, weight, gradient)
        found = lifted.under(better)
        reached = mean_square(found) + weight * effort_square(better)
        if not reached < primal:
            break
        forces, error, back, primal = better, found, lifted.adjoint(found), reached
    below = mean_square(error) + effort_square(back) / weight
    dual = min(max(0.0, float(np.mean(error * lifted.free))) ** 2 / below if below else 0.0, primal)
    return Point(
        weight=weight,
        effort=math.sqrt(effort_square(forces)),
        rms=math.sqrt(mean_square(error)),
        dual=dual,
        gap=(primal - dual) / primal if primal else 0.0,
        peak=float(np.max(np.abs(error))),
    )


def _default_weights(lifted: Lifted) -> list[float]:
    """About |P* free|^2/|free|^2, the gain of the ports for what is there to be cancelled; 1 where they can do nothing."""
    gain = effort_square(lifted.adjoint(lifted.free)) / (mean_square(lifted.free) or 1.0)
    highest, lowest = DECADES
    return [gain * 10.0 ** (highest - i / PER_DECADE) for i in range(PER_DECADE * (highest - lowest) + 1)] if gain else [1.0]


def _positive(weight: float) -> float:
    if not 0 < weight < math.inf:
        raise wrong("weights", "be finite numbers > 0", weight)
    return float(weight)


def _part(progress: Progress | None, index: int, parts: int) -> Progress | None:
    """Progress through one of several equal parts."""
    return None if progress is None else lambda done, every: progress(index * every + done, parts * every)
