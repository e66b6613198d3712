"""Many members of a batch through one trial, in one compiled call. Plain Python, compiled before use, around `run_trial`.

A member is a parameter set of its own: gains, actuators, constraint, plant. Every array's leading axis is the members', or 1
where all share it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from dampen.simulation.kernel import Inputs, Step, run_trial
from dampen.simulation.ports import PORTS
from dampen.simulation.tally import tally

Array = np.ndarray
LEARNS = False  # bound before use: whether the law learns from trial to trial, by `relearn`


class Members(NamedTuple):
    """What belongs to the members from trial to trial.

    coefficients (., COEFFICIENTS, modes): rows of the modal record.   b (., ports, modes), g (., ports, ports): of the
    step.   q, rate (., modes).   ports, stages: records, a row a member.   feedforward, coulomb (., steps, ports): the law
    without what is learned, which is in learned_feedforward and learned_coulomb.   row (., ports, numbers): for `relearn`.
    before (., ports): last commands.   alive (.,): 0 once a motion has stopped being finite.
    """

    coefficients: Array
    b: Array
    g: Array
    q: Array
    rate: Array
    ports: Array
    stages: Array
    feedforward: Array
    coulomb: Array
    learned_feedforward: Array
    learned_coulomb: Array
    row: Array
    before: Array
    alive: Array


class Given(NamedTuple):
    """What a trial brings, as in :class:`Inputs`; low and high (., steps + 1, ports)."""

    disturbance: Array
    load: Array
    drift: Array
    low: Array
    high: Array
    origin: Array


class Desk(NamedTuple):
    """What one thread works with, for one member after the other: the modal record, the step, the record that a trial leaves,
    and feedforward and coulomb (steps, ports)."""

    modal: Array
    step: Step
    record: tuple[Array, ...]
    feedforward: Array
    coulomb: Array


def relearn(feedforward, coulomb, error, v, command, row):
    """What is learned at one step and port; bound to the controller's own function before use."""
    return feedforward, coulomb


def run_members(members, given, desk, sampler, every, by_port, whole):
    """Run all members through one trial and write down their figures; see `tally`."""
    steps = len(desk.feedforward)
    for i in range(len(members.alive)):
        if members.alive[i] == 0.0:
            continue
        take(i, members, desk)
        record, low, high = desk.record, given.low[row_of(given.low, i)], given.high[row_of(given.high, i)]
        shaken = row_of(given.load, i)
        inputs = Inputs(
            desk.feedforward, desk.coulomb, given.disturbance[shaken], given.load[shaken], given.drift[row_of(given.drift, i)],
            low[1:], high[1:], given.origin[row_of(given.origin, i)],
        )  # fmt: skip
        done = run_trial(desk.modal, desk.step, inputs, sampler, members.ports[i], members.stages[i], every, record)
        tally(record, low, high, done, members.before[i], by_port[i], whole[i])
        if done < steps:
            members.alive[i] = 0.0
        m = desk.modal[0]
        for k in range(m.count):
            members.q[i, k], members.rate[i, k] = m.q[k], m.rate[k]
        if LEARNS:
            learn(i, members, record)


def row_of(array, i):
    """Where member i finds its part of an array: its own row, or the one that all share."""
    return min(i, len(array) - 1)


def take(i, members, desk):
    """Put a member on the desk."""
    m, step, shared = desk.modal[0], desk.step, row_of(members.coefficients, i)
    c = members.coefficients[shared]
    for k in range(m.count):
        m.q[k], m.rate[k] = members.q[i, k], members.rate[i, k]
        m.c11[k], m.c12[k], m.c22[k], m.psi[k], m.omega2[k] = c[0, k], c[1, k], c[2, k], c[3, k], c[4, k]
        m.b0[k], m.b1[k] = c[5, k], c[6, k]
        m.loss_qq[k], m.loss_qr[k], m.loss_rr[k] = c[7, k], c[8, k], c[9, k]
        m.loss_qa[k], m.loss_ra[k], m.loss_aa[k] = c[10, k], c[11, k], c[12, k]
    copy(step.b, members.b[shared])
    copy(step.g, members.g[shared])
    learner = row_of(members.learned_coulomb, i)
    put(desk.feedforward, members.feedforward[i], members.learned_feedforward[learner])
    put(desk.coulomb, members.coulomb[i], members.learned_coulomb[learner])


def copy(target, source):
    """Write `source` into `target`, element by element."""
    for r in range(source.shape[0]):
        for c in range(source.shape[1]):
            target[r, c] = source[r, c]


def put(target, fixed, learned):
    """Write the sum of what is fixed and what is learned."""
    for k in range(len(target)):
        for p in range(PORTS):
            target[k, p] = fixed[k, p] + learned[k, p] if LEARNS else fixed[k, p]


def learn(i, members, record):
    """Let a member learn from the trial that it has just been through."""
    feedforward, coulomb = members.learned_feedforward[i], members.learned_coulomb[i]
    for p in range(PORTS):
        row = members.row[i, p]
        for k in range(len(feedforward)):
            feedforward[k, p], coulomb[k, p] = relearn(
                feedforward[k, p], coulomb[k, p], record.y[k + 1, p], record.v[k, p], record.command[k, p], row
            )
