"""A structure in shape functions, before its modes are found: what modes and fixed bases are made from."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from dampen.plants.base import Array, Constant, Damping, Field, Modes, projected
from dampen.plants.energies import Energies
from dampen.port import Port

EXTRA, LEAST = 4, 8  # a basis has one mode more for every EXTRA that are wanted from it, but LEAST more at the least
SPANNED = 1e-10  # share of a deflection outside the span of a basis that is no more than round-off


@dataclass(frozen=True, kw_only=True)
class Discretisation:
    """M u_tt + K u = sum_p b_p F_p,    y_p = b_p . u,    u (dof,) the amounts of the shape functions.

    energies:     M and K, or their roots.
    port_vectors: (ports, dof), b_p is row p.
    ports:        the ports, in that order.
    fields:       with `shapes` x (points,) -> (points, dof), what each shape function adds to the field.
    damping:      proportional damping, a rule for the modes.
    space:        which shape functions these are: spaces of the same ones are equal. None: combinations of some.
    rule, breaks: as in :class:`Modes`.
    translation:  (dof,) inertia against a translation of the base; None: that of the field `w`, if the rule is known.
    """

    energies: Energies
    port_vectors: Array
    ports: tuple[Port, ...]
    fields: tuple[Field, ...]
    damping: Damping
    space: Any = None
    rule: tuple[Array, Array] | None = None
    breaks: Array | None = None
    translation: Array | None = None

    @property
    def size(self) -> int:
        """Number of shape functions."""
        return self.port_vectors.shape[1]

    def modes(self, count: int) -> Modes:
        """The lowest `count` modes. Raises ArgumentError if there are fewer shape functions."""
        omega, vectors = self.energies.solve(count)
        fields = tuple(field.on(vectors) for field in self.fields)
        return Modes(
            omega=omega,
            b=np.ascontiguousarray(self.port_vectors @ vectors),
            decay=self.damping.decay(omega),
            ports=self.ports,
            fields=fields,
            compliance=self.energies.compliance(self.port_vectors) if omega[0] > 0 else None,
            rule=self.rule,
            breaks=self.breaks,
            translation=self._translation(fields) if self.translation is None else self.translation @ vectors,
            vectors=vectors,
        )

    def on(self, basis: Array) -> Discretisation:
        """The structure held to u = basis @ v, basis (dof, columns): Rayleigh-Ritz, with the columns as shape functions.

        Its frequencies are upper bounds; their errors go with the square of the distance of the modes from the span.
        """
        translation = self._translation(self.fields) if self.translation is None else self.translation
        return replace(
            self,
            energies=self.energies.on(basis),
            port_vectors=self.port_vectors @ basis,
            fields=tuple(field.on(basis) for field in self.fields),
            space=None,
            translation=None if translation is None else translation @ basis,
        )

    def ritz_basis(self, count: int) -> Array:
        """(dof, m) columns in which `count` modes of structures not far from this one are found well: M-orthonormal.

        The lowest count + max(count/4, 8) modes of this one, or all there are, and the static deflections under unit port
        forces, which a change at a port needs most. Raises ArgumentError if there are less than `count` shape functions.
        """
        wanted = count + max(int(np.ceil(count / EXTRA)), LEAST)
        _, columns = self.energies.solve(max(count, min(wanted, self.size)))
        for deflection in self.energies.deflections(self.port_vectors).T:
            columns = _extended(columns, deflection, self.energies.mass)
        return columns

    def _translation(self, fields: tuple[Field, ...]) -> Array | None:
        """(columns,) inertia of the shapes of `fields` against w = 1; None where it is not known along x."""
        moved = next((field for field in fields if field.name == "w"), None)
        if self.rule is None or moved is None or moved.inertia is None:
            return None
        return projected(moved, self.rule, Constant(1.0))


def _extended(columns: Array, vector: Array, mass: Array) -> Array:
    """M-orthonormal `columns` (dof, m) and what `vector` (dof,) adds to their span, if anything: twice Gram-Schmidt."""
    rest = vector / np.sqrt(vector @ mass @ vector)
    for least in (SPANNED, 0.5):
        rest = rest - columns @ (columns.T @ (mass @ rest))
        length = np.sqrt(max(rest @ mass @ rest, 0.0))
        if length < least:
            return columns
        rest = rest / length
    return np.column_stack([columns, rest])
