"""The barrier composite energy E_j(T_b) of He et al. 2017, (20)-(25), along the trials.

The paper gives neither mu, lambda nor the bounds d_bar: here mu = 1, d_bar = m (B_r - B_l), and a list of lambda. The weight
e^(-lambda t) restarts with every trial, so that E1 + E2 + E3 jump by (1 - e^(-lambda T_b)) times their unweighted value between
trials; the difference (46) of the proof leaves that jump out.
"""

from __future__ import annotations

import numpy as np

from dampen.controllers.dual_loop_ailc import DualLoopAILC
from dampen.simulation.result import Result

Array = np.ndarray
LAMBDAS = (0.0, 0.01, 0.5, 1.0, 2.0, 5.0)


def rises(result: Result, *, jump: bool) -> dict[float, int] | None:
    """How often E_j(T_b) rises from one trial to the next, for each lambda; None for another law than the paper's."""
    if not isinstance(result.scenario.controller, DualLoopAILC):
        return None
    return {value: int(np.sum(np.diff(composite_energy(result, value, jump=jump)) > 0)) for value in LAMBDAS}


def composite_energy(result: Result, decay: float, *, jump: bool) -> Array:
    """(trials,) E_j(T_b) for one lambda; with `jump` False the sum of the differences (46), begun at E_0(T_b)."""
    law, dt = result.scenario.controller, result.scenario.numerics.step
    assert isinstance(law, DualLoopAILC)
    steps = result.layout.coordinates["step"][1]
    weight, end = np.exp(-decay * steps) * dt, np.exp(-decay * result.scenario.task.trial_duration)
    limits, d_bar = result.scenario.limits, law.assumed_backlash.width
    damping, observer = np.array([law.alpha_4, law.alpha_7]), np.array([law.alpha_8, law.alpha_9])
    barrier = np.array([law.alpha_3, law.alpha_6])
    zeta_before = np.zeros((len(steps), 2))
    states, integrals = [], []
    for j in range(result.trials):
        energy, y = np.asarray(result["energy"][j]), np.asarray(result["y"][j])[[0, -1]]
        with np.errstate(divide="ignore", invalid="ignore"):
            stored = (barrier / 4 * np.log1p(-((y / limits) ** 2)) ** 2).sum(axis=1)
        xi = zeta_before - damping * np.asarray(result["v"][j])
        short = d_bar - np.asarray(result["d_hat"][j])
        states.append(energy[[0, -1]] + stored)
        integrals.append(weight @ (xi**2 / (2 * damping) + short**2 / (2 * observer)).sum(axis=1))
        zeta_before = np.asarray(result["zeta"][j])
    start, final = np.array(states).T
    total = end * final + np.array(integrals)
    if jump:
        return total
    change = end * final - start
    change[1:] += np.diff(integrals)
    return total[0] + np.concatenate([[0.0], np.cumsum(change[1:])])
