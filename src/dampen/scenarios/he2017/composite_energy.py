"""The barrier composite energy E_j(T_b) of He et al. 2017, (20)-(25), along the trials.

The paper gives neither mu, lambda nor the bounds d_bar: here mu = 1, d_bar = m (B_r - B_l) of the backlash that is there, and
a list of lambda. The weight e^(-lambda t) restarts with every trial, so that E1 + E2 + E3 jump by (1 - e^(-lambda T_b)) times
their unweighted value between trials; the difference (46) of the proof leaves that jump out.
"""

from __future__ import annotations

import numpy as np

from dampen.actuators.backlash import Backlash
from dampen.controllers.dual_loop_ailc import DualLoopAILC
from dampen.simulation.result import Result

Array = np.ndarray
LAMBDAS = (0.0, 0.01, 0.5, 1.0, 2.0, 5.0)


def rises(energy: Array) -> list[int]:
    """How often each column of E_j(T_b) rises from one trial to the next."""
    return [int(n) for n in np.sum(np.diff(energy, axis=0) > 0, axis=0)]


def composite_energy(result: Result, lambdas: tuple[float, ...] = LAMBDAS) -> tuple[Array, Array] | None:
    """(trials, lambdas) E_j(T_b), and the sum of the differences (46) begun at E_0(T_b); None for another law."""
    law, (steps, dt) = result.scenario.controller, result.scenario.law_grid
    if not isinstance(law, DualLoopAILC):
        return None
    decay, rate = np.array(lambdas), "rate_estimate" if result.scenario.sampled else "v"
    weights = np.exp(-np.outer(decay, (np.arange(steps) + 0.5) * dt)) * dt
    end = np.exp(-decay * result.scenario.task.trial_duration)
    damping, observer = np.array([law.alpha_4, law.alpha_7]), np.array([law.alpha_8, law.alpha_9])
    d_bar, zeta_before = gap_widths(result), np.zeros((weights.shape[1], 2))
    start, final, integrals = [], [], []
    for j in range(result.trials):
        first, last = unweighted(result, j)
        xi = zeta_before - damping * np.asarray(result[rate][j])
        short = d_bar - np.asarray(result["d_hat"][j])
        start.append(first)
        final.append(end * last)
        integrals.append(weights @ (xi**2 / (2 * damping) + short**2 / (2 * observer)).sum(axis=1))
        zeta_before = np.asarray(result["zeta"][j])
    total = np.array(final) + np.array(integrals)
    change = np.array(final)[1:] - np.array(start)[1:, None] + np.diff(integrals, axis=0)
    return total, total[0] + np.vstack([np.zeros(len(decay)), np.cumsum(change, axis=0)])


def unweighted(result: Result, trial: int) -> Array:
    """E1 + E2 + E3 with the weight 1, at the start and at the end of a trial."""
    law = result.scenario.controller
    assert isinstance(law, DualLoopAILC)
    energy, y = np.asarray(result["energy"][trial])[[0, -1]], np.asarray(result["y"][trial])[[0, -1]]
    scaled = np.minimum(np.abs(y) / result.scenario.limits()[1][0], 1.0)
    with np.errstate(divide="ignore"):
        stored = np.array([law.alpha_3, law.alpha_6]) / 4 * np.log1p(-(scaled**2)) ** 2
    return energy + stored.sum(axis=1)


def gap_widths(result: Result) -> Array:
    """(ports,) d_bar: the gap of each port's backlash, 0 where there is none."""
    chains = [result.scenario.actuators.get(port.name, ()) for port in result.scenario.plant.ports]
    return np.array([sum(s.slope * (s.right - s.left) for s in chain if isinstance(s, Backlash)) for chain in chains])
