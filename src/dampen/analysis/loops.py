"""The closed loop of a linear law as a matrix, and which of its eigenvalues belong to which mode of the plant."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dampen.modal import ModalModel
from dampen.stage import Stage

Array = np.ndarray
ROUND_OFF = 10 * float(np.finfo(float).eps)  # of the balanced matrix: backward error of its eigenvalues
SETTLED = 1e-9  # an eigenvalue of a sampled loop below this is gone within a sample or two: commands that were under way


def closed_loop(model: ModalModel, damping: Array, stiffness: Array, chains: Sequence[Sequence[Stage]]) -> Array:
    """The matrix of x' = A x under u_p = -damping_p y_p' - stiffness_p y_p, x: all q, all q', the output of every lag.

        q_i'' + 2 decay_i q_i' + omega_i^2 q_i = sum_p b_pi F_p,    F_p = u_p through its chain, each stage gain / (1 + tau s)

    damping: (ports,) [N s/m, N m s].   stiffness: (ports,) [N/m, N m/rad].   chains: for each port its stages.
    """
    n = model.count
    lags = sum(stage.lag_time > 0 for chain in chains for stage in chain)
    a = np.zeros((2 * n + lags,) * 2)
    a[:n, n : 2 * n] = np.eye(n)
    a[n : 2 * n, :n], a[n : 2 * n, n : 2 * n] = -np.diag(model.omega**2), -2 * np.diag(model.decay)
    state = 2 * n
    for b, d, k, chain in zip(model.b, damping, stiffness, chains, strict=True):
        force = np.concatenate([-k * b, -d * b, np.zeros(lags)])
        for stage in chain:
            force = stage.gain * force
            if stage.lag_time > 0:
                a[state] = force / stage.lag_time
                a[state, state] -= 1 / stage.lag_time
                force, state = np.eye(len(a))[state], state + 1
        a[n : 2 * n] += np.outer(b, force)
    return a


@dataclass(frozen=True)
class Eigenvalues:
    """s (modes,): for each plant mode its eigenvalue in the loop [1/s], Im s >= 0. others: all that are left; whose: for each
    the number of the plant mode, from 0, that has the largest share in it, or the number of modes for an actuator's lag, and
    one more for what the controller keeps. s_noise, others_noise: what round-off leaves unknown of each [1/s]."""

    s: Array
    others: Array
    whose: Array
    s_noise: Array
    others_noise: Array


def eigenvalues(matrix: Array, plant: Array, dt: float | None = None, lags: int | None = None) -> Eigenvalues:
    """The eigenvalues of x' = A x, or with `dt` of x+ = A x as s = ln(z) / dt, given to the modes of the plant.

    matrix: (size, size), x: all q, all q', the outputs of `lags` lags (None: all the rest is that), what the controller keeps.
    plant: (modes,) eigenvalues of the plant alone.   dt: [s].
    Each plant mode gets the one in which it takes part most, all modes together: participation factors |l_ik r_ki| of left and
    right eigenvectors, which do not depend on units. A mode that no longer swings has two real ones, and gets the slower. The
    frequency of a mode beyond half the sample rate is told from its samples only up to multiples of it: the nearest to the
    plant's is taken. Source: Perez-Arriaga, Verghese and Schweppe, IEEE Trans. Power Apparatus and Systems 101, 1982.

    An eigenvalue is known up to the backward error of the balanced matrix times its condition |l| |r| / |l . r|.
    """
    from scipy.linalg import eig, matrix_balance
    from scipy.optimize import linear_sum_assignment

    n = len(plant)
    balanced: Array = np.asarray(matrix_balance(matrix, permute=False)[0])
    value, left, right = eig(balanced, left=True, right=True)
    part, after = np.abs(left * right), len(matrix) if lags is None else 2 * n + lags
    share = np.vstack([part[:n] + part[n : 2 * n], part[2 * n : after].sum(axis=0), part[after:].sum(axis=0)])
    share /= np.maximum(part.sum(axis=0), 1e-300)
    condition = 1 / np.maximum(np.abs(np.sum(left.conj() * right, axis=0)), ROUND_OFF)  # both have length 1
    noise = ROUND_OFF * np.linalg.norm(balanced, 2) * condition / (1.0 if dt is None else dt * np.maximum(np.abs(value), SETTLED))
    kept = (value.imag >= 0) & ((dt is None) | (np.abs(value) > SETTLED))
    share, value, noise = share[:, kept], value[kept], noise[kept]
    s = value if dt is None else np.log(value) / dt
    taken = linear_sum_assignment(share[:n], maximize=True)[1]
    whose = np.argmax(share, axis=0)
    for k in sorted(set(range(len(s))) - set(taken), key=lambda k: s[k].real):
        i = whose[k]
        if i < n and s[k].imag == 0 == s[taken[i]].imag and s[k].real > s[taken[i]].real:
            taken[i] = k
    rest = np.setdiff1d(np.arange(len(s)), taken)
    own = s[taken] if dt is None else unfolded(s[taken], plant.imag, dt)
    return Eigenvalues(own, s[rest], whose[rest], noise[taken], noise[rest])


def unfolded(s: Array, near: Array, dt: float) -> Array:
    """s with the imaginary part, known up to its sign and multiples of 2 pi / dt, that is nearest to `near`."""
    turn = 2 * np.pi / dt
    either = [sign * s.imag + turn * np.round((near - sign * s.imag) / turn) for sign in (1, -1)]
    imag = np.where(np.abs(either[0] - near) <= np.abs(either[1] - near), *either)
    return s.real + 1j * np.abs(imag)


def of_plant(model: ModalModel) -> Array:
    """(modes,) eigenvalues of the plant alone [1/s], Im >= 0; of an overdamped mode the slower."""
    square = model.omega**2 - model.decay**2
    root = np.sqrt(np.abs(square))
    slow = model.omega**2 / np.where(model.decay + root > 0, model.decay + root, 1.0)
    return np.where(square >= 0, -model.decay + 1j * root, -slow + 0j)
