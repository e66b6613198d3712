"""Modes of many plants that differ in their constants, on one basis: quick, and with shapes that are known beforehand."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dampen.plants.base import Array, Modes, Plant
from dampen.plants.discretisation import Discretisation


@dataclass(frozen=True, kw_only=True, eq=False)
class FixedBasis:
    """A basis made once from a nominal plant, on which the modes of changed ones are found by Rayleigh-Ritz.

    count:   how many modes it was made for.
    grid:    points of the finite-difference grid, if any.
    nominal: the nominal plant in its shape functions.
    columns: (dof, m) the basis, m > count as a rule.
    carrier: all m modes of the nominal plant on the basis: loads and fields need be projected on these alone.

    Frequencies come out too high, by the square of what the basis misses of a mode: for changes of some 30 percent, most in
    the highest modes, by 1e-5 of them. A plant far from the nominal one deserves modes, or a basis, of its own.
    """

    count: int
    grid: int | None
    nominal: Discretisation
    columns: Array
    carrier: Modes

    @classmethod
    def of(cls, plant: Plant, count: int, grid: int | None = None) -> FixedBasis | None:
        """A basis for `count` modes of plants like this one; None for a plant that is not known in shape functions.

        Raises ArgumentError where it has fewer modes.
        """
        nominal = _discretised(plant, count, grid, None)
        if nominal is None:
            return None
        columns = nominal.ritz_basis(count)
        carrier = nominal.on(columns).modes(columns.shape[1])
        return cls(count=count, grid=grid, nominal=nominal, columns=columns, carrier=carrier)

    def reprojected(self, plant: Plant, count: int) -> tuple[Modes, Array] | None:
        """The lowest `count` modes of a changed plant, and W (m, count): its modes in those of the carrier.

            shapes(x) = carrier shapes(x) @ W   of every field;  so modal loads are those on the carrier @ W

        `vectors` of the modes are in terms of the columns. None where the basis will not do: for more modes than it was made
        for, another length, base, grid or class, other matrices' size, or where a rigid-body motion has come or gone.
        """
        member = _discretised(plant, self.count, self.grid, self.nominal) if count <= self.count else None
        if member is None:
            return None
        reduced = member.on(self.columns)
        if not member.energies.rigid == reduced.energies.rigid == self.nominal.energies.rigid:
            return None
        modes = reduced.modes(count)
        return modes, np.linalg.solve(_vectors(self.carrier), _vectors(modes))


def _vectors(modes: Modes) -> Array:
    assert modes.vectors is not None, "modes of a discretisation have vectors"
    return modes.vectors


def _discretised(plant: Plant, count: int, grid: int | None, like: Discretisation | None) -> Discretisation | None:
    """The plant in shape functions; None too where a class of the user's own has changed `modes` and not how they are found."""
    for cls in type(plant).__mro__:
        if "discretise" in vars(cls) or "in_space" in vars(cls):
            return plant.discretise(count, grid, like)
        if "modes" in vars(cls):
            return None
    return None
