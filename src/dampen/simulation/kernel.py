"""The time axis: one trial, step by step, as free motion -> port closure -> apply. Plain Python, compiled before use.

Everything arrives as arrays: modes are (modes,), per-step inputs (steps, ports) or (steps, modes), and what belongs to one
port or one stage is a record with named fields.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from dampen.simulation.barrier import barrier_memo, fresh_memo
from dampen.simulation.closure import RELAXATION
from dampen.simulation.compiled import reassociated, standalone
from dampen.simulation.digital import measure, sample
from dampen.simulation.ports import PORTS, close_ports, velocity

Array = np.ndarray

STAGE_PARAMETERS = 32
STAGE_STATES = 16
MODES_AT_MOST = 1000
ABSURD = 1e30  # J: beyond it a motion has diverged, whatever is being moved
DAMPED = False  # bound before use: whether any mode is damped
SAMPLED = False  # and whether a law may act through samples
_ROW = (float, MODES_AT_MOST + 32)

PORT = np.dtype(
    [
        # the chain of stages between law and force: stages first .. last - 1, their slope in full motion and within a step
        ("first", int), ("last", int), ("gain", float), ("feedthrough", float), ("per_feedthrough", float),
        # the port's numerical compliance
        ("soft", float),
        # the law: constant in a trial, then held over the step
        ("damping", float), ("stiffness", float), ("barrier", float), ("feedforward", float), ("coulomb", float),
        ("low", float), ("high", float),
        # the port as the step begins: its tracking error y, low < y < high
        ("y", float), ("memo", float), ("v_free", float), ("slow", float),
        # what the closure finds, and its working values
        ("force", float), ("command", float), ("v_law", float), ("per_slope", float), ("give", float), ("answer", float),
        ("middle", float), ("v_middle", float), ("held", float),
        ("guess", float), ("v_others", float),
    ]
)  # fmt: skip
STAGE = np.dtype(
    [
        ("code", int),
        ("states", int),
        ("parameters", float, STAGE_PARAMETERS),
        ("state", float, STAGE_STATES),
        ("new_state", float, STAGE_STATES),
    ]
)


# All modes in one record of fixed size: the compiler then knows that its rows do not overlap, and the loop over modes runs in
# vector instructions without a check. Rows are an odd number of cache lines long, so that they do not compete for one place
# in the cache. q+ = c11 q + c12 q' + psi a and q'+ = c22 q' + c12 (a - omega2 q) is the exact solution over one step of length
# dt under a held modal force a (c22 = c11 without damping). b0, b1: port vectors of the first two ports, zero where there is no
# such port. The losses make the energy that damping takes in a step, a quadratic form in q, q' and a. Without a force a mode
# would go by `free` = q+ - q = c12 q' - psi omega2 q: a port's mean velocity in the step is their sum, weighted with b, over dt.
_LOSSES = ("loss_qq", "loss_qr", "loss_rr", "loss_qa", "loss_ra", "loss_aa")
COEFFICIENTS = ("c11", "c12", "c22", "psi", "omega2", "b0", "b1", *_LOSSES)
MODAL = np.dtype(
    [*((row, *_ROW) for row in ("q", "rate", "a", "free", *COEFFICIENTS)), ("count", int), ("free0", float), ("free1", float)]
)


class Step(NamedTuple):
    """What the ports see of a step of length dt: their mean velocity is v_free + G F under port forces F.

    `b` (ports, modes): port vectors, `g` (ports, ports), `coupling` a scratch copy of it.
    """

    dt: float
    per_dt: float
    b: Array
    g: Array
    coupling: Array


class Inputs(NamedTuple):
    """What one trial is given, held over each step: feedforward, coulomb and disturbance at the ports (steps, ports), the
    modal load (steps, modes or more), the velocity that disturbance and load give the ports in a step, less that of the reference
    (steps, ports), and the limits of the tracking error (steps, ports). `origin` (ports,) is the reference at time 0."""

    feedforward: Array
    coulomb: Array
    disturbance: Array
    load: Array
    drift: Array
    low: Array
    high: Array
    origin: Array


class Record(NamedTuple):
    """What a trial leaves. On times, (steps + 1, ...): the tracking error y, slow (ports) and energy; on steps: v, command,
    delivered (ports), work_load and dissipated; q at every `every`-th time, (times, modes); the number of steps whose closure
    did not settle, (1,)."""

    y: Array
    slow: Array
    energy: Array
    v: Array
    command: Array
    delivered: Array
    work_load: Array
    dissipated: Array
    q: Array
    unsettled: Array


@standalone
def run_trial(modal, step, inputs, sampler, ports, stages, every, record):
    """Run one trial in place; `modal`, `ports` and `stages`, arrays of records, carry the state from trial to trial.

    Returns the number of steps done: fewer than there are where the motion stops being finite.
    """
    m, dt = modal[0], step.dt
    record.unsettled[0] = 0.0
    steps = len(inputs.disturbance)
    start(m, step, inputs, ports, record)
    snapshot, wait = 0, every
    for k in range(steps):
        if SAMPLED and sampler.period > 0:
            sample(k, ports, sampler)
        else:
            act(k, inputs, ports)
        free_motion(k, m, step, inputs, ports)
        if not close_ports(ports, stages, step.g, step.coupling, dt):
            record.unsettled[0] += 1
        record.work_load[k], record.energy[k + 1], record.dissipated[k] = apply(k, m, step, inputs, ports)
        for p in range(PORTS):
            end_step(k, p, ports, stages, step, record)
        wait -= 1
        if wait == 0:
            snapshot, wait = snapshot + 1, every
            for i in range(m.count):
                record.q[snapshot, i] = m.q[i]
        if not record.energy[k + 1] < ABSURD:
            return k
    if SAMPLED and sampler.period > 0:
        measure(len(sampler.error) - 1, ports, sampler)
    return steps


def start(m, step, inputs, ports, record):
    """Where a trial begins: ports, energy and first snapshot."""
    total = 0.0
    for i in range(m.count):
        total += m.rate[i] * m.rate[i] + m.omega2[i] * m.q[i] * m.q[i]
        record.q[0, i] = m.q[i]
    record.energy[0] = 0.5 * total
    begin_freely(m)
    for p in range(PORTS):
        port = ports[p]
        port.y = 0.0
        for i in range(m.count):
            port.y += step.b[p, i] * m.q[i]
        port.y -= inputs.origin[p]
        port.low, port.high = inputs.low[0, p], inputs.high[0, p]
        port.memo = fresh_memo(port.y, port.low, port.high)
        record.y[0, p], record.slow[0, p] = port.y, port.slow


def act(k, inputs, ports):
    """What a continuous law has for the step."""
    for p in range(PORTS):
        ports[p].feedforward = inputs.feedforward[k, p]
        ports[p].coulomb = inputs.coulomb[k, p]


def free_motion(k, m, step, inputs, ports):
    """How fast the ports go under all that is known as the step begins, and how far they may."""
    for p in range(PORTS):
        port = ports[p]
        free = m.free0 if p == 0 else m.free1 if p == 1 else weighted(m, step.b[p])
        port.v_free = free * step.per_dt + inputs.drift[k, p]
        if inputs.low[k, p] != port.low or inputs.high[k, p] != port.high:
            port.low, port.high = inputs.low[k, p], inputs.high[k, p]
            port.memo = fresh_memo(port.y, port.low, port.high)


@reassociated
def weighted(m, row):
    """How far a port beyond the second would go without forces."""
    n, far = m.count, 0.0
    for i in range(n):
        far += row[i] * m.free[i]
    return far


@reassociated
def begin_freely(m):
    """How far modes and ports would go in the first step without forces."""
    n, far0, far1 = m.count, 0.0, 0.0
    for i in range(n):
        free = m.c12[i] * m.rate[i] - m.psi[i] * (m.omega2[i] * m.q[i])
        m.free[i] = free
        far0 += m.b0[i] * free
        far1 += m.b1[i] * free
    m.free0, m.free1 = far0, far1


def apply(k, m, step, inputs, ports):
    """Move all modes under the load and the port forces. Returns the work of the load, the energy reached and what was lost."""
    first = ports[0].force + inputs.disturbance[k, 0]
    second = ports[1].force + inputs.disturbance[k, 1] if PORTS > 1 else 0.0
    load, modes = inputs.load[k], m.count
    if PORTS > 2:
        for i in range(modes):
            m.a[i] = 0.0
        for p in range(2, PORTS):
            force = ports[p].force + inputs.disturbance[k, p]
            for i in range(modes):
                m.a[i] += force * step.b[p, i]
    return move(m, load, first, second)


@reassociated
def move(m, load, first, second):
    """The loop over modes, which also finds how far they would go in the next step without forces; `a` holds the modal forces of
    all ports beyond the second."""
    work, energy, lost, far0, far1 = 0.0, 0.0, 0.0, 0.0, 0.0
    n = m.count
    for i in range(n):
        b0, b1 = m.b0[i], m.b1[i]
        a = load[i] + first * b0 + second * b1
        if PORTS > 2:
            a += m.a[i]
        q, rate, c11, c12, psi, omega2 = m.q[i], m.rate[i], m.c11[i], m.c12[i], m.psi[i], m.omega2[i]
        q_new = c11 * q + c12 * rate + psi * a
        rate_new = (m.c22[i] if DAMPED else c11) * rate + c12 * (a - omega2 * q)
        work += load[i] * (q_new - q)
        if DAMPED:
            lost += (m.loss_qq[i] * q + m.loss_qr[i] * rate + m.loss_qa[i] * a) * q
            lost += (m.loss_rr[i] * rate + m.loss_ra[i] * a) * rate + m.loss_aa[i] * a * a
        pull = omega2 * q_new
        energy += pull * q_new + rate_new * rate_new
        free = c12 * rate_new - psi * pull
        if PORTS > 2:
            m.free[i] = free
        far0 += b0 * free
        far1 += b1 * free
        m.q[i] = q_new
        m.rate[i] = rate_new
    m.free0, m.free1 = far0, far1
    return work, 0.5 * energy, lost


def end_step(k, p, ports, stages, step, record):
    """Move port p to where the forces took it, accept the next states of its stages, and write the step down."""
    port = ports[p]
    y_new = port.y + step.dt * velocity(p, ports, step.g)
    if port.barrier > 0.0:
        port.memo = barrier_memo(y_new, port.y, port.memo, port.low, port.high)
    port.y = y_new
    port.slow += RELAXATION * (port.force - port.slow)
    record.y[k + 1, p], record.slow[k + 1, p] = port.y, port.slow
    record.v[k, p], record.command[k, p], record.delivered[k, p] = port.v_law, port.command, port.force
    for s in range(port.first, port.last):
        for i in range(stages[s].states):
            stages[s].state[i] = stages[s].new_state[i]
