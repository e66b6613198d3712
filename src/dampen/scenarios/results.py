"""Result files read back."""

from __future__ import annotations

from pathlib import Path

from dampen.component import ArgumentError
from dampen.scenarios.read import build, parse
from dampen.simulation.result import Result
from dampen.simulation.stores import open_result


def load(path: str | Path) -> Result:
    """A result that `dampen run` wrote, with the scenario that it carries. Raises ArgumentError for any other file."""
    path = Path(path)
    if not path.is_file():
        raise ArgumentError(f"Result file `{path}` cannot be read: there is no such file.")
    try:
        import netCDF4

        with netCDF4.Dataset(path) as file:
            text = file.getncattr("scenario")
    except (OSError, AttributeError) as error:
        raise ArgumentError(f"Result file `{path}` is not a dampen result: {error}.") from None
    return open_result(path, build(parse(text, str(path)), path.parent))
