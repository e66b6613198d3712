"""The two discretisations in space: what a plant needs of either is the same few Gram matrices.

A space holds functions on [0, L] that vanish at x = 0 (the clamp), and knows

    vv[i, j] = int u_i u_j dx      dd[i, j] = int u_i' u_j' dx      dv[i, j] = int u_i' u_j dx
"""

from __future__ import annotations

from abc import ABC, abstractmethod

import numpy as np
from numpy.polynomial.legendre import legvander

from dampen.gauss import gauss_legendre

Array = np.ndarray


class Space(ABC):
    """Functions on [0, length] that vanish at 0. `rule`: points and weights that `vv` is integrated with."""

    length: float
    vv: Array
    dd: Array
    dv: Array
    rule: tuple[Array, Array]
    breaks: Array

    @abstractmethod
    def values(self, x: Array) -> Array:
        """(points, size) values of the basis functions at x."""


class Spectral(Space):
    """One element of high degree: integrated Legendre polynomials, integrated exactly.

    u_k(s) = (P_(k+1)(s) - P_(k-1)(s)) / sqrt(2 (2k + 1)) for k >= 1 and u_0 = (1 + s)/2, on s = 2x/L - 1: the derivatives of
    the former are orthonormal Legendre polynomials, so `dd` is nearly diagonal and well conditioned at any degree.
    Source: Szabo and Babuska, Finite Element Analysis, 1991, ch. 3 (hierarchic shape functions).
    """

    def __init__(self, length: float, degree: int):
        self.length, self.degree = length, degree
        s, weights = gauss_legendre(degree + 2)
        x, weights = (s + 1) * length / 2, weights * length / 2
        value, slope = self.values(x), self._slopes(x)
        self.vv, self.dd, self.dv = ((a * weights[:, None]).T @ b for a, b in ((value, value), (slope, slope), (slope, value)))
        self.rule, self.breaks = (x, weights), np.array([0.0, length])

    def values(self, x: Array) -> Array:
        s = 2 * x / self.length - 1
        p = legvander(s, self.degree)
        k = np.arange(1, self.degree)
        return np.column_stack([(1 + s) / 2, (p[:, 2:] - p[:, :-2]) / np.sqrt(2 * (2 * k + 1))])

    def _slopes(self, x: Array) -> Array:
        p = legvander(2 * x / self.length - 1, self.degree - 1)
        k = np.arange(1, self.degree)
        return np.column_stack([np.ones_like(x) / 2, np.sqrt((2 * k + 1) / 2) * p[:, 1:]]) * 2 / self.length


class FiniteDifference(Space):
    """The paper's uniform grid of `points` nodes, x = 0 included: second-order central differences, symmetric.

    Inertia and phi^2 are taken at the nodes (half a cell at the tip), differences between neighbours at the middles.
    """

    def __init__(self, length: float, points: int):
        self.length = length
        self.nodes = np.linspace(0, length, points)
        h, n = length / (points - 1), points - 1
        weights = np.full(n, h)
        weights[-1] = h / 2
        above = np.diag(np.ones(n - 1), 1)
        self.vv = np.diag(weights)
        self.dd = (2 * np.eye(n) - above - above.T) / h
        self.dd[-1, -1] = 1 / h
        self.dv = (above.T - above) / 2
        self.dv[-1, -1] = 0.5
        self.rule, self.breaks = (self.nodes[1:], weights), self.nodes

    def values(self, x: Array) -> Array:
        """Straight lines between the nodes."""
        h = self.nodes[1]
        return np.clip(1 - np.abs(x[:, None] - self.nodes[None, 1:]) / h, 0, None)
