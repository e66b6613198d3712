"""Kinetic and elastic energy of a structure in shape functions, in the form that its modes are best found from."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from dampen.plants.eigen import elastic_shift, rigid_modes, solve_modes, solve_roots, static_compliance

Array = np.ndarray
PURE = 1e-6  # largest omega^2, as a share of the first elastic one, of a column that is a rigid motion but for round-off


class Energies(ABC):
    """Kinetic energy u_t^T M u_t / 2 and elastic energy u^T K u / 2; M and K (dof, dof)."""

    mass: Array
    stiffness: Array

    @abstractmethod
    def solve(self, count: int) -> tuple[Array, Array]:
        """omega (count,), ascending, and mass-normalised vectors (dof, count). Raises ArgumentError where there are fewer."""

    @abstractmethod
    def on(self, basis: Array) -> Energies:
        """The energies of u = basis @ v, a motion in the span of the columns of `basis` (dof, columns).

        Columns that are rigid-body motions but for round-off have no stiffness at all.
        """

    @cached_property
    def rigid(self) -> int:
        """Number of independent motions without stiffness."""
        return rigid_modes(self.stiffness)

    def compliance(self, forces: Array) -> Array:
        """(forces, forces) static displacements against `forces` (forces, dof) under unit forces."""
        return static_compliance(self.stiffness, forces.T)

    def deflections(self, forces: Array) -> Array:
        """(dof, forces) static deflections under `forces` (forces, dof).

        A structure that is free to move as a rigid body is held by springs in proportion to the mass, such that all motions
        are about as soft as the first elastic mode.
        """
        from scipy.linalg import cho_factor, cho_solve

        shift = elastic_shift(self.mass, self.stiffness, self.rigid) if self.rigid else 0.0
        return cho_solve(cho_factor(self.stiffness + shift * self.mass), forces.T)


@dataclass(frozen=True)
class MassAndStiffness(Energies):
    """Energies by their matrices M and K. `small`: all modes are found at once, which is quicker if most are wanted."""

    mass: Array
    stiffness: Array
    small: bool = False

    def solve(self, count: int) -> tuple[Array, Array]:
        return solve_modes(self.mass, self.stiffness, count, at_once=self.small)

    def on(self, basis: Array) -> MassAndStiffness:
        mass, stiffness = (_symmetric(basis.T @ (matrix @ basis)) for matrix in (self.mass, self.stiffness))
        if self.rigid:
            free = _rigid_columns(np.diag(mass), np.diag(stiffness), self.rigid)
            stiffness[free] = stiffness[:, free] = 0.0
        return MassAndStiffness(mass, stiffness, small=True)


@dataclass(frozen=True)
class Roots(Energies):
    """Energies by roots of their matrices, M = unit A^T A and K = unit B^T B; A and B (points, dof).

    unit: a power of two that goes with the masses, so that roots of the same structure in other units of mass are the same.
    """

    mass_root: Array
    stiffness_root: Array
    unit: float = 1.0

    @cached_property
    def mass(self) -> Array:  # type: ignore[override]
        return self.unit * (self.mass_root.T @ self.mass_root)

    @cached_property
    def stiffness(self) -> Array:  # type: ignore[override]
        return self.unit * (self.stiffness_root.T @ self.stiffness_root)

    def solve(self, count: int) -> tuple[Array, Array]:
        omega, vectors = solve_roots(self.mass_root, self.stiffness_root, count)
        return omega, vectors / np.sqrt(self.unit)

    def on(self, basis: Array) -> Roots:
        mass_root, stiffness_root = self.mass_root @ basis, self.stiffness_root @ basis
        if self.rigid:
            free = _rigid_columns(np.sum(mass_root**2, axis=0), np.sum(stiffness_root**2, axis=0), self.rigid)
            stiffness_root[:, free] = 0.0
        return Roots(_triangle(mass_root), _triangle(stiffness_root), self.unit)


def _rigid_columns(mass: Array, stiffness: Array, rigid: int) -> Array:
    """Which columns, of mass and stiffness (columns,), are rigid-body motions: `rigid` at most."""
    squares = stiffness / mass
    softest = np.argsort(squares)
    first_elastic = squares[softest[rigid]] if rigid < len(squares) else np.inf
    return softest[:rigid][squares[softest[:rigid]] < PURE * first_elastic]


def _symmetric(matrix: Array) -> Array:
    return (matrix + matrix.T) / 2


def _triangle(root: Array) -> Array:
    """The square root of the same matrix, (columns, columns)."""
    return np.asarray(np.linalg.qr(root, mode="r"))
