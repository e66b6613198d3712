"""A-priori bounds on energy and port motion under a passive law, from the stated bounds, beside what was measured."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dampen.analysis.metrics import largest
from dampen.analysis.supply import NoBound, Supply, supply
from dampen.controllers.base import PortLaw, Setting
from dampen.simulation.bench import Bench
from dampen.simulation.compose import BARRIERS
from dampen.simulation.passes import begun, law_of
from dampen.simulation.result import Result
from dampen.simulation.setting import setting_of

Array = np.ndarray
ROUND_OFF = 1e-9


@dataclass(frozen=True)
class PortBound:
    """Largest |y| of one port in each trial [unit]. push: what disturbance, feedforward and the actuator's deviation come to
    beyond dry friction [N, N m]; None without a bound.   bound: empty where nothing holds the port.   measured: all trials."""

    port: str
    unit: str
    push: float | None
    bound: tuple[float, ...]
    measured: tuple[float, ...]


@dataclass(frozen=True)
class Bounds:
    """Largest V = energy + energy of barrier and stiffness in each trial [J], and |y|, bound beside measured.

    reason: why there is no bound; empty where there is one.   trials: how many trials, the first, the bound speaks of.
    bound: (trials,) by trial.   measured: of all finished trials.   holds: whether both stay within their bounds at all times
    that they speak of; None without a bound.   notes: what has to be known with the numbers, one line each.
    """

    reason: str
    trials: int
    bound: tuple[float, ...]
    measured: tuple[float, ...]
    ports: tuple[PortBound, ...]
    holds: bool | None
    notes: tuple[str, ...]


def bounds(result: Result, bench: Bench | None = None) -> Bounds:
    """The bounds that a passive law guarantees under disturbances within the scenario's stated bounds, true or not.

        V = E + sum_p gain_p (barrier_p V_b(y_p) + stiffness_p y_p^2 / 2)
        V' <= sum_p max_v [push_p |v| - gain_p damping_p v^2] + f_bar sqrt(int dx / rho) sqrt(2 E_kin)
        push_p = (d_bar_p + w_p + gain_p max |feedforward_p| - gain_p coulomb_p)_+

    w_p is how far the actuator can be off its slope (`Stage.deviation`). The maximum is at most push^2 / (4 gain damping), and
    with |v_p| <= sqrt(sum_i b_pi^2) sqrt(2 E_kin) at most that times push: whatever bounds V more tightly counts. What the
    structure's own damping takes is left out. From V the port follows,

        |y_p| <= sqrt(2 V / (1/k_pp + gain_p stiffness_p)),    k_pp = sum_i b_pi^2 / omega_i^2,    gain_p barrier_p V_b(y_p) <= V

    It is exact for the law in continuous time; what the steps' numerical compliance adds vanishes with the step. It may be
    loose: without dissipation in excess of the disturbance, V grows like t^2. A law that learns is passive as long
    as it has learned nothing: its bound is that of trial 0.
    """
    if not result.trials:
        return _table(result, None, 0, "No trial was finished.")
    scenario = result.scenario
    bench = bench or Bench(scenario)
    setting = setting_of(scenario, bench=bench)
    memory = begun(scenario.controller, setting)
    law = law_of(scenario, memory, setting)
    trials = 1 if memory else result.trials
    disturbed = [bool(np.any(np.asarray(result["disturbance"][:trials])[..., p])) for p in range(len(scenario.ports))]
    try:
        given = supply(scenario, law, setting, bench, disturbed)
    except NoBound as reason:
        return _table(result, None, 0, str(reason))
    allowed = over_trials(result, given, [float(energy(result, j)[0]) for j in range(trials)])
    reach = [port_reach(law, setting, bench, scenario.controller.barrier_shape, p) for p in range(len(scenario.ports))]
    held = all(within(energy(result, j), bound) for j, bound in enumerate(allowed))
    limits = []
    for p, most in enumerate(reach):
        at_port = [most(bound) for bound in allowed]
        held &= all(within(np.abs(np.asarray(result["y"][j])[:, p]), bound) for j, bound in enumerate(at_port))
        limits.append(tuple(float(bound[-1]) for bound in at_port if np.isfinite(bound[-1])))
    bare = _table(result, given, trials, "", limits)
    return replace(bare, bound=tuple(float(b[-1]) for b in allowed), holds=held, notes=notes(result, memory, given))


def energy(result: Result, trial: int) -> Array:
    """(times,) energy of structure, barrier and stiffness in a trial [J]."""
    return np.asarray(result["energy"][trial]) + np.asarray(result["barrier_energy"][trial])


def _table(
    result: Result, given: Supply | None, trials: int, reason: str, limits: Sequence[tuple[float, ...]] | None = None
) -> Bounds:
    """What was measured, and the ports' bounds beside it where there are any."""
    ports = tuple(
        PortBound(
            port.name,
            port.motion_unit,
            None if given is None else float(given.push[p]),
            () if limits is None else limits[p],
            tuple(float(peak) for peak in largest(result, "y", port.name)),
        )
        for p, port in enumerate(result.scenario.plant.ports)
    )
    measured = tuple(float(energy(result, j).max()) for j in range(result.trials))
    return Bounds(reason, trials, (), measured, ports, None, ())


def over_trials(result: Result, given: Supply, starts: Sequence[float]) -> list[Array]:
    """For each trial (times,) the largest V allowed: from the start on, or from where a reset puts it."""
    t, duration = result.time, result.scenario.task.trial_duration
    if result.scenario.task.start == "reset":
        return [given.largest(t, start) for start in starts]
    return [given.largest(t + j * duration, starts[0]) for j in range(len(starts))]


def port_reach(law: PortLaw, setting: Setting, bench: Bench, shape: str, p: int) -> Callable[[Array], Array]:
    """The function V (times,) -> largest |y_p| (times,); infinite where nothing holds the port."""
    b, omega, gain = bench.modes.b[p], bench.modes.omega, float(setting.gains[p])
    free = bool(np.any((omega == 0) & (b != 0)))
    compliance = float(np.sum(np.divide(b, omega, where=omega > 0, out=np.zeros_like(b)) ** 2))
    holding = (0.0 if free or compliance == 0 else 1 / compliance) + gain * float(law.stiffness[p])
    barrier = gain * float(law.barrier[p])
    limit = float(max(setting.high[0, p], -setting.low[0, p]))

    def at_most(v: Array) -> Array:
        most = np.sqrt(2 * v / holding) if holding > 0 else np.full_like(v, np.inf)
        if barrier > 0:
            most = np.minimum(most, [BARRIERS[shape].reach(level, limit) for level in v / barrier])
        return np.asarray(most)

    return at_most


def within(values: Array, bound: Array) -> bool:
    """Whether values stay within their bound at all times, up to round-off."""
    return bool(np.all(values <= bound * (1 + ROUND_OFF)))


def notes(result: Result, memory: object, given: Supply) -> tuple[str, ...]:
    """What has to be known with the bound."""
    found = []
    if memory:
        found.append("What the law has learned can push as well as brake: the bound is that of trial 0, before it has learned.")
    if result.status == "constraint_lost" and result.scenario.controller.barrier_shape != "none":
        found.append("The constraint was lost: beyond it the barrier has no energy that a bound could hold.")
    if given.load > 0:
        found.append("A load along the structure is not answered where it acts: under its bound alone V may grow without end.")
    loose = [n for n, push, d in zip(result.scenario.ports, given.push, given.damping, strict=True) if push > 0 and not d > 0]
    if loose:
        found.append(f"At {', '.join(loose)} the disturbance may push and nothing damps: V may grow without end.")
    return tuple(found)
