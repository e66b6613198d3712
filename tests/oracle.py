"""Slow, plain reference for one trial of a structure with a control law at its ports.

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
NODES = 16
PI = np.longdouble("3.14159265358979323846264338327950288")


@dataclass
class Trial:
    """Grid quantities have steps + 1 rows, step quantities have steps rows; the last four are the final state.

    y is the displacement, v the rate of the error y - reference that the law sees.
    """

    y: np.ndarray
    v: np.ndarray
    command: np.ndarray
    delivered: np.ndarray
    energy: np.ndarray
    work_load: np.ndarray
    dissipated: np.ndarray
    q: np.ndarray
    rate: np.ndarray
    states: list
    slow: np.ndarray


class Law(NamedTuple):
    """What the law of one port knows in one step; low and high limit its error."""

    feedforward: float
    coulomb: float
    damping: float
    stiffness: float
    barrier: float
    low: float
    high: float
    shape: str


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


class Structure:
    """Exact motion of the modes over one step of held forces.

    Time runs in units of dt, so that all entries are of order one; the state is (q, dt rate), and its increment is
    propagated, not the end state: subtracting two nearly equal states would leave too few digits for velocity and force.
    """

    def __init__(self, omega, decay, b, dt):
        self.omega, self.b = np.asarray(omega, float), np.asarray(b, float)
        self.decay = np.zeros_like(self.omega) if decay is None else np.asarray(decay, float)
        self.n, self.dt = len(self.omega), dt
        n = self.n
        self.a = np.zeros((2 * n, 2 * n))
        self.a[:n, n:] = np.eye(n)
        self.a[n:, :n] = -np.diag((self.omega * dt) ** 2)
        self.a[n:, n:] = -2 * np.diag(self.decay * dt)
        self.grow = self.growth(1.0)
        self.pushed = dt**2 * self.grow[:, n:] @ self.b.T
        self.gain = self.b @ self.pushed[:n]
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        self.inside = [(w / 2, self.growth((s + 1) / 2)[n:]) for s, w in zip(nodes, weights, strict=True)]

    def growth(self, share):
        """The state grows by this matrix times (a state + input) in a share of the step."""
        size = 2 * self.n
        held = np.zeros((2 * size, 2 * size))
        held[:size, :size] = self.a
        held[:size, size:] = np.eye(size)
        return expm(share * held)[:size, size:]

    def change(self, state, force):
        """a state + input under modal forces."""
        return self.a @ state + np.concatenate([np.zeros(self.n), self.dt**2 * force])

    def lost(self, state, force):
        """int 2 decay rate^2 over the step, by Gauss points on the exact motion."""
        change = self.change(state, force)
        rates = [(w, (state[self.n :] + grow @ change) / self.dt) for w, grow in self.inside]
        return self.dt * sum(w * np.sum(2 * self.decay * rate**2) for w, rate in rates)

    def energy(self, grid):
        """Of states, one a row."""
        return ((grid[:, self.n :] / self.dt) ** 2 + (self.omega * grid[:, : self.n]) ** 2).sum(axis=1) / 2


def potential(at, c, shape):
    """V and V' at `at` inside a symmetric limit c, in extended precision."""
    rest = (c - at) * (c + at)
    if shape == "log":
        logarithm = -np.log1p(at / c) - np.log1p(-at / c)
        return logarithm**2 / 4, at / rest * logarithm
    to_edge = PI / 2 * rest / c**2  # pi/2 less the angle of the tangent
    return np.cos(to_edge) / np.sin(to_edge) / PI, at / c**2 / np.sin(to_edge) ** 2


def potential_slope(y, dy, low, high, shape):
    """(V(y + dy) - V(y)) / dy, where V(y) has the limit high for y > 0 and -low for y < 0."""
    start = np.longdouble(y)
    end = start + np.longdouble(dy)
    ends = [(at, np.longdouble(high if at > 0 or (at == 0 and start + end > 0) else -low)) for at in (start, end)]
    room = min(c - abs(at) for at, c in ends)
    if not room > 0:
        raise ArithmeticError("port outside its limit, where the barrier is undefined")
    # Over a thousandth of the distance to the singularity Simpson's mean of V' is good to 1e-13; beyond it the
    # difference of V loses only three digits of the extended ones. From one side to the other dy is as long as y.
    if start * end >= 0 and abs(dy) < 1e-3 * room:
        c = ends[0][1]
        mean = [potential(at, c, shape)[1] for at in (start, (start + end) / 2, end)]
        return float((mean[0] + 4 * mean[1] + mean[2]) / 6)
    (before, _), (after, _) = (potential(at, c, shape) for at, c in ends)
    return float((after - before) / (end - start))


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
    """Delivered force, command and v_law of one port whose error y changes by drift + push * force in the step."""
    stiffness = (1 + SOFTNESS) * push / dt
    hold = (SOFTNESS * push * slow - drift) / ((1 + SOFTNESS) * push)  # v_law = stiffness * (force - hold)
    low, high = -np.inf, np.inf
    if law.barrier > 0:
        low, high = ((limit - y - drift) / push for limit in (law.low, law.high))

    def command(force, sign):
        moved = drift + push * force
        u = law.feedforward - law.damping * stiffness * (force - hold) - law.coulomb * sign
        u -= law.stiffness * (y + moved / 2)
        if law.barrier > 0:
            u -= law.barrier * potential_slope(y, moved, law.low, law.high, law.shape)
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
    omega, b, q, rate, dt, feedforward, coulomb, damping, barrier, low, high, disturbance, load, deliver, states, slow, force,
    decay=None, stiffness=None, reference=None, shape="log",
):  # fmt: skip
    """One trial. low, high: limits of the error, (ports,) or for each step the one at its end, (steps, ports); reference:
    (steps + 1, ports); force: the delivered force before it, only the first guess of the sweeps over the ports."""
    structure = Structure(omega, decay, b, dt)
    b, n = structure.b, structure.n
    load, disturbance = (np.asarray(a, float) for a in (load, disturbance))
    steps, ports, states, slow = len(load), len(b), list(states), np.array(slow, float)
    low, high = (np.broadcast_to(limit, (steps, ports)) for limit in (low, high))
    reference = np.zeros((steps + 1, ports)) if reference is None else reference
    stiffness = np.zeros(ports) if stiffness is None else stiffness
    state = np.concatenate([q, dt * np.asarray(rate, float)])
    grid, step, work, lost = [state.copy()], [], [], []
    for k in range(steps):
        error = b @ state[:n] - reference[k]
        free = structure.grow @ structure.change(state, load[k])
        drift = b @ free[:n] - (reference[k + 1] - reference[k])
        rows = zip(feedforward[k], coulomb[k], damping, stiffness, barrier, low[k], high[k], [shape] * ports, strict=True)
        laws = [Law(*row) for row in rows]
        outputs = [lambda u, f=f, s=s: f(u, s)[0] for f, s in zip(deliver, states, strict=True)]
        force, command, v = solve_ports(laws, outputs, error, drift, structure.gain, dt, disturbance[k], slow, force)
        moved = free + structure.pushed @ (force + disturbance[k])
        lost.append(structure.lost(state, load[k] + b.T @ (force + disturbance[k])))
        state = state + moved
        states = [f(u, s)[1] for f, u, s in zip(deliver, command, states, strict=True)]
        slow = slow + RELAXATION * (force - slow)
        grid.append(state.copy())
        step.append((v, command, force))
        work.append(load[k] @ moved[:n])
    grid = np.array(grid)
    v, command, delivered = np.array(step).reshape(steps, 3, ports).transpose(1, 0, 2)
    return Trial(
        grid[:, :n] @ b.T, v, command, delivered, structure.energy(grid), np.array(work), np.array(lost), state[:n],
        state[n:] / dt, states, slow,
    )  # fmt: skip
