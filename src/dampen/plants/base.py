"""What every plant hands on: its modes, its ports and its fields."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, ClassVar

import numpy as np
from annotated_types import Ge, Unit
from typing_extensions import Doc

from dampen.component import ArgumentError, Component
from dampen.family import Family
from dampen.gauss import gauss_legendre
from dampen.modal import ModalModel
from dampen.plants.shapes import Combined, Shapes
from dampen.port import Port

if TYPE_CHECKING:
    from dampen.plants.discretisation import Discretisation

Array = np.ndarray


@dataclass(frozen=True)
class Field:
    """One field of the structure, such as w(x, t).

    shapes:   x (points,) -> (points, modes), the field's part of every mode shape.
    inertia:  distributed inertia per metre, a function of x (points,); None where only the matrices know it.
    lumps:    (x, inertia) of every lumped inertia, such as the tip payload.
    """

    name: str
    unit: str
    shapes: Callable[[Array], Array]
    inertia: Callable[[Array], Array] | None
    lumps: tuple[tuple[float, float], ...] = ()

    def on(self, vectors: Array) -> Field:
        """The field as the columns of `vectors` (modes, columns) rebuild it, of which each combines modes."""
        combined = self.shapes.on(vectors) if isinstance(self.shapes, Shapes) else Combined(self.shapes, vectors)
        return replace(self, shapes=combined)


@dataclass(frozen=True, kw_only=True)
class Modes(ModalModel):
    """A linear structure as its modes and its ports.

    q_i'' + 2 decay_i q_i' + omega_i^2 q_i = sum_p b_pi F_p + f_i(t),    y_p = sum_i b_pi q_i

    omega, b, decay: as in :class:`ModalModel`, ascending in omega.
    ports:       the ports, in the order of `b`.
    fields:      the fields that the modes rebuild; a structure known by its matrices alone has none.
    compliance:  (ports, ports) static compliance of the whole discretisation, before modes were cut; None if it is free to move.
    rule:        points and weights of the rule that the mass matrix was integrated with.
    breaks:      places between which the shapes are smooth; a load is integrated piece by piece.
    translation: (modes,) inertia against a translation of the base, int rho phi_i dx + M phi_i(L); None: not known.
    vectors:     (dof, modes) the modes in the shape functions of the discretisation that they were found in, if any.
    """

    ports: tuple[Port, ...]
    fields: tuple[Field, ...] = ()
    compliance: Array | None = None
    rule: tuple[Array, Array] | None = None
    breaks: Array | None = None
    translation: Array | None = None
    vectors: Array | None = None

    @property
    def residual_compliance(self) -> Array:
        """(ports, ports) static compliance that the modes left out would have added."""
        if self.compliance is None:
            raise ValueError("A structure that is free to move as a rigid body has no static compliance.")
        return self.compliance - (self.b / self.omega**2) @ self.b.T

    def field(self, name: str) -> Field:
        for field in self.fields:
            if field.name == name:
                return field
        known = ", ".join(field.name for field in self.fields) or "none"
        raise ArgumentError(f"A load along the field `{name}` needs a plant with that field; known here: {known}.")

    def project(self, name: str, values: Callable[[Array], Array]) -> Array:
        """Modal coordinates (modes,) of the field `name` = values(x), in the mass inner product, lumps included.

        Values that contradict the boundary (a rate of 0.1 m/s at the clamp) are met in the mean, as well as modes can.
        Raises ArgumentError for a structure whose inertia along x is not known: one given by its matrices.
        """
        field = self.field(name)
        if self.rule is None or field.inertia is None:
            raise ArgumentError(f"The field `{name}` cannot start from a shape: its inertia along x is not known, only matrices.")
        return projected(field, self.rule, values)

    def load_rule(self, name: str, shortest_wave: float) -> tuple[Array, Array]:
        """Points x (points,) and matrix (points, modes) such that f(x, t) @ matrix is the modal load of f on a field.

        Gauss points on every smooth piece: enough for products of the load's shortest wave [m] and the highest mode.
        Raises ArgumentError where the plant has no such field.
        """
        field = self.field(name)
        assert self.breaks is not None, "a plant with fields has breaks"
        pieces = np.diff(self.breaks)
        waves = pieces.max() / shortest_wave + self.count / 2 / len(pieces)
        nodes, weights = gauss_legendre(32 * int(np.ceil((np.pi * waves + 20) / 32)))
        x = (self.breaks[:-1, None] + pieces[:, None] * (nodes + 1) / 2).ravel()
        w = (pieces[:, None] * weights / 2).ravel()
        return x, w[:, None] * field.shapes(x)


def projected(field: Field, rule: tuple[Array, Array], values: Callable[[Array], Array]) -> Array:
    """(modes,) int inertia(x) values(x) shapes(x) dx by the points and weights of `rule`, and the same for every lump."""
    assert field.inertia is not None, "what has a rule has an inertia along x"
    x, weights = rule
    modal = (weights * field.inertia(x) * values(x)) @ field.shapes(x)
    for place, lump in field.lumps:
        at = np.array([place])
        modal = modal + lump * values(at) @ field.shapes(at)
    return modal


class Plant(Family):
    """A vibrating structure: turns its physics into :class:`Modes`. Needs `ports` and `modes`; the rest has defaults."""

    has_grid: ClassVar[bool] = False  # whether `modes` knows a finite-difference grid

    @property
    @abstractmethod
    def ports(self) -> tuple[Port, ...]:
        """Where forces act."""

    @abstractmethod
    def modes(self, count: int, grid: int | None = None) -> Modes:
        """The lowest `count` modes, of the spectral discretisation or of a finite-difference grid of `grid` points.

        Raises ArgumentError where there are fewer. Without `has_grid`, `grid` is never given and may be left out.
        """

    def discretise(self, count: int, grid: int | None = None, like: Discretisation | None = None) -> Discretisation | None:
        """The structure in the shape functions that `modes` finds its modes in; None for a plant that tells only its modes.

        With `like`, it is put on the shape functions of that one, whatever `count` would ask for, so that matrices of both
        belong to the same; None where it cannot be: with another length, base, grid, ports or fields.
        """
        return None

    @property
    def fields(self) -> tuple[tuple[str, str], ...]:
        """(name, unit) of every field."""
        return ()

    @property
    def span(self) -> float:
        """Length over which fields and loads are spread [m]."""
        return max(port.x for port in self.ports)

    def initial_ports(self) -> tuple[float, ...]:
        """Port displacements at the start of trial 0, exactly as asked for."""
        return (0.0,) * len(self.ports)

    def initial_state(self, modes: Modes) -> tuple[Array, Array]:
        """Modal coordinates and rates, (modes,) each, at the start of trial 0."""
        return np.zeros(modes.count), np.zeros(modes.count)


@dataclass(frozen=True)
class Damping(Component):
    """Proportional damping: decay_i = ratio omega_i + kelvin_voigt omega_i^2 / 2 + viscous / 2, the sum of what is given.

    `ratio` is one number for all modes, or a list for the lowest, whose last number goes for all above. Kelvin-Voigt: every
    stress is E (strain + kelvin_voigt strain rate), in bending and shear alike. Viscous: every mass, payload included, is
    dragged by viscous times mass times velocity.
    """

    ratio: Annotated[float | tuple[float, ...], Ge(0), Doc("modal damping ratio: one for all, or a list, lowest first")] = 0.0
    kelvin_voigt: Annotated[float, Ge(0), Unit("s"), Doc("retardation time of the material")] = 0.0
    viscous: Annotated[float, Ge(0), Unit("1/s"), Doc("drag per mass")] = 0.0

    def decay(self, omega: Array) -> Array:
        """(modes,) decay rates [1/s]."""
        given = np.atleast_1d(np.asarray(self.ratio, float))
        ratio = given[np.minimum(np.arange(len(omega)), len(given) - 1)]
        return np.asarray(ratio * omega + self.kelvin_voigt * omega**2 / 2 + self.viscous / 2)


def polynomial(coefficients: Sequence[float]) -> Callable[[Array], Array]:
    """c0 + c1 x + c2 x^2 + ... as a function of x; 0 without coefficients."""
    return lambda x: np.polynomial.polynomial.polyval(x, np.asarray(tuple(coefficients) or (0.0,), float))


@dataclass(frozen=True)
class Constant:
    """`value`, as a function of x: x (points,) -> (points,)."""

    value: float

    def __call__(self, x: Array) -> Array:
        return np.full(len(x), self.value)
