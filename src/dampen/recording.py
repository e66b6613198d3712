"""Recorded signals: named columns of a CSV or NetCDF file, pinned by the hash of its content."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Literal

import numpy as np

from dampen.component import ArgumentError, suggestion

Array = np.ndarray
Outside = Literal["zero", "hold", "repeat"]
VARIANCE = 0.999
STRAIGHT = 1e-9  # of a column's size: what round-off makes of a straight line
FINEST = 2**20


@dataclass(frozen=True)
class Recording:
    """Columns (rows,) over increasing times (rows,) [s]."""

    time: Array
    columns: Mapping[str, Array]

    def at(self, column: str, t: Array, outside: Outside = "zero") -> Array:
        """Straight lines between the rows; outside the record 0, or its first and last value, or the record again."""
        first, last = self.time[0], self.time[-1]
        if outside == "repeat":
            t = first + np.mod(t - first, last - first)
        edge = 0.0 if outside == "zero" else None
        return np.interp(t, self.time, self.columns[column], left=edge, right=edge)

    def highest_frequency(self, column: str) -> float:
        """Frequency [Hz] below which 99.9 % of a column's variance lies, about the straight line between its ends.

        The record is followed by its mirror image, backwards and upside down: without a jump or a kink where they meet, little is
        mistaken for high frequencies. A sinusoid that fills the record comes out up to 50/length too high, never too low.
        """
        count = min(FINEST, 1 + int(np.ceil((self.time[-1] - self.time[0]) / np.diff(self.time).min())))
        values = np.interp(np.linspace(self.time[0], self.time[-1], count), self.time, self.columns[column])
        scale = np.abs(values).max()
        values = values - np.linspace(values[0], values[-1], count)
        if np.abs(values).max() <= STRAIGHT * scale:
            return 0.0
        power = np.cumsum(np.abs(np.fft.rfft(np.concatenate([values, -values[-2:0:-1]]))) ** 2)
        return float(np.searchsorted(power, VARIANCE * power[-1]) / (2 * (self.time[-1] - self.time[0])))


def content_of(path: str) -> bytes:
    """The bytes of a record; raises ArgumentError for `file`."""
    try:
        if Path(path).exists() and not Path(path).is_file():  # a device or a pipe may have no end
            raise ArgumentError(f"Argument `file` must name a file, but `{path}` is none.")
        return Path(path).read_bytes()
    except (OSError, ValueError) as error:  # ValueError: no name that a file can have
        if isinstance(error, ArgumentError):
            raise
        raise _unreadable(path, error) from None


def is_netcdf(content: bytes) -> bool:
    """Whether these bytes begin like a NetCDF file."""
    return content.startswith((b"\x89HDF", b"CDF"))


def _unreadable(path: str, error: OSError | ValueError) -> ArgumentError:
    return ArgumentError(f"Argument `file` names `{path}`, which cannot be read: {getattr(error, 'strerror', None) or error}.")


def pin(recorded: Any) -> None:
    """Make the `file` of a component absolute, fill in its `sha256` where it has none, and read it then."""
    try:
        object.__setattr__(recorded, "file", str(Path(recorded.file).resolve()))
    except (OSError, ValueError) as error:
        raise _unreadable(recorded.file, error) from None
    if not recorded.sha256:
        object.__setattr__(recorded, "sha256", fingerprint(recorded.file))
        recorded.recording()


def fingerprint(path: str) -> str:
    """SHA-256 of a record's content."""
    return hashlib.sha256(content_of(path)).hexdigest()


def read_recording(path: str, sha256: str, wanted: Sequence[tuple[str, str]]) -> Recording:
    """The record in a file whose content has this hash; read again only when the file was changed.

    wanted: (argument, column) pairs, the time first; the arguments are what a complaint names. Raises ArgumentError.
    """
    try:
        state = Path(path).stat()
    except OSError as error:
        raise _unreadable(path, error) from None
    return _read(path, sha256, tuple(wanted), (state.st_mtime_ns, state.st_size))


@lru_cache(maxsize=16)
def _read(path: str, sha256: str, wanted: tuple[tuple[str, str], ...], state: tuple[int, int]) -> Recording:
    content = content_of(path)
    found = hashlib.sha256(content).hexdigest()
    if found != sha256:
        raise ArgumentError(f"Argument `sha256` must be {found[:12]}..., that of `{Path(path).name}`, but is '{sha256[:12]}...'.")
    names = [column for _, column in wanted]
    known = _netcdf_names(content) if is_netcdf(content) else _header(content, path)[0]
    for argument, column in wanted:
        if column not in known:
            raise ArgumentError(
                f"Argument `{argument}` names the column `{column}`, which `{Path(path).name}` has not{suggestion(column, known)}"
            )
    table = _netcdf(content, names, path) if is_netcdf(content) else _csv(content, names, path)
    for (argument, column), values in zip(wanted, table, strict=True):
        _check_column(argument, column, values, path)
    step = np.diff(table[0])
    if len(step) == 0 or not np.all(step > 0):
        what = f"row {int(np.argmin(step > 0)) + 2} does not" if len(step) else "there is one row"
        raise ArgumentError(f"Argument `{wanted[0][0]}` must name a column that increases from row to row, but {what}.")
    return Recording(table[0], dict(zip(names, table, strict=True)))


def _check_column(argument: str, column: str, values: Array, path: str) -> None:
    bad = np.flatnonzero(~np.isfinite(values))
    if len(bad) or not len(values):
        what = f"row {bad[0] + 1} of `{column}` is {values[bad[0]]}" if len(bad) else "it is empty"
        raise ArgumentError(f"Argument `{argument}` must name a column of finite numbers in `{Path(path).name}`, but {what}.")


def _header(content: bytes, path: str) -> tuple[list[str], str, list[str]]:
    """Column names, separator and rows of CSV text; a `#` before the names, quotes round them and blank lines are ignored."""
    try:
        lines = [line for line in content.decode("utf-8-sig").splitlines() if line.strip()]
    except UnicodeDecodeError:
        raise ArgumentError(f"Argument `file` names `{path}`, which is neither NetCDF nor UTF-8 text.") from None
    first = lines[0].lstrip("# ") if lines else ""
    separator = next((mark for mark in ",;\t" if mark in first), ",")
    return [name.strip().strip("\"'") for name in first.split(separator)], separator, lines[1:]


def _csv(content: bytes, names: list[str], path: str) -> list[Array]:
    header, separator, rows = _header(content, path)
    if not rows:
        return [np.zeros(0)] * len(names)
    try:
        table = np.loadtxt(rows, delimiter=separator, usecols=[header.index(name) for name in names], ndmin=2)
    except ValueError as error:
        reason = str(error).rstrip(".").split("; use")[0]
        raise ArgumentError(f"Argument `file` names `{Path(path).name}`, which is not a table of numbers: {reason}.") from None
    return [np.ascontiguousarray(column) for column in table.T]


def _netcdf_names(content: bytes) -> list[str]:
    import netCDF4

    with netCDF4.Dataset("record", memory=content) as file:
        return list(file.variables)


def _netcdf(content: bytes, names: list[str], path: str) -> list[Array]:
    import netCDF4

    with netCDF4.Dataset("record", memory=content) as file:
        columns: list[Array] = [np.ma.filled(np.ma.asarray(file[name][...], float), np.nan) for name in names]
    shapes = {column.shape for column in columns}
    if len(shapes) > 1 or columns[0].ndim != 1:
        given = ", ".join(f"`{name}` {column.shape}" for name, column in zip(names, columns, strict=True))
        raise ArgumentError(f"Argument `file` must have rows of equal number in `{Path(path).name}`, but has {given}.")
    return columns
