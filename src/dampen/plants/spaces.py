"""The discretisations in space: what a plant needs of any is the same few Gram matrices.

A space holds functions u_i on [0, L] that meet the conditions at x = 0, and knows

    values(x, a)[p, i] = u_i^(a)(x_p)        gram(a, b, weight)[i, j] = int weight(x) u_i^(a) u_j^(b) dx

Spaces are equal if their functions are.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.polynomial.legendre import legvander

from dampen.component import ArgumentError
from dampen.gauss import gauss_legendre
from dampen.plants.base import Constant

Array = np.ndarray
DEGREE_AT_MOST = 4000  # a minute and half a gigabyte
Function = Callable[[Array], Array]


@dataclass(frozen=True)
class Space(ABC):
    """Functions on [0, length].

    scales: whether Gram matrices of constant weights are scaled ones of weight 1, made once; equal to round-off.
    """

    length: float
    scales: bool = field(default=False, kw_only=True, compare=False)

    @property
    @abstractmethod
    def size(self) -> int:
        """Number of functions."""

    @property
    @abstractmethod
    def rule(self) -> tuple[Array, Array]:
        """Points and weights that `gram(0, 0)` is integrated with."""

    @property
    @abstractmethod
    def breaks(self) -> Array:
        """Places between which the functions are smooth."""

    @abstractmethod
    def values(self, x: Array, derivative: int = 0) -> Array:
        """(points, size) values of the basis functions, or of their derivative, at x."""

    @abstractmethod
    def integral(self, a: int, b: int, weight: Function) -> Array:
        """(size, size) matrix of int weight u_i^(a) u_j^(b) dx."""

    def gram(self, a: int, b: int, weight: Function) -> Array:
        """The same, from what is remembered where that will do."""
        if self.scales and isinstance(weight, Constant):
            return weight.value * self._remembered(("gram", a, b), lambda: self.integral(a, b, Constant(1.0)))
        return self.integral(a, b, weight)

    def at(self, x: float, derivative: int = 0) -> Array:
        """(1, size) values at a single place."""
        return self.values(np.array([x]), derivative)

    def kin(self, other: object) -> bool:
        """Whether `other` has functions of the same kind on the same domain, if not as many."""
        return self == other

    @cached_property
    def shared(self) -> Space:
        """The same space, for many plants that differ in constants."""
        return replace(self, scales=True)

    @cached_property
    def _memory(self) -> dict[tuple[str | float, ...], Array]:
        return {}

    def _remembered(self, key: tuple[str | float, ...], make: Callable[[], Array]) -> Array:
        if key not in self._memory:
            self._memory[key] = make()
            self._memory[key].flags.writeable = False
        return self._memory[key]


@dataclass(frozen=True)
class Polynomials(Space):
    """One element of high degree, integrated by Gauss points: exactly for weights up to degree + 126 in x."""

    degree: int

    @cached_property
    def rule(self) -> tuple[Array, Array]:
        s, weights = gauss_legendre(3 * self.degree // 2 + 64)
        return (s + 1) * self.length / 2, weights * self.length / 2

    @property
    def breaks(self) -> Array:
        return np.array([0.0, self.length])

    def values(self, x: Array, derivative: int = 0) -> Array:
        """Remembered for the points of `rule`, where integrals and projections ask, and at either end, where lumps are."""
        place: str | float = "rule" if x is self.rule[0] else float(x[0]) if len(x) == 1 else ""
        if place not in ("rule", 0.0, self.length):
            return self.evaluated(x, derivative)
        return self._remembered(("values", place, derivative), lambda: self.evaluated(x, derivative))

    @abstractmethod
    def evaluated(self, x: Array, derivative: int) -> Array:
        """(points, size) values of the basis functions, or of their derivative, at any x."""

    def integral(self, a: int, b: int, weight: Function) -> Array:
        x, weights = self.rule
        return (self.values(x, a) * (weights * weight(x))[:, None]).T @ self.values(x, b)

    def root(self, a: int, weight: Function) -> Array:
        """(points, size) matrix R such that R^T R = gram(a, a, weight)."""
        if self.scales and isinstance(weight, Constant):
            return np.sqrt(weight.value) * self._remembered(("root", a), lambda: self._root(a, Constant(1.0)))
        return self._root(a, weight)

    def _root(self, a: int, weight: Function) -> Array:
        x, weights = self.rule
        return self.values(x, a) * np.sqrt(weights * weight(x))[:, None]

    def kin(self, other: object) -> bool:
        return isinstance(other, Polynomials) and replace(self, degree=other.degree) == other


@dataclass(frozen=True)
class Spectral(Polynomials):
    """Integrated Legendre polynomials, which vanish at x = 0.

    u_k(s) = (P_(k+1)(s) - P_(k-1)(s)) / sqrt(2 (2k + 1)) for k >= 1 and u_0 = (1 + s)/2, on s = 2x/L - 1: the derivatives of
    the former are orthonormal Legendre polynomials, so gram(1, 1) is nearly diagonal and well conditioned at any degree.
    Source: Szabo and Babuska, Finite Element Analysis, 1991, ch. 3 (hierarchic shape functions).
    """

    @property
    def size(self) -> int:
        return self.degree

    def evaluated(self, x: Array, derivative: int) -> Array:
        p = legvander(2 * x / self.length - 1, self.degree)
        k = np.arange(1, self.degree)
        if derivative:
            return np.column_stack([np.ones_like(x) / 2, np.sqrt((2 * k + 1) / 2) * p[:, 1:-1]]) * 2 / self.length
        return np.column_stack([x / self.length, (p[:, 2:] - p[:, :-2]) / np.sqrt(2 * (2 * k + 1))])


@dataclass(frozen=True)
class Bending(Polynomials):
    """Twice integrated Legendre polynomials, which vanish at x = 0 with their slope; and the function x, where it may turn.

    With orthonormal Legendre polynomials as second derivatives, gram(2, 2) is diagonal for a constant weight, and well
    conditioned at any degree for a smooth one. The function x, of no curvature, is the rigid rotation of a pinned base.
    """

    pinned: bool

    @property
    def size(self) -> int:
        return self.degree - 1 + self.pinned

    def evaluated(self, x: Array, derivative: int) -> Array:
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


@dataclass(frozen=True)
class FiniteDifference(Space):
    """The paper's uniform grid of `points` nodes, x = 0 included: second-order central differences, symmetric.

    Products of values are taken at the nodes (half a cell at the tip), with their weight; all that has a difference between
    neighbours in it is taken at the middles, with its weight there and values averaged.
    """

    points: int

    @property
    def size(self) -> int:
        return self.points - 1

    @cached_property
    def nodes(self) -> Array:
        return np.linspace(0, self.length, self.points)

    @cached_property
    def rule(self) -> tuple[Array, Array]:
        weights = np.full(self.size, self.length / self.size)
        weights[-1] /= 2
        return self.nodes[1:], weights

    @property
    def breaks(self) -> Array:
        return self.nodes

    def values(self, x: Array, derivative: int = 0) -> Array:
        """Straight lines between the nodes."""
        if derivative:
            raise NotImplementedError("A grid has differences, not derivatives.")
        h = self.nodes[1]
        return np.clip(1 - np.abs(x[:, None] - self.nodes[None, 1:]) / h, 0, None)

    def integral(self, a: int, b: int, weight: Function) -> Array:
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
    return resolved(np.pi * count / 2 * max(crowding, 1.0) - 1e-9) + 24


def resolved(functions: float) -> int:
    """A number of shape functions as a whole one. Raises ArgumentError where it is none, or too many to be reckoned with."""
    if not functions <= DEGREE_AT_MOST:
        raise ArgumentError(
            f"Argument `plant` must vary less along x, or be less taut: {functions:.3g} shape functions would be needed to "
            f"resolve it, more than {DEGREE_AT_MOST}."
        )
    return int(np.ceil(functions))
