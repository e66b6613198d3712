"""How ports stick, for how long, and what stays behind them: energy, and an offset."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dampen.analysis.audit.energetics import given_by_control, late
from dampen.analysis.metrics import tracking_error
from dampen.simulation.bench import Bench
from dampen.simulation.result import Result

Array = np.ndarray


@dataclass(frozen=True)
class Sticking:
    """How the driven ports stick. By port: share of steps in which it stuck, the longest stick [s] and when it began [s, over
    the whole run], the trials in which it never moved; in the last five trials the mean error, an offset, and the root mean
    square of all of it [m, rad], and the largest delivered force [N, N m].

    together: share of steps in the last five trials in which all of them stuck; by trial likewise.   kept_by_trial: mean energy
    of the structure while they did, None where they did not [J].
    """

    ports: tuple[str, ...]
    units: tuple[tuple[str, str], ...]
    share: tuple[float, ...]
    longest: tuple[float, ...]
    longest_at: tuple[float, ...]
    still: tuple[tuple[int, ...], ...]
    offset: tuple[float, ...]
    rms: tuple[float, ...]
    force: tuple[float, ...]
    together: float
    together_by_trial: tuple[float, ...]
    kept_by_trial: tuple[float | None, ...]


@dataclass(frozen=True)
class Left:
    """What is left in the last five trials. energy: mean energy of the structure [J].   static: what of it the driven ports' mean
    displacements alone would take, y' C^-1 y / 2 with the compliance C at these ports [J]; None where the structure is free to
    move as a rigid body.   taken: energy that the control takes in one of these trials [J]."""

    energy: float
    static: float | None
    taken: float


def driven(result: Result) -> list[int]:
    """The ports with an actuator, where anything is commanded."""
    scenario = result.scenario
    if scenario.controller.kind == "none":
        return []
    return [p for p in range(len(scenario.ports)) if all(stage.gain for stage in scenario.chain(p))]


def sticking(result: Result) -> Sticking | None:
    """How the driven ports of a continuous run stuck; None where none is driven, or the law acts through samples."""
    scenario, ports = result.scenario, driven(result)
    if scenario.sampled or not ports:
        return None
    stuck = np.array([np.asarray(result["v"][j])[:, ports] == 0 for j in range(result.trials)])
    runs = [longest_stick(stuck[:, :, i], scenario.task.start == "chained") for i in range(len(ports))]
    all_stuck = np.asarray(stuck.all(axis=2))
    mean = [(np.asarray(result["energy"][j])[1:] + np.asarray(result["energy"][j])[:-1]) / 2 for j in range(result.trials)]
    kept = [float(mean[j][all_stuck[j]].mean()) if all_stuck[j].any() else None for j in range(result.trials)]
    names = [scenario.ports[p] for p in ports]
    errors = [np.concatenate([tracking_error(result, name, j) for j in late(result)]) for name in names]
    forces = [max(float(np.abs(np.asarray(result["delivered"][j])[:, p]).max()) for j in late(result)) for p in ports]
    dt, plant = scenario.numerics.step, scenario.plant.ports
    return Sticking(
        ports=tuple(names),
        units=tuple((plant[p].motion_unit, plant[p].effort_unit) for p in ports),
        share=tuple(map(float, stuck.mean(axis=(0, 1)))),
        longest=tuple(length * dt for length, _ in runs),
        longest_at=tuple(begin * dt for _, begin in runs),
        still=tuple(tuple(int(j) for j in np.flatnonzero(stuck[:, :, i].all(axis=1))) for i in range(len(ports))),
        offset=tuple(float(error.mean()) for error in errors),
        rms=tuple(float(np.sqrt(np.mean(error**2))) for error in errors),
        force=tuple(forces),
        together=float(all_stuck[late(result).start :].mean()),
        together_by_trial=tuple(map(float, all_stuck.mean(axis=1))),
        kept_by_trial=tuple(kept),
    )


def longest_stick(stuck: Array, chained: bool) -> tuple[int, int]:
    """Length of the longest run of True in `stuck` (trials, steps), and its first step, counted over all trials; a stick goes on
    from trial to trial only where these are chained."""
    parts = [stuck.ravel()] if chained else list(stuck)
    best = (0, 0)
    for j, part in enumerate(parts):
        edges = np.flatnonzero(np.diff(np.concatenate([[0], part.astype(int), [0]])))
        lengths = edges[1::2] - edges[::2]
        if len(lengths) and lengths.max() > best[0]:
            best = int(lengths.max()), int(edges[::2][lengths.argmax()]) + j * stuck.shape[1]
    return best


def left(result: Result, bench: Bench) -> Left:
    """What is left in the structure in the last trials, and what the control still takes of it."""
    trials, ports, modes = late(result), driven(result), bench.modes
    static = None
    if ports and modes.omega[0] > 0:
        y = np.mean([np.asarray(result["y"][j])[:, ports].mean(axis=0) for j in trials], axis=0)
        b = modes.b[ports]
        static = float(y @ np.linalg.lstsq((b / modes.omega**2) @ b.T, y, rcond=None)[0]) / 2
    return Left(
        energy=float(np.mean([np.mean(result["energy"][j]) for j in trials])),
        static=static,
        taken=-float(given_by_control(result)[trials.start :].mean()),
    )
