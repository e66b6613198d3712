"""What a browser hands in: scenario files, results, attachments; read as data only."""

from __future__ import annotations

import hashlib
import re
import zipfile
from pathlib import Path
from typing import Any

from dampen.component import ArgumentError
from dampen.lab.limits import ATTACHMENT, UNPACKED, check_cost
from dampen.lab.tables import Trust, scenario_of
from dampen.scenarios.read import parse
from dampen.simulation.result import Result
from dampen.simulation.stores import open_result

ATTACHABLE = (".csv", ".txt", ".nc", ".npz", ".npy", ".mtx")
HDF5, CLASSIC = b"\x89HDF", b"CDF"


def is_result(content: bytes) -> bool:
    """Whether these bytes begin like a NetCDF file."""
    return content.startswith((HDF5, CLASSIC))


def table_in(content: bytes, name: str, trust: Trust) -> dict[str, Any]:
    """The table of a scenario file, checked by building the scenario. Raises ArgumentError."""
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        raise ArgumentError(f"Scenario file `{name}` cannot be read: not UTF-8 text.") from None
    table = parse(text, name)
    if "based_on" in table:
        raise ArgumentError("Argument `based_on` must be left out here: a browser hands in whole scenarios.")
    scenario_of(table, trust)
    return table


def result_in(path: Path, trust: Trust) -> tuple[Result, dict[str, Any]]:
    """A stored result and its scenario's table, nothing else of the file being believed. Raises ArgumentError."""
    import netCDF4

    try:
        with netCDF4.Dataset(path) as file:
            text = str(file.getncattr("scenario"))
    except (OSError, AttributeError, RuntimeError):
        raise ArgumentError("Result file is not a dampen result.") from None
    table = parse(text, "in the result")
    scenario = scenario_of(table, trust)
    check_cost(scenario)
    try:
        result = open_result(path, scenario)
        for name, variable in result.layout.variables.items():
            found, expected = tuple(result[name].shape[1:]), result.layout.shape(variable)
            if found != expected or len(result[name]) < result.trials:
                raise ArgumentError(f"Result file must have `{name}` of shape {expected} in each trial, but has {found}.")
    except (OSError, AttributeError, KeyError, IndexError, RuntimeError, ValueError) as error:
        if isinstance(error, ArgumentError):
            raise
        raise ArgumentError(f"Result file does not fit its own scenario: {error}.") from None
    return result, table


def attach(content: bytes, name: str, trust: Trust) -> str:
    """Keep a file that a scenario may name; returns its name in the lab, which holds a hash of its content."""
    if len(content) > ATTACHMENT:
        raise ArgumentError(f"Attachment `{name}` must be at most {ATTACHMENT // 2**20} MiB, but is {len(content) / 2**20:.1f}.")
    suffix = Path(name).suffix.lower()
    if suffix not in ATTACHABLE:
        raise ArgumentError(f"Attachment `{name}` must be one of {', '.join(ATTACHABLE)}, but is {suffix or 'without suffix'!r}.")
    stem = re.sub(r"[^A-Za-z0-9_-]+", "-", Path(name).stem).strip("-")[:40] or "file"
    path = trust.attachments / f"{stem}-{hashlib.sha256(content).hexdigest()[:8]}{suffix}"
    path.write_bytes(content)
    if suffix == ".npz" and unpacked(path) > UNPACKED:
        path.unlink()
        raise ArgumentError(f"Attachment `{name}` must unfold to at most {UNPACKED // 2**20} MiB.")
    return path.name


def unpacked(path: Path) -> int:
    """The size of what an archive holds; 0 for what is none."""
    try:
        with zipfile.ZipFile(path) as archive:
            return sum(member.file_size for member in archive.infolist())
    except zipfile.BadZipFile:
        return 0
