"""How ports stick, for how long, and what energy stays behind them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dampen.analysis.audit.energetics import given_by_control
from dampen.analysis.merits import LATE
from dampen.simulation.bench import Bench
from dampen.simulation.result import Result

Array = np.ndarray


@dataclass(frozen=True)
class Sticking:
    """Of each driven port: the share of steps in which it stuck, the longest stick [s] and when it began [s, over the whole run],
    and the trials in which it never moved.   together: share of steps in the last five trials in which all of them stuck.

    trapped: mean energy of the structure while they did, in the last five trials [J]; static: what of it the ports' displacements
    alone would take, y' C^-1 y / 2 with the structure's compliance C [J]; None where it is free to move as a rigid body.   taken:
    energy that the control takes in one of these trials [J].   By trial: the same, nan where they never stuck together.
    """

    ports: tuple[str, ...]
    share: tuple[float, ...]
    longest: tuple[float, ...]
    longest_at: tuple[float, ...]
    still: tuple[tuple[int, ...], ...]
    together: float
    trapped: float
    static: float | None
    taken: float
    together_by_trial: tuple[float, ...]
    trapped_by_trial: tuple[float | None, ...]


def sticking(result: Result, bench: Bench) -> Sticking | None:
    """How the driven ports of a continuous run stuck; None where none is driven, or the law acts through samples."""
    scenario = result.scenario
    driven = [p for p in range(len(scenario.ports)) if all(stage.gain for stage in scenario.chain(p))]
    if scenario.sampled or not driven or scenario.controller.kind == "none":
        return None
    stuck = np.array([np.asarray(result["v"][j])[:, driven] == 0 for j in range(result.trials)])
    runs = [longest_run(stuck[:, :, p].ravel()) for p in range(len(driven))]
    if scenario.task.start == "reset":
        runs = [max((longest_run(row) for row in stuck[:, :, p]), key=lambda run: run[0]) for p in range(len(driven))]
    dt = scenario.numerics.step
    all_stuck = np.asarray(stuck.all(axis=2))
    energy = np.array(
        [(np.asarray(result["energy"][j])[1:] + np.asarray(result["energy"][j])[:-1]) / 2 for j in range(result.trials)]
    )
    by_trial = [float(energy[j][all_stuck[j]].mean()) if all_stuck[j].any() else None for j in range(result.trials)]
    late = slice(max(result.trials - LATE, 0), result.trials)
    held = all_stuck[late]
    return Sticking(
        ports=tuple(scenario.ports[p] for p in driven),
        share=tuple(map(float, stuck.mean(axis=(0, 1)))),
        longest=tuple(run[0] * dt for run in runs),
        longest_at=tuple(run[1] * dt for run in runs),
        still=tuple(tuple(int(j) for j in np.flatnonzero(stuck[:, :, p].all(axis=1))) for p in range(len(driven))),
        together=float(held.mean()),
        trapped=float(energy[late][held].mean()) if held.any() else 0.0,
        static=static_energy(result, bench, held, late),
        taken=-float(given_by_control(result)[late].mean()),
        together_by_trial=tuple(map(float, all_stuck.mean(axis=1))),
        trapped_by_trial=tuple(by_trial),
    )


def longest_run(stuck: Array) -> tuple[int, int]:
    """Length and beginning of the longest run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], stuck.astype(int), [0]])))
    begins, lengths = edges[::2], edges[1::2] - edges[::2]
    return (int(lengths.max()), int(begins[lengths.argmax()])) if len(lengths) else (0, 0)


def static_energy(result: Result, bench: Bench, held: Array, late: slice) -> float | None:
    """Mean of y' C^-1 y / 2 while all stick [J]: what it takes to hold the ports where they are, the structure at rest."""
    modes = bench.modes
    if modes.omega[0] == 0 or not held.any():
        return None
    compliance = (modes.b / modes.omega**2) @ modes.b.T
    y = np.array([np.asarray(result["y"][j])[1:] for j in range(late.start, late.stop)])[held]
    return float(np.mean(np.sum(y * np.linalg.solve(compliance, y.T).T, axis=1)) / 2)
