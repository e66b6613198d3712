"""Models and results as .mat and .npz files."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from dampen.archive import whole_file
from dampen.component import ArgumentError
from dampen.export.linear import LinearModel
from dampen.release import version
from dampen.simulation.result import Result
from dampen.simulation.scenario import Scenario
from dampen.toml import to_toml

Array = np.ndarray
LARGEST = 2**31 - 1024  # bytes of a variable in a .mat file


def write_model(path: Path, model: LinearModel, scenario: Scenario) -> None:
    """A, B, C, D, dt (0: continuous), names and units of states, inputs and outputs, the scenario as TOML and the version."""
    content: dict[str, Any] = {"A": model.a, "B": model.b, "C": model.c, "D": model.d, "dt": model.dt}
    for key in ("states", "inputs", "outputs"):
        names, units = zip(*getattr(model, key), strict=True)
        content |= {f"{key[:-1]}_names": np.array(names), f"{key[:-1]}_units": np.array(units)}
    write(path, content | {"scenario": to_toml(scenario), "dampen_version": version()})


def write_result(path: Path, result: Result) -> None:
    """Every variable of a result, (trial, ...), its coordinates, and as structs by name its `dims`, `units` and `meaning`."""
    variables = {matlab_name(name): variable for name, variable in result.layout.variables.items()}
    content: dict[str, Any] = {matlab_name(name): np.asarray(result[name][: result.trials]) for name in result.layout.variables}
    coordinates = {f"at_{name}": values for name, (_, values, _) in result.layout.coordinates.items()}
    about = {
        "dims": {name: ",".join(("trial", *v.dims)) for name, v in variables.items()},
        "units": {name: v.unit or "by port or field" for name, v in variables.items()},
        "meaning": {name: v.meaning for name, v in variables.items()},
    }
    if path.suffix == ".npz":
        about = {f"{what}_{name}": text for what, table in about.items() for name, text in table.items()}  # type: ignore[misc]
    attributes = {f"run_{name}" if name == "status" else name: v for name, v in result.attributes.items() if v != ""}
    write(path, content | coordinates | about | attributes)


def write(path: Path, content: Mapping[str, Any]) -> None:
    """Write a .mat file (version 5: MATLAB, Octave, scipy.io) or an .npz file, as the path's ending says."""
    check_ending(path)
    large = [name for name, value in content.items() if isinstance(value, np.ndarray) and value.nbytes > LARGEST]
    if large and path.suffix == ".mat":
        raise ArgumentError(f"Output file `{path}` cannot hold `{large[0]}`, more than 2 GB; an .npz file can.")
    with whole_file(path) as file:
        fill(file, path.suffix, content)


def fill(file: BinaryIO, ending: str, content: Mapping[str, Any]) -> None:
    """Write to an open file what goes into a .mat or an .npz file."""
    if ending == ".npz":
        arrays: dict[str, Any] = {name: np.asarray(value) for name, value in content.items()}
        np.savez_compressed(file, **arrays)
        return
    from scipy.io import savemat

    cased = {name: cells(value) for name, value in content.items()}
    savemat(file, cased, long_field_names=True, do_compression=True)  # type: ignore[arg-type]  # the stubs know no open file


def check_ending(path: Path) -> None:
    """Raise ArgumentError for a path that says neither .mat nor .npz."""
    if path.suffix not in (".mat", ".npz"):
        raise ArgumentError(f"Output file `{path}` must end in .mat or .npz.")


def cells(value: Any) -> Any:
    """A list of texts as a cell array, all else as it is."""
    return value.astype(object) if isinstance(value, np.ndarray) and value.dtype.kind == "U" else value


def matlab_name(name: str) -> str:
    """A variable's name as MATLAB takes it."""
    plain = re.sub(r"\W", "_", name, flags=re.ASCII)[:60]
    return plain if plain[:1].isalpha() else f"v_{plain}"
