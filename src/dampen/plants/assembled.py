"""A structure from elsewhere, known by its matrices: finite elements, a reduced model, a measured one."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Annotated, ClassVar, Literal, TypeAlias

import numpy as np
from annotated_types import Unit
from typing_extensions import Doc

from dampen.component import Component, InFile
from dampen.plants.base import Damping, Field, Modes, Plant
from dampen.plants.eigen import solve_modes, static_compliance
from dampen.plants.matrices import Matrices, content_hash, interpolation, read_matrices
from dampen.port import Port

Rows: TypeAlias = tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class AssembledPort(Component):
    """A place where a force acts on an assembled structure; its row of `port_vectors` says on what."""

    name: Annotated[str, Doc("name of the port")]
    effort: Annotated[Literal["force", "torque"], Doc("what acts there")] = "force"
    x: Annotated[float, Unit("m"), Doc("where along the structure")] = 0.0
    field: Annotated[str, Doc("the field whose value it sees, if there are shapes")] = ""


@dataclass(frozen=True)
class AssembledShape(Component):
    """A field of an assembled structure: its values at points x for every degree of freedom, straight lines in between."""

    name: Annotated[str, Doc("name of the field")]
    x: Annotated[tuple[float, ...], Unit("m"), Doc("points, ascending")]
    values: Annotated[Rows, Doc("(points, dof) values of the field per unit of each degree of freedom")]
    unit: Annotated[str, Doc("unit of the field")] = "m"


@dataclass(frozen=True)
class Assembled(Plant):
    """A structure given by its mass and stiffness matrices and port vectors.

        M u_tt + K u = sum_p b_p F_p + M r (-a),    y_p = b_p . u

    M symmetric positive definite, K symmetric positive semidefinite, (dof, dof); b_p is row p of `port_vectors`; r is the
    `translation`, the degrees of freedom under a unit translation of the base, which base accelerations a need.

    Matrices are nested lists or arrays (in Python: SciPy's sparse ones too), or names of files: `.mtx` (MatrixMarket),
    `.npy`, or `.npz` as SciPy saves a sparse matrix. What is not given is taken from `file`, an `.npz` by `numpy.savez`
    with the keys

        mass, stiffness (dof, dof)    port_vectors (ports, dof)    translation (dof,), optional
        port_names, port_efforts ("force" or "torque"), port_x, port_fields (ports,): all optional
        shape_names, shape_units (fields,), shape_x (points,), shape_NAME (points, dof) for every field NAME: all optional

    Ports are as named in `port`, fields as given in `shape`; without shapes there are no fields, and no load along the
    structure. It starts at rest: from matrices alone no shape w(x, 0) can be turned into degrees of freedom.
    """

    kind: ClassVar[str] = "assembled"

    file: Annotated[str, InFile(), Doc(".npz that holds what is not given here")] = ""
    mass: Annotated[Rows | str, InFile(), Doc("mass matrix M, or its file")] = ()
    stiffness: Annotated[Rows | str, InFile(), Doc("stiffness matrix K, or its file")] = ()
    port_vectors: Annotated[Rows | str, InFile(), Doc("(ports, dof), or its file")] = ()
    translation: Annotated[tuple[float, ...], Doc("degrees of freedom under a unit translation of the base")] = ()
    port: Annotated[tuple[AssembledPort, ...], Doc("the ports, in the order of their vectors")] = ()
    shape: Annotated[tuple[AssembledShape, ...], Doc("the fields, if any")] = ()
    sha256: Annotated[str, Doc("hash of the files' content, in the order above: filled in, and compared when given")] = ""
    damping: Annotated[Damping, Doc("proportional damping")] = field(default_factory=Damping)

    def check(self) -> None:
        found = content_hash(self, self.sha256)
        object.__setattr__(self, "sha256", found)
        self.matrices.check()

    @cached_property
    def matrices(self) -> Matrices:
        """Everything, from here and from files."""
        return read_matrices(self)

    @property
    def ports(self) -> tuple[Port, ...]:
        return self.matrices.ports

    @property
    def fields(self) -> tuple[tuple[str, str], ...]:
        return tuple((shape.name, shape.unit) for shape in self.matrices.shapes)

    @property
    def span(self) -> float:
        return max([port.x for port in self.ports] + [float(shape.x[-1]) for shape in self.matrices.shapes])

    def modes(self, count: int, grid: int | None = None) -> Modes:
        """The lowest `count` modes. Raises ArgumentError if there are fewer degrees of freedom."""
        m = self.matrices
        omega, vectors = solve_modes(m.mass, m.stiffness, count)
        places = np.unique(np.concatenate([shape.x for shape in m.shapes])) if m.shapes else None
        return Modes(
            omega=omega,
            b=np.ascontiguousarray(m.port_vectors @ vectors),
            decay=self.damping.decay(omega),
            ports=self.ports,
            fields=tuple(Field(s.name, s.unit, interpolation(s.x, s.values @ vectors), None) for s in m.shapes),
            compliance=static_compliance(m.stiffness, m.port_vectors.T) if omega[0] > 0 else None,
            breaks=places,
            translation=None if m.translation is None else m.translation @ m.mass @ vectors,
        )
