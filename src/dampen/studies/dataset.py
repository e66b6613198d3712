"""A study's table as an xarray Dataset, with units and the whole scenario."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from dampen.analysis.merits import columns, merit, merit_unit
from dampen.release import version
from dampen.studies.definition import Definition
from dampen.toml import to_toml

if TYPE_CHECKING:
    import pandas
    import xarray


def dataset_of(definition: Definition, table: pandas.DataFrame) -> xarray.Dataset:
    """The figures of merit and the status, (member,); of a finished grid, along the grid's axes instead."""
    import xarray

    data: dict[str, Any] = {}
    for name in columns(definition.scenario):
        attributes = {"units": merit_unit(name, definition.scenario), "long_name": merit(name).meaning}
        data[name] = (("member",), table[name].to_numpy(float), attributes)
    data["status"] = (("member",), table["status"].to_numpy(str))
    axes = {axis.name: (("member",), table[axis.name].to_numpy()) for axis in definition.axes}
    attributes = {"dampen_version": version(), "scenario": to_toml(definition.scenario), "study": definition.to_toml()}
    found = xarray.Dataset(data, {"member": table["member"].to_numpy(), **axes}, attributes)
    if definition.kind != "sweep" or len(table) < definition.members:
        return found
    shape = tuple(len(axis.values) for axis in definition.axes)
    names = tuple(axis.name for axis in definition.axes)
    grid = {name: (names, np.reshape(v.to_numpy(), shape), v.attrs) for name, v in found.data_vars.items()}
    return xarray.Dataset(grid, {axis.name: list(axis.values) for axis in definition.axes}, attributes)
