"""The best forces for one weight: conjugate gradients, which the exact factorisation lets end after one step."""

from __future__ import annotations

import numpy as np

from dampen.analysis.limit.lifted import Lifted, effort_square, mean_square
from dampen.analysis.limit.riccati import solve

Array = np.ndarray
SETTLED, ROUNDS = 1e-12, 60
COARSER, COARSEST = 10.0, 1e4


def best_forces(lifted: Lifted, weight: float, pull: Array) -> tuple[Array, Array, Array]:
    """u, e = free + P u and P* e at the minimum of  |e|^2 + weight |u|^2.

    The gradient is P* e + weight u, found from u each time; where its square is g, the minimum is at most g/weight lower. For
    weights so small that round-off takes the factorisation's definiteness, one for a larger weight is the preconditioner.

    pull: P* free.
    """
    forces, error, back = np.zeros_like(pull), lifted.free, pull
    factored, way, fall_before = weight, np.zeros_like(pull), 0.0
    for _ in range(ROUNDS):
        gradient = back + weight * forces
        primal = mean_square(error) + weight * effort_square(forces)
        if effort_square(gradient) <= SETTLED * weight * primal:
            break
        step = solve(lifted, factored, gradient)
        fall = float(np.vdot(gradient, step))
        if not 0 < fall < np.inf:
            factored, fall_before = COARSER * factored, 0.0
            continue
        way = step + (fall / fall_before if fall_before else 0.0) * way
        along = lifted.adjoint(lifted.response(way)) + weight * way
        better = forces - fall / float(np.vdot(way, along)) * way
        found = lifted.under(better)
        if not mean_square(found) + weight * effort_square(better) < primal:
            if factored > COARSEST * weight:
                break
            factored, fall_before = COARSER * factored, 0.0
            continue
        forces, error, back, fall_before = better, found, lifted.adjoint(found), fall
    return forces, error, back
