"""Decay rates, mode by mode, of the loop that a linear law closes; and what a reduced-order law does to the modes it left out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from dampen.analysis.loops import Eigenvalues, closed_loop, eigenvalues, of_plant
from dampen.analysis.rate_notes import evidence, law_notes, payload_note, payloads, stage_notes
from dampen.analysis.sampled_ports import sampled_port_loop
from dampen.arguments import BENCH, SCENARIO, takes
from dampen.component import ArgumentError, own_name
from dampen.controllers.base import Controller, PortLaw, SampledFeedback, Setting
from dampen.modal import ModalModel
from dampen.simulation.bench import Bench
from dampen.simulation.compose import BARRIERS
from dampen.simulation.memory import begun
from dampen.simulation.passes import law_of
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import setting_of

Array = np.ndarray
Loop = Literal["continuous", "sampled"]
OWN = 0.5  # of a rate in the loop: a plant's own that is more sets it
AT_MOST = 1e-6  # of the largest eigenvalue: what round-off may hide of a rate, however ill-conditioned


@dataclass(frozen=True)
class LoopMode:
    """One mode of the plant, number 1 the lowest, in the closed loop.

    frequency [Hz] and rate [1/s] of e^(-rate t) cos(2 pi frequency t), rate > 0 where it decays; 0 Hz: it no longer swings.
    ratio: rate / |eigenvalue|, the damping ratio.   plant_frequency, plant_rate: of the plant alone.   known: whether the law
    is designed on this mode.
    """

    number: int
    frequency: float
    rate: float
    ratio: float
    plant_frequency: float
    plant_rate: float
    known: bool


@dataclass(frozen=True)
class OtherMode:
    """A motion of the loop that is no mode of the plant: of an actuator's lag, of what the controller keeps (its observer), or
    the faster half of a plant mode that no longer swings."""

    part: Literal["plant", "actuator", "controller"]
    frequency: float
    rate: float
    ratio: float


@dataclass(frozen=True)
class Spillover:
    """What a law designed on the lowest `known` modes does to the modes that it left out.

    left_out: how many.   slowed: those whose rate is less than the plant's alone.   worst, change: the number of the one that
    lost most, and rate less plant's rate [1/s]; None where none lost.   growing: numbers of those that grow.
    """

    known: int
    left_out: int
    slowed: int
    worst: int | None
    change: float
    growing: tuple[int, ...]


@dataclass(frozen=True)
class Rates:
    """Decay rates of a closed loop. loop: how the law acts in it.

    slowest, rate: number (None: no mode of the plant) and rate of the slowest motion in the loop [1/s], negative where one grows,
    0 where it is zero to round-off.   growing, still: numbers of the plant modes that grow, and of those that neither grow nor
    decay.   with_modes: (modes, slowest rate) of fewer modes, where a payload leaves
    the continuum without a uniform rate.   notes: what has to be known with the numbers, one line each.
    """

    loop: Loop
    modes: tuple[LoopMode, ...]
    others: tuple[OtherMode, ...]
    slowest: int | None
    rate: float
    growing: tuple[int, ...]
    still: tuple[int, ...]
    spillover: Spillover | None
    with_modes: tuple[tuple[int, float], ...]
    notes: tuple[str, ...]


@dataclass(frozen=True)
class NoRates:
    """No linear loop stands for this law; `reason` says why."""

    reason: str


@takes(scenario=SCENARIO, bench=BENCH)
def rates(scenario: Scenario, bench: Bench | None = None) -> Rates | NoRates:
    """The decay rates of the loop that the scenario's law closes around the modes kept.

    Port by port, with K_p also the curvature of a barrier at zero error (none for the log barrier, 1/C^2 for tan),

        q'' + 2 decay q' + omega^2 q = sum_p b_p F_p,    u_p = -D_p y_p' - K_p y_p,    F_p = gain_p u_p, behind lags if any

    The rule for what is not linear: a coulomb term has no slope at rest, so a law with one has no rates (NoRates). An actuator
    counts with its slope in full motion, and a lag with its time constant; gaps, limits and memory are left out, and a note
    names them: the rates then hold where motion is large against a gap and within the limits. Feedforward, reference,
    disturbance and what is learned between trials do not move the eigenvalues; the law is that of trial 0. A law that acts
    port by port through samples is taken with its estimator, hold and delay; one that acts through samples on all ports
    together tells its loop itself, `Controller.sampled_loop`.
    """
    bench = bench or Bench(scenario)
    setting, controller = setting_of(scenario, bench=bench), scenario.controller
    sampled = controller.sampled_loop(setting) if scenario.sampled else None
    plant, lags = of_plant(bench.modes), sum(map(len, setting.lags))
    if sampled is not None:
        lagging = [port for port, times in zip(scenario.ports, setting.lags, strict=True) if times]
        if sampled.lags != lags:
            return NoRates(f"The loop that the law tells leaves out the actuator's lag at {', '.join(lagging)}.")
        check_loop(controller, sampled.matrix, 2 * len(plant) + lags)
        found = eigenvalues(sampled.matrix, plant, setting.dt, lags)
        return table(found, plant, "sampled", sampled.known, stage_notes(scenario, setting, list(setting.gains > 0)))
    if isinstance(controller, SampledFeedback):
        name = type(controller).__name__
        return NoRates(f"{name} acts through samples by its own function, without `sampled_loop`: its loop is unknown.")
    law = law_of(scenario, begun(scenario, setting), setting)
    dry = [port for p, port in enumerate(scenario.ports) if setting.gains[p] * law.coulomb[:, p].max() > 0]
    if dry:
        return NoRates(
            f"The law has a coulomb term at {', '.join(dry)}: it is set-valued at rest, where the port sticks, and no linear "
            "loop stands for it."
        )
    return _by_ports(scenario, bench, setting, law, plant)


def check_loop(controller: Controller, matrix: Array, least: int) -> None:
    """Raise ArgumentError unless a law's own loop is a square matrix of numbers around all modes and lags."""
    shape = np.shape(matrix)
    if len(shape) != 2 or shape[0] != shape[1] or shape[0] < least or not np.all(np.isfinite(matrix)):
        must = f"give a finite square matrix of at least {least} rows, for all modes and lags"
        raise ArgumentError(f"{own_name(controller)}.sampled_loop must {must}, but gives one of shape {shape}.")


def _by_ports(scenario: Scenario, bench: Bench, setting: Setting, law: PortLaw, plant: Array) -> Rates:
    """The rates of a law port by port."""
    stiffness = law.stiffness + barrier_stiffness(law, setting, scenario.controller.barrier_shape)
    chains = [scenario.chain(p) for p in range(len(scenario.ports))]
    sampled = scenario.sampled

    def around(model: ModalModel) -> Eigenvalues:
        alone = of_plant(model)
        if sampled:
            loop = sampled_port_loop(model, law, stiffness, scenario.sampling, setting)
            return eigenvalues(loop, alone, setting.dt, sum(map(len, setting.lags)))
        return eigenvalues(closed_loop(model, law.damping, stiffness, chains), alone)

    driven = setting.gains * (law.damping + law.stiffness + law.barrier) > 0
    notes = law_notes(scenario, law, setting) + stage_notes(scenario, setting, list(driven))
    damped = setting.gains * law.damping > 0
    payload = payloads(bench.modes, damped)
    slowest: tuple[tuple[int, float], ...] = ()
    if payload and all(port in payload for port, is_damped in zip(scenario.ports, damped, strict=True) if is_damped):
        slowest = evidence(bench.modes, lambda model: slowest_of(around(model)))
    how: Loop = "sampled" if sampled else "continuous"
    whole = table(around(bench.modes), plant, how, None, notes)
    if not slowest:
        return whole
    own = whole.slowest is not None and whole.modes[whole.slowest - 1].plant_rate > OWN * whole.rate
    said = payload_note(payload, slowest, bench.modes.damped, own)
    return replace(whole, with_modes=slowest, notes=(*whole.notes, said))


def slowest_of(found: Eigenvalues) -> float:
    """The rate of the slowest motion [1/s]."""
    return float(min(clean(found.s, found).min(), clean(found.others, found).min(initial=np.inf)))


def clean(s: Array, found: Eigenvalues) -> Array:
    """The rates of eigenvalues of a loop [1/s], zero where they are within round-off of it."""
    noise = found.s_noise if s is found.s else found.others_noise
    most = AT_MOST * max(np.abs(found.s).max(), np.abs(found.others).max(initial=0.0))
    return np.where(np.abs(s.real) <= np.minimum(noise, most), 0.0, -s.real)


def table(found: Eigenvalues, plant: Array, loop: Loop, known: int | None, notes: list[str]) -> Rates:
    """The eigenvalues as rates and frequencies."""
    n = len(plant)
    modes = tuple(
        LoopMode(i + 1, *_figures(s), _figures(alone)[0], _figures(alone)[1], known is None or i < known)
        for i, (s, alone) in enumerate(zip(found.s, plant, strict=True))
    )
    parts: tuple[Literal["actuator", "controller"], ...] = ("actuator", "controller")
    others = tuple(
        OtherMode("plant" if i < n else parts[i - n], *_figures(s)) for s, i in zip(found.others, found.whose, strict=True)
    )
    own, rate = clean(found.s, found), slowest_of(found)
    growing, still = (tuple(int(i) + 1 for i in np.flatnonzero(which)) for which in (own < 0, own == 0))
    slow = int(np.argmin(own))
    if rate < 0:
        notes = [f"The loop grows by {-rate:.3g} 1/s: it is not stable.", *notes]
    spilt = None if known is None or known >= n else _spillover(modes, known, found.s_noise, growing)
    slowest = slow + 1 if own[slow] == rate else None
    return Rates(loop, modes, others, slowest, rate, growing, still, spilt, (), tuple(notes))


def _figures(s: complex) -> tuple[float, float, float]:
    """Frequency [Hz], rate [1/s] and damping ratio of an eigenvalue."""
    rate = float(-s.real) + 0.0  # no negative zero
    return float(abs(s.imag) / (2 * np.pi)), rate, rate / float(abs(s)) if s else 0.0


def _spillover(modes: Sequence[LoopMode], known: int, noise: Array, growing: Sequence[int]) -> Spillover:
    left = modes[known:]
    slowed = [m for m in left if m.rate - m.plant_rate < -noise[m.number - 1]]
    worst = min(slowed, key=lambda m: m.rate - m.plant_rate, default=None)
    change = 0.0 if worst is None else worst.rate - worst.plant_rate
    grow = tuple(number for number in growing if number > known)
    return Spillover(known, len(left), len(slowed), None if worst is None else worst.number, change, grow)


def barrier_stiffness(law: PortLaw, setting: Setting, shape: str) -> Array:
    """(ports,) curvature of the law's barrier at zero error; where limits are uneven, the mean of both sides."""
    if shape not in BARRIERS:
        return np.zeros(len(setting.ports))
    both = [
        [BARRIERS[shape].curvature(limit) if gain > 0 else 0.0 for gain, limit in zip(law.barrier, side, strict=True)]
        for side in (setting.high[0], -setting.low[0])
    ]
    return np.asarray(law.barrier * np.mean(both, axis=0))
