"""Decay rates, mode by mode, of the loop that a linear law closes; and what a reduced-order law does to the modes it left out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from dampen.analysis.loops import Eigenvalues, closed_loop, eigenvalues, of_plant
from dampen.analysis.rate_notes import evidence, law_notes, payload_note, payloads, stage_notes
from dampen.controllers.base import PortLaw, SampledFeedback, Setting
from dampen.simulation.bench import Bench
from dampen.simulation.compose import BARRIERS
from dampen.simulation.passes import begun, law_of
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import setting_of

Array = np.ndarray
Loop = Literal["continuous", "continuous twin", "sampled"]
GROWING = 1e-9  # of the largest eigenvalue: growth below this is round-off


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
    """Decay rates of a closed loop. loop: how the law acts in it; "continuous twin": a law port by port that acts through
    samples, whose rates are those of the same law acting continuously.

    slowest, rate: number (None: no mode of the plant) and rate of the slowest motion in the loop [1/s], negative where one grows.
    growing: numbers of the plant modes that grow.   with_modes: (modes, slowest rate) of fewer modes, where a payload leaves
    the continuum without a uniform rate.   notes: what has to be known with the numbers, one line each.
    """

    loop: Loop
    modes: tuple[LoopMode, ...]
    others: tuple[OtherMode, ...]
    slowest: int | None
    rate: float
    growing: tuple[int, ...]
    spillover: Spillover | None
    with_modes: tuple[tuple[int, float], ...]
    notes: tuple[str, ...]


@dataclass(frozen=True)
class NoRates:
    """No linear loop stands for this law; `reason` says why."""

    reason: str


def rates(scenario: Scenario, bench: Bench | None = None) -> Rates | NoRates:
    """The decay rates of the loop that the scenario's law closes around the modes kept.

    Port by port, with K_p also the curvature of a barrier at zero error (none for the log barrier, 1/C^2 for tan),

        q'' + 2 decay q' + omega^2 q = sum_p b_p F_p,    u_p = -D_p y_p' - K_p y_p,    F_p = gain_p u_p, behind lags if any

    The rule for what is not linear: a coulomb term has no slope at rest, so a law with one has no rates (NoRates). An actuator
    counts with its slope in full motion, and a lag with its time constant; gaps, limits and memory are left out, and a note
    names them: the rates then hold where motion is large against a gap and within the limits. Feedforward, reference,
    disturbance and what is learned between trials do not move the eigenvalues; the law is that of trial 0. A law that acts
    through samples on all ports together tells its loop itself, `Controller.sampled_loop`.
    """
    bench = bench or Bench(scenario)
    setting, controller = setting_of(scenario, bench=bench), scenario.controller
    sampled = controller.sampled_loop(setting) if scenario.sampled else None
    plant, chains = of_plant(bench.modes), [scenario.chain(p) for p in range(len(scenario.ports))]
    if sampled is not None:
        found = eigenvalues(sampled.matrix, plant, setting.dt)
        lagging = [port for port, chain in zip(scenario.ports, chains, strict=True) if any(s.lag_time > 0 for s in chain)]
        notes = [f"The loop from sample to sample leaves out the actuator's lag at {', '.join(lagging)}."] if lagging else []
        notes += stage_notes(scenario, setting, list(setting.gains > 0))
        return table(found, plant, "sampled", sampled.known, notes)
    if isinstance(controller, SampledFeedback):
        name = type(controller).__name__
        return NoRates(f"{name} acts through samples by its own function, without `sampled_loop`: its loop is unknown.")
    law = law_of(scenario, begun(controller, setting), setting)
    dry = [port for p, port in enumerate(scenario.ports) if setting.gains[p] * law.coulomb[:, p].max() > 0]
    if dry:
        return NoRates(
            f"The law has a coulomb term at {', '.join(dry)}: it is set-valued at rest, where the port sticks, and no linear "
            "loop stands for it."
        )
    stiffness = law.stiffness + barrier_stiffness(law, setting, controller.barrier_shape)
    found = eigenvalues(closed_loop(bench.modes, law.damping, stiffness, chains), plant)
    driven = setting.gains * (law.damping + law.stiffness + law.barrier) > 0
    notes = law_notes(scenario, law, setting) + stage_notes(scenario, setting, list(driven))
    damped = setting.gains * law.damping > 0
    payload = payloads(bench.modes, damped)
    slowest: tuple[tuple[int, float], ...] = ()
    if payload and all(port in payload for port, is_damped in zip(scenario.ports, damped, strict=True) if is_damped):
        slowest = evidence(bench.modes, law.damping, stiffness, chains)
        notes.append(payload_note(payload, slowest, bench.modes.damped))
    how: Loop = "continuous twin" if scenario.sampled else "continuous"
    return replace(table(found, plant, how, None, notes), with_modes=slowest)


def table(found: Eigenvalues, plant: Array, loop: Loop, known: int | None, notes: list[str]) -> Rates:
    """The eigenvalues as rates and frequencies."""
    n = len(plant)
    modes = tuple(
        LoopMode(i + 1, *_figures(s), _figures(alone)[0], _figures(alone)[1], known is None or i < known)
        for i, (s, alone) in enumerate(zip(found.s, plant, strict=True))
    )
    rest: Literal["controller", "actuator"] = "controller" if loop == "sampled" else "actuator"
    others = tuple(OtherMode("plant" if i < n else rest, *_figures(s)) for s, i in zip(found.others, found.whose, strict=True))
    limit = -GROWING * max(np.abs(found.s).max(), np.abs(found.others).max(initial=0.0))
    growing = tuple(m.number for m in modes if m.rate < limit)
    slow = min(modes, key=lambda m: m.rate)
    rate = min([slow.rate, *(m.rate for m in others)])
    if rate < limit:
        notes = [f"The loop grows by {-rate:.3g} 1/s: it is not stable.", *notes]
    spilt = None if known is None or known >= n else _spillover(modes, known, limit)
    return Rates(loop, modes, others, slow.number if slow.rate == rate else None, rate, growing, spilt, (), tuple(notes))


def _figures(s: complex) -> tuple[float, float, float]:
    """Frequency [Hz], rate [1/s] and damping ratio of an eigenvalue."""
    rate = float(-s.real) + 0.0  # no negative zero
    return float(abs(s.imag) / (2 * np.pi)), rate, rate / float(abs(s)) if s else 0.0


def _spillover(modes: Sequence[LoopMode], known: int, limit: float) -> Spillover:
    left = modes[known:]
    slowed = [m for m in left if m.rate - m.plant_rate < limit]
    worst = min(slowed, key=lambda m: m.rate - m.plant_rate, default=None)
    change = 0.0 if worst is None else worst.rate - worst.plant_rate
    growing = tuple(m.number for m in left if m.rate < limit)
    return Spillover(known, len(left), len(slowed), None if worst is None else worst.number, change, growing)


def barrier_stiffness(law: PortLaw, setting: Setting, shape: str) -> Array:
    """(ports,) curvature of the law's barrier at zero error; where limits are uneven, the mean of both sides."""
    if shape not in BARRIERS:
        return np.zeros(len(setting.ports))
    both = [
        [BARRIERS[shape].curvature(limit) if gain > 0 else 0.0 for gain, limit in zip(law.barrier, side, strict=True)]
        for side in (setting.high[0], -setting.low[0])
    ]
    return np.asarray(law.barrier * np.mean(both, axis=0))
