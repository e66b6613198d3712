"""The port closure: the force at one port that law, actuator and structure agree on, as scalar functions for the kernel.

Over a step of length dt a port moves with the mean velocity v = v_free + g B, where B is the delivered force, and

    B = A(u),    u in feedforward - damping v_law - coulomb Sgn(v_law) - U'(y, y_new),    v_law = v + soft (B - B_slow)

U = stiffness y^2 / 2 + barrier V(y) is the potential of the law, y the tracking error and v its rate. A is the chain of stages
between law and force. v_law is the velocity that the law sees. It differs from v by a small compliance at the port,
soft = SOFTNESS g, that gives way to what is fast in B and holds what is slow (B_slow follows B at the rate RELAXATION a step).
Without it a stuck port's held force would have to flip the end velocity in every step; with it a point mass comes to rest
within a few steps. It is passive: over a step it stores soft dt B_slow^2 / (2 RELAXATION) and dissipates
soft dt (1 - RELAXATION/2) (B - B_slow)^2, and both go into the energy account.

With non-negative damping, coulomb, stiffness and barrier and a non-decreasing A, the commands that the law allows fall as B
rises: there is exactly one solution, sticking (v_law = 0, a command inside the jump of Sgn) included.
"""

from __future__ import annotations

import math

from dampen.simulation.barrier import barrier_gradient

SOFTNESS = 1.0
RELAXATION = 0.05
TOLERANCE = 1e-12
ITERATIONS = 200
GAPLESS = 1e-17  # a bracket of commands this narrow, against what the force takes, has closed on a jump
NOTHING = 1e-20  # a force this small, against the one that would hold, is zero: a flat actuator's root may be zero itself
LEAST = 1e-12
UNMOVED = 1e-9  # of the way to the limit: a barrier that moves by less is where it was


def stage_step(code, command, state, parameters, new_state):
    """Step the stage with this code; bound to the scenario's own step functions before use."""
    raise NotImplementedError


def through(port, command, stages):
    """The port's chain of stages: what a command delivers now. Where it would lead goes to the stages' `new_state`."""
    for s in range(port.first, port.last):
        stage = stages[s]
        command = stage_step(stage.code, command, stage.state, stage.parameters, stage.new_state)
    return command


def port_force(port, stages, v_free, g, dt):
    """Solve the inclusion at one port: force, command, v_law, 1 / slope of the residual there, and the stages' next states.

    What the port did last is tried first; a solution found so is the solution, since there is only one. If that fails: with
    the force B_hold at which v_law = 0, do commands that the law allows there reach it? Then the port sticks. If not, the
    direction of slip is known, and the residual r(B) = A(u(B)) - B falls with a slope of at most -1, so that its root lies
    between B_hold and B_hold + r(B_hold): a guarded secant finds it.
    """
    h = g + port.soft
    w = v_free - port.soft * port.slow
    port.give = 1 / h
    if port.v_law != 0.0 and still_slips(port, stages, v_free, g, w, h, dt):
        return
    hold = -w * port.give
    port.v_middle = v_free + g * hold
    port.middle = port.feedforward - potential_force(port, port.v_middle, dt)
    if port.v_law == 0.0 and still_sticks(port, stages, hold):
        return
    middle = through(port, port.middle, stages)
    if middle == hold:
        settle(port, hold, port.middle, 0.0, 0.0)
        return
    sign = 1.0 if middle > hold else -1.0
    edge = port.middle - sign * port.coulomb
    output = through(port, edge, stages)
    if sign * (output - hold) <= 0:
        settle(port, hold, command_for(port, hold, port.middle, middle, edge, output, stages), 0.0, 0.0)
        return

    # Along the bracket r falls from the slip's end to the end over it; each end keeps its force, command, output and r.
    slip, slip_u, slip_out, slip_r = hold, edge, output, output - hold
    x, over, over_u, over_out, over_r = output, output, port.middle, middle, 0.0
    nothing = NOTHING * abs(hold)
    for iteration in range(ITERATIONS):
        command = slip_command(port, sign, w + h * x, v_free + g * x, dt)
        output = through(port, command, stages)
        r = output - x
        if abs(r) <= TOLERANCE * (abs(output) + abs(x)) + nothing:
            settle(port, output, command, w + h * output, (over - slip) / (over_r - slip_r))
            return
        if (r > 0) == (slip_r > 0):
            slip, slip_u, slip_out, slip_r = x, command, output, r
        else:
            over, over_u, over_out, over_r = x, command, output, r
        if iteration < 8 and over_r != 0.0:
            x = slip - slip_r * (over - slip) / (over_r - slip_r)
        if iteration >= 8 or over_r == 0.0 or x == slip or x == over:
            x = 0.5 * (slip + over)
            if x == slip or x == over:
                break
    # The bracket has closed on a jump, of an actuator or of a barrier so stiff that rounding of y_new decides the command.
    # Keep the force, and take the command that delivers it from between those of the two ends.
    command = command_for(port, x, slip_u, slip_out, over_u, over_out, stages)
    settle(port, x, command, w + h * x, -LEAST)


def confirm(port, stages, v_free, g, dt):
    """Whether a port goes on as it was just found, now that its neighbours moved it a little: then all is brought up to date."""
    h = g + port.soft
    w = v_free - port.soft * port.slow
    if port.v_law == 0.0:
        hold = -w / h
        v = v_free + g * hold
        room = UNMOVED * min(port.high - port.y, port.y - port.low)
        if port.stiffness > 0.0 or not dt * abs(v - port.v_middle) <= room:
            port.middle = port.feedforward - potential_force(port, v, dt)
        return still_sticks(port, stages, hold)
    return still_slips(port, stages, v_free, g, w, h, dt)


def still_sticks(port, stages, hold):
    """Try to deliver the new holding force from the flank that delivered the last."""
    command = port.command + (hold - port.held) * port.per_feedthrough
    output = through(port, command, stages)
    scale = abs(hold) + port.feedthrough * (abs(command) + port.coulomb)
    if abs(output - hold) > TOLERANCE * scale or abs(command - port.middle) > port.coulomb:
        return False
    settle(port, hold, command, 0.0, 0.0)
    return True


def still_slips(port, stages, v_free, g, w, h, dt):
    """Slip on in the direction of the last v_law: a secant from the force that is there, with the last slope to begin with."""
    x, sign = port.force, math.copysign(1.0, port.v_law)
    per_slope = max(port.per_slope, -1.0) if port.per_slope < 0.0 else -1.0
    x_before, r_before = x, 0.0
    for iteration in range(5):
        command = slip_command(port, sign, w + h * x, v_free + g * x, dt)
        output = through(port, command, stages)
        r = output - x
        if abs(r) <= TOLERANCE * (abs(output) + abs(x)):
            if sign * (w + h * output) <= 0:
                return False
            settle(port, output, command, w + h * output, per_slope)
            return True
        if iteration > 0:
            if x == x_before or r == r_before:  # steeper than rounding can tell
                return False
            per_slope = (x - x_before) / (r - r_before)
            if not -2.0 <= per_slope < 0.0:  # the slope is at most -1: rounding rules here
                return False
        x_before, r_before = x, r
        x -= r * per_slope
    return False


def answer(port, g):
    """dB/dv_free: how the port's force answers to a push from elsewhere.

    Where it sticks, -1/h. Where it slips its residual has the slope -(1 + c h + k g): damping, c as the actuator passes it on,
    answers to v_law and so to h, the potential, k, to v and so to g. Told apart by c: a barrier that holds the port gives -1/g.
    In terms of s = 1 / (1 + c h + k g) the answer is -(c + k) s = (c h s (h - g) - (1 - s) h) / (h g).
    """
    if port.v_law == 0.0:
        return -port.give
    h = g + port.soft
    least = max(g, LEAST * h)
    per_least = 1 / least
    s = min(-port.per_slope, 1.0)
    damping = min(port.feedthrough * port.damping * h * s, 1.0 - s)
    return damping * (h - least) * per_least * port.give - (1.0 - s) * per_least


def slip_command(port, sign, v_law, v, dt):
    """The law of a port that slips in the direction `sign`."""
    return port.feedforward - port.damping * v_law - sign * port.coulomb - potential_force(port, v, dt)


def potential_force(port, v, dt):
    """The law's potential terms, their discrete gradients, if the port moves with mean velocity v."""
    force = 0.0
    if port.barrier > 0.0:
        force = port.barrier * barrier_gradient(port.y, port.y + dt * v, port.memo, port.low, port.high)
    if port.stiffness > 0.0:
        force += port.stiffness * (port.y + 0.5 * dt * v)
    return force


def command_for(port, target, near, near_output, far, far_output, stages):
    """The command nearest to `near`, between `near` and `far`, that delivers `target`.

    On a flank of full slope one step from either end lands on it; elsewhere the bracket is halved. Where A jumps across the
    target it is the command at the jump: there the port delivers what lies in between, as under a command that chatters.
    """
    scale = abs(target) + abs(far_output) + port.feedthrough * (abs(near) + abs(far))
    closed = GAPLESS * scale * port.per_feedthrough
    low, high = min(near, far), max(near, far)
    guess = far - (far_output - target) / port.feedthrough
    for iteration in range(ITERATIONS):
        output = through(port, guess, stages)
        if abs(output - target) <= TOLERANCE * scale or guess == low or guess == high:
            break
        if output < target:
            low = max(low, guess)
        else:
            high = min(high, guess)
        if iteration > 1 and high - low <= closed:
            break
        guess = near - (near_output - target) / port.feedthrough if iteration == 0 else 0.5 * (low + high)
    return guess


def settle(port, force, command, v_law, per_slope):
    """Write down what a port came to; `per_slope` is 1 / slope of its residual, 0 where it sticks."""
    port.force = force
    port.command = command
    port.v_law = v_law
    port.per_slope = per_slope
    port.held = force
