"""The barrier composite energy E_j(T_b) of He et al. 2017, (20)-(25), along the trials, term by term.

The paper gives neither mu, lambda nor the bounds d_bar: here mu = 1, d_bar = m (B_r - B_l) of the backlash that is there, and
a list of lambda. The weight e^(-lambda t) restarts with every trial, so that E1 + E2 + E3 jump by (1 - e^(-lambda T_b)) times
their unweighted value between trials; the difference (46) of the proof leaves that jump out.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dampen.actuators.backlash import Backlash
from dampen.controllers.dual_loop_ailc import DualLoopAILC
from dampen.simulation.result import Result

Array = np.ndarray
LAMBDAS = (0.0, 0.01, 0.5, 1.0, 2.0, 5.0)
TERMS = ("E1 + E2, energy of the structure and its payload", "E3, barrier", "E4, xi", "E5, observer")


@dataclass(frozen=True)
class CompositeEnergy:
    """at_end: (trials, lambdas, TERMS) the terms of E_j(T_b) [J].   jump: (trials - 1, lambdas) by how much E1 + E2 + E3 jump
    as the weight restarts, (1 - e^(-lambda T_b)) times their unweighted value [J]."""

    lambdas: tuple[float, ...]
    at_end: Array
    jump: Array

    @property
    def total(self) -> Array:
        """(trials, lambdas) E_j(T_b), the jumps of its weight counted."""
        return np.asarray(self.at_end.sum(axis=2))

    @property
    def printed(self) -> Array:
        """(trials, lambdas) the sum of the differences (46), which leave the jumps out, begun at E_0(T_b)."""
        before = np.vstack([np.zeros((1, len(self.lambdas))), np.cumsum(self.jump, axis=0)])
        return np.asarray(self.total - before)

    def risen(self, trials: Array, column: int) -> list[str]:
        """The terms that rose most in these steps from one trial to the next, in the order of how often."""
        steps = np.diff(self.at_end[:, column], axis=0)[trials]
        most = np.argmax(steps, axis=1)
        return [TERMS[i] for i in sorted(set(most), key=lambda i: -int(np.sum(most == i)))]


def rises(energy: Array) -> list[int]:
    """How often each column of E_j(T_b) rises from one trial to the next."""
    return [int(n) for n in np.sum(np.diff(energy, axis=0) > 0, axis=0)]


def composite_energy(result: Result, lambdas: tuple[float, ...] = LAMBDAS) -> CompositeEnergy | None:
    """The composite energy of a run under the dual-loop law; None for another law."""
    law, (steps, dt) = result.scenario.controller, result.scenario.law_grid
    if not isinstance(law, DualLoopAILC) or not result.trials:
        return None
    decay, rate = np.array(lambdas), "rate_estimate" if result.scenario.sampled else "v"
    weights = np.exp(-np.outer(decay, (np.arange(steps) + 0.5) * dt)) * dt
    end = np.exp(-decay * result.scenario.task.trial_duration)
    damping, observer = by_kind(result, law.alpha_4, law.alpha_7), by_kind(result, law.alpha_8, law.alpha_9)
    d_bar, zeta_before = gap_widths(result), np.zeros((steps, len(damping)))
    start, final, integrals = [], [], []
    for j in range(result.trials):
        first, last = unweighted(result, j)
        xi = zeta_before - damping * np.asarray(result[rate][j])
        short = d_bar - np.asarray(result["d_hat"][j])
        start.append(first.sum())
        final.append(end[:, None] * last)
        integrals.append([weights @ (part**2).sum(axis=1) / 2 for part in (xi / np.sqrt(damping), short / np.sqrt(observer))])
        zeta_before = np.asarray(result["zeta"][j])
    at_end = np.concatenate([np.array(final), np.array(integrals).transpose(0, 2, 1)], axis=2)
    jump = np.array(start)[1:, None] - np.array(final).sum(axis=2)[:-1]
    return CompositeEnergy(lambdas, at_end, jump)


def unweighted(result: Result, trial: int) -> Array:
    """(2, 2) E1 + E2, and E3, with the weight 1, at the start and at the end of a trial."""
    law = result.scenario.controller
    assert isinstance(law, DualLoopAILC)
    energy, error = (np.asarray(result[name][trial])[[0, -1]] for name in ("energy", "y"))
    reference, (low, high) = result.scenario.reference(trial)[[0, -1]], result.scenario.limits(trial)
    error = error - reference
    room = np.where(error >= 0, high[[0, -1]] - reference, reference - low[[0, -1]])
    scaled = np.minimum(np.abs(error) / room, 1.0)
    with np.errstate(divide="ignore"):
        stored = by_kind(result, law.alpha_3, law.alpha_6) / 4 * np.log1p(-(scaled**2)) ** 2
    return np.column_stack([energy, stored.sum(axis=1)])


def by_kind(result: Result, force: float, torque: float) -> Array:
    """(ports,) one number for force ports, another for torque ports."""
    return np.array([force if port.kind == "force" else torque for port in result.scenario.plant.ports])


def gap_widths(result: Result) -> Array:
    """(ports,) d_bar: the gap of each port's backlash, 0 where there is none."""
    chains = [result.scenario.actuators.get(port.name, ()) for port in result.scenario.plant.ports]
    return np.array([sum(s.slope * (s.right - s.left) for s in chain if isinstance(s, Backlash)) for chain in chains])
