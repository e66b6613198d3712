"""What a browser hands in: scenario files, results, attachments, and archives of them; read as data only."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from dampen.component import ArgumentError
from dampen.lab.foreign import arrays, attributes, plain_copy
from dampen.lab.limits import ATTACHMENT, UNPACKED
from dampen.lab.opening import attachment_name, renamed
from dampen.lab.tables import Trust, scenario_of
from dampen.recording import is_netcdf
from dampen.scenarios.read import parse
from dampen.simulation.bench import output_points
from dampen.simulation.result import Layout, Result
from dampen.simulation.setting import setting_of

ATTACHABLE = (".csv", ".txt", ".nc", ".npz", ".npy", ".mtx")
ARCHIVE = b"PK\x03\x04"
FINISHED = ("complete", "constraint_lost", "interrupted", "diverged", "controller_lost")


def contents(content: bytes, trust: Trust) -> tuple[bytes, dict[str, str]]:
    """The scenario or result in what was handed in, and what its attachments, kept by then, are called here.

    An archive, as the lab gives them out, holds one scenario or result and the files that it names.
    """
    if not content.startswith(ARCHIVE):
        return content, {}
    if unpacked(content) > UNPACKED:
        raise ArgumentError(f"An archive must unfold to at most {UNPACKED // 2**20} MiB.")
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        held = {Path(name).name: archive.read(name) for name in archive.namelist() if not name.endswith("/")}
    main = [name for name in held if name.endswith(".toml") or name == "result.nc"]
    if len(main) != 1:
        raise ArgumentError("An archive must hold one scenario (.toml) or result (result.nc), and the files that it names.")
    whole = held.pop(main[0])
    return whole, {name: attach(inner, name, trust) for name, inner in held.items()}


def table_in(content: bytes, name: str, trust: Trust, kept: Mapping[str, str]) -> dict[str, Any]:
    """The table of a scenario file, checked by building the scenario. Raises ArgumentError."""
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        raise ArgumentError(f"Scenario file `{name}` cannot be read: not UTF-8 text.") from None
    table = renamed(parse(text, name), kept)
    if "based_on" in table:
        raise ArgumentError("Argument `based_on` must be left out here: a browser hands in whole scenarios.")
    scenario_of(table, trust)
    return dict(table)


def result_in(content: bytes, trust: Trust, kept: Mapping[str, str]) -> tuple[Result, dict[str, Any]]:
    """A stored result, in memory, and its scenario's table; nothing of the file is believed. Raises ArgumentError."""
    about = attributes(content)
    text, status, trials = str(about.get("scenario", "")), about.get("status"), about.get("trials_finished")
    if not text or status not in FINISHED or not isinstance(trials, int | np.integer):
        raise ArgumentError("Result file is not a dampen result.")
    table = renamed(parse(text, "in the result"), kept)
    scenario = scenario_of(table, trust)
    if not 0 <= trials <= scenario.task.trials:
        raise ArgumentError(f"Result file must have at most the {scenario.task.trials} trials of its scenario, but has {trials}.")
    layout = Layout.of(scenario, output_points(scenario), setting_of(scenario))
    wanted = {name: (variable.kind, layout.shape(variable)) for name, variable in layout.variables.items()}
    values = arrays(content, wanted, int(trials))
    warnings = str(about.get("warnings", "")).splitlines()
    result = Result(scenario, str(about.get("dampen_version", "")), str(status), int(trials), layout, values, warnings)
    return result, dict(table)


def attach(content: bytes, name: str, trust: Trust) -> str:
    """Keep a file that a scenario may name; returns its name in the lab, which holds a hash of its content."""
    if len(content) > ATTACHMENT:
        raise ArgumentError(f"Attachment `{name}` must be at most {ATTACHMENT // 2**20} MiB, but is {len(content) / 2**20:.1f}.")
    suffix = Path(name).suffix.lower()
    if suffix not in ATTACHABLE:
        raise ArgumentError(f"Attachment `{name}` must be one of {', '.join(ATTACHABLE)}, but is {suffix or 'without suffix'!r}.")
    path = trust.attachments / attachment_name(name, content)
    if is_netcdf(content):
        plain_copy(content, path, UNPACKED)
    elif unpacked(content) > UNPACKED:
        raise ArgumentError(f"Attachment `{name}` must unfold to at most {UNPACKED // 2**20} MiB.")
    else:
        path.write_bytes(content)
    return path.name


def unpacked(content: bytes) -> int:
    """The size of what bytes unfold to: an archive's members, a sparse matrix written out; 0 for what does not unfold."""
    if content.startswith(b"%%MatrixMarket"):
        from scipy.io import mminfo

        try:
            rows, columns, *_ = mminfo(io.BytesIO(content))
        except ValueError:
            return 0
        return 8 * int(rows) * int(columns)
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            size = sum(member.file_size for member in archive.infolist())
            sparse = "shape.npy" in archive.namelist() and "format.npy" in archive.namelist()
        if not sparse or size > UNPACKED:
            return size
        with np.load(io.BytesIO(content), allow_pickle=False) as held:
            return max(size, 8 * int(np.prod(np.asarray(held["shape"], float))))
    except (zipfile.BadZipFile, ValueError, OSError, EOFError, KeyError, NotImplementedError):
        return 0
