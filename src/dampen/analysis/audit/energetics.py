"""Does the energy account close, is the dissipation what it must be, and does the control take energy or give it?"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from dampen.analysis.audit.finding import Finding, Quantity, Values
from dampen.analysis.energy import EnergyAccount, energy_account
from dampen.analysis.merits import LATE
from dampen.gauss import gauss_legendre
from dampen.modal import propagator
from dampen.simulation.bench import Bench
from dampen.simulation.result import Result

Array = np.ndarray
ROUND_OFF = 1e-11
LOOKED_AT, STIFF = 64, 800.0  # steps whose dissipation is integrated again; rad that the fastest mode may turn in one
FEED = 1e-9  # of the largest energy: less is no gift


def energetics(result: Result, bench: Bench) -> Iterator[Finding]:
    """The rows about energy."""
    account = energy_account(result)
    yield closes(result, account)
    if bench.modes.damped:
        yield dissipates(result, bench)
    yield takes(result, account)


def closes(result: Result, account: EnergyAccount) -> Finding:
    """The account to round-off, with every work named."""
    worst = max(account.error, *(trial_errors(result) / (account.largest or 1.0)))
    works = named_works(result, account)
    said = ", ".join(f"{name} {quantity.value:+.3g} J" for name, quantity in works.items() if quantity.value)
    return Finding.of(
        "energy",
        "energy.account",
        f"change of energy = work of all forces, to {ROUND_OFF:g} of the largest energy, over the run and in each trial",
        f"{worst:.1e}",
        bool(worst <= ROUND_OFF),
        f"From {account.initial:.3g} J to {account.final:.3g} J: {said or 'nothing worked'}.",
        {
            "initial": Quantity(account.initial, "J"),
            "final": Quantity(account.final, "J"),
            **works,
            "barrier, start": Quantity(account.barrier_initial, "J"),
            "barrier, end": Quantity(account.barrier_final, "J"),
            "compliance, stored": Quantity(account.compliance_stored, "J"),
            "compliance, lost": Quantity(account.compliance_lost, "J"),
            "closing error": Quantity(worst),
        },
    )


def named_works(result: Result, account: EnergyAccount) -> Values:
    """Every work of the account by name; the disturbances' port by port."""
    by_port = sum(np.asarray(result["work_disturbance"][j]).sum(axis=0) for j in range(result.trials))
    disturbed = {f"disturbance at {name}": Quantity(float(by_port[p]), "J") for p, name in enumerate(result.scenario.ports)}
    return {
        "law": Quantity(account.law, "J"),
        "actuator": Quantity(account.actuator, "J"),
        **disturbed,
        "load": Quantity(account.load, "J"),
        "dissipated": Quantity(-account.dissipated, "J"),
        "resets": Quantity(account.resets, "J"),
    }


def trial_errors(result: Result) -> Array:
    """(trials,) |change of energy - work| in each trial [J]."""
    errors = []
    for j in range(result.trials):
        energy = np.asarray(result["energy"][j])
        work = sum(float(np.sum(result[name][j])) for name in ("work_control", "work_disturbance", "work_load"))
        errors.append(abs(energy[-1] - energy[0] - work + float(np.sum(result["dissipated"][j]))))
    return np.array(errors)


def dissipates(result: Result, bench: Bench) -> Finding:
    """The dissipation in some steps of trial 0, once more by points within them."""
    modes = bench.modes
    turn = float((modes.omega + 2 * modes.decay).max()) * bench.step.dt
    criterion = "int 2 sum_i zeta_i omega_i q_i'^2 dt, by Gauss points within steps of trial 0, is what the account has, to 1e-8"
    if turn > STIFF:
        why = f"The fastest mode turns by {turn:.0f} rad in a step: points within it would have to be too many."
        return Finding.of("energy", "energy.dissipated", criterion, "not looked at", None, why, {})
    steps = np.unique(np.linspace(0, result.scenario.steps - 1, LOOKED_AT).astype(int))
    again, kept = dissipation_by_quadrature(result, bench, steps), float(np.sum(np.asarray(result["dissipated"][0])[steps]))
    off = abs(again - kept) / abs(again) if again else abs(kept)
    return Finding.of(
        "energy",
        "energy.dissipated",
        criterion,
        f"{again:.6g} J in {len(steps)} steps; off by {off:.1e}",
        bool(off <= 1e-8),
        "The structure's own damping is integrated without use of the balance that it closes.",
        {"dissipated in these steps, by quadrature": Quantity(again, "J"), "in the account": Quantity(kept, "J")},
    )


def dissipation_by_quadrature(result: Result, bench: Bench, steps: Array) -> float:
    """int 2 sum_i decay_i q_i'^2 dt over some steps of trial 0 [J]: the motion replayed under its forces, with q' at Gauss
    points in pieces of each of these steps, so short that no mode turns by more than a few radians in one."""
    modes, dt = bench.modes, bench.step.dt
    disturbance, load, _ = bench.shaking(0)
    forces = (np.asarray(result["delivered"][0]) + disturbance) @ modes.b + load[:, : modes.count]
    pieces = 1 + int((modes.omega + 2 * modes.decay).max() * dt / 4)
    nodes, weights = gauss_legendre(16)
    times = ((np.arange(pieces)[:, None] + (nodes + 1) / 2) * dt / pieces).ravel()
    inside = [propagator(modes, float(time)) for time in times]
    c21, c22, c12 = (np.array([getattr(p, name) for p in inside]) for name in ("c21", "c22", "c12"))
    weight = np.tile(weights, pieces) * dt / (2 * pieces)
    step, (q, rate) = propagator(modes, dt), bench.state(0)
    total, wanted = 0.0, set(map(int, steps))
    for k, a in enumerate(forces[: max(wanted) + 1]):
        if k in wanted:
            within = c21 * q + c22 * rate + c12 * a
            total += float(weight @ (within**2 @ (2 * modes.decay)))
        q, rate = step.c11 * q + step.c12 * rate + step.psi * a, step.c21 * q + step.c22 * rate + step.c12 * a
    return total


def takes(result: Result, account: EnergyAccount) -> Finding:
    """Whether the control takes energy: its work and what its barrier, stiffness and compliance have come to hold."""
    given, least = given_by_control(result), FEED * account.largest
    net, lately = float(given.sum()), float(given[-LATE:].sum())
    feeding = np.flatnonzero(given > least)
    tracking = bool(result.scenario.task.reference)
    holds = None if tracking or not account.control else net <= least and lately <= least
    if tracking:
        meaning = "To follow a reference a control has to give energy."
    elif not account.control:
        meaning = "Nothing pushed."
    elif holds:
        meaning = (
            f"It takes energy; it gave some in {len(feeding)} of {result.trials} trials." if len(feeding) else "It takes energy."
        )
    else:
        meaning = feeding_meaning(result)
    return Finding.of(
        "energy",
        "energy.control-takes",
        f"control's work + change of what its barrier and springs store <= 0 over the run, and over the last {LATE} trials",
        f"{net:+.3g} J; last {LATE}: {lately:+.3g} J",
        holds,
        meaning,
        {"given by the control, by trial": Quantity(tuple(map(float, given)), "J")},
    )


def feeding_meaning(result: Result) -> str:
    """What may be behind a control that gives energy."""
    scenario = result.scenario
    rough = {
        port: [f"{what} {given[port]:.3g}" for what, given in sources if given.get(port, 0.0) > 0]
        for port in scenario.ports
        for sources in [(("noise of", scenario.sampling.noise), ("a quantum of", scenario.sampling.quantum))]
    }
    read = {port: words for port, words in rough.items() if words}
    if not scenario.sampled or not read:
        return "The control feeds energy into the structure: its gains, its delay or what it has learned push the wrong way."
    units = {port.name: (port.motion_unit, port.effort_unit) for port in scenario.plant.ports}
    told = []
    for p, port in enumerate(scenario.ports):
        if port in read:
            square = np.mean([np.mean(np.asarray(result["delivered"][j])[:, p] ** 2) for j in late(result)])
            motion, effort = units[port]
            told.append(
                f"{port} is read with {' and '.join(f'{w} {motion}' for w in read[port])}, force {square**0.5:.3g} {effort}"
            )
    return (
        "The control feeds energy into the structure. The sensors may be why: what they add, the law answers with forces "
        f"that move the structure ({'; '.join(told)} RMS, last {LATE} trials). Otherwise its gains, its delay or what it has "
        "learned push the wrong way."
    )


def late(result: Result) -> range:
    """The last five trials, or all there are."""
    return range(max(result.trials - LATE, 0), result.trials)


def given_by_control(result: Result) -> Array:
    """(trials,) work of the delivered forces and change of barrier, stiffness and compliance energy [J]."""
    given = []
    for j in range(result.trials):
        stored = np.asarray(result["barrier_energy"][j])[[0, -1]] + np.asarray(result["compliance_energy"][j])[[0, -1]]
        change = stored[1] - stored[0] if np.all(np.isfinite(stored)) else 0.0
        given.append(float(np.sum(result["work_control"][j])) + change)
    return np.array(given)
