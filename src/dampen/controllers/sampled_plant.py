"""The structure from sample to sample, as a law that acts through samples has it before itself: hold, delay, actuators' lags."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dampen.controllers.base import Array, Setting
from dampen.modal import ModalModel, propagator

Lags = Sequence[Sequence[float]]


def under_way(setting: Setting) -> int:
    """How many samples' commands are on their way to the actuators."""
    return int(np.ceil(setting.delay / setting.dt - 1e-9))


def sampled_model(model: ModalModel, setting: Setting, lags: Lags = ()) -> tuple[Array, Array, Array]:
    """(A, B, C) of the modes at the samples: all q, all q', the output of every lag, then the commands that are under way,
    oldest first. lags: for each port the time constants of its actuator [s]; none: it delivers at once."""
    n, ports, late = 2 * model.count + sum(map(len, lags)), len(setting.ports), under_way(setting)
    free, push = transition(model, setting.dt, lags)
    push = push * setting.gains
    c = np.hstack([model.b, np.zeros((ports, n - model.count + late * ports))])
    if not late:
        return free, push, c
    wait = setting.delay - (late - 1) * setting.dt  # of the oldest command, whose successor acts from then on
    size = n + late * ports
    a, b = np.zeros((size, size)), np.zeros((size, ports))
    end, end_push = transition(model, setting.dt - wait, lags)
    end_push, begin_push = end_push * setting.gains, transition(model, wait, lags)[1] * setting.gains
    a[:n, :n] = free
    a[:n, n : n + ports] = end @ begin_push
    if late > 1:
        a[:n, n + ports : n + 2 * ports] = end_push
    else:
        b[:n] = end_push
    a[n : size - ports, n + ports :] = np.eye((late - 1) * ports)
    b[size - ports :] = np.eye(ports)
    return a, b, c


def transition(model: ModalModel, seconds: float, lags: Lags = ()) -> tuple[Array, Array]:
    """(A, B) of the modes over some time under held port forces, each behind its lags; x is all q, all q', then the lags."""
    if any(lags):
        return lagged_transition(model, seconds, lags)
    p = propagator(model, seconds)
    a = np.block([[np.diag(p.c11), np.diag(p.c12)], [np.diag(p.c21), np.diag(p.c22)]])
    return a, np.vstack([(p.psi * model.b).T, (p.c12 * model.b).T])


def lagged_transition(model: ModalModel, seconds: float, lags: Lags) -> tuple[Array, Array]:
    """The same by the matrix exponential of x' = A x + B u, u' = 0, with s' = (input - s) / tau for every lag."""
    from scipy.linalg import expm

    n, ports = model.count, len(model.b)
    size = 2 * n + sum(map(len, lags))
    both = np.zeros((size + ports,) * 2)
    both[:n, n : 2 * n] = np.eye(n)
    both[n : 2 * n, :n], both[n : 2 * n, n : 2 * n] = -np.diag(model.omega**2), -2 * np.diag(model.decay)
    state = 2 * n
    for p, times in enumerate(lags):
        source = size + p
        for tau in times:
            both[state, source], both[state, state] = 1 / tau, -1 / tau
            source, state = state, state + 1
        both[n : 2 * n, source] += model.b[p]
    scale = np.ones(size + ports)
    scale[:n] = np.maximum(model.omega, 1.0)  # q as velocities: the exponential then meets frequencies, not their squares
    moved = expm(seconds * both * scale[:, None] / scale) / scale[:, None] * scale
    return moved[:size, :size], moved[:size, size:]
