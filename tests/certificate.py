"""Is a finished run a solution of the equations? Checked step by step, without solving them.

The law at the ports is a monotone inclusion with one solution, so a run that satisfies it is that solution, whatever the
coupling of the ports. The motion is computed again from the delivered forces by matrix exponentials.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

import dampen
from dampen.controllers.base import PortLaw
from dampen.simulation.setting import of_trial, setting_of
from tests import oracle

Array = np.ndarray


def faults(result: dampen.Result, modes: Any, deliver: Sequence[Any], starts: Sequence[float]) -> dict[str, float]:
    """The largest violation of each equation, relative to the largest value of what it determines.

    deliver, starts: for each port the oracle's actuator and its first state.
    """
    case, worst = result.scenario, dict.fromkeys(("motion", "energy", "dissipated", "rate", "law", "actuator"), 0.0)
    structure = oracle.Structure(modes.omega, modes.decay, modes.b, case.numerics.step)
    state = np.concatenate([*case.plant.initial_state(modes)])
    state[structure.n :] *= structure.dt
    setting = setting_of(case)
    memory, states, slow = case.controller.begin(setting), list(starts), np.zeros(len(starts))
    for j in range(result.trials):
        law = case.controller.law(memory, of_trial(setting, case, j))
        trial = {name: np.asarray(result[name][j]) for name in ("y", "v", "command", "delivered", "disturbance", "energy")}
        grid, lost = march(structure, state, trial["delivered"] + trial["disturbance"])
        state = grid[-1]
        note(worst, "motion", grid[:, : structure.n] @ structure.b.T - trial["y"], trial["y"])
        note(worst, "energy", structure.energy(grid) - trial["energy"], trial["energy"])
        note(worst, "dissipated", lost - result["dissipated"][j], result["dissipated"][j])
        slow_at = np.zeros_like(trial["delivered"])
        for k, force in enumerate(trial["delivered"]):
            slow_at[k] = slow
            slow = slow + oracle.RELAXATION * (force - slow)
        rate = np.diff(trial["y"] - case.reference(j), axis=0) / structure.dt
        rate += np.diag(structure.gain) / structure.dt * oracle.SOFTNESS * (trial["delivered"] - slow_at)
        note(worst, "rate", rate - trial["v"], np.diff(trial["y"], axis=0) / structure.dt)
        note(worst, "law", law_gap(case, j, law, trial), trial["command"])
        delivered = np.zeros_like(trial["delivered"])
        for k, command in enumerate(trial["command"]):
            for p, f in enumerate(deliver):
                delivered[k, p], states[p] = f(command[p], states[p])
        note(worst, "actuator", delivered - trial["delivered"], trial["command"])
        memory = {name: np.asarray(result[name][j]) for name in memory}
    return worst


def march(structure: oracle.Structure, state: Array, forces: Array) -> tuple[Array, Array]:
    """States and losses under given port forces."""
    grid, lost = [state], []
    for force in forces:
        push = structure.b.T @ force
        lost.append(structure.lost(grid[-1], push))
        grid.append(grid[-1] + structure.grow @ structure.change(grid[-1], push))
    return np.array(grid), np.array(lost)


def note(worst: dict[str, float], name: str, gap: Any, of: Any) -> None:
    worst[name] = max(worst[name], float(np.max(np.abs(gap)) / max(np.max(np.abs(of)), 1e-300)))


def law_gap(case: dampen.Scenario, j: int, law: PortLaw, trial: dict[str, Array]) -> Array:
    """How far each command is from what the law allows, beyond what the last digits of the displacement can do to it."""
    reference, (low, high) = case.reference(j), case.limits(j)
    error = trial["y"] - reference
    gap = np.zeros_like(trial["command"])
    for k, p in np.ndindex(gap.shape):
        e, moved, v = error[k, p], error[k + 1, p] - error[k, p], trial["v"][k, p]
        ulp = 8 * np.finfo(float).eps * (abs(trial["y"][k : k + 2, p]).max() + abs(reference[k : k + 2, p]).max())
        known = law.feedforward[k, p] - law.damping[p] * v - law.stiffness[p] * (e + moved / 2)
        allowed = [known - sign * law.coulomb[k, p] for sign in ((-1, 1) if v == 0 else (np.sign(v),))]
        if law.barrier[p] > 0:
            limits = low[k + 1, p] - reference[k + 1, p], high[k + 1, p] - reference[k + 1, p]
            pulls = [
                law.barrier[p] * oracle.potential_slope(e, moved + d, *limits, case.controller.barrier_shape) for d in (-ulp, ulp)
            ]
            allowed = [u - pull for u in allowed for pull in pulls]
        u = trial["command"][k, p]
        gap[k, p] = max(min(allowed) - u, u - max(allowed), 0.0)
    return gap
