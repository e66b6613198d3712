"""A scenario: everything that one experiment consists of, as objects."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from typing import Annotated, Literal

import numpy as np
from annotated_types import Ge, Gt, Le, Unit
from typing_extensions import Doc

from dampen.component import ArgumentError, Component, listed, own_name, wrong
from dampen.controllers.base import Controller, SampledFeedback
from dampen.controllers.none import NoControl
from dampen.disturbances.base import Disturbance
from dampen.plants.base import Plant
from dampen.simulation.kernel import MODES_AT_MOST
from dampen.simulation.sampling import Sampling
from dampen.simulation.task import Task
from dampen.stage import Stage

LARGEST_TRIAL = 4.0
NAME = re.compile(r"\w[\w.-]{0,59}")


@dataclass(frozen=True)
class Numerics(Component):
    """How the experiment is computed."""

    discretisation: Annotated[Literal["spectral", "finite-difference"], Doc("in space")] = "spectral"
    modes: Annotated[int, Ge(1), Le(MODES_AT_MOST), Doc("number of modes kept")] = 80
    points: Annotated[int, Ge(3), Le(1001), Doc("grid points of the finite-difference grid, clamp included")] = 51
    step: Annotated[float, Gt(0), Unit("s"), Doc("time step; must divide the trial's duration")] = 0.001
    mode: Annotated[
        Literal["continuous", "sampled"], Doc("continuous: the law as published; sampled: through samples, as [sampling] says")
    ] = "continuous"


@dataclass(frozen=True)
class Output(Component):
    """What is kept of the fields; port signals and energies are kept at every step."""

    points: Annotated[int, Ge(2), Le(5000), Doc("points along the structure")] = 51
    every: Annotated[int, Ge(1), Doc("steps from one snapshot to the next; must divide the number of steps")] = 10


@dataclass(frozen=True)
class Scenario(Component):
    """One experiment: plant, actuators, disturbance, controller, task, stated bounds, sampling, numerics and output.

    actuators:    for each port its chain of stages; a port that is left out has an ideal actuator.
    compensation: for each port the stages before it, on the controller's side: inverses of what the actuator is taken for.
    bounds:       what the controller is told of the disturbances: by port name [N, N m], and "f" for the load [N/m].
    claims:       name of a set of claims that the run is to be held against.
    """

    plant: Plant
    controller: Controller
    disturbance: Disturbance
    task: Task = field(default_factory=Task)
    sampling: Sampling = field(default_factory=Sampling)
    numerics: Numerics = field(default_factory=Numerics)
    output: Output = field(default_factory=Output)
    actuators: dict[str, tuple[Stage, ...]] = field(default_factory=dict)
    compensation: dict[str, tuple[Stage, ...]] = field(default_factory=dict)
    bounds: Annotated[
        dict[str, float],
        Ge(0),
        Unit("N, N m, N/m"),
        Doc("by port, and by `f` for the load along the structure: how large the disturbance is at most"),
    ] = field(default_factory=dict)
    name: str = "unnamed"
    title: str = ""
    claims: Literal["he2017"] | None = None

    def check(self) -> None:
        if not NAME.fullmatch(self.name):
            raise wrong("name", "be 1 to 60 letters, digits, dots, dashes or underscores, since it names a folder", self.name)
        self._check_ports()
        self._check_disturbance()
        self._check_grids()
        self._check_law()

    def _check_ports(self) -> None:
        named: dict[str, Iterable[str]] = {
            "task.constraint": self.task.constraint,
            "task.reference": self.task.reference,
            "task.reset_error": self.task.reset_error,
            "actuator": self.actuators,
            "compensation": self.compensation,
            **{f"sampling.{name}": table for name, table in self.sampling.by_port.items()},
        }
        for table, keys in (*named.items(), ("bounds", self.bounds)):
            known = ["f", *self.ports] if table == "bounds" else list(self.ports)
            for key in keys:
                if key not in known:
                    raise ArgumentError(f"Argument `{table}.{key}` is not a port of this plant; known here: {', '.join(known)}.")

    def _check_disturbance(self) -> None:
        for name, one in (("disturbance", self.disturbance), ("controller", self.controller)):
            for argument, port in one.ports_named().items():
                if port not in self.ports:
                    known = ", ".join(self.ports)
                    raise ArgumentError(f"Argument `{name}.{argument}` is not a port of this plant; known here: {known}.")
        fields = [name for name, _ in self.plant.fields]
        loaded = [name for part in self.disturbance.parts for name in (part.load_field, part.point_field) if name is not None]
        for name in loaded:
            if name not in fields:
                known = f"known here: {', '.join(fields)}" if fields else "it has none"
                raise ArgumentError(f"Argument `disturbance` loads `{name}`, which is not a field of this plant; {known}.")

    def _check_grids(self) -> None:
        numerics, duration = self.numerics, self.task.trial_duration
        if numerics.discretisation == "finite-difference" and not self.plant.has_grid:
            raise wrong("numerics.discretisation", 'be "spectral" for this plant', numerics.discretisation)
        if not divides(numerics.step, duration):
            raise wrong("numerics.step", f"divide task.trial_duration = {duration:g} s", numerics.step)
        size = self.steps * (numerics.modes + 60) * 8 / 2**30
        if size > LARGEST_TRIAL:
            raise wrong("numerics.step", f"be larger: a trial of {self.steps} steps would need {size:.3g} GiB", numerics.step)
        if self.steps % self.output.every:
            raise wrong("output.every", f"divide the {self.steps} steps of a trial", self.output.every)
        if self.sampled:
            period, delay = self.sampling.period, self.sampling.delay
            if not divides(period, duration):
                raise wrong("sampling.period", f"divide task.trial_duration = {duration:g} s", period)
            if not divides(numerics.step, period):
                raise wrong("sampling.period", f"be a multiple of numerics.step = {numerics.step:g} s", period)
            if delay > self.task.trials * duration:
                raise wrong("sampling.delay", f"be at most {self.task.trials * duration:g} s, all trials together", delay)
            if delay and not divides(numerics.step, delay):
                raise wrong("sampling.delay", f"be a multiple of numerics.step = {numerics.step:g} s", delay)

    def _check_law(self) -> None:
        if isinstance(self.controller, SampledFeedback) and not self.sampled:
            raise wrong(
                "numerics.mode", f'be "sampled": {type(self.controller).__name__} acts through samples', self.numerics.mode
            )
        needs = self.controller.needs_bounds
        units = {"f": "N/m", **{port.name: port.effort_unit for port in self.plant.ports}}
        needed = [*(["f"] if "f" in needs else ()), *(self.ports if "ports" in needs else ())]
        missing = [f"{key} in {units[key]}" for key in needed if key not in self.bounds]
        if missing:
            raise ArgumentError(f"Argument `bounds` must be given, {listed(missing)}: the controller relies on it.")
        if self.controller.barrier_shape == "none":
            return
        behind = [self.controller.has_barrier(port) for port in self.plant.ports]
        for port, barrier in zip(self.ports, behind, strict=True):
            if barrier and port not in self.task.constraint:
                raise ArgumentError(f"Argument `task.constraint.{port}` must be given: the controller has a barrier there.")
        low, high = self.task.limits(self.ports, np.zeros(1), 0)
        initial = self.plant.initial_ports()
        if len(initial) != len(self.ports):
            whose = f"{own_name(self.plant)}.initial_ports"
            raise ArgumentError(f"{whose} must give a number for each of {len(self.ports)} ports, but gives {len(initial)}.")
        for p, (name, y) in enumerate(zip(self.ports, initial, strict=True)):
            if behind[p] and not low[0, p] < y < high[0, p]:
                symmetric = low[0, p] == -high[0, p]
                where = f"|y| < {high[0, p]:g}" if symmetric else f"{low[0, p]:g} < y < {high[0, p]:g}"
                raise wrong("plant.initial", f"put {name} inside its constraint, {where}", y)

    @property
    def ports(self) -> tuple[str, ...]:
        """Names of the ports."""
        return tuple(port.name for port in self.plant.ports)

    @property
    def steps(self) -> int:
        """Steps in a trial."""
        return round(self.task.trial_duration / self.numerics.step)

    @property
    def times(self) -> np.ndarray:
        """(steps + 1,) clock of a trial [s]."""
        return np.arange(self.steps + 1) * self.numerics.step

    @property
    def sampled(self) -> bool:
        """Whether the law acts through samples."""
        return self.numerics.mode == "sampled"

    @property
    def by_chance(self) -> bool:
        """Whether trials differ by chance: in the disturbance, in where a reset puts the ports, or in what sensors read."""
        noise = self.sampled and any(self.sampling.noise.values())
        return self.disturbance.by_chance or any(self.task.reset_error.values()) or noise

    @property
    def law_grid(self) -> tuple[int, float]:
        """How many intervals a trial has for the law, and their length [s]."""
        period = self.sampling.period if self.sampled else self.numerics.step
        return round(self.task.trial_duration / period), period

    def reference(self, trial: int = 0) -> np.ndarray:
        """(steps + 1, ports) what the ports are to follow."""
        return self._steady[0] if self.task.steady else self.task.references(self.ports, self.times, trial)

    def limits(self, trial: int = 0) -> tuple[np.ndarray, np.ndarray]:
        """(steps + 1, ports) lower and upper limits of the displacements, infinite where there is none."""
        return self._steady[1] if self.task.steady else self.task.limits(self.ports, self.times, trial)

    @cached_property
    def _steady(self) -> tuple[np.ndarray, tuple[np.ndarray, np.ndarray]]:
        """Reference and limits, where every trial has the same: asked for many times a trial. Not to be written to."""
        reference, limits = self.task.references(self.ports, self.times, 0), self.task.limits(self.ports, self.times, 0)
        for array in (reference, *limits):
            array.flags.writeable = False
        return reference, limits

    def __getstate__(self) -> dict[str, object]:
        """For another process: what was given, not what follows from it."""
        return {f.name: getattr(self, f.name) for f in fields(self)}

    def chain(self, index: int) -> tuple[Stage, ...]:
        """All stages between law and force at a port: the controller's own compensation, the scenario's, then the actuator."""
        return self._chains[index]

    @cached_property
    def _chains(self) -> tuple[tuple[Stage, ...], ...]:
        return tuple(
            (*self.controller.compensation(port), *self.compensation.get(port.name, ()), *self.actuators.get(port.name, ()))
            for port in self.plant.ports
        )

    def with_controller(self, controller: Controller) -> Scenario:
        """The same experiment under another controller."""
        return replace(self, controller=controller)

    def uncontrolled(self) -> Scenario:
        """The same experiment without control."""
        return replace(self, controller=NoControl(), compensation={}, numerics=replace(self.numerics, mode="continuous"))

    def continuous(self) -> Scenario:
        """The same experiment with the law acting continuously."""
        return replace(self, numerics=replace(self.numerics, mode="continuous"))


def divides(part: float, whole: float) -> bool:
    """Whether `whole` is a multiple of `part`, up to rounding."""
    ratio = whole / part
    return bool(np.isfinite(ratio)) and round(ratio) >= 1 and abs(ratio - round(ratio)) <= 1e-9 * ratio
