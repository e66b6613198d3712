"""Characteristic equations of beams and strings, integrated from the base: no modes, no basis, nothing of the package."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations

import numpy as np
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import brentq

Array = np.ndarray
Function = Callable[[float], float]
PAIRS = list(combinations(range(4), 2))


def compound(a: Array) -> Array:
    """The second additive compound of a 4 x 4 matrix: how the 2 x 2 minors of two solutions of y' = a y move.

    Following minors instead of solutions keeps the characteristic equation free of cancellation at any frequency.
    """
    d = np.eye(4)
    return np.array(
        [
            [a[i, k] * d[j, m] + a[j, m] * d[i, k] - a[i, m] * d[j, k] - a[j, k] * d[i, m] for k, m in PAIRS]
            for i, j in PAIRS
        ]
    )  # fmt: skip


def minors(u: Array, v: Array) -> Array:
    return np.array([u[i] * v[j] - u[j] * v[i] for i, j in PAIRS])


def carried(matrix: Callable[[float], Array], length: float, start: Array, varies: bool) -> Array:
    """The solution of y' = matrix(x) y at x = length."""
    if not varies:
        return expm(matrix(0.0) * length) @ start
    solution = solve_ivp(lambda x, y: matrix(x) @ y, (0, length), start, method="DOP853", rtol=1e-12, atol=1e-14)
    return solution.y[:, -1]


def bending_residual(
    omega: float, rho: Function, ei: Function, length: float, mass: float, inertia: float,
    tension: float = 0.0, base: str = "clamped", hub: float = 0.0, varies: bool = False,
) -> float:  # fmt: skip
    """Of w, w', EI w'', T w' - (EI w'')' at the tip of an Euler-Bernoulli beam, scaled to be of one size."""
    beta = np.sqrt(omega) * (rho(0.0) / ei(0.0)) ** 0.25
    scale = np.array([1, beta, beta**2 * ei(0.0), beta**3 * ei(0.0)])

    def matrix(x: float) -> Array:
        a = np.array([[0, 1, 0, 0], [0, 0, 1 / ei(x), 0], [0, tension, 0, -1], [-rho(x) * omega**2, 0, 0, 0]])
        return compound(a / scale[:, None] * scale)

    e = np.eye(4)
    first = e[2] if base == "clamped" else e[1] - hub * omega**2 * e[2]
    start = minors(first / scale, e[3] / scale)
    end = carried(matrix, length, start / np.abs(start).max(), varies)
    force, torque = np.array([-mass * omega**2, 0, 0, 1]) * scale, np.array([0, -inertia * omega**2, 1, 0]) * scale
    rows = minors(force, torque)
    return float(rows @ end / np.abs(rows).max() / np.exp(beta * length))


def timoshenko_residual(
    omega: float, rho: Function, ei: Function, k: Function, i_rho: Function, length: float, mass: float, inertia: float
) -> float:
    def matrix(x: float) -> Array:
        w, phi = -rho(x) * omega**2, -i_rho(x) * omega**2
        return compound(np.array([[0, 1, 1 / k(x), 0], [0, 0, 0, 1 / ei(x)], [w, 0, 0, 0], [0, phi, -1, 0]]))

    end = carried(matrix, length, minors(np.eye(4)[2], np.eye(4)[3]), varies=True)
    return float(minors(np.array([-mass * omega**2, 0, 1, 0]), np.array([0, -inertia * omega**2, 0, 1])) @ end)


def string_residual(omega: float, rho: Function, tension: Function, length: float, mass: float) -> float:
    def matrix(x: float) -> Array:
        return np.array([[0, 1 / tension(x)], [-rho(x) * omega**2, 0]])

    w, force = carried(matrix, length, np.array([0.0, 1.0]), varies=True)
    return float(force - mass * omega**2 * w)


def roots(residual: Function, count: int, highest: float, points: int = 1000, lowest: float = 0.01) -> Array:
    """The lowest `count` roots omega of a characteristic function, sought on a grid that is even in sqrt(omega)."""
    grid = np.linspace(np.sqrt(lowest), np.sqrt(highest), points) ** 2
    values, found = [residual(o) for o in grid], []
    for a, b, fa, fb in zip(grid[:-1], grid[1:], values[:-1], values[1:], strict=True):
        if fa * fb < 0:
            found.append(brentq(residual, a, b, xtol=1e-13, rtol=1e-14))
    assert len(found) >= count, f"only {len(found)} roots below {highest}"
    return np.array(found[:count])
