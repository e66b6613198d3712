"""Fewer states by balanced truncation: what is hard to reach and hard to see is left out."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from dampen.component import ArgumentError, is_whole, wrong
from dampen.export.linear import Array, LinearModel

ROUND_OFF = 1e-13  # of the largest Hankel singular value: states below it are noise


def balanced(model: LinearModel, order: int) -> tuple[LinearModel, Array]:
    """The model with `order` states, and the Hankel singular values of all.

    With the Gramians P = Z Z^T and Q = Y Y^T and Y^T Z = U S V^T, the projections T = Z V_1 S_1^(-1/2) and
    W = Y U_1 S_1^(-1/2) keep the largest of S. The frequency response is then off by at most twice the sum of those left out,
    at any frequency. Source: Antoulas, Approximation of Large-Scale Dynamical Systems, 2005, ch. 7.

    Raises ArgumentError for a structure with a mode that does not decay, whose Gramians are infinite.
    """
    from scipy.linalg import svd

    size = len(model.a)
    if not (is_whole(order) and 1 <= order <= size):
        raise wrong("balanced", f"be a whole number from 1 to the {size} states of the model", order)
    z, y = _root(*_gramian(model.a, model.b, model.dt)), _root(*_gramian(model.a.T, model.c.T, model.dt))
    u, s, vt = svd(y.T @ z)
    if s[order - 1] <= ROUND_OFF * s[0]:
        useful = int(np.sum(s > ROUND_OFF * s[0]))
        raise wrong("balanced", f"be at most {useful}: the other states are neither reached nor seen", order)
    root = np.sqrt(s[:order])
    t, w = z @ vt[:order].T / root, y @ u[:, :order] / root
    states = tuple((f"x_{i + 1}", "1") for i in range(order))
    return replace(model, a=w.T @ model.a @ t, b=w.T @ model.b, c=model.c @ t, states=states), s


def _gramian(a: Array, b: Array, dt: float) -> tuple[Array, Array]:
    """Eigenvalues and vectors of P, where A P + P A^T + B B^T = 0, or A P A^T - P + B B^T = 0 at samples.

    In coordinates in which every mode is a 2 x 2 block the scale of q and q' differs by omega: they are scaled to be alike.
    """
    from scipy.linalg import eigh, solve_continuous_lyapunov, solve_discrete_lyapunov

    rates = np.linalg.eigvals(a)
    slowest = -rates.real.max() if dt == 0 else 1 - np.abs(rates).max()
    if slowest <= 1e-12 * np.abs(rates).max():
        raise ArgumentError(
            "Argument `balanced` needs a plant whose every mode decays; give it `plant.damping`, or take `modes` instead."
        )
    p = solve_continuous_lyapunov(a, -b @ b.T) if dt == 0 else solve_discrete_lyapunov(a, b @ b.T)
    size, vectors = eigh((p + p.T) / 2)
    return size, vectors


def _root(size: Array, vectors: Array) -> Array:
    """Z with Z Z^T = P."""
    return np.asarray(vectors * np.sqrt(np.maximum(size, 0.0)))
