"""The discretisations in space: what a plant needs of any is the same few Gram matrices.

A space holds functions u_i on [0, L] that meet the conditions at x = 0, and knows

    values(x, a)[p, i] = u_i^(a)(x_p)        gram(a, b, weight)[i, j] = int weight(x) u_i^(a) u_j^(b) dx
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable

import numpy as np
from numpy.polynomial.legendre import legvander

from dampen.gauss import gauss_legendre

Array = np.ndarray
Function = Callable[[Array], Array]


class Space(ABC):
    """Functions on [0, length]. `rule`: points and weights that `gram(0, 0)` is integrated with; smooth between `breaks`."""

    length: float
    size: int
    rule: tuple[Array, Array]
    breaks: Array

    @abstractmethod
    def values(self, x: Array, derivative: int = 0) -> Array:
        """(points, size) values of the basis functions, or of their derivative, at x."""

    @abstractmethod
    def gram(self, a: int, b: int, weight: Function) -> Array:
        """(size, size) matrix of int weight u_i^(a) u_j^(b) dx."""


class Polynomials(Space):
    """One element of high degree, integrated by Gauss points: exactly for weights up to degree + 126 in x."""

    def _integrate_with(self, length: float, degree: int, derivatives: int) -> None:
        self.length, self.degree, self.size = length, degree, len(self.values(np.zeros(1))[0])
        s, weights = gauss_legendre(3 * degree // 2 + 64)
        self.rule, self.breaks = ((s + 1) * length / 2, weights * length / 2), np.array([0.0, length])
        self._tables = [self.values(self.rule[0], a) for a in range(derivatives + 1)]

    def gram(self, a: int, b: int, weight: Function) -> Array:
        x, weights = self.rule
        return (self._tables[a] * (weights * weight(x))[:, None]).T @ self._tables[b]

    def root(self, a: int, weight: Function) -> Array:
        """(points, size) matrix R such that R^T R = gram(a, a, weight)."""
        x, weights = self.rule
        return self._tables[a] * np.sqrt(weights * weight(x))[:, None]


class Spectral(Polynomials):
    """Integrated Legendre polynomials, which vanish at x = 0.

    u_k(s) = (P_(k+1)(s) - P_(k-1)(s)) / sqrt(2 (2k + 1)) for k >= 1 and u_0 = (1 + s)/2, on s = 2x/L - 1: the derivatives of
    the former are orthonormal Legendre polynomials, so gram(1, 1) is nearly diagonal and well conditioned at any degree.
    Source: Szabo and Babuska, Finite Element Analysis, 1991, ch. 3 (hierarchic shape functions).
    """

    def __init__(self, length: float, degree: int):
        self.length, self.degree = length, degree
        self._integrate_with(length, degree, derivatives=1)

    def values(self, x: Array, derivative: int = 0) -> Array:
        p = legvander(2 * x / self.length - 1, self.degree)
        k = np.arange(1, self.degree)
        if derivative:
            return np.column_stack([np.ones_like(x) / 2, np.sqrt((2 * k + 1) / 2) * p[:, 1:-1]]) * 2 / self.length
        return np.column_stack([x / self.length, (p[:, 2:] - p[:, :-2]) / np.sqrt(2 * (2 * k + 1))])


class Bending(Polynomials):
    """Twice integrated Legendre polynomials, which vanish at x = 0 with their slope; and the function x, where it may turn.

    With orthonormal Legendre polynomials as second derivatives, gram(2, 2) is diagonal for a constant weight, and well
    conditioned at any degree for a smooth one. The function x, of no curvature, is the rigid rotation of a pinned base.
    """

    def __init__(self, length: float, degree: int, pinned: bool):
        self.length, self.degree, self.pinned = length, degree, pinned
        self._integrate_with(length, degree, derivatives=2)

    def values(self, x: Array, derivative: int = 0) -> Array:
        s, k = 2 * x / self.length - 1, np.arange(self.degree - 1)
        p = legvander(s, self.degree)
        if derivative == 2:
            basis = p[:, :-2].copy()
        elif derivative == 1:
            basis = np.column_stack([1 + s, (p[:, 2:-1] - p[:, :-3]) / (2 * k[1:] + 1)])
        else:
            start = [(1 + s) ** 2 / 2, (1 + s) ** 2 * (s - 2) / 6]
            j = k[2:]
            rise, fall = (p[:, 4:] - p[:, 2:-2]) / (2 * j + 3), (p[:, 2:-2] - p[:, :-4]) / (2 * j - 1)
            basis = np.column_stack([*start, (rise - fall) / (2 * j + 1)])
        basis *= np.sqrt(k + 0.5) * (2 / self.length) ** derivative
        rotation = (x / self.length, np.full_like(x, 1 / self.length), np.zeros_like(x))[derivative]
        return np.column_stack([rotation, basis]) if self.pinned else basis


class FiniteDifference(Space):
    """The paper's uniform grid of `points` nodes, x = 0 included: second-order central differences, symmetric.

    Products of values are taken at the nodes (half a cell at the tip), with their weight; all that has a difference between
    neighbours in it is taken at the middles, with its weight there and values averaged.
    """

    def __init__(self, length: float, points: int):
        self.length, self.size = length, points - 1
        self.nodes = np.linspace(0, length, points)
        weights = np.full(self.size, length / self.size)
        weights[-1] /= 2
        self.rule, self.breaks = (self.nodes[1:], weights), self.nodes

    def values(self, x: Array, derivative: int = 0) -> Array:
        """Straight lines between the nodes."""
        if derivative:
            raise NotImplementedError("A grid has differences, not derivatives.")
        h = self.nodes[1]
        return np.clip(1 - np.abs(x[:, None] - self.nodes[None, 1:]) / h, 0, None)

    def gram(self, a: int, b: int, weight: Function) -> Array:
        if a == b == 0:
            x, weights = self.rule
            return np.diag(weights * weight(x))
        h, here, before = self.nodes[1], np.eye(self.size), np.eye(self.size, k=-1)
        at_middles = ((here + before) / 2, (here - before) / h)
        middles = (self.nodes[1:] + self.nodes[:-1]) / 2
        return (at_middles[a] * (h * weight(middles))[:, None]).T @ at_middles[b]


def degree(count: int, *slowness: Array) -> int:
    """Polynomial degree that resolves `count` modes: two families at most, pi points a wavelength, and a margin.

    In the worst case one family holds all `count` modes, which is count/2 wavelengths. Where the structure varies along x,
    they are shortest where the waves of a family are slowest: `slowness`, at sample points, is any measure of that.
    """
    crowding = max((float(np.max(slow) / np.mean(slow)) for slow in slowness), default=1.0)
    return int(np.ceil(np.pi * count / 2 * max(crowding, 1.0) - 1e-9)) + 24
