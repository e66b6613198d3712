"""NetCDF files from elsewhere, read as data only: HDF5 can point into other files of the machine, and must not get there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from dampen.component import ArgumentError

Array = np.ndarray


def attributes(content: bytes) -> dict[str, Any]:
    """The global attributes of a file. Raises ArgumentError for what is no NetCDF file."""
    with opened(content) as file:
        return {name: file.getncattr(name) for name in file.ncattrs()}


def arrays(content: bytes, wanted: Mapping[str, tuple[str, tuple[int, ...]]], rows: int) -> dict[str, Array]:
    """The first `rows` of every wanted variable, which must have this type and this shape behind its rows.

    wanted: by name, type as NumPy writes it ("f8") and shape. Raises ArgumentError where a variable is another one.
    """
    found = {}
    with opened(content) as file:
        for name, (kind, shape) in wanted.items():
            variable = file.variables.get(name)
            if variable is None or variable.dtype != np.dtype(kind) or variable.shape[1:] != shape or len(variable) < rows:
                what = "none" if variable is None else f"{variable.dtype} of shape {variable.shape}"
                raise ArgumentError(f"Result file must have `{name}`, {kind} of shape {(rows, *shape)}, but has {what}.")
            variable.set_auto_maskandscale(False)
            found[name] = np.asarray(variable[:rows])
    return found


def plain_copy(content: bytes, path: Path, most: int) -> None:
    """Write a NetCDF file with the columns of numbers that another one has, and nothing else of it.

    most: bytes that they may take. Raises ArgumentError.
    """
    import netCDF4

    with opened(content) as file:
        columns = {name: v for name, v in file.variables.items() if v.ndim == 1 and getattr(v.dtype, "kind", "") in "fiu"}
        if 8 * sum(len(v) for v in columns.values()) > most:
            raise ArgumentError(f"Attachment must unfold to at most {most // 2**20} MiB.")
        values: dict[str, Array] = {name: np.ma.filled(np.ma.asarray(v[...], float), np.nan) for name, v in columns.items()}
    with netCDF4.Dataset(path, "w") as copy:
        for i, (name, column) in enumerate(values.items()):
            copy.createDimension(f"row{i}", len(column))
            copy.createVariable(name, "f8", (f"row{i}",))[:] = column


@contextmanager
def opened(content: bytes) -> Iterator[Any]:
    """A NetCDF file from its bytes, while no other file can be opened. Raises ArgumentError where it cannot be read so."""
    import netCDF4

    with no_more_files():
        try:
            with netCDF4.Dataset("foreign", memory=content) as file:
                yield file
        except (OSError, RuntimeError, ValueError, AttributeError, IndexError, KeyError) as error:
            if isinstance(error, ArgumentError):
                raise
            raise ArgumentError(f"This NetCDF file cannot be read: {error}.") from None


@contextmanager
def no_more_files() -> Iterator[None]:
    """The system opens no further file for this process meanwhile. Raises ArgumentError where it cannot be told so."""
    try:
        import resource
    except ImportError:
        text = "NetCDF files from a browser cannot be read safely on this system: name them to `dampen lab` instead."
        raise ArgumentError(text) from None
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (0, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
