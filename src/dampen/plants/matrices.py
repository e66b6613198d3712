"""Mass, stiffness and port vectors of a structure from elsewhere: read from where they are, and checked."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from dampen.component import ArgumentError, wrong
from dampen.port import Port

Array = np.ndarray
FILES = ("file", "mass", "stiffness", "port_vectors")
LARGEST = 4000
ASYMMETRY, NEGATIVE = 1e-9, 1e-11  # round-off that is let pass, as shares of the largest entry or eigenvalue


@dataclass(frozen=True)
class Shape:
    """A field: x (points,), values (points, dof)."""

    name: str
    unit: str
    x: Array
    values: Array


@dataclass(frozen=True)
class Matrices:
    """mass, stiffness (dof, dof), port_vectors (ports, dof), translation (dof,) or None; ports and shapes."""

    mass: Array
    stiffness: Array
    port_vectors: Array
    translation: Array | None
    ports: tuple[Port, ...]
    shapes: tuple[Shape, ...]

    def check(self) -> None:
        """Raises ArgumentError with one line for the first thing that cannot be."""
        from scipy.linalg import eigvalsh

        self._check_sizes()
        least = float(eigvalsh(self.mass, subset_by_index=(0, 0))[0])
        if not least > 0:
            raise ArgumentError(f"Argument `mass` must be positive definite, but its least eigenvalue is {least:g}.")
        squares = eigvalsh(self.stiffness, self.mass)
        if squares[0] < -NEGATIVE * np.abs(squares).max():
            what = f"its least eigenvalue against the mass is {squares[0]:g} (rad/s)^2"
            raise ArgumentError(f"Argument `stiffness` must be positive semidefinite, but {what}.")

    def _check_sizes(self) -> None:
        for name in ("mass", "stiffness"):
            _check_symmetric(name, getattr(self, name))
        dof = len(self.mass)
        _check_shape("stiffness", self.stiffness, (dof, dof), "like the mass")
        if self.port_vectors.ndim != 2 or self.port_vectors.shape[1] != dof or not len(self.port_vectors):
            raise wrong("port_vectors", f"be of shape (ports, {dof}), one row for each port", self.port_vectors.shape)
        if len(self.ports) != len(self.port_vectors):
            raise wrong("port", f"name {len(self.port_vectors)} ports, one for each port vector", len(self.ports))
        if self.translation is not None:
            _check_shape("translation", self.translation, (dof,), "one value for each degree of freedom")
        for of, names in (("port", [p.name for p in self.ports]), ("shape", [s.name for s in self.shapes])):
            if len(set(names)) < len(names) or not all(names):
                raise wrong(of, "give each its own name", names)
        for shape in self.shapes:
            if shape.x.ndim != 1 or len(shape.x) < 2 or not np.all(np.diff(shape.x) > 0):
                raise wrong("shape", f"have at least 2 points x, ascending, for `{shape.name}`", shape.x.tolist())
            _check_shape("shape", shape.values, (len(shape.x), dof), f"(points, dof), for `{shape.name}`")


def read_matrices(plant: Any) -> Matrices:
    """What an :class:`~dampen.plants.assembled.Assembled` is given, or else names in files."""
    held = _load(plant.file, "file") if plant.file else {}
    given = {name: _matrix(getattr(plant, name), name, held) for name in FILES[1:]}
    for name, value in given.items():
        if value.dtype.kind not in "fiu" or not np.all(np.isfinite(value)):
            raise ArgumentError(f"Argument `{name}` must hold finite numbers only.")
    try:
        return _read_rest(plant, held, **{name: value.astype(float) for name, value in given.items()})
    except (TypeError, ValueError, IndexError) as error:
        if isinstance(error, ArgumentError):
            raise
        raise ArgumentError(f"Argument `file` has ports, shapes or a translation of a wrong kind: {error}.") from None


def _read_rest(plant: Any, held: Mapping[str, Array], mass: Array, stiffness: Array, port_vectors: Array) -> Matrices:
    """Translation, ports and shapes, beside the matrices."""
    rigid = plant.translation or held.get("translation")
    translation = None if rigid is None or len(rigid) == 0 else np.array(rigid, float)
    shapes = tuple(Shape(s.name, s.unit, np.array(s.x), np.array(s.values)) for s in plant.shape) or _shapes(held)
    ports = tuple(Port(p.name, p.field, p.x, p.effort) for p in plant.port) or _ports(held, len(port_vectors))
    return Matrices(mass, stiffness, port_vectors, translation, ports, shapes)


def content_hash(plant: Any, expected: str) -> str:
    """sha256 of the files that `plant` names, one after the other; "" without files. Raises ArgumentError unless as expected."""
    paths = [(name, value) for name in FILES if isinstance(value := getattr(plant, name), str) and value]
    total = hashlib.sha256()
    for name, path in paths:
        try:
            if Path(path).exists() and not Path(path).is_file():  # a device or a pipe may have no end
                raise ArgumentError(
                    f"Argument `{name}` names `{path}`, which is no .npz, .npy or .mtx file: it is no file at all."
                )
            total.update(Path(path).read_bytes())
        except (OSError, ValueError) as error:  # ValueError: no name that a file can have
            if isinstance(error, ArgumentError):
                raise
            reason = getattr(error, "strerror", None) or error
            raise ArgumentError(f"Argument `{name}` names `{path}`, which cannot be read: {reason}.") from None
    found = total.hexdigest() if paths else ""
    if expected and expected != found:
        raise wrong("sha256", f"be {found or 'left out, since no file is named'}, the files' hash (have they changed?)", expected)
    return found


def _matrix(value: Any, name: str, held: Mapping[str, Array]) -> Array:
    if isinstance(value, str) and value:
        return _only(_load(value, name), name, value)
    if len(value):
        try:
            return np.array(value, float)
        except ValueError:
            raise ArgumentError(f"Argument `{name}` must have rows of one length.") from None
    if name not in held:
        raise ArgumentError(f"Argument `{name}` must be given, here or in `file`.")
    return held[name]


def _load(path: str, name: str) -> Mapping[str, Array]:
    """The arrays of a file, by name; a single matrix has the name ""."""
    try:
        if path.endswith(".mtx"):
            from scipy.io import mmread

            return {"": _dense(mmread(path))}
        loaded = np.load(path, allow_pickle=False)
        if isinstance(loaded, np.ndarray):
            return {"": loaded}
        with loaded:
            if "format" in loaded and "shape" in loaded:
                from scipy.sparse import load_npz

                return {"": _dense(load_npz(path))}
            return dict(loaded)
    except Exception as error:
        reason = f"{type(error).__name__}: {error}".splitlines()[0]
        raise ArgumentError(f"Argument `{name}` names `{path}`, which is no .npz, .npy or .mtx file: {reason}.") from None


def _only(arrays: Mapping[str, Array], name: str, path: str) -> Array:
    if "" in arrays or name in arrays:
        return arrays["" if "" in arrays else name]
    raise ArgumentError(f"Argument `{name}` names `{path}`, which has no `{name}`; it has {', '.join(arrays)}.")


def _dense(matrix: Any) -> Array:
    if matrix.shape[0] > LARGEST:
        raise ValueError(f"{matrix.shape[0]} rows; at most {LARGEST} can be solved here, condense the model first")
    return matrix.toarray() if hasattr(matrix, "toarray") else np.asarray(matrix)


def _ports(held: Mapping[str, Array], count: int) -> tuple[Port, ...]:
    if "port_names" not in held:
        return ()
    names = [str(name) for name in held["port_names"]]
    efforts, fields = held.get("port_efforts", ["force"] * count), held.get("port_fields", [""] * count)
    x = held.get("port_x", np.zeros(count))
    if not len(names) == len(efforts) == len(fields) == len(x) or not set(map(str, efforts)) <= {"force", "torque"}:
        raise ArgumentError('Argument `file` must have port_efforts ("force" or "torque"), port_x and port_fields for each port.')
    kinds: dict[str, Any] = {"force": "force", "torque": "torque"}
    return tuple(Port(n, str(f), float(p), kinds[str(e)]) for n, e, p, f in zip(names, efforts, x, fields, strict=True))


def _shapes(held: Mapping[str, Array]) -> tuple[Shape, ...]:
    if "shape_names" not in held:
        return ()
    names = [str(name) for name in held["shape_names"]]
    units = [str(unit) for unit in held.get("shape_units", ["m"] * len(names))]
    missing = [key for key in ("shape_x", *(f"shape_{name}" for name in names)) if key not in held]
    if missing or len(units) != len(names):
        raise ArgumentError(f"Argument `file` must have {missing[0] if missing else 'a unit for each shape'}.")
    x = np.array(held["shape_x"], float)
    return tuple(Shape(n, u, x, np.array(held[f"shape_{n}"], float)) for n, u in zip(names, units, strict=True))


def _check_symmetric(name: str, matrix: Array) -> None:
    if matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1] or not len(matrix):
        raise wrong(name, "be a square matrix", matrix.shape)
    if len(matrix) > LARGEST:
        raise wrong(name, f"have at most {LARGEST} rows: condense the model first", len(matrix))
    difference = np.abs(matrix - matrix.T)
    i, j = np.unravel_index(np.argmax(difference), matrix.shape)
    if difference[i, j] > ASYMMETRY * np.abs(matrix).max():
        raise ArgumentError(f"Argument `{name}` must be symmetric, but [{i}, {j}] and [{j}, {i}] differ by {difference[i, j]:g}.")


def _check_shape(name: str, array: Array, shape: tuple[int, ...], why: str) -> None:
    if array.shape != shape:
        raise wrong(name, f"be of shape {shape}, {why}", array.shape)
