"""Result files read back."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from dampen.arguments import PATH, takes
from dampen.component import ArgumentError, shown
from dampen.scenarios.read import build, parse
from dampen.simulation.result import Layout, Result
from dampen.simulation.stores import open_result

STATUSES = ("running", "complete", "constraint_lost", "interrupted", "diverged", "controller_lost")
TEXTS = ("scenario", "dampen_version", "status", "warnings")


@takes(path=PATH)
def load(path: str | Path) -> Result:
    """A result that `dampen run` wrote, with the scenario that it carries. Raises ArgumentError for any other file."""
    path = Path(path)
    try:
        known = path.is_file()
    except (OSError, ValueError):  # no name that a file can have
        known = False
    if not known:
        raise ArgumentError(f"Result file `{path}` cannot be read: {not_a_file(path)}")
    import netCDF4

    try:
        with netCDF4.Dataset(path) as file:
            about = {name: file.getncattr(name) for name in file.ncattrs()}
    except (OSError, RuntimeError, AttributeError, UnicodeDecodeError) as error:
        raise ArgumentError(f"Result file `{path}` is not a dampen result: {error}.") from None
    missing = [name for name in (*TEXTS, "trials_finished") if name not in about]
    if missing:
        raise ArgumentError(f"Result file `{path}` is not a dampen result: it has no attribute `{missing[0]}`.")
    scenario = build(parse(str(about["scenario"]), str(path)), path.parent)
    check_attributes(path, about, scenario.task.trials)
    result = open_result(path, scenario)
    check_variables(path, result.layout, result)
    return result


def not_a_file(path: Path) -> str:
    """What there is instead."""
    try:
        if path.is_dir():
            inside = path / "result.nc"
            return f"it is a folder; did you mean `{inside}`?" if inside.is_file() else "it is a folder, without a result.nc."
    except (OSError, ValueError):
        pass
    return "there is no such file."


def check_attributes(path: Path, about: dict[str, Any], most: int) -> None:
    """Raise ArgumentError where what a file says of itself is not what a result says."""
    for name in TEXTS:
        if not isinstance(about[name], str):
            raise _other(path, f"attribute `{name}` must be text, but is {shown(about[name])}")
    if about["status"] not in STATUSES:
        raise _other(path, f"attribute `status` must be one of {', '.join(STATUSES)}, but is {shown(about['status'])}")
    trials = about["trials_finished"]
    if not isinstance(trials, int | np.integer) or not 0 <= trials <= most:
        raise _other(path, f"attribute `trials_finished` must be 0 to {most}, as the scenario has trials, but is {shown(trials)}")


def check_variables(path: Path, layout: Layout, result: Result) -> None:
    """Raise ArgumentError where a variable of the scenario's result is not in the file, or is another one."""
    file = result.arrays.file  # type: ignore[attr-defined]
    for name, variable in layout.variables.items():
        found = file.variables.get(name)
        shape = layout.shape(variable)
        if found is None:
            raise _other(path, f"variable `{name}` is missing")
        if found.dtype != np.dtype(variable.kind) or found.shape[1:] != shape or len(found) < result.trials:
            must = f"be {variable.kind} of shape {(result.trials, *shape)}, as its scenario says"
            raise _other(path, f"variable `{name}` must {must}, but is {found.dtype} of shape {found.shape}")


def _other(path: Path, what: str) -> ArgumentError:
    return ArgumentError(f"Result file `{path}` is not as dampen wrote it: {what}.")
