"""Slow, plain reference for one trial under a digital controller, written from the definition of its clock.

Readings are taken at sample instants, a command acts from `delay` steps after its sample until the next one arrives. Numpy
and scipy only, no code shared with the package.
"""

from dataclasses import dataclass, field

import numpy as np
from scipy.linalg import expm

from tests.oracle import RELAXATION, Structure, Trial, potential


@dataclass
class Sampled(Trial):
    """What a trial leaves, with what the controller read, estimated and commanded, one row a sample."""

    reading: np.ndarray
    rate_estimate: np.ndarray
    issued: np.ndarray


@dataclass
class Digital:
    """The controller's equipment. period, delay: steps; l_1, l_2: gains of the estimator

        r = e - (e_hat + T v_hat),    e_hat <- e_hat + T v_hat + l_1 r,    v_hat <- v_hat + l_2 r / T,

    which starts at the first reading and at rest. It keeps what it knows, and the commands that are still to come, from trial
    to trial.
    """

    period: int
    delay: int
    seconds: float
    l_1: float
    l_2: float
    quantum: np.ndarray
    ceiling: np.ndarray
    error: np.ndarray | None = None
    rate: np.ndarray | None = None
    clock: int = 0
    to_come: dict = field(default_factory=dict)

    def read(self, y, noise):
        """The reading of a displacement."""
        z = y + noise
        return np.where(self.quantum > 0, self.quantum * np.floor(z / np.where(self.quantum > 0, self.quantum, 1) + 0.5), z)

    def estimate(self, error):
        """Take in a reading."""
        if self.error is None:
            self.error, self.rate = error, np.zeros(len(error))
            return
        expected = self.error + self.seconds * self.rate
        surprise = error - expected
        self.error, self.rate = expected + self.l_1 * surprise, self.rate + self.l_2 * surprise / self.seconds


def simulate(omega, b, decay, q, rate, dt, digital, law, noise, reference, disturbance, load, deliver, states, command):
    """One trial; command: the one that acts as it begins. law(s, e, v, r) -> commands of sample s."""
    structure = Structure(omega, decay, b, dt)
    b, n, steps, states = structure.b, structure.n, len(load), list(states)
    state = np.concatenate([q, dt * np.asarray(rate, float)])
    grid, step, work, lost = [state.copy()], [], [], []
    readings, rates, issued = [], [], []
    for k in range(steps):
        y = b @ state[:n]
        if k % digital.period == 0:
            s = k // digital.period
            readings.append(digital.read(y, noise[s]))
            digital.estimate(readings[-1] - reference[k])
            wanted = law(s, digital.error, digital.rate, reference[k])
            issued.append(np.clip(wanted, -digital.ceiling, digital.ceiling))
            rates.append(digital.rate)
            digital.to_come[digital.clock + digital.delay] = issued[-1]
        command = digital.to_come.pop(digital.clock, command)
        digital.clock += 1
        moves = [f(u, s) for f, u, s in zip(deliver, command, states, strict=True)]
        force, states = np.array([m[0] for m in moves]), [m[1] for m in moves]
        push = load[k] + b.T @ (force + disturbance[k])
        moved = structure.grow @ structure.change(state, push)
        lost.append(structure.lost(state, push))
        state = state + moved
        grid.append(state.copy())
        step.append(((b @ moved[:n] - (reference[k + 1] - reference[k])) / dt, command, force))
        work.append(load[k] @ moved[:n])
    grid = np.array(grid)
    v, commands, delivered = np.array(step).transpose(1, 0, 2)
    return Sampled(
        grid[:, :n] @ b.T, v, commands, delivered, structure.energy(grid), np.array(work), np.array(lost), state[:n],
        state[n:] / dt, states, np.zeros(len(b)), np.array(readings), np.array(rates), np.array(issued),
    )  # fmt: skip


def difference_gains(period, filter_time):
    """Difference quotient behind a first-order filter, discretised exactly: l_1 = 1, l_2 = 1 - e^(-T / filter_time)."""
    return 1.0, 1.0 - np.exp(-period / filter_time) if filter_time else 1.0


def observer_gains(period, bandwidth):
    """l_1, l_2 for which the observer's error, e~ <- (1 - l_1)(e~ + T v~), v~ <- v~ - l_2 (e~/T + v~), has a double pole."""
    pole = np.exp(-2 * np.pi * bandwidth * period)
    # characteristic polynomial z^2 - (2 - l_1 - l_2) z + (1 - l_1), which must be (z - pole)^2
    l_1 = 1 - pole * pole
    return l_1, 2 - 2 * pole - l_1


def slope_of_barrier(e, low, high, edge, shape):
    """V'(e), with e taken back to `edge` of the limits."""
    inside = np.clip(e, edge * low, edge * high)
    c = high if inside >= 0 else -low
    return float(potential(np.longdouble(inside), np.longdouble(c), shape)[1])


class PortLaws:
    """u = feedforward - damping v - coulomb Sgn(v) - stiffness e - barrier V'(e), port by port, with one kind of Sgn."""

    def __init__(self, switching, damping, stiffness, barrier, edge, layer, compliance, shape, late=0.0, ceiling=np.inf):
        self.switching, self.shape, self.edge, self.layer = switching, shape, edge, layer
        self.damping, self.stiffness, self.barrier, self.compliance = damping, stiffness, barrier, compliance
        self.slow, self.before = np.zeros(len(damping)), np.zeros(len(damping))
        self.late, self.ceiling = late, ceiling  # delay in sample periods

    def __call__(self, e, v, feedforward, coulomb, low, high):
        u = np.zeros(len(e))
        for p in range(len(e)):
            smooth = feedforward[p] - self.stiffness[p] * e[p]
            if self.barrier[p] > 0:
                smooth -= self.barrier[p] * slope_of_barrier(e[p], low[p], high[p], self.edge, self.shape)
            if self.switching == "implicit":
                # what the last command will still bring about while it is under way: 2/3 of the compliance for a period
                under_way = 2 / 3 * self.compliance[p] * self.late * (self.before[p] - self.slow[p])
                u[p] = self.implicit(p, smooth, v[p] + under_way, coulomb[p])
            else:
                sign = np.sign(v[p]) if self.switching == "explicit" else np.clip(v[p] / self.layer, -1, 1)
                u[p] = smooth - self.damping[p] * v[p] - coulomb[p] * sign
        self.before = np.clip(u, -self.ceiling, self.ceiling)
        return u

    def implicit(self, p, smooth, v, coulomb):
        """The one u in smooth - damping v+ - coulomb Sgn(v+), v+ = v + compliance (u - slow): where v+ < 0, > 0, or = 0."""
        found = [self.slow[p] - v / self.compliance[p]]
        for sign in (-1, 1):
            # v+ solves v+ = v + compliance (smooth - damping v+ - sign coulomb - slow)
            there = v + self.compliance[p] * (smooth - sign * coulomb - self.slow[p])
            there /= 1 + self.compliance[p] * self.damping[p]
            if sign * there > 0:
                found.append(smooth - self.damping[p] * there - sign * coulomb)
        self.slow[p] += RELAXATION * (found[-1] - self.slow[p])
        return found[-1]


class Regulator:
    """LQG from its definition: matrices by matrix exponentials and a walk through the delay, gains by Riccati iteration.

    x holds q, q' and the commands under way, oldest first. u = u_rest(r) - hold (x - x_rest(r)): the model's equilibrium.
    """

    def __init__(self, omega, decay, b, gains, seconds, delay, energy, error, effort, force_noise, sensor_noise):
        n, ports = len(omega), len(b)
        late = int(np.ceil(delay / seconds - 1e-9))
        size, pushed = 2 * n + late * ports, gains[:, None] * b  # what a unit of command does
        self.c = np.hstack([b, np.zeros((ports, size - n))])
        rest = np.zeros((size, ports))
        self.a = np.array([self.walk(x, np.zeros(ports), omega, decay, pushed, seconds, delay, late) for x in np.eye(size)]).T
        inputs = np.eye(ports)
        self.b = np.array([self.walk(np.zeros(size), u, omega, decay, pushed, seconds, delay, late) for u in inputs]).T
        weight = np.zeros((size, size))
        weight[:n, :n], weight[n : 2 * n, n : 2 * n] = energy * np.diag(omega**2), energy * np.eye(n)
        weight += self.c.T @ np.diag(error) @ self.c
        self.hold = riccati(self.a, self.b, weight, effort * np.eye(ports))[1]
        shaken = np.zeros((size, ports))
        for p in range(ports):
            shaken[: 2 * n, p] = moved(np.zeros(2 * n), b[p], omega, decay, seconds)
        spread = riccati(self.a.T, self.c.T, force_noise**2 * shaken @ shaken.T, sensor_noise**2 * np.eye(ports))[0]
        self.correct = spread @ self.c.T @ np.linalg.inv(self.c @ spread @ self.c.T + sensor_noise**2 * np.eye(ports))
        held = np.linalg.inv((b / omega**2) @ b.T)  # static force for a unit of displacement
        rest[:n] = (b / omega**2).T @ held
        held = held / gains[:, None]
        rest[2 * n :] = np.vstack([held] * late) if late else rest[2 * n :]
        self.feed, self.x = held + self.hold @ rest, np.zeros(size)

    @staticmethod
    def walk(x, u, omega, decay, b, seconds, delay, late):
        """One sample on: the oldest command under way acts until its successor arrives."""
        n, ports = len(omega), len(b)
        motion, queue = x[: 2 * n], [*x[2 * n :].reshape(late, ports), u]
        until = delay - (late - 1) * seconds if late else 0.0
        if late:
            motion = moved(motion, b.T @ queue[0], omega, decay, until)
            queue = queue[1:]
        motion = moved(motion, b.T @ queue[0], omega, decay, seconds - until)
        return np.concatenate([motion, *(queue if late else [])])

    def __call__(self, reading, reference):
        x = self.x + self.correct @ (reading - self.c @ self.x)
        u = self.feed @ reference - self.hold @ x
        self.x = self.a @ x + self.b @ u
        return u


def moved(x, force, omega, decay, seconds):
    """(q, q') some time on, under held modal forces."""
    n = len(omega)
    a = np.zeros((2 * n + 1, 2 * n + 1))
    a[:n, n : 2 * n] = np.eye(n)
    a[n : 2 * n, :n], a[n : 2 * n, n : 2 * n] = -np.diag(omega**2), -2 * np.diag(decay)
    a[n : 2 * n, -1] = force
    return (expm(a * seconds) @ np.append(x, 1.0))[:-1]


def riccati(a, b, q, r):
    """The stationary cost and gain, by going back in time until nothing changes."""
    cost = q.copy()
    for _ in range(200_000):
        gain = np.linalg.solve(r + b.T @ cost @ b, b.T @ cost @ a)
        closed = a - b @ gain
        before, cost = cost, closed.T @ cost @ closed + gain.T @ r @ gain + q
        if np.max(np.abs(cost - before)) <= 1e-15 * np.max(np.abs(cost)):
            break
    return cost, np.linalg.solve(r + b.T @ cost @ b, b.T @ cost @ a)
