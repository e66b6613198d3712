"""The time axis: one trial, step by step, as free motion -> port closure -> apply. Plain Python, compiled before use.

Everything arrives as arrays: modes are (modes,), per-step inputs (steps, ports) or (steps, modes), and what belongs to one
port or one stage is a record with named fields.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from dampen.simulation.barrier import EDGE, log_ratio, log_ratio_at
from dampen.simulation.closure import RELAXATION
from dampen.simulation.ports import close_ports, velocity

Array = np.ndarray

STAGE_PARAMETERS = 32
STAGE_STATES = 16

PORT = np.dtype(
    [
        # the chain of stages between law and force: stages first .. last - 1, their slope in full motion, the compliance
        ("first", int), ("last", int), ("gain", float), ("soft", float),
        # the law: constant in a trial, then held over the step
        ("damping", float), ("barrier", float), ("limit", float), ("feedforward", float), ("coulomb", float),
        # the port as the step begins
        ("y", float), ("log_y", float), ("v_free", float), ("slow", float),
        # what the closure finds, and its working values
        ("force", float), ("command", float), ("v_law", float), ("slope", float), ("middle", float), ("held", float), ("guess", float), ("v_others", float),
    ]
)  # fmt: skip
STAGE = np.dtype(
    [("code", int), ("states", int), ("parameters", float, STAGE_PARAMETERS), ("state", float, STAGE_STATES), ("new_state", float, STAGE_STATES)]
)


class Step(NamedTuple):
    """The exact solution of every mode over one step dt under a held modal force a,

        q+ = c11 q + c12 q' + psi a        q'+ = c21 q + c22 q' + c12 a

    and what the ports see of it, their mean velocity v = v_q q + v_rate q' + G F under port forces F. `b`, `v_q`, `v_rate` are
    (ports, modes), `g` is (ports, ports), `coupling` a scratch copy of it; `a`, `q_new`, `rate_new` are scratch (modes,),
    `zero` is (modes,) zeros.
    """

    dt: float
    c11: Array
    c12: Array
    c21: Array
    c22: Array
    psi: Array
    omega2: Array
    b: Array
    v_q: Array
    v_rate: Array
    g: Array
    coupling: Array
    a: Array
    zero: Array
    q_new: Array
    rate_new: Array


class Inputs(NamedTuple):
    """What one trial is given, held over each step: feedforward, coulomb and disturbance at the ports (steps, ports), the
    modal load (steps, modes), and the mean velocity that disturbance and load give the ports in a step (steps, ports)."""

    feedforward: Array
    coulomb: Array
    disturbance: Array
    load: Array
    drift: Array


class Record(NamedTuple):
    """What a trial leaves: y, slow (steps + 1, ports) and energy (steps + 1,) on times; v, command, delivered (steps, ports)
    and work_load (steps,) on steps; q at every `every`-th time, (times, modes)."""

    y: Array
    slow: Array
    energy: Array
    v: Array
    command: Array
    delivered: Array
    work_load: Array
    q: Array


def run_trial(step, inputs, ports, stages, q, rate, every, record):
    """Run one trial in place; `q`, `rate`, `ports` and `stages` carry the state from trial to trial.

    Returns the number of steps done: fewer than there are where the motion stops being finite.
    """
    steps, n = inputs.disturbance.shape
    dt, a, q_new, rate_new = step.dt, step.a, step.q_new, step.rate_new
    for p in range(n):
        ports[p].y = dot(step.b[p], q, step.b[p], step.zero)
        record.y[0, p] = ports[p].y
        record.slow[0, p] = ports[p].slow
        if abs(ports[p].y) < EDGE * ports[p].limit:
            ports[p].log_y = log_ratio(ports[p].y, ports[p].limit)
    record.energy[0] = energy_of(q, rate, step.omega2)
    copy(q, record.q[0])
    for k in range(steps):
        # free motion: where the ports go under all that is known as the step begins
        for p in range(n):
            port = ports[p]
            port.v_free = dot(step.v_q[p], q, step.v_rate[p], rate) + inputs.drift[k, p]
            port.feedforward = inputs.feedforward[k, p]
            port.coulomb = inputs.coulomb[k, p]

        close_ports(ports, stages, step.g, step.coupling, dt)

        # apply
        scaled_sum(inputs.load[k], ports[0].force + inputs.disturbance[k, 0], step.b[0], a)
        for p in range(1, n):
            scaled_sum(a, ports[p].force + inputs.disturbance[k, p], step.b[p], a)
        work, potential = move(step, inputs.load[k], q, rate, a, q_new)
        kinetic = speed_up(step, q, rate, a, rate_new)
        q, q_new, rate, rate_new = q_new, q, rate_new, rate
        record.work_load[k] = work
        record.energy[k + 1] = kinetic + potential
        for p in range(n):
            port = ports[p]
            y_new = port.y + dt * velocity(p, ports, step.g)
            if port.barrier > 0.0:
                port.log_y = log_ratio_at(y_new, port.y, port.log_y, port.limit)
            port.y = y_new
            port.slow += RELAXATION * (port.force - port.slow)
            record.y[k + 1, p] = port.y
            record.slow[k + 1, p] = port.slow
            record.v[k, p] = port.v_law
            record.command[k, p] = port.command
            record.delivered[k, p] = port.force
        for s in range(len(stages)):
            for i in range(stages[s].states):
                stages[s].state[i] = stages[s].new_state[i]
        if (k + 1) % every == 0:
            copy(q, record.q[(k + 1) // every])
        if not record.energy[k + 1] < np.inf:
            return k
    if steps % 2:
        copy(q, q_new)
        copy(rate, rate_new)
    return steps


def move(step, load, q, rate, a, q_new):
    """q_new; returns the work of the load, sum(load (q_new - q)), and the potential energy, sum(omega^2 q_new^2) / 2."""
    c11, c12, psi, omega2 = step.c11, step.c12, step.psi, step.omega2
    work, potential = 0.0, 0.0
    for i in range(len(q)):
        x = c11[i] * q[i] + c12[i] * rate[i] + psi[i] * a[i]
        work += load[i] * (x - q[i])
        potential += omega2[i] * x * x
        q_new[i] = x
    return work, 0.5 * potential


def speed_up(step, q, rate, a, rate_new):
    """rate_new; returns the kinetic energy, sum(rate_new^2) / 2."""
    c21, c22, c12 = step.c21, step.c22, step.c12
    kinetic = 0.0
    for i in range(len(q)):
        x = c21[i] * q[i] + c22[i] * rate[i] + c12[i] * a[i]
        kinetic += x * x
        rate_new[i] = x
    return 0.5 * kinetic


def energy_of(q, rate, omega2):
    """Kinetic and potential energy, sum(q'^2 + omega^2 q^2) / 2."""
    total = 0.0
    for i in range(len(q)):
        total += rate[i] * rate[i] + omega2[i] * q[i] * q[i]
    return 0.5 * total


def scaled_sum(a, factor, b, out):
    """out = a + factor b."""
    for i in range(len(a)):
        out[i] = a[i] + factor * b[i]


def copy(a, out):
    """out = a."""
    for i in range(len(a)):
        out[i] = a[i]


def dot(a, b, c, d):
    """sum(a b + c d)."""
    total = 0.0
    for i in range(len(a)):
        total += a[i] * b[i] + c[i] * d[i]
    return total
