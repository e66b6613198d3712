"""Evidence about learning and about many runs: the lifted recursion, batches, the limit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from kit import Evidence, Number, at_most, canvas, ticks
from scipy.linalg import expm

import dampen
from dampen.simulation.batch import Batch, alone
from dampen.simulation.bench import Bench


def p_type_recursion() -> Evidence:
    """P-type learning through the whole simulation, against e_(j+1) = (1 - P gain) e_j with P from a matrix exponential."""
    gain, ports = 15.0, ("tip_w", "tip_phi")
    move, sway = dampen.MinimumJerk(target=0.05, duration=0.6), dampen.Sinusoid(amplitude=0.02, frequency=2.0)
    scenario = dampen.Scenario(
        plant=dampen.TimoshenkoBeam(damping=dampen.Damping(ratio=0.02)),
        controller=dampen.PTypeILC(learning=dict.fromkeys(ports, gain)),
        disturbance=dampen.HarmonicFamilies(frozen_at=0),
        task=dampen.Task(trials=8, trial_duration=0.4, start="reset", reference={"tip_w": move, "tip_phi": sway}),
        numerics=dampen.Numerics(modes=16, step=0.002),
    )
    run = dampen.simulate(scenario)
    seen = (run["reference"] - run["y"])[:, 1:].reshape(run.trials, -1)
    p, wanted = lifted(scenario), [seen[0]]
    for _ in range(run.trials - 1):
        wanted.append(wanted[-1] - p @ (gain * wanted[-1]))
    off = np.abs(seen - wanted).max() / np.abs(seen).max()
    figure, (axes,) = canvas()
    axes.semilogy(np.linalg.norm(wanted, axis=1), "k--", lw=0.7, label="recursion, matrix exponential")
    axes.semilogy(np.linalg.norm(seen, axis=1), "o", ms=4, label="run")
    axes.set(xlabel="trial", ylabel="norm of the error")
    axes.legend()
    return Evidence((at_most("errors of all trials off by, relative", off, 1e-9),), figure)


def lifted(scenario: dampen.Scenario) -> np.ndarray:
    """P, (steps ports, steps ports): what a command held over a step does to all later displacements."""
    modes, steps, dt = Bench(scenario).modes, scenario.steps, scenario.numerics.step
    n, ports = modes.count, len(scenario.ports)
    a = np.zeros((2 * n + ports, 2 * n + ports))
    a[:n, n : 2 * n] = np.eye(n)
    a[n : 2 * n, : 2 * n] = np.hstack([-np.diag(modes.omega**2), -2 * np.diag(modes.decay)])
    a[n : 2 * n, 2 * n :] = modes.b.T
    step = expm(a * dt)
    free, push, p = step[: 2 * n, : 2 * n], step[: 2 * n, 2 * n :], np.zeros((steps, ports, steps, ports))
    for late in range(steps):
        for k in range(steps - late):
            p[k + late, :, k] = modes.b @ push[:n]
        push = free @ push
    return p.reshape(steps * ports, -1)


def batches() -> Evidence:
    """Experiments side by side in one compiled call are those run one by one, to the last bit."""
    nominal = dampen.read_scenario("he2017", ["task.trials=4", "numerics.modes=20", "numerics.step=0.002"])
    gains = np.geomspace(0.2, 5, 12)
    members = [replace(nominal, controller=replace(nominal.controller, alpha_4=float(gain))) for gain in gains]
    batch = Batch(nominal)
    together = np.array([tally.by_port for tally in batch.run(members)])
    single = np.array([alone(member, batch.bench_of(member)).by_port for member in members])
    figure, (axes,) = canvas()
    axes.loglog(gains, single[:, -1, 0, 0], "ks", ms=5, mfc="none", label="one by one")
    axes.loglog(gains, together[:, -1, 0, 0], ".", ms=4, label="side by side")
    ticks(axes, [0.2, 0.5, 1, 2, 5])
    axes.set(xlabel="alpha_4 [N s/m]", ylabel="peak |w(L)| of the last trial [m]")
    axes.legend()
    off = float(np.abs(together - single).max())
    return Evidence((Number(f"largest difference of {together.size} figures of merit", off, 0.0, 0.0),), figure)


def limit() -> Evidence:
    """No run lies below the certified bound, whatever its law."""
    ports = ("tip_w", "tip_phi")
    scenario = dampen.read_scenario("he2017", ["task.trials=3", "numerics.modes=16", "numerics.step=0.002"])
    curve = dampen.limit(scenario, "w", weights=np.geomspace(1e-6, 1, 9))
    laws = [scenario.controller, *(dampen.BoundaryDamping(damping=dict.fromkeys(ports, d)) for d in np.geomspace(0.1, 30, 9))]
    places = [dampen.standing(curve, dampen.simulate(scenario.with_controller(law))) for law in laws]
    effort = np.geomspace(0.01, 3, 80)
    figure, (axes,) = canvas()
    axes.loglog(effort, [curve.bound(value) for value in effort], "k", lw=0.8, label="bound")
    axes.loglog([p.effort for p in places[1:]], [p.rms for p in places[1:]], "o", ms=3, label="boundary damping, nine gains")
    axes.loglog(places[0].effort, places[0].rms, "s", ms=4, label="the paper's law")
    axes.set(xlabel="effort, RMS [N]", ylabel="RMS of w [m]")
    axes.legend()
    nearest = min(p.rms / curve.bound(p.effort) for p in places)
    return Evidence(
        (
            at_most("largest duality gap of the bound, relative", max(point.gap for point in curve.points), 1e-10),
            Number("nearest run, times the bound", float(nearest), 1.0, np.inf),
        ),
        figure,
    )


ALL = (p_type_recursion, batches, limit)
