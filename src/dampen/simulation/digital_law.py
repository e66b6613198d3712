"""The law at the ports as a digital controller computes it from samples, with three ways to treat Sgn.

    u = feedforward - damping v - coulomb Sgn(v) - U'(e)

explicit:        Sgn as it is, of the estimated rate: chatters at the sample rate wherever the rate should be zero.
boundary layer:  Sgn(v) ~ v / layer within the layer: no chatter, but a dragged port instead of a held one.
implicit:        of the rate that the command will bring about, v+ = v + compliance (u - u_slow): the controller solves this
                 small inclusion before it outputs, and gives the command that brings the port to rest where that is within
                 reach. `compliance` is a nominal one; u_slow follows u, so that a force that has to be held is held. What the
                 command before will still do, while it is delayed, is counted in as pending (u_before - u_slow).
                 Source: Acary and Brogliato, Systems & Control Letters 59, 2010 (implicit discretisation of sliding modes).

The barrier is taken at most at `edge` of the limit, as a real controller has to: past it the command does not grow.
"""

from __future__ import annotations

from dampen.simulation.barrier import barrier_gradient, fresh_memo

EXPLICIT, LAYER, IMPLICIT = 0.0, 1.0, 2.0
RELAXATION = 0.05
COLUMNS = ("damping", "stiffness", "barrier", "edge", "switching", "layer", "compliance", "pending")
ROW = len(COLUMNS)


def port_law(sample, state, parameters, command):
    """The commands of all ports; `parameters` holds COLUMNS port after port, `state` u_slow."""
    for p in range(len(command)):
        row = p * ROW
        damping, stiffness, barrier, edge = parameters[row], parameters[row + 1], parameters[row + 2], parameters[row + 3]
        switching, layer, compliance, pending = parameters[row + 4], parameters[row + 5], parameters[row + 6], parameters[row + 7]
        error, rate, coulomb = sample.error[p], sample.rate[p], sample.coulomb[p]
        smooth = sample.feedforward[p] - stiffness * error
        if barrier > 0.0:
            low, high = sample.low[p], sample.high[p]
            inside = min(max(error, edge * low), edge * high)
            smooth -= barrier * barrier_gradient(inside, inside, fresh_memo(inside, low, high), low, high)
        if switching == IMPLICIT:
            ahead = rate + pending * (sample.before[p] - state[p])
            command[p] = implicit(smooth, ahead - compliance * state[p], damping, coulomb, compliance)
            state[p] += RELAXATION * (command[p] - state[p])
        elif switching == LAYER:
            command[p] = smooth - damping * rate - coulomb * min(max(rate / layer, -1.0), 1.0)
        else:
            command[p] = smooth - damping * rate - (coulomb * (rate > 0.0) - coulomb * (rate < 0.0))


def implicit(smooth, rate, damping, coulomb, compliance):
    """The solution u of u in smooth - damping v - coulomb Sgn(v), v = rate + compliance u."""
    rest = -rate / compliance
    if smooth - coulomb > rest:
        return (smooth - coulomb - damping * rate) / (1.0 + damping * compliance)
    if smooth + coulomb < rest:
        return (smooth + coulomb - damping * rate) / (1.0 + damping * compliance)
    return rest
