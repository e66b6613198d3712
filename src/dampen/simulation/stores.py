"""Where the trials of a run are written as they finish: memory, or a NetCDF file that is readable after every trial."""

from __future__ import annotations

import shutil
from abc import ABC, abstractmethod
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from dampen.component import ArgumentError
from dampen.release import version
from dampen.simulation.cost import check_disk, check_memory
from dampen.simulation.result import Layout, Result

Array = np.ndarray


class Store(ABC):
    """Takes trials one by one; `close` turns it into a Result. commands_from: to be set before `open`, as in the result."""

    commands_from: str = ""

    @abstractmethod
    def open(self, layout: Layout, warnings: list[str]) -> None:
        """Prepare for the trials of a scenario."""

    @abstractmethod
    def write(self, trial: int, record: Mapping[str, Any]) -> None:
        """Add a trial."""

    @abstractmethod
    def close(self, status: str, trials: int) -> Result:
        """Finish; `trials` is the number of trials that went to their end."""


class MemoryStore(Store):
    """Keeps everything in memory."""

    def open(self, layout: Layout, warnings: list[str]) -> None:
        check_memory(layout)
        self.layout, self.warnings = layout, warnings
        trials = layout.scenario.task.trials
        self.arrays = {name: np.zeros((trials, *layout.shape(v)), v.kind) for name, v in layout.variables.items()}

    def write(self, trial: int, record: Mapping[str, Any]) -> None:
        with np.errstate(over="ignore"):  # fields beyond single precision: the trial then counts as broken off
            for name, array in self.arrays.items():
                array[trial] = record[name]

    def close(self, status: str, trials: int) -> Result:
        kept = {name: array[:trials] for name, array in self.arrays.items()}
        return Result(
            self.layout.scenario, version(), status, trials, self.layout, kept, self.warnings, commands_from=self.commands_from
        )


class FileStore(Store):
    """Writes to a NetCDF file, trial by trial; memory does not grow with the number of trials.

    Signals are kept as they are (double precision, incompressible), fields in single precision and compressed.
    """

    def __init__(self, path: Path):
        self.path = path

    def open(self, layout: Layout, warnings: list[str]) -> None:
        import netCDF4

        self.layout, self.warnings = layout, warnings
        try:
            check_disk(layout, self.path)
            self.file = netCDF4.Dataset(self.path, "w", format="NETCDF4")
        except OSError as error:
            raise ArgumentError(f"Result file `{self.path}` cannot be written: {error.strerror or error}.") from None
        self.file.createDimension("trial", None)
        for name, size in layout.sizes.items():
            self.file.createDimension(name, size)
        for name, (dims, values, unit) in layout.coordinates.items():
            variable = self.file.createVariable(name, str if values.dtype.kind == "U" else "f8", dims)
            variable[:] = values.astype(object) if values.dtype.kind == "U" else values
            if unit:
                variable.units = unit
        for name, v in layout.variables.items():
            packing: dict[str, Any] = {"zlib": True, "complevel": 4} if v.kind == "f4" else {}
            chunks = (1, *layout.shape(v))
            held = int(np.prod(chunks)) * np.dtype(v.kind).itemsize  # one trial: more would only fill memory
            variable = self.file.createVariable(
                name, v.kind, ("trial", *v.dims), chunksizes=chunks, chunk_cache=max(held, 1024), **packing
            )
            variable.set_auto_mask(False)
            variable.long_name = v.meaning
            if v.unit:
                variable.units = v.unit
        self._describe("running", 0)

    def write(self, trial: int, record: Mapping[str, Any]) -> None:
        try:
            for name in self.layout.variables:
                self.file[name][trial] = record[name]
            self.file.setncattr("trials_finished", trial + (record["status"] == 0))
        except (OSError, RuntimeError) as error:
            raise self._full(trial, error) from None

    def _full(self, trial: int, error: Exception) -> ArgumentError:
        """What is said of a disk that takes no more: HDF5 tells no reason of its own."""
        free = shutil.disk_usage(self.path.absolute().parent).free
        return ArgumentError(
            f"Result file `{self.path}` cannot be written beyond trial {trial}: {error}; {free / 2**20:.1f} MiB are free there."
        )

    def close(self, status: str, trials: int) -> Result:
        try:
            self._describe(status, trials)
            self.file.close()
        except (OSError, RuntimeError) as error:
            raise self._full(trials, error) from None
        return open_result(self.path, self.layout.scenario)

    def _describe(self, status: str, trials: int) -> None:
        result = Result(
            self.layout.scenario, version(), status, trials, self.layout, {}, self.warnings, commands_from=self.commands_from
        )
        self.file.setncatts(result.attributes)


class FileArrays(Mapping[str, Any]):
    """The variables of a NetCDF file, read when indexed."""

    def __init__(self, file: Any, names: list[str]):
        self.file, self.names = file, names

    def __getitem__(self, name: str) -> Any:
        if name not in self.names:
            raise KeyError(name)
        variable = self.file[name]
        variable.set_auto_mask(False)
        return variable

    def __iter__(self) -> Any:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)


def open_result(path: Path, scenario: Any) -> Result:
    """A result file, opened for reading; `scenario` is the one that the file carries."""
    import netCDF4

    from dampen.simulation.bench import output_points
    from dampen.simulation.setting import setting_of

    file = netCDF4.Dataset(path)
    layout = Layout.of(scenario, output_points(scenario), setting_of(scenario))
    attributes = {name: file.getncattr(name) for name in file.ncattrs()}
    return Result(
        scenario, attributes["dampen_version"], attributes["status"], int(attributes["trials_finished"]), layout,
        FileArrays(file, list(layout.variables)), attributes["warnings"].splitlines(), path, attributes.get("commands_from", ""),
    )  # fmt: skip
