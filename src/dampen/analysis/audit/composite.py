"""Theorem 2 and the conditions on its gains, by number: for the dual-loop law of He et al. 2017."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from dampen.analysis.audit.finding import Finding, Quantity
from dampen.analysis.composite_energy import LAMBDAS, CompositeEnergy, composite_energy
from dampen.analysis.metrics import largest
from dampen.simulation.result import Result

Array = np.ndarray
LABELS = {"by (46)": "E_0(T_b) and the sum of the differences (46)", "with the jump": "E_j(T_b)"}


def composite(result: Result) -> Iterator[Finding]:
    """E_j(T_b) for every lambda, and the gains' slacks; nothing for another law."""
    energy = composite_energy(result)
    if energy is None:
        return
    for column, decay in enumerate(energy.lambdas):
        yield falls(energy, column, decay)
    yield alpha_1(result)
    for name, kind in (("alpha_2", "force"), ("alpha_5", "torque")):
        yield from robust_gain(result, name, kind)


def falls(energy: CompositeEnergy, column: int, decay: float) -> Finding:
    """Whether E_j(T_b) falls along the trials, as printed and with the jump of the weight."""
    totals = {"by (46)": energy.printed[:, column], "with the jump": energy.total[:, column]}
    up = {name: np.flatnonzero(np.diff(values) > 0) for name, values in totals.items()}
    blamed = energy.risen(up["with the jump"], column)
    few, fell = len(energy.at_end) < 2, not any(map(len, up.values()))
    told = (
        f"{(totals['with the jump'][0]):.3g} J to {totals['with the jump'][-1]:.3g} J"
        if np.isfinite(totals["with the jump"]).all()
        else "infinite"
    )
    return Finding.of(
        "composite energy",
        f"composite-energy.lambda={decay:g}",
        f"E_j(T_b) rises in no trial, lambda = {decay:g} 1/s",
        f"{told}; rises: {len(up['by (46)'])} by (46) as printed, {len(up['with the jump'])} with the jump of the weight",
        None if few else fell,
        "One trial shows no trend."
        if few
        else "It falls from trial to trial."
        if fell
        else f"What rises: {'; '.join(blamed)}."
        if blamed
        else "It rises only by the differences of the proof, which leave out what the weight's restart gives back.",
        {f"{LABELS[name]}, by trial": Quantity(tuple(map(float, values)), "J") for name, values in totals.items()}
        | {f"trials that rise {name}": Quantity(tuple(int(j) + 1 for j in trials)) for name, trials in up.items()},
    )


def alpha_1(result: Result) -> Finding:
    """The sum inequality that the proof asks of alpha_1, evaluated on the run.

    sum_(i=1..j) int int e^(-lambda r) w_t f dx dr  <=  sum_(i=1..j) int 2 alpha_1 f_bar L e^(-lambda r) |w_t(L)| dr
    """
    criterion = "the load's work since trial 1 <= 2 alpha_1 f_bar L int |w_t(L)| dr, both weighted, for every j and lambda"
    if result.trials < 2:
        nothing = "The sum begins with trial 1, and there is none."
        return Finding.of("gain conditions", "gain.alpha_1", criterion, "one trial", None, nothing, {})
    left, per_alpha = sides_of_alpha_1(result)
    own = result.scenario.controller.alpha_1  # type: ignore[attr-defined]  # of this law
    slack = own * per_alpha - left
    with np.errstate(divide="ignore", invalid="ignore"):
        needed = max(float(np.nanmax(np.where(left > 0, left / per_alpha, 0.0))), 0.0)
    trial, column = np.unravel_index(int(np.argmin(slack)), slack.shape)
    holds = bool(slack.min() >= 0)
    by_lambda = {
        f"slack by trial, lambda = {decay:g} 1/s": Quantity(tuple(map(float, slack[:, k])), "J")
        for k, decay in enumerate(LAMBDAS)
    }
    return Finding.of(
        "gain conditions",
        "gain.alpha_1",
        criterion,
        f"slack at least {slack.min():.3g} J; for this motion alpha_1 = {needed:.3g} would be enough, it is {own:g}",
        holds,
        "Large enough on this run; the proof says no more than that there is such an alpha_1."
        if holds
        else f"Worst up to trial {trial + 1} at lambda = {LAMBDAS[column]:g} 1/s: the load gave more than the gain covers.",
        {**by_lambda, "alpha_1 needed for this motion": Quantity(needed)},
    )


def sides_of_alpha_1(result: Result) -> tuple[Array, Array]:
    """(trials - 1, lambdas) both sides of the inequality up to each trial [J], the right one for alpha_1 = 1."""
    dt, bound = result.scenario.numerics.step, 2 * result.scenario.bounds["f"] * result.scenario.plant.span
    force = np.array([port.kind == "force" for port in result.scenario.plant.ports])
    weight = np.exp(-np.outer((np.arange(result.scenario.steps) + 0.5) * dt, LAMBDAS))
    load, path = [], []
    for j in range(1, result.trials):
        load.append(np.asarray(result["work_load"][j]) @ weight)
        path.append(np.abs(np.diff(np.asarray(result["y"][j])[:, force], axis=0)).sum(axis=1) @ weight)
    return np.cumsum(load, axis=0), bound * np.cumsum(path, axis=0)


def robust_gain(result: Result, name: str, kind: str) -> Iterator[Finding]:
    """alpha_2, alpha_5 >= 1, and whether alpha d_bar covered the disturbance as it was."""
    value = float(getattr(result.scenario.controller, name))
    for port in result.scenario.plant.ports:
        if port.kind != kind:
            continue
        worst, bound = float(largest(result, "disturbance", port.name).max()), result.scenario.bounds[port.name]
        slack, covered = value - 1, value * bound - worst  # zero where the bound is met exactly
        covers = covered >= -1e-12 * worst
        yield Finding.of(
            "gain conditions",
            f"gain.{name}.{port.name}",
            f"{name} >= 1, and {name} d_bar >= |d| at {port.name} as it was",
            f"slack {slack:.3g}; {covered:.3g} {port.effort_unit}",
            bool(slack >= 0 and covers),
            "The switching gain outweighs the disturbance at the port."
            if covers
            else "The disturbance at the port is larger than what the switching gain is made for.",
            {"slack": Quantity(slack), "slack against the disturbance": Quantity(covered, port.effort_unit)},
        )
