"""What of a scenario goes into the C controller: tables, law, learning, limits; and what cannot go there."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dampen.component import ArgumentError, is_whole, own_name, wrong
from dampen.controllers.base import Controller, SampledFeedback, Setting
from dampen.controllers.none import NoControl
from dampen.controllers.norm_optimal_ilc import NormOptimalILC
from dampen.controllers.p_type_ilc import PTypeILC
from dampen.controllers.pointwise import PointwiseLearning
from dampen.own import own
from dampen.simulation.bench import Bench
from dampen.simulation.compiled import bind
from dampen.simulation.compose import BARRIERS
from dampen.simulation.digital import Sampler
from dampen.simulation.digital_law import port_law
from dampen.simulation.digital_side import prepare, sampler_of
from dampen.simulation.memory import begun
from dampen.simulation.passes import law_of
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import of_trial, setting_of

Array = np.ndarray
ROOM = 2.0  # readings are believed up to so many times the constraint's half-width from its middle
FAR = 1e3  # m, rad: where a port has no constraint
HUGE = 1e30  # m, rad: what a float can still be added to
PATIENCE = 30_000  # readings: an int of any processor can count them
LARGEST = 3.4028234663852886e38, 1.7976931348623157e308  # float, double


@dataclass(frozen=True)
class Guards:
    """How the controller looks after itself: readings by port name outside [low, high] are not believed, nor after `patience`
    of them in a row the sensor; whether it stops where the constraint is crossed."""

    believed: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    patience: int = 5
    stop_at_constraint: bool = True

    def check(self, ports: Sequence[str]) -> None:
        """Raise ArgumentError for what no controller could look after itself with."""
        if not (is_whole(self.patience) and 0 <= self.patience <= PATIENCE):
            raise wrong("patience", f"be a whole number from 0 to {PATIENCE}", self.patience)
        for name, ends in self.believed.items():
            if name not in ports:
                raise ArgumentError(f"Option `--range {name}` is not a port of this plant; known here: {', '.join(ports)}.")
            low, high = ends
            if not -HUGE <= low < high <= HUGE:
                raise ArgumentError(
                    f"Option `--range {name}` must have LOW < HIGH, both of at most {HUGE:g}, but has {low:g}:{high:g}."
                )


@dataclass(frozen=True)
class Blueprint:
    """A scenario's sampled controller as numbers and functions.

    law: the function of a sample; parameters, states: of it.   feedforward, coulomb (samples, ports): without what is learned.
    reference (samples + 1, ports), low, high (samples, ports): of the tracking error.   believed (ports, 2): readings.
    tunable: whether the law's parameters and the output limits stand in the record, to be changed while it runs.
    """

    scenario: Scenario
    setting: Setting
    single: bool
    guards: Guards
    law: Callable[..., None]
    sampler: Sampler
    believed: Array
    tunable: bool = False

    @property
    def controller(self) -> Controller:
        return self.scenario.controller

    @property
    def ports(self) -> int:
        return len(self.setting.ports)

    @property
    def samples(self) -> int:
        return self.setting.steps

    @property
    def ceiling(self) -> Array:
        """(ports,) the output's limit: as stated, in float the next number that is not beyond it, or the largest there is."""
        stated = np.minimum(self.sampler.ceiling, LARGEST[not self.single])
        if not self.single:
            return stated
        rounded = stated.astype(np.float32)
        return np.where(rounded > stated, np.nextafter(rounded, np.float32(0)), rounded).astype(float)

    @property
    def learning(self) -> str:
        """How it learns: "pointwise", "gains", "lifted" or "none"."""
        for cls, how in ((PointwiseLearning, "pointwise"), (PTypeILC, "gains"), (NormOptimalILC, "lifted")):
            if isinstance(self.controller, cls):
                return how
        return "none"


def blueprint(
    scenario: Scenario, single: bool = False, guards: Guards | None = None, bench: Bench | None = None, tunable: bool = False
) -> Blueprint:
    """The scenario's controller, ready to be written in C. Raises ArgumentError where that cannot be done."""
    refuse(scenario)
    guards = guards or Guards()
    guards.check(scenario.ports)
    bench = bench or Bench(scenario)
    setting = setting_of(scenario, bench=bench)
    refuse_wandering(scenario, setting)
    law = law_of(scenario, begun(scenario, setting), setting)
    sampler = prepare(sampler_of(scenario, setting), scenario, setting, law, 0)
    law_itself, readings = law_function(scenario), believed(scenario, setting, guards)
    return Blueprint(scenario, setting, single, guards, law_itself, sampler, readings, tunable)


def refuse(scenario: Scenario) -> None:
    """One clear line for what has no sampled controller that could be written in C."""
    controller = scenario.controller
    if own(type(controller)):
        raise ArgumentError(
            f"Argument `controller` is {own_name(controller)}, Python of your own, which cannot be exported as C: "
            "only the shipped laws can."
        )
    if isinstance(controller, NoControl):
        raise ArgumentError("Argument `controller` is none: there is nothing to export as C.")
    if not scenario.sampled:
        raise ArgumentError(
            'Argument `numerics.mode` must be "sampled" for an export as C, but is "continuous": what runs on a processor acts '
            "through samples. Try `--set numerics.mode=sampled`, and look at the run first."
        )
    known = isinstance(controller, PointwiseLearning | PTypeILC | NormOptimalILC)
    if not known and type(controller).learn is not Controller.learn:
        raise ArgumentError(f"Argument `controller` is {own_name(controller)}, whose learning cannot be exported as C.")
    for p, port in enumerate(scenario.ports):
        for stage in compensation(scenario, p):
            if own(type(stage)):
                raise ArgumentError(
                    f"Argument `compensation.{port}` has {own_name(stage)}, Python of your own, which cannot be exported as C."
                )


def refuse_wandering(scenario: Scenario, setting: Setting) -> None:
    """Reference and constraint become tables for one trial: every trial must have the same."""
    for trial in range(1, scenario.task.trials):
        if scenario.task.steady:
            return
        other = of_trial(setting, scenario, trial)
        for name in ("reference", "low", "high"):
            if not np.array_equal(getattr(setting, name), getattr(other, name)):
                raise ArgumentError(
                    "Argument `task` must have the same reference and constraint in every trial for an export as C, but those "
                    f"of trial {trial} are not those of trial 0."
                )


def compensation(scenario: Scenario, port: int) -> tuple[Any, ...]:
    """The stages on the controller's side of a port: its own idea of the actuator, and the scenario's."""
    own_port = scenario.plant.ports[port]
    return (*scenario.controller.compensation(own_port), *scenario.compensation.get(own_port.name, ()))


def law_function(scenario: Scenario) -> Callable[..., None]:
    """The function that makes commands of a sample, with the barrier's shape bound into it."""
    controller = scenario.controller
    law: Callable[..., None] = type(controller).step if isinstance(controller, SampledFeedback) else port_law
    shape = controller.barrier_shape
    if shape in ("none", "log"):
        return law
    return bind(law, **{name: getattr(BARRIERS[shape], name) for name in ("carried", "fresh", "gradient", "potential")})


def believed(scenario: Scenario, setting: Setting, guards: Guards) -> Array:
    """(ports, 2) least and largest reading that is believed: as stated, or from the constraint, or FAR."""
    found = []
    for p, name in enumerate(scenario.ports):
        low, high = (getattr(setting, side)[:, p] + setting.reference[:, p] for side in ("low", "high"))
        least, most = float(low.min()), float(high.max())
        middle, room = (least + most) / 2, ROOM * (most - least) / 2
        own_range = (middle - room, middle + room) if np.isfinite(room) else (-FAR, FAR)
        found.append(guards.believed.get(name, own_range))
    return np.array(found)
