"""A scenario: everything that one experiment consists of, as objects."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Annotated, Literal

import numpy as np
from annotated_types import Ge, Gt, Le, Unit
from typing_extensions import Doc

from dampen.component import ArgumentError, Component, wrong
from dampen.controllers.base import Controller, Setting
from dampen.disturbances.base import Disturbance
from dampen.plants.base import Plant
from dampen.simulation.kernel import MODES_AT_MOST
from dampen.stage import Stage

Positive = Annotated[float, Gt(0)]
NonNegative = Annotated[float, Ge(0)]
LARGEST_TRIAL = 4.0
NAME = re.compile(r"\w[\w.-]{0,59}")


@dataclass(frozen=True)
class Task(Component):
    """What is to be done: how many trials of what length, and within which constraint."""

    trials: Annotated[int, Ge(1), Le(100_000), Doc("number of trials")] = 25
    trial_duration: Annotated[float, Gt(0), Unit("s"), Doc("duration T_b of a trial")] = 2.0
    start: Annotated[Literal["chained"], Doc("a trial starts in the state in which the last one ended")] = "chained"
    constraint: Annotated[dict[str, Positive], Doc("for each port the displacement or angle C to stay below [m, rad]")] = field(
        default_factory=dict
    )


@dataclass(frozen=True)
class Numerics(Component):
    """How the experiment is computed."""

    discretisation: Annotated[Literal["spectral", "finite-difference"], Doc("in space")] = "spectral"
    modes: Annotated[int, Ge(1), Le(MODES_AT_MOST), Doc("number of modes kept")] = 80
    points: Annotated[int, Ge(3), Le(1001), Doc("grid points of the finite-difference grid, clamp included")] = 51
    step: Annotated[float, Gt(0), Unit("s"), Doc("time step; must divide the trial's duration")] = 0.001
    mode: Annotated[Literal["continuous"], Doc("the law acts continuously in time")] = "continuous"


@dataclass(frozen=True)
class Output(Component):
    """What is kept of the fields; port signals and energies are kept at every step."""

    points: Annotated[int, Ge(2), Le(5000), Doc("points along the structure")] = 51
    every: Annotated[int, Ge(1), Doc("steps from one snapshot to the next; must divide the number of steps")] = 10


@dataclass(frozen=True)
class Scenario(Component):
    """One experiment: plant, actuators, disturbance, controller, task, stated bounds, numerics and output.

    actuators:    for each port its chain of stages; a port that is left out has an ideal actuator.
    compensation: for each port the stages before it, on the controller's side: inverses of what the actuator is taken for.
    bounds:       what the controller is told of the disturbances: by port name [N, N m], and "f" for the load [N/m].
    claims:       name of a set of claims that the run is to be held against.
    """

    plant: Plant
    controller: Controller
    disturbance: Disturbance
    task: Task = field(default_factory=Task)
    numerics: Numerics = field(default_factory=Numerics)
    output: Output = field(default_factory=Output)
    actuators: dict[str, tuple[Stage, ...]] = field(default_factory=dict)
    compensation: dict[str, tuple[Stage, ...]] = field(default_factory=dict)
    bounds: dict[str, NonNegative] = field(default_factory=dict)
    name: str = "unnamed"
    title: str = ""
    claims: Literal["he2017"] | None = None

    def check(self) -> None:
        if not NAME.fullmatch(self.name):
            raise wrong("name", "be 1 to 60 letters, digits, dots, dashes or underscores, since it names a folder", self.name)
        names = [port.name for port in self.plant.ports]
        tables = {"task.constraint": names, "bounds": ["f", *names], "actuators": names, "compensation": names}
        for table, known in tables.items():
            given: Mapping[str, object] = self.task.constraint if table == "task.constraint" else getattr(self, table)
            for key in given:
                if key not in known:
                    raise ArgumentError(f"Argument `{table}.{key}` is not a port of this plant; known here: {', '.join(known)}.")
        if self.numerics.discretisation == "finite-difference" and not self.plant.has_grid:
            raise wrong("numerics.discretisation", 'be "spectral" for this plant', self.numerics.discretisation)
        ratio = self.task.trial_duration / self.numerics.step
        if not np.isfinite(ratio) or abs(ratio - round(ratio)) > 1e-9 * ratio or round(ratio) < 1:
            raise wrong("numerics.step", f"divide task.trial_duration = {self.task.trial_duration:g} s", self.numerics.step)
        size = self.steps * (self.numerics.modes + 60) * 8 / 2**30
        if size > LARGEST_TRIAL:
            raise wrong(
                "numerics.step", f"be larger: a trial of {self.steps} steps would need {size:.3g} GiB", self.numerics.step
            )
        if self.steps % self.output.every:
            raise wrong("output.every", f"divide the {self.steps} steps of a trial", self.output.every)
        if self.controller.uses_barrier:
            self._check_barrier(names)

    def _check_barrier(self, names: list[str]) -> None:
        start = self.plant.initial_ports()
        for name, y in zip(names, start, strict=True):
            limit = self.task.constraint.get(name)
            if limit is None:
                raise ArgumentError(f"Argument `task.constraint.{name}` must be given: the controller has a barrier there.")
            if not abs(y) < limit:
                raise wrong("plant.initial", f"put {name} inside its constraint, |y| < {limit:g}", y)
        for key in ("f", *names):
            if key not in self.bounds:
                raise ArgumentError(f"Argument `bounds.{key}` must be given: the controller relies on it.")

    @property
    def steps(self) -> int:
        """Steps in a trial."""
        return round(self.task.trial_duration / self.numerics.step)

    @property
    def limits(self) -> np.ndarray:
        """(ports,) constraint, inf where there is none."""
        return np.array([self.task.constraint.get(port.name, np.inf) for port in self.plant.ports])

    @property
    def setting(self) -> Setting:
        """What the controller is told."""
        return Setting(self.plant.ports, self.steps, self.numerics.step, self.plant.span, self.limits, self.bounds)

    def chain(self, index: int) -> tuple[Stage, ...]:
        """All stages between law and force at a port: the controller's own compensation, the scenario's, then the actuator."""
        port = self.plant.ports[index]
        return (*self.controller.compensation(port), *self.compensation.get(port.name, ()), *self.actuators.get(port.name, ()))

    def with_controller(self, controller: Controller) -> Scenario:
        """The same experiment under another controller."""
        return replace(self, controller=controller)
