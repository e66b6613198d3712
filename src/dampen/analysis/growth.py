"""How far an energy can rise at most whose supply is bounded: the largest solution of V' = a + c sqrt(2 V)."""

from __future__ import annotations

import numpy as np

Array = np.ndarray
ROUNDS = 60
SMALL = 1e-4


def largest_energy(t: Array, initial: float, power: float, push: float) -> Array:
    """The largest V(t) with V' <= power + push sqrt(2 V) and V(0) = initial, (times,) [J].

    t: (times,) [s].   initial: [J].   power: a >= 0 [W].   push: c >= 0 [sqrt(W/s)].

    With s = sqrt(2 V): s' = c + a / s, whose solution takes the time

        t(s) = (s - s0)/c - a/c^2 ln(1 + c (s - s0)/(a + c s0)) = (d s0 + a d^2 g(c d/A)/A)/A,    d = s - s0,  A = a + c s0

    g(x) = (x - ln(1 + x))/x^2. t(s) is convex, so that Newton's method from above comes down to it and never passes it: at any
    number of rounds the answer is a bound. It starts from sqrt(s0^2 + 2 a t) + c t, which is one.
    """
    start = np.sqrt(2 * initial)
    if push == 0:
        return initial + power * t
    if power == 0:
        return (start + push * t) ** 2 / 2
    slope = power + push * start
    s = np.sqrt(start**2 + 2 * power * t) + push * t
    for _ in range(ROUNDS):
        d = s - start
        late = (d * start + power * d**2 * _excess(push * d / slope) / slope) / slope - t
        lower = np.maximum(s - late * (push + power / np.where(s > 0, s, 1.0)), start)
        if np.all(s - lower <= 1e-14 * s):
            break
        s = np.minimum(s, lower)
    return s**2 / 2


def _excess(x: Array) -> Array:
    """(x - ln(1 + x)) / x^2 for x >= 0, without cancellation near zero."""
    far = np.where(x > SMALL, x, 1.0)
    return np.where(x > SMALL, (far - np.log1p(far)) / far**2, 0.5 - x / 3 + x**2 / 4)
