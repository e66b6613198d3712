"""A-priori bounds on energy and port motion under a passive law, from the stated bounds, beside what was measured."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dampen.analysis.metrics import largest
from dampen.analysis.supply import NoBound, Supply, supply
from dampen.arguments import BENCH, RESULT, takes
from dampen.controllers.base import PortLaw, Setting
from dampen.simulation.bench import Bench
from dampen.simulation.compose import BARRIERS
from dampen.simulation.memory import begun
from dampen.simulation.passes import law_of
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
class Breach:
    """Where a bound was first broken: what ("V" or a port's "|y| at ..."), trial, time in it [s], the value there and its bound
    there."""

    what: str
    unit: str
    trial: int
    time: float
    value: float
    bound: float


@dataclass(frozen=True)
class Bounds:
    """Largest V = energy + energy of barrier and stiffness in each trial [J], and |y|, bound beside measured.

    reason: why there is no bound; empty where there is one.   trials: how many trials, the first, the bound speaks of.
    bound: (trials,) by trial.   measured: of all finished trials.   holds: whether both stay within their bounds at all times
    that they speak of; None without a bound.   broken: where not, for the first time.   notes: what has to be known with the
    numbers, one line each.
    """

    reason: str
    trials: int
    bound: tuple[float, ...]
    measured: tuple[float, ...]
    ports: tuple[PortBound, ...]
    holds: bool | None
    broken: Breach | None
    notes: tuple[str, ...]


@takes(result=RESULT, bench=BENCH)
def bounds(result: Result, bench: Bench | None = None) -> Bounds:
    """The bounds that a passive law guarantees under disturbances within the scenario's stated bounds, true or not.

        V = E + sum_p gain_p (barrier_p V_b(y_p) + stiffness_p y_p^2 / 2)
        V' <= sum_p max_v [push_p |v| - gain_p damping_p v^2] + f_bar sqrt(int dx / rho) sqrt(2 E_kin)
        push_p = (d_bar_p + w_p + gain_p max |feedforward_p| - gain_p coulomb_p)_+

    w_p is how far the actuator can be off its slope (`Stage.deviation`). The maximum is at most push^2 / (4 gain damping), and
    with |v_p| <= sqrt(sum_i b_pi^2) sqrt(2 E_kin) at most that times push: whatever bounds V more tightly counts. What the
    structure's own damping takes is left out. From V the port follows,

        |y_p| <= sqrt(2 V / (1/k_pp + gain_p stiffness_p)),    k_pp = sum_i b_pi^2 / omega_i^2,    gain_p barrier_p V_b(y_p) <= V

    That is the law in continuous time. In steps the law sees v, and the port moves with v - soft (x + z) in the mean of a step
    (`simulation.closure`, R = RELAXATION): B = L + P, L the delivered force but for P, that of the potentials, which answers to
    the port's own velocity; x = L - L_slow, z = P - P_slow. L gives the structure L (v - soft x - soft z), of which
    soft L x dt = change of soft dt L_slow^2 / (2 R) + (1 - R/2) soft x^2 dt; that storage, empty at the start, counts with V.
    The disturbance gives d (v - soft x - soft z). So V' is larger by at most

        d_bar soft |x| - (1 - R/2) soft x^2 <= soft d_bar^2 / (4 (1 - R/2)),    |L + d| soft |z|,    |z| <= 2 |P|

    with |P| <= sqrt(gain stiffness) sqrt(2 V), see `Supply`. All of it vanishes with the step, as soft does. For the barrier,
    whose force no multiple of sqrt(2 V) bounds, soft |z| is left out. The bound may be loose: without dissipation in excess of
    the disturbance, V grows like t^2. A law that learns is passive as long as it has learned nothing: its bound is that of
    trial 0.
    """
    if not result.trials:
        return _table(result, None, 0, "No trial was finished.")
    scenario = result.scenario
    bench = bench or Bench(scenario)
    setting = setting_of(scenario, bench=bench)
    memory = begun(scenario, setting)
    law = law_of(scenario, memory, setting)
    trials = 1 if memory else result.trials
    disturbed = [bool(np.any(np.asarray(result["disturbance"][:trials])[..., p])) for p in range(len(scenario.ports))]
    try:
        given = supply(scenario, law, setting, bench, disturbed)
    except NoBound as reason:
        return _table(result, None, 0, str(reason))
    allowed = over_trials(result, given, [float(energy(result, j)[0]) for j in range(trials)])
    reach = [port_reach(law, setting, bench, scenario.controller.barrier_shape, p) for p in range(len(scenario.ports))]
    breaches, limits = [], []
    for j, bound in enumerate(allowed):
        breaches.append(breach("V", "J", j, result.time, energy(result, j), bound))
    for p, most in enumerate(reach):
        port, at_port = scenario.plant.ports[p], [most(bound) for bound in allowed]
        for j, bound in enumerate(at_port):
            y = np.abs(np.asarray(result["y"][j])[:, p])
            breaches.append(breach(f"|y| at {port.name}", port.motion_unit, j, result.time, y, bound))
        limits.append(tuple(float(bound[-1]) for bound in at_port if np.isfinite(bound[-1])))
    broken = min((b for b in breaches if b is not None), key=lambda b: (b.trial, b.time), default=None)
    bare = _table(result, given, trials, "", limits)
    said = notes(result, memory, given)
    if broken is not None and np.any(setting.gains * law.barrier > 0):
        said += ("What the steps' compliance exchanges with the barrier is not in the bound: half the step tells it apart.",)
    return replace(bare, bound=tuple(float(b[-1]) for b in allowed), holds=broken is None, broken=broken, notes=said)


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
    return Bounds(reason, trials, (), measured, ports, None, None, ())


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


def breach(what: str, unit: str, trial: int, t: Array, values: Array, bound: Array) -> Breach | None:
    """Where values leave their bound for the first time, by more than round-off."""
    beyond = np.flatnonzero(~(values <= bound * (1 + ROUND_OFF)))
    if not len(beyond):
        return None
    k = int(beyond[0])
    return Breach(what, unit, trial, float(t[k]), float(values[k]), float(bound[k]))


def notes(result: Result, memory: object, given: Supply) -> tuple[str, ...]:
    """What has to be known with the bound."""
    found = []
    if memory:
        found.append("What the law has learned can push as well as brake: the bound is that of trial 0, before it has learned.")
    if result.status == "constraint_lost" and result.scenario.controller.barrier_shape != "none":
        found.append("The constraint was lost: beyond it the barrier has no energy that a bound could hold.")
    if given.growth * result.scenario.task.trial_duration * result.trials > 1:
        found.append(
            "Stiffness and damping behind the steps' compliance let the bound grow without end: a finer step tightens it."
        )
    if given.load > 0:
        found.append("A load along the structure is not answered where it acts: under its bound alone V may grow without end.")
    loose = [n for n, push, d in zip(result.scenario.ports, given.push, given.damping, strict=True) if push > 0 and not d > 0]
    if loose:
        found.append(f"At {', '.join(loose)} the disturbance may push and nothing damps: V may grow without end.")
    return tuple(found)
