"""A result: the variables of all finished trials, with the whole scenario and the version; in memory or in a NetCDF file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from dampen.component import ArgumentError
from dampen.controllers.base import Setting
from dampen.simulation.scenario import Scenario
from dampen.toml import to_toml

if TYPE_CHECKING:
    import xarray

Array = np.ndarray


@dataclass(frozen=True)
class Variable:
    """One variable of a result: its dimensions after `trial`, unit and meaning. Unit "" with a port: see the coordinates."""

    dims: tuple[str, ...]
    unit: str
    meaning: str
    kind: str = "f8"


SIGNALS = {
    "y": Variable(("time", "port"), "", "displacement (angle) at the port"),
    "energy": Variable(("time",), "J", "kinetic and potential energy of the structure, payload included"),
    "barrier_energy": Variable(("time",), "J", "energy of the law's barrier and stiffness, as the actuator's slope delivers it"),
    "compliance_energy": Variable(("time",), "J", "energy stored in the ports' numerical compliance"),
    "v": Variable(("step", "port"), "", "rate that the law sees: exactly 0 while the port sticks"),
    "command": Variable(("step", "port"), "", "the law's value"),
    "delivered": Variable(("step", "port"), "", "force (torque) that the actuator delivers"),
    "disturbance": Variable(("step", "port"), "", "disturbing force (torque) at the port"),
    "work_control": Variable(("step", "port"), "J", "work of the delivered force over the step"),
    "work_actuator": Variable(("step", "port"), "J", "part of it that is not the actuator's slope times the command"),
    "work_disturbance": Variable(("step", "port"), "J", "work of the port's disturbance over the step"),
    "work_load": Variable(("step",), "J", "work of the distributed load over the step"),
    "dissipated": Variable(("step",), "J", "energy that the structure's damping takes over the step"),
    "compliance_loss": Variable(("step",), "J", "energy dissipated by the ports' numerical compliance over the step"),
}
SAMPLES = {
    "reading": Variable(("sample", "port"), "", "displacement (angle) as the controller read it"),
    "rate_estimate": Variable(("sample", "port"), "", "rate of the tracking error as the controller estimated it"),
    "issued": Variable(("sample", "port"), "", "command as it was computed, to be held from the end of the delay on"),
}
REFERENCE = Variable(("time", "port"), "", "what the port is to follow")
STATUS = Variable((), "", "0: finished, 1: broke off", "i1")


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
        learned = {
            name: Variable((on, "port"), "", f"learned {name} after the trial") for name in scenario.controller.begin(setting)
        }
        extra = {**(SAMPLES if scenario.sampled else {}), **({"reference": REFERENCE} if scenario.task.reference else {})}
        peak = Variable(("field",), "", "largest |field| of the trial, over snapshots everywhere and over ports at every step")
        whole = {"peak": peak, "status": STATUS} if fields else {"status": STATUS}
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
        _check_names({**SIGNALS, **SAMPLES, "reference": REFERENCE, **learned, **coordinates, "peak": peak, **whole}, fields)
        return Layout(scenario, sizes, {**SIGNALS, **extra, **learned, **fields, **whole}, coordinates)

    def shape(self, variable: Variable) -> tuple[int, ...]:
        return tuple(self.sizes[dim] for dim in variable.dims)


def _check_names(taken: Mapping[str, Any], fields: Mapping[str, Any]) -> None:
    """A field stands beside the result's own variables, in a file too: it needs a name that is free and that a file can have."""
    for name in fields:
        if name in taken or name == "trial" or not name or "/" in name or not name.isprintable():
            why = "is a name that results use themselves" if name in taken or name == "trial" else "cannot stand in a file"
            raise ArgumentError(f"Argument `plant` has a field `{name}`, which {why}; give it another one.")


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
