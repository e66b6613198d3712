"""A study's table as an xarray Dataset, with units and the whole scenario."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from dampen.analysis.merits import columns, merit, merit_unit
from dampen.toml import to_toml

if TYPE_CHECKING:
    import xarray

    from dampen.studies.study import Study


def dataset_of(study: Study) -> xarray.Dataset:
    """The figures of merit and the status, (member,); of a finished grid, along the grid's axes instead."""
    import xarray

    table, definition = study.table, study.definition
    data: dict[str, Any] = {}
    for name in columns(definition.scenario):
        attributes = {"units": merit_unit(name, definition.scenario), "long_name": merit(name).meaning}
        data[name] = (("member",), table[name].to_numpy(float), attributes)
    data["status"] = (("member",), table["status"].to_numpy(str))
    axes = {axis.name: (("member",), table[axis.name].to_numpy()) for axis in definition.axes}
    attributes = {"dampen_version": study.version, "scenario": to_toml(definition.scenario), "study": definition.to_toml()}
    found = xarray.Dataset(data, {"member": table["member"].to_numpy(), **axes}, attributes)
    if definition.kind != "sweep" or not study.complete:
        return found
    shape = tuple(len(axis.values) for axis in definition.axes)
    names = tuple(axis.name for axis in definition.axes)
    grid = {name: (names, np.reshape(v.to_numpy(), shape), v.attrs) for name, v in found.data_vars.items()}
    return xarray.Dataset(grid, {axis.name: list(axis.values) for axis in definition.axes}, attributes)
