"""The log barrier V(y) = 1/4 ln^2(C^2 / (C^2 - y^2)) of He et al. 2017, as scalar functions for the kernel.

What is carried from step to step is the logarithm: one division a gradient is left.
"""

from __future__ import annotations

import math

EDGE = 1 - 1e-12
SMALL = 1e-6


def fresh(y, limit):
    """ln(C^2 / (C^2 - y^2)) for |y| < C, with small relative error at both ends of the range."""
    return math.log1p(y * y / ((limit - y) * (limit + y)))


def carried(y_new, y, log_y, limit):
    """The logarithm at y_new from its value at y; beyond the edge it is not used, and left alone."""
    edge = EDGE * limit
    if abs(y_new) > edge:
        return log_y
    if abs(y) > edge:
        return fresh(y_new, limit)
    z = (y_new - y) * mean_slope(y, y_new, limit)
    square = z * z
    if square < SMALL:
        return log_y + 2 * z * atanh_ratio(square)
    return fresh(y_new, limit)


def potential(y, limit):
    """V(y), going on in a straight line beyond the edge."""
    edge = EDGE * limit
    if abs(y) < edge:
        return 0.25 * fresh(y, limit) ** 2
    return 0.25 * fresh(edge, limit) ** 2 + steepest(limit) * (abs(y) - edge)


def reach(level, limit):
    """The |y| at which V is `level`: C sqrt(1 - exp(-2 sqrt(V)))."""
    return limit * math.sqrt(-math.expm1(-2 * math.sqrt(level)))


def curvature(limit):
    """V'' at 0: none, V begins as y^4 / (4 C^4)."""
    return 0.0


def gradient(y, y_new, log_y, limit):
    """(V(y_new) - V(y)) / (y_new - y), without 0/0; `log_y` is fresh(y, limit), or anything once y is beyond the edge.

    With s the mean slope and z = (y_new - y) s it is (log_y + atanh z) (atanh z / z) s.
    """
    edge = EDGE * limit
    if abs(y) > edge or abs(y_new) > edge:
        return gradient_beyond(y, y_new, limit, edge)
    s = mean_slope(y, y_new, limit)
    z = (y_new - y) * s
    square = z * z
    if square < SMALL:
        ratio = atanh_ratio(square)
    else:
        ratio = (fresh(y_new, limit) - log_y) / (2 * z)
    return (log_y + z * ratio) * ratio * s


def mean_slope(y, y_new, limit):
    """s = (y + y_new) / (2 C^2 - y^2 - y_new^2), with which half the difference of the two logarithms is atanh((y_new - y) s)."""
    return (y + y_new) / ((limit - y) * (limit + y) + (limit - y_new) * (limit + y_new))


def atanh_ratio(square):
    """atanh(z) / z for z^2 = square < SMALL, to round-off."""
    return 1 + square * (1 / 3 + square * (1 / 5))


def steepest(limit):
    """V' at the edge."""
    edge = EDGE * limit
    return edge / ((limit - edge) * (limit + edge)) * fresh(edge, limit)


def gradient_beyond(y, y_new, limit, edge):
    """The same with y or y_new beyond the edge, where V goes on with the slope it has there."""
    if y == y_new:
        return math.copysign(steepest(limit), y)
    log_edge = fresh(edge, limit)
    log_old, log_new = log_edge, log_edge
    if abs(y) < edge:
        log_old = fresh(y, limit)
    if abs(y_new) < edge:
        log_new = fresh(y_new, limit)
    rise = 0.25 * (log_new - log_old) * (log_new + log_old)
    rise += steepest(limit) * (max(abs(y_new) - edge, 0.0) - max(abs(y) - edge, 0.0))
    return rise / (y_new - y)
