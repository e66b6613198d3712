"""The limit: for each effort the least that any forces at the same ports could reach, with a certificate for every point."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from dampen.analysis.limit.best import best_forces
from dampen.analysis.limit.lifted import Lifted, effort_square, mean_square
from dampen.analysis.limit.measure import experiment, measure, measures
from dampen.analysis.limit.riccati import KEPT, gains_size
from dampen.arguments import BENCH, NOTHING, POSITIVES, PROGRESS, SCENARIO, TEXT, count, takes
from dampen.component import wrong
from dampen.simulation.bench import Bench
from dampen.simulation.cores import cores
from dampen.simulation.scenario import Scenario

Array = np.ndarray
Progress = Callable[[int, int], None]
DECADES = (1, -7)  # of the default weights, about the one at which forces begin to pay
TIGHT, ROUNDS = 1.05, 2  # how far the default weights let `reached` be above `bound`, and how often they are made denser
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

    @property
    def cancelled(self) -> float:
        """The effort [N] from which on no bound is left: as far as the points can tell, such forces may leave nothing."""
        return math.sqrt(max(point.dual / point.weight for point in self.points))

    def reached(self, effort: float) -> float:
        """What some forces of at most this effort [N] do reach [unit]: mixtures of two neighbouring points' forces.

        The limit lies between `bound` and this.
        """
        efforts = [0.0, *(point.effort**2 for point in self.points)]
        squares = [self.uncontrolled**2, *(point.rms**2 for point in self.points)]
        return float(np.sqrt(np.interp(effort**2, efforts, squares)))


@takes(scenario=SCENARIO, weights=POSITIVES | NOTHING, bench=BENCH, progress=PROGRESS, threads=count(1) | NOTHING)
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


@takes(
    scenario=SCENARIO, of=TEXT | NOTHING, weights=POSITIVES | NOTHING, bench=BENCH, progress=PROGRESS, threads=count(1) | NOTHING
)
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
    weights:  r [unit^2/N^2]; the default covers eight decades about the one at which forces begin to pay, more densely where the
              limit would not be known to a few percent.
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
    points = _known_points(lifted, progress, threads) if weights is None else _points(lifted, list(weights), progress, threads)
    free = lifted.free
    return Limit(
        scenario=scenario.name,
        experiment=experiment(scenario),
        of=lifted.measure.of,
        unit=lifted.measure.unit,
        uncontrolled=math.sqrt(mean_square(free)),
        uncontrolled_peak=float(np.max(np.abs(free))),
        points=points,
        effort_unit=EFFORT,
        trials=scenario.task.trials,
        start=scenario.task.start,
        horizon=scenario.task.trial_duration * (scenario.task.trials if lifted.chained else 1),
        modes=bench.modes.count,
        step=scenario.numerics.step,
    )


def _known_points(lifted: Lifted, progress: Progress | None, threads: int | None) -> tuple[Point, ...]:
    """The points of a weight a decade, and of weights between where the limit is not yet known well."""
    weights = _default_weights(lifted)
    points: tuple[Point, ...] = ()
    for done in range(ROUNDS + 1):
        points = _points(lifted, weights, _part(progress, done, ROUNDS + 1), threads, points)
        weights = [math.sqrt(a.weight * b.weight) for a, b in pairwise(points) if _looseness(a, b) > TIGHT]
    return points


def _looseness(a: Point, b: Point) -> float:
    """Between two points, how far what their forces reach is above what they certify, where their lines meet."""
    square = (a.dual - b.dual) / (a.weight - b.weight)
    bound = a.dual - a.weight * square
    share = (square - a.effort**2) / (b.effort**2 - a.effort**2)
    return math.sqrt((a.rms**2 + share * (b.rms**2 - a.rms**2)) / bound) if bound > 0 else math.inf


def _points(
    lifted: Lifted, weights: Sequence[float], progress: Progress | None, threads: int | None, known: Sequence[Point] = ()
) -> tuple[Point, ...]:
    """The points of all weights, some at a time, and those known already, in the order of falling weights."""
    weights, pull = [_positive(weight) for weight in weights], lifted.adjoint(lifted.free)
    room = max(1, 2 * KEPT // max(1, gains_size(lifted)))
    pool = ThreadPoolExecutor(min(threads or cores(), room))
    try:
        futures = [pool.submit(_point, lifted, weight, pull) for weight in weights]
        for done, _ in enumerate(as_completed(futures), 1):
            if progress:
                progress(done, len(weights))
        return tuple(sorted([*known, *(future.result() for future in futures)], key=lambda point: -point.weight))
    finally:
        pool.shutdown(cancel_futures=True)


def _point(lifted: Lifted, weight: float, pull: Array) -> Point:
    """The best forces for one weight, and what they make of the measure.   pull: P* free, the gradient without forces."""
    forces, error, back = best_forces(lifted, weight, pull)
    square, effort = mean_square(error), effort_square(forces)
    primal, below = square + weight * effort, square + effort_square(back) / weight
    dual = min(max(0.0, float(np.mean(error * lifted.free))) ** 2 / below if below else 0.0, primal)
    return Point(
        weight=weight,
        effort=math.sqrt(effort),
        rms=math.sqrt(square),
        dual=dual,
        gap=(primal - dual) / primal if primal else 0.0,
        peak=float(np.max(np.abs(error))),
    )


def _default_weights(lifted: Lifted) -> list[float]:
    """About |P* free|^2/|free|^2, the gain of the ports for what is there to be cancelled; 1 where they can do nothing."""
    gain = effort_square(lifted.adjoint(lifted.free)) / (mean_square(lifted.free) or 1.0)
    highest, lowest = DECADES
    return [gain * 10.0**k for k in range(highest, lowest - 1, -1)] if gain else [1.0]


def _positive(weight: float) -> float:
    if not 0 < weight < math.inf:
        raise wrong("weights", "be finite numbers > 0", weight)
    return float(weight)


def _part(progress: Progress | None, index: int, parts: int) -> Progress | None:
    """Progress through one of several equal parts."""
    return None if progress is None else lambda done, every: progress(index * every + done, parts * every)
