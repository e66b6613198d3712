"""A result: the variables of all finished trials, with the whole scenario and the version; in memory or in a NetCDF file."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from dampen.component import ArgumentError, suggestion
from dampen.controllers.base import Setting
from dampen.simulation.memory import begun
from dampen.simulation.scenario import Scenario
from dampen.simulation.variables import PEAK, REFERENCE, SAMPLES, SIGNALS, STATUS, TAKEN, Variable, why_not
from dampen.toml import to_toml

if TYPE_CHECKING:
    import xarray

Array = np.ndarray


@dataclass(frozen=True)
class Layout:
    """The shape of a result before it is filled."""

    scenario: Scenario
    sizes: Mapping[str, int]
    variables: Mapping[str, Variable]
    coordinates: Mapping[str, tuple[tuple[str, ...], Array, str]]

    @staticmethod
    def of(scenario: Scenario, x: Array, setting: Setting) -> Layout:
        plant, steps, dt = scenario.plant, scenario.steps, scenario.numerics.step
        fields = {name: Variable(("time_out", "x"), unit, f"field {name}(x, t)", "f4") for name, unit in plant.fields}
        on = "sample" if scenario.sampled else "step"
        learned = {name: Variable((on, "port"), "", f"learned {name} after the trial") for name in begun(scenario, setting)}
        _check_fields(scenario, learned)
        extra = {**(SAMPLES if scenario.sampled else {}), **(REFERENCE if scenario.task.reference else {})}
        whole = {**PEAK, **STATUS} if fields else STATUS
        time = np.arange(steps + 1) * dt
        coordinates: dict[str, tuple[tuple[str, ...], Array, str]] = {
            "time": (("time",), time, "s"),
            "step": (("step",), time[:-1] + dt / 2, "s"),
            "time_out": (("time_out",), time[:: scenario.output.every], "s"),
            "x": (("x",), x, "m"),
            "port": (("port",), np.array([p.name for p in plant.ports]), ""),
            "motion_unit": (("port",), np.array([p.motion_unit for p in plant.ports]), ""),
            "effort_unit": (("port",), np.array([p.effort_unit for p in plant.ports]), ""),
        }
        if fields:
            coordinates["field"] = (("field",), np.array(list(fields)), "")
        if scenario.sampled:
            coordinates["sample"] = (("sample",), np.arange(setting.steps) * setting.dt, "s")
        sizes = {dims[0]: len(values) for dims, values, _ in coordinates.values()}
        return Layout(scenario, sizes, {**SIGNALS, **extra, **learned, **fields, **whole}, coordinates)

    def shape(self, variable: Variable) -> tuple[int, ...]:
        return tuple(self.sizes[dim] for dim in variable.dims)


def _check_fields(scenario: Scenario, learned: Collection[str]) -> None:
    """A field stands beside the result's own variables and what the law learns, in a file too: it needs a name that is free."""
    for name, _ in scenario.plant.fields:
        if why := why_not(name, {*TAKEN, *learned}):
            raise ArgumentError(f"Argument `plant` has a field `{name}`, which {why}; give it another one.")


class UnknownVariable(ArgumentError, KeyError):
    """A result has no variable of this name."""

    def __init__(self, name: str, known: Collection[str]):
        near = suggestion(str(name), known)
        all_known = "" if near.endswith(".") else f" Known here: {', '.join(known)}."
        super().__init__(f"This result has no variable `{name}`{near}{all_known}")

    def __str__(self) -> str:
        return "\n".join(self.lines)


@dataclass
class Result:
    """What a run left. `result["y"][3]` is the port motion of trial 3; `result.dataset` is everything as an xarray Dataset.

    trials: number of finished trials.
    status: "complete", "constraint_lost", "interrupted" or "diverged"; "controller_lost" where that was a program that failed.
    warnings: thin resolution, a lost constraint, forces that did not settle; one line each.
    commands_from: what made the commands where that was not the scenario's law.
    """

    scenario: Scenario
    version: str
    status: str
    trials: int
    layout: Layout
    arrays: Mapping[str, Any]
    warnings: list[str] = field(default_factory=list)
    path: Path | None = None
    commands_from: str = ""

    def __getitem__(self, name: str) -> Any:
        """All trials of a variable, (trial, ...); from a file, read when indexed."""
        if name not in self.layout.variables:
            raise UnknownVariable(name, self.layout.variables)
        return self.arrays[name]

    @property
    def broke_off(self) -> bool:
        """Whether the run ended before its last trial did."""
        return self.status not in ("complete", "constraint_lost")

    @property
    def time(self) -> Array:
        """(steps + 1,) clock of a trial [s]."""
        return self.layout.coordinates["time"][1]

    @property
    def x(self) -> Array:
        """Output points along the structure [m]."""
        return self.layout.coordinates["x"][1]

    @property
    def time_out(self) -> Array:
        """Times of the snapshots in a trial [s]."""
        return self.layout.coordinates["time_out"][1]

    @property
    def dataset(self) -> xarray.Dataset:
        """Everything as an xarray Dataset with units, loaded."""
        import xarray

        data = {
            name: (("trial", *v.dims), np.asarray(self.arrays[name][: self.trials]), {"units": v.unit, "long_name": v.meaning})
            for name, v in self.layout.variables.items()
        }
        coords = {name: (dims, values, {"units": unit}) for name, (dims, values, unit) in self.layout.coordinates.items()}
        return xarray.Dataset(data, {**coords, "trial": np.arange(self.trials)}, attrs=self.attributes)

    @property
    def attributes(self) -> dict[str, Any]:
        return {
            "title": self.scenario.title or self.scenario.name,
            "dampen_version": self.version,
            "status": self.status,
            "trials_finished": self.trials,
            "warnings": "\n".join(self.warnings),
            "scenario": to_toml(self.scenario),
            **({"commands_from": self.commands_from} if self.commands_from else {}),
        }
