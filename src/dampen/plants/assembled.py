"""A structure from elsewhere, known by its matrices: finite elements, a reduced model, a measured one."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import Annotated, ClassVar, Literal, TypeAlias

import numpy as np
from annotated_types import Unit
from typing_extensions import Doc

from dampen.component import Component, InFile
from dampen.plants.base import Damping, Field
from dampen.plants.discretisation import Discretisation
from dampen.plants.discretised import DiscretisedPlant
from dampen.plants.energies import MassAndStiffness
from dampen.plants.matrices import Matrices, Shape, content_hash, read_matrices
from dampen.plants.shapes import Interpolated
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


@dataclass(frozen=True, eq=False)
class DegreesOfFreedom:
    """The degrees of freedom of matrices, `size` in number, as shape functions: what each adds to which field."""

    size: int
    shapes: tuple[Shape, ...]

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, DegreesOfFreedom)
            and (self.size, len(self.shapes)) == (other.size, len(other.shapes))
            and all(
                a.name == b.name and np.array_equal(a.x, b.x) and np.array_equal(a.values, b.values)
                for a, b in zip(self.shapes, other.shapes, strict=True)
            )
        )

    def __hash__(self) -> int:
        return hash((self.size, tuple(shape.name for shape in self.shapes)))

    def kin(self, other: object) -> bool:
        return self == other

    @property
    def shared(self) -> DegreesOfFreedom:
        return self


@dataclass(frozen=True)
class Assembled(DiscretisedPlant):
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

    def space(self, count: int, grid: int | None) -> DegreesOfFreedom:
        return DegreesOfFreedom(len(self.matrices.mass), self.matrices.shapes)

    def in_space(self, space: DegreesOfFreedom) -> Discretisation:
        m = self.matrices
        return Discretisation(
            energies=MassAndStiffness(m.mass, m.stiffness),
            port_vectors=m.port_vectors,
            ports=self.ports,
            fields=tuple(Field(s.name, s.unit, Interpolated(s.x, s.values), None) for s in m.shapes),
            damping=self.damping,
            space=space,
            breaks=np.unique(np.concatenate([shape.x for shape in m.shapes])) if m.shapes else None,
            translation=None if m.translation is None else m.translation @ m.mass,
        )
