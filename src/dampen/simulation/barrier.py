"""Barriers: potentials that rise without bound towards the constraint, and their discrete gradients, as scalar functions.

A barrier acts on the tracking error y, between low < 0 < high; on either side it has the shape of a symmetric one with the
limit C = high or C = -low. The discrete gradient (V(y_new) - V(y)) / (y_new - y) makes the barrier's work over a step exactly
its change of energy (Gonzalez, J. Nonlinear Sci. 6, 1996). Beyond `EDGE * C` it goes on in a straight line: the law stays
defined, and monotone, where an actuator or the arithmetic cannot hold the constraint.

`gradient`, `carried`, `fresh` and `potential` are those of one shape, the log barrier here; `compose` swaps in another's.
`memo` is what a shape keeps of y from step to step, so as not to compute it twice.
"""

from __future__ import annotations

from dampen.simulation.log_barrier import EDGE, carried, fresh, gradient, potential


def barrier_gradient(y, y_new, memo, low, high):
    """The discrete gradient from y to y_new."""
    limit = high if y + y_new >= 0.0 else -low
    if y * y_new < 0.0 and low != -high:
        return (potential(y_new, side(y_new, low, high)) - potential(y, side(y, low, high))) / (y_new - y)
    return gradient(y, y_new, memo, limit)


def barrier_memo(y_new, y, memo, low, high):
    """The memo of y_new, carried on from that of y."""
    if y * y_new <= 0.0 and low != -high:  # at 0 the memo of the other side would be carried
        return fresh_memo(y_new, low, high)
    return carried(y_new, y, memo, side(y_new, low, high))


def fresh_memo(y, low, high):
    """The memo of y; anything beyond the edge, where it is not used."""
    limit = side(y, low, high)
    if abs(y) < EDGE * limit:
        return fresh(y, limit)
    return 0.0


def side(y, low, high):
    """The limit C on the side on which y is."""
    return high if y >= 0.0 else -low
