"""The law at a bench: it reads samples, computes, and holds its command; scalar functions for the kernel.

At sample s, `period` steps after the one before, the displacement of every port is read through noise and quantiser. A
second-order estimator follows the tracking error and its rate,

    r = e - (e_hat + T v_hat),    e_hat <- e_hat + T v_hat + l1 r,    v_hat <- v_hat + l2 r / T

(l1 = 1 is the filtered difference quotient, l1 < 1 an observer), the law computes its commands from what is known then, and
`delay` steps later they reach the actuators, where they are held until the next ones come.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from dampen.simulation.ports import PORTS

Array = np.ndarray


class Sampler(NamedTuple):
    """All that the digital controller has. period, delay: in steps; with period 0 the law acts continuously.

    Given for a trial: noise, reference (samples + 1, ports), feedforward, coulomb, low, high (samples, ports); for a run:
    quantum, gain_1, gain_2, ceiling (ports,), the sample period T [s], the law's parameters. Kept from sample to sample:
    e_hat, v_hat (ports,), the law's state, `begun` (1,). Written down: error (samples + 1, ports), rate (samples, ports),
    issued (ahead + samples, ports), the first `ahead` >= 1 rows from the trial before.
    """

    period: int
    delay: int
    ahead: int
    seconds: float
    noise: Array
    reference: Array
    feedforward: Array
    coulomb: Array
    low: Array
    high: Array
    quantum: Array
    gain_1: Array
    gain_2: Array
    ceiling: Array
    parameters: Array
    e_hat: Array
    v_hat: Array
    state: Array
    begun: Array
    error: Array
    rate: Array
    issued: Array


class Sample(NamedTuple):
    """What a sampled law is given, (ports,) each: tracking error and its rate as estimated, the reference, and from the
    controller's memory feedforward and coulomb; the limits of the error; the commands of the sample before."""

    error: Array
    rate: Array
    reference: Array
    feedforward: Array
    coulomb: Array
    low: Array
    high: Array
    before: Array


def sampled_law(sample, state, parameters, command):
    """Write the commands (ports,) that follow from a sample; bound to the scenario's own law before use."""
    raise NotImplementedError


def sample(k, ports, sampler):
    """At a sample instant, measure and compute; in every step, hand the commands that are due to the ports."""
    period = sampler.period
    s = k // period
    if k == s * period:
        measure(s, ports, sampler)
        row = sampler.ahead + s
        known = Sample(
            sampler.e_hat, sampler.v_hat, sampler.reference[s], sampler.feedforward[s], sampler.coulomb[s], sampler.low[s],
            sampler.high[s], sampler.issued[row - 1],
        )  # fmt: skip
        sampled_law(known, sampler.state, sampler.parameters, sampler.issued[row])
        for p in range(PORTS):
            sampler.rate[s, p] = sampler.v_hat[p]
            sampler.issued[row, p] = limited(sampler.issued[row, p], sampler.ceiling[p])
    due = sampler.ahead + (k - sampler.delay) // period
    for p in range(PORTS):
        ports[p].feedforward = sampler.issued[due, p]


def measure(s, ports, sampler):
    """Read all ports at sample s and bring the estimates up to date."""
    for p in range(PORTS):
        reading = ports[p].y + sampler.reference[s, p] + sampler.noise[s, p]
        if sampler.quantum[p] > 0.0:
            reading = sampler.quantum[p] * math.floor(reading / sampler.quantum[p] + 0.5)
        error = reading - sampler.reference[s, p]
        sampler.error[s, p] = error
        if sampler.begun[0] == 0.0:
            sampler.e_hat[p] = error
        elif s < len(sampler.rate):
            follow(p, error, sampler.seconds, sampler.gain_1[p], sampler.gain_2[p], sampler.e_hat, sampler.v_hat)
    sampler.begun[0] = 1.0


def follow(p, error, seconds, gain_1, gain_2, e_hat, v_hat):
    """Bring the estimates of one port up to date with its tracking error."""
    expected = e_hat[p] + seconds * v_hat[p]
    surprise = error - expected
    e_hat[p] = expected + gain_1 * surprise
    v_hat[p] += gain_2 * surprise / seconds


def limited(command, ceiling):
    """A command, at most as large as its limit."""
    return min(max(command, -ceiling), ceiling)
