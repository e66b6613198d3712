"""What every plant hands on: its modes, its ports and its fields."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from dampen.component import Component, wrong
from dampen.plants.gauss import gauss_legendre
from dampen.port import Port

Array = np.ndarray
Discretisation = Literal["spectral", "finite-difference"]


@dataclass(frozen=True)
class Field:
    """One field of the structure, such as w(x, t).

    shapes:   x (points,) -> (points, modes), the field's part of every mode shape.
    inertia:  distributed inertia, per metre.
    lumps:    (x, inertia) of every lumped inertia, such as the tip payload.
    """

    name: str
    unit: str
    shapes: Callable[[Array], Array]
    inertia: float
    lumps: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True)
class Modes:
    """A linear structure as its modes and its ports.

    q_i'' + omega_i^2 q_i = sum_p b_pi F_p + f_i(t),    y_p = sum_i b_pi q_i

    omega:      (modes,) angular frequencies, ascending [rad/s].
    b:          (ports, modes) port vectors, for mass-normalised modes.
    ports:      the ports, in the order of `b`.
    fields:     the fields that the modes rebuild.
    compliance: (ports, ports) static compliance of the whole discretisation, before modes were cut.
    rule:       points and weights of the rule that the mass matrix was integrated with.
    breaks:     places between which the shapes are smooth; a load is integrated piece by piece.
    """

    omega: Array
    b: Array
    ports: tuple[Port, ...]
    fields: tuple[Field, ...]
    compliance: Array
    rule: tuple[Array, Array]
    breaks: Array

    @property
    def count(self) -> int:
        return len(self.omega)

    @property
    def residual_compliance(self) -> Array:
        """(ports, ports) static compliance that the modes left out would have added."""
        return self.compliance - (self.b / self.omega**2) @ self.b.T

    def field(self, name: str) -> Field:
        return next(f for f in self.fields if f.name == name)

    def project(self, name: str, values: Callable[[Array], Array]) -> Array:
        """Modal coordinates (modes,) of the field `name` = values(x), in the mass inner product, lumps included.

        Values that contradict the boundary (a rate of 0.1 m/s at the clamp) are met in the mean, as well as modes can.
        """
        field, (x, weights) = self.field(name), self.rule
        modal = field.inertia * (weights * values(x)) @ field.shapes(x)
        for place, lump in field.lumps:
            at = np.array([place])
            modal = modal + lump * values(at) @ field.shapes(at)
        return modal

    def load_rule(self, name: str, shortest_wave: float) -> tuple[Array, Array]:
        """Points x (points,) and matrix (points, modes) such that f(x, t) @ matrix is the modal load of f on a field.

        Gauss points on every smooth piece: enough for products of the load's shortest wave [m] and the highest mode.
        """
        pieces = np.diff(self.breaks)
        waves = pieces.max() / shortest_wave + self.count / 2 / len(pieces)
        nodes, weights = gauss_legendre(32 * int(np.ceil((np.pi * waves + 20) / 32)))
        x = (self.breaks[:-1, None] + pieces[:, None] * (nodes + 1) / 2).ravel()
        w = (pieces[:, None] * weights / 2).ravel()
        return x, w[:, None] * self.field(name).shapes(x)


class Plant(Component):
    """A vibrating structure: turns its physics into :class:`Modes`. `span` is its length [m]."""

    @property
    @abstractmethod
    def ports(self) -> tuple[Port, ...]:
        """Where forces act."""

    @property
    @abstractmethod
    def fields(self) -> tuple[tuple[str, str], ...]:
        """(name, unit) of every field."""

    @property
    @abstractmethod
    def span(self) -> float:
        """Length over which fields and loads are spread [m]."""

    @abstractmethod
    def initial_ports(self) -> tuple[float, ...]:
        """Port displacements at the start of trial 0, exactly as asked for."""

    @abstractmethod
    def modes(self, count: int, discretisation: Discretisation = "spectral", points: int = 51) -> Modes:
        """The lowest `count` modes. `points` is the number of grid points of the finite-difference grid, clamp included."""

    @abstractmethod
    def initial_state(self, modes: Modes) -> tuple[Array, Array]:
        """Modal coordinates and rates, (modes,) each, at the start of trial 0."""


def solve_modes(mass: Array, stiffness: Array, count: int) -> tuple[Array, Array]:
    """Lowest `count` solutions of K v = omega^2 M v: omega ascending, and mass-normalised vectors as columns.

    Solved as M v = (1/omega^2) K v, whose largest eigenvalues are the lowest frequencies: those come out with relative
    errors near round-off, where the direct form loses the ratio of the highest to the lowest eigenvalue.
    """
    from scipy.linalg import eigh

    size = len(mass)
    if count > size:
        raise wrong("modes", f"be <= {size}, the number of modes that this discretisation has", count)
    inverse, vectors = eigh(mass, stiffness, subset_by_index=(size - count, size - 1))
    omega = 1 / np.sqrt(inverse[::-1])
    return omega, vectors[:, ::-1] * omega


def static_compliance(stiffness: Array, port_vectors: Array) -> Array:
    """(ports, ports) matrix of static port displacements per unit port force."""
    from scipy.linalg import cho_factor, cho_solve

    return port_vectors.T @ cho_solve(cho_factor(stiffness), port_vectors)


def polynomial(coefficients: Sequence[float]) -> Callable[[Array], Array]:
    """c0 + c1 x + c2 x^2 + ... as a function of x."""
    return lambda x: np.polynomial.polynomial.polyval(x, np.asarray(coefficients, float))
