"""Slow, plain reference for one trial of a beam with a control law at its ports.

It shows that the compiled solver solves the equations it claims to solve: the same discrete problem is written
down again from its definition and solved by bracketing. It uses numpy and scipy only and shares no code with the
package, so an error would have to be made twice, in two different ways, to go unnoticed.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.linalg import expm
from scipy.optimize import brentq

SOFTNESS = 1.0
RELAXATION = 0.05
SWEEPS = 500


@dataclass
class Trial:
    """Grid quantities have steps + 1 rows, step quantities have steps rows; the last four are the final state."""

    y: np.ndarray
    v: np.ndarray
    command: np.ndarray
    delivered: np.ndarray
    energy: np.ndarray
    work_load: np.ndarray
    q: np.ndarray
    rate: np.ndarray
    states: list
    slow: np.ndarray


class Law(NamedTuple):
    """What the law of one port knows in one step."""

    feedforward: float
    coulomb: float
    damping: float
    barrier: float
    limit: float


def ideal():
    """Actuator that delivers its command."""
    return lambda u, state: (u, state)


def play(slope, right, left):
    """Backlash; its state is its last output."""

    def deliver(u, old):
        new = min(max(old, slope * (u - right)), slope * (u - left))
        return new, new

    return deliver


def compensated_play(slope, right, left, assumed_slope, assumed_left):
    """Backlash behind a controller that inverts what it believes to be the left branch."""
    actuator = play(slope, right, left)
    return lambda u, old: actuator(u / assumed_slope + assumed_left, old)


def increments(omega, dt):
    """Matrices A, P such that the state (q, dt rate) grows by P (A state + input) in one step of held input.

    Time runs in units of dt, so that all entries are of order one, and the increment itself is propagated, not the
    end state: subtracting two nearly equal states would leave too few digits for the velocity and the force.
    """
    n = len(omega)
    a = np.zeros((2 * n, 2 * n))
    a[:n, n:] = np.eye(n)
    a[n:, :n] = -np.diag((omega * dt) ** 2)
    held = np.zeros((4 * n, 4 * n))
    held[: 2 * n, : 2 * n] = a
    held[: 2 * n, 2 * n :] = np.eye(2 * n)
    return a, expm(held)[: 2 * n, 2 * n :]


def potential_slope(y, dy, limit):
    """(V(y + dy) - V(y)) / dy for V = ln^2(C^2 / (C^2 - y^2)) / 4."""
    c = np.longdouble(limit)
    start, end = np.longdouble(y), np.longdouble(y) + np.longdouble(dy)
    room = c - max(abs(start), abs(end))
    if not room > 0:
        raise ArithmeticError("port outside its limit, where the barrier is undefined")

    def logarithm(at):
        return -np.log1p(at / c) - np.log1p(-at / c)

    def derivative(at):
        return at / ((c - at) * (c + at)) * logarithm(at)

    # Over a thousandth of the distance to the singularity Simpson's mean of V' is good to 1e-14; beyond it the
    # difference of V loses only three digits of the extended ones.
    if abs(dy) < 1e-3 * room:
        return float((derivative(start) + 4 * derivative((start + end) / 2) + derivative(end)) / 6)
    return float((logarithm(end) ** 2 - logarithm(start) ** 2) / 4 / (end - start))


def bracket(gap, start, low, high):
    """Ends of an interval inside (low, high) on which the falling function gap changes sign."""
    near, residual = start, gap(start)
    wall = high if residual > 0 else low
    for _ in range(200):
        if residual == 0:
            return near, near
        far = near + 2 * residual  # enough up to rounding, since gap falls with a slope of -1 or steeper
        if abs(far - near) >= abs(wall - near):
            far = (near + wall) / 2
        value = gap(far)
        if (value > 0) != (residual > 0):
            return near, far
        near, residual = far, value
    raise ArithmeticError("the actuator cannot keep the port inside its limit")


def nearest_command(output, centre, reach, hold):
    """The command closest to centre, within reach, that delivers hold."""
    if output(centre) == hold:
        return centre
    side = 1.0 if output(centre) < hold else -1.0
    enough, short = centre + side * reach, centre
    while True:
        middle = (enough + short) / 2
        if middle in (enough, short):
            return enough
        if side * (output(middle) - hold) >= 0:
            enough = middle
        else:
            short = middle


def solve_port(law, output, y, drift, push, dt, slow):
    """Delivered force, command and v_law of one port whose displacement in the step is drift + push * force."""
    stiffness = (1 + SOFTNESS) * push / dt
    hold = (SOFTNESS * push * slow - drift) / ((1 + SOFTNESS) * push)  # v_law = stiffness * (force - hold)
    low, high = -np.inf, np.inf
    if law.barrier > 0:
        low, high = ((side * law.limit - y - drift) / push for side in (-1, 1))

    def command(force, sign):
        u = law.feedforward - law.damping * stiffness * (force - hold) - law.coulomb * sign
        if law.barrier > 0:
            u -= law.barrier * potential_slope(y, drift + push * force, law.limit)
        return u

    if low < hold < high:
        centre, start = command(hold, 0), hold
        least, most = output(centre - law.coulomb), output(centre + law.coulomb)
        if least <= hold <= most:
            return hold, nearest_command(output, centre, law.coulomb, hold), 0.0
        sign = 1 if least > hold else -1
    else:  # sticking would carry the port past its limit, so it must slip inward
        sign, start = (1 if hold <= low else -1), (low + high) / 2

    def gap(force):
        return output(command(force, sign)) - force

    near, far = bracket(gap, start, low, high)
    force = near if near == far else brentq(gap, near, far, xtol=1e-18, rtol=4 * np.finfo(float).eps, maxiter=1000)
    return force, command(force, sign), stiffness * (force - hold)


def solve_ports(laws, outputs, y, free, gain, dt, disturbance, slow, force):
    """Sweep over the ports until their forces no longer change; gain[p, r] is displacement of p per force at r."""
    force = np.array(force, float)
    command, v = np.zeros(len(y)), np.zeros(len(y))
    for _ in range(SWEEPS):
        before = force.copy()
        for p, law in enumerate(laws):
            others = force.copy()
            others[p] = 0.0
            drift = free[p] + gain[p] @ (others + disturbance)
            force[p], command[p], v[p] = solve_port(law, outputs[p], y[p], drift, gain[p, p], dt, slow[p])
        change = abs(force - before)
        if len(y) == 1 or np.all(change <= 1e-15 * abs(force)):
            return force, command, v
    if np.max(change) > 1e-12 * np.max(abs(force)):  # rounding may keep the last digit moving, but no more
        raise ArithmeticError("the sweeps over the ports did not settle")
    return force, command, v


def simulate(
    omega, b, q, rate, dt, feedforward, coulomb, damping, barrier, limit, disturbance, load, deliver, states, slow, force
):
    """One trial; force is the delivered force before it, only the first guess of the sweeps over the ports."""
    omega, b, load, disturbance = (np.asarray(a, float) for a in (omega, b, load, disturbance))
    n, steps, states, slow = len(omega), len(load), list(states), np.array(slow, float)
    a, grow = increments(omega, dt)
    pushed = dt**2 * grow[:, n:] @ b.T
    gain = b @ pushed[:n]
    state = np.concatenate([q, dt * np.asarray(rate, float)])
    grid, step, work = [state.copy()], [], []
    for k in range(steps):
        y = b @ state[:n]
        free = grow @ (a @ state + np.concatenate([np.zeros(n), dt**2 * load[k]]))
        laws = [Law(*row) for row in zip(feedforward[k], coulomb[k], damping, barrier, limit, strict=True)]
        outputs = [lambda u, f=f, s=s: f(u, s)[0] for f, s in zip(deliver, states, strict=True)]
        force, command, v = solve_ports(laws, outputs, y, b @ free[:n], gain, dt, disturbance[k], slow, force)
        moved = free + pushed @ (force + disturbance[k])
        state = state + moved
        states = [f(u, s)[1] for f, u, s in zip(deliver, command, states, strict=True)]
        slow = slow + RELAXATION * (force - slow)
        grid.append(state.copy())
        step.append((v, command, force))
        work.append(load[k] @ moved[:n])
    grid = np.array(grid)
    v, command, delivered = np.array(step).reshape(steps, 3, len(b)).transpose(1, 0, 2)
    energy = ((grid[:, n:] / dt) ** 2 + (omega * grid[:, :n]) ** 2).sum(axis=1) / 2
    return Trial(grid[:, :n] @ b.T, v, command, delivered, energy, np.array(work), state[:n], state[n:] / dt, states, slow)
