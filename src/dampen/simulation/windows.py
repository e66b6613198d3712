"""Many runs side by side, a sample period at a time, in one compiled call. Plain Python, compiled before use, around `run_trial`.

A window is a trial of one period: the very kernel goes through the period's slice of what the trial brings, with a digital
controller whose tables are slices too, and whose law is the command that was handed in from outside. All state is in the
records that the kernel carries from trial to trial anyway.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from dampen.simulation.digital import Sampler, measure
from dampen.simulation.kernel import Inputs, Step, run_trial
from dampen.simulation.ports import PORTS

Array = np.ndarray
REST, LOOK, MOVE = 0, 1, 2  # what a run is to do: nothing, read its sensors, go through a window and then read them


class Fleet(NamedTuple):
    """What belongs to the runs, a row each.

    todo: REST, LOOK or MOVE.   row: of the :class:`Bank`.   at: the coming sample of the trial.   command (., ports): to be held.
    modal, ports, stages: the kernel's records.   e_hat, v_hat, state, begun, noise, error, rate, issued: of the
    :class:`Sampler`, for a whole trial.
    Written down: seen_error, seen_rate (., ports) as a controller has them at the coming sample; y (., ports) the tracking
    error itself; square, effort (., ports) the means of y^2 and command^2 over the window; energy; crossed: 1 where a port left
    its constraint, 2 where the motion stopped being finite.
    """

    todo: Array
    row: Array
    at: Array
    command: Array
    modal: Any
    ports: Any
    stages: Any
    e_hat: Array
    v_hat: Array
    state: Array
    begun: Array
    noise: Array
    error: Array
    rate: Array
    issued: Array
    seen_error: Array
    seen_rate: Array
    y: Array
    square: Array
    effort: Array
    energy: Array
    crossed: Array


class Bank(NamedTuple):
    """What trials bring, as in :class:`Inputs`, a row for each that is going on: (., steps, ...); `along` (., steps + 1, ports)
    and `reference` (., samples + 1, ports): what the ports are to follow, at every time and at the samples."""

    disturbance: Array
    load: Array
    drift: Array
    low: Array
    high: Array
    along: Array
    reference: Array


class Gear(NamedTuple):
    """What all runs have in common of a :class:`Sampler`; `idle` (period, ports) and `blank` (1, ports) are zeros."""

    period: int
    delay: int
    ahead: int
    seconds: float
    quantum: Array
    gain_1: Array
    gain_2: Array
    ceiling: Array
    idle: Array
    blank: Array


class Bay(NamedTuple):
    """What one thread works with: the step, the record that a window leaves, for a look (ports,), (ports,), (1,), (1, ports)."""

    step: Step
    record: tuple[Array, ...]
    e_hat: Array
    v_hat: Array
    begun: Array
    rate: Array


def run_windows(fleet, bank, gear, bay, first, last):
    """Let the runs first .. last - 1 do what they are to do."""
    for i in range(first, last):
        if fleet.todo[i] == MOVE:
            move_on(i, fleet, bank, gear, bay)
        if fleet.todo[i] != REST:
            look(i, fleet, bank, gear, bay)


def move_on(i, fleet, bank, gear, bay):
    """Take run i through a window, its command held, and write down how it fared."""
    s, row, period = fleet.at[i], fleet.row[i], gear.period
    begin, end = s * period, (s + 1) * period
    inputs = Inputs(
        gear.idle, gear.idle, bank.disturbance[row, begin:end], bank.load[row, begin:end], bank.drift[row, begin:end],
        bank.low[row, begin:end], bank.high[row, begin:end], bank.along[row, begin],
    )  # fmt: skip
    sampler = Sampler(
        period, gear.delay, gear.ahead, gear.seconds, fleet.noise[i, s : s + 2], bank.reference[row, s : s + 2],
        gear.blank, gear.blank, gear.blank, gear.blank, gear.quantum, gear.gain_1, gear.gain_2, gear.ceiling,
        fleet.command[i], fleet.e_hat[i], fleet.v_hat[i], fleet.state[i], fleet.begun[i],
        fleet.error[i, s : s + 2], fleet.rate[i, s : s + 1], fleet.issued[i, s : s + gear.ahead + 1],
    )  # fmt: skip
    record = bay.record
    done = run_trial(fleet.modal[i : i + 1], bay.step, inputs, sampler, fleet.ports[i], fleet.stages[i], period + 1, record)
    fleet.at[i] = s + 1
    crossed = 0
    for p in range(PORTS):
        square, effort = 0.0, 0.0
        for k in range(period):
            y = record.y[k + 1, p]
            square += y * y
            effort += record.command[k, p] * record.command[k, p]
            if not (inputs.low[k, p] < y and y < inputs.high[k, p]):
                crossed = 1
        fleet.square[i, p], fleet.effort[i, p] = square / period, effort / period
    fleet.crossed[i] = crossed if done == period else 2


def look(i, fleet, bank, gear, bay):
    """What the controller of run i will know at the coming sample; its own estimates are left for the sample itself."""
    s, row, ports, m = fleet.at[i], fleet.row[i], fleet.ports[i], fleet.modal[i]
    energy = 0.0
    for n in range(m.count):
        energy += m.rate[n] * m.rate[n] + m.omega2[n] * m.q[n] * m.q[n]
    fleet.energy[i] = 0.5 * energy
    for p in range(PORTS):
        y = 0.0
        for n in range(m.count):
            y += bay.step.b[p, n] * m.q[n]
        ports[p].y = y - bank.along[row, s * gear.period, p]
        fleet.y[i, p] = ports[p].y
        bay.e_hat[p], bay.v_hat[p] = fleet.e_hat[i, p], fleet.v_hat[i, p]
    bay.begun[0] = fleet.begun[i, 0]
    sampler = Sampler(
        gear.period, gear.delay, gear.ahead, gear.seconds, fleet.noise[i, s : s + 1], bank.reference[row, s : s + 1],
        gear.blank, gear.blank, gear.blank, gear.blank, gear.quantum, gear.gain_1, gear.gain_2, gear.ceiling,
        fleet.command[i], bay.e_hat, bay.v_hat, fleet.state[i], bay.begun, fleet.error[i, s : s + 1], bay.rate, bay.rate,
    )  # fmt: skip
    measure(0, ports, sampler)
    for p in range(PORTS):
        fleet.seen_error[i, p], fleet.seen_rate[i, p] = bay.e_hat[p], bay.v_hat[p]
