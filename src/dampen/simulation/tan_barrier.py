"""The tan barrier V(y) = tan(a) / pi, a = pi y^2 / (2 C^2), as scalar functions for the kernel.

Near zero it is the spring y^2 / (2 C^2): unlike the log barrier, it pulls everywhere. Source: Jin and Xu, Automatica 49,
2013 (tan-type barrier Lyapunov functions in iterative learning control).
"""

from __future__ import annotations

import math

EDGE = 1 - 1e-12
HALF_PI = math.pi / 2


def fresh(y, limit):
    """Nothing is carried."""
    return 0.0


def carried(y_new, y, memo, limit):
    """Nothing is carried."""
    return 0.0


def potential(y, limit):
    """V(y), going on in a straight line beyond the edge."""
    edge = EDGE * limit
    inside = min(abs(y), edge)
    sine, cosine = math.sin(HALF_PI * (inside / limit) ** 2), cosine_of(inside, limit)
    return sine / cosine / math.pi + steepest(limit) * (abs(y) - inside)


def reach(level, limit):
    """The |y| at which V is `level`: y^2 = 2 C^2 atan(pi V) / pi."""
    return limit * math.sqrt(math.atan(math.pi * level) / HALF_PI)


def curvature(limit):
    """V'' at 0: 1 / C^2."""
    return 1 / (limit * limit)


def gradient(y, y_new, memo, limit):
    """(V(y_new) - V(y)) / (y_new - y) = sin(d)/d (y + y_new) / (2 C^2 cos a cos a_new), d = a_new - a."""
    edge = EDGE * limit
    if abs(y) > edge or abs(y_new) > edge:
        if y == y_new:
            return math.copysign(steepest(limit), y)
        return (potential(y_new, limit) - potential(y, limit)) / (y_new - y)
    d = HALF_PI * (y_new - y) * (y_new + y) / (limit * limit)
    ratio = 1 - d * d / 6 * (1 - d * d / 20) if abs(d) < 1e-3 else math.sin(d) / d
    return ratio * (y + y_new) / (2 * limit * limit * cosine_of(y, limit) * cosine_of(y_new, limit))


def cosine_of(y, limit):
    """cos(pi y^2 / (2 C^2)), from the distance to the limit, so that it does not cancel there."""
    return math.sin(HALF_PI * (limit - y) * (limit + y) / (limit * limit))


def steepest(limit):
    """V' at the edge."""
    edge = EDGE * limit
    return edge / (limit * limit) / cosine_of(edge, limit) ** 2
