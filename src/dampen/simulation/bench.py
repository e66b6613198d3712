"""What is computed once, before the first trial: modes, the exact step, the kernel, and per trial what shakes and steers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from threading import RLock
from typing import Any

import numpy as np

from dampen.component import ArgumentError, own_name, wrong
from dampen.controllers.base import PortLaw, SampledFeedback
from dampen.disturbances.base import Disturbance
from dampen.modal import propagator
from dampen.own import blame
from dampen.plants.base import Modes
from dampen.port import Site
from dampen.simulation.compose import Composition, compiled_kernel
from dampen.simulation.cost import check_memory_of_trial
from dampen.simulation.digital_law import port_law
from dampen.simulation.kernel import Inputs
from dampen.simulation.pieces import check_stages, modes_of
from dampen.simulation.records import aligned, exact_step, modal_record
from dampen.simulation.resolution import check_ports, check_resolution, odd_sizes
from dampen.simulation.scenario import Scenario
from dampen.stage import Stage

Array = np.ndarray
LOADS_KEPT = 128 * 2**20
ROUND_OFF = 1e-15
LOAD_BLOCK = 100  # steps whose load is sampled at a time: what fits a processor's cache


class Bench:
    """The plant, set up for a scenario's task and disturbance; controllers can be changed without setting it up again.

    modes:   the plant's modes, where they have been found already.
    carried: another bench with the same disturbance, and the modes in terms of its own, shapes(x) = its shapes(x) @ mix, with
             mix (its modes, modes): what is spread along the structure is then sampled and projected there, once for all benches
             that it carries.
    keep:    bytes of loads that are kept at most; the last one is in any case.

    Raises ArgumentError for what modes and step cannot resolve; `warnings` says where that is thin.
    """

    def __init__(
        self, scenario: Scenario, modes: Modes | None = None, carried: tuple[Bench, Array] | None = None, keep: int = LOADS_KEPT
    ):
        check_memory_of_trial(scenario)
        numerics, plant = scenario.numerics, scenario.plant
        self.scenario = scenario
        self.site = Site(plant.ports, plant.span, scenario.task.trial_duration)
        on_grid = numerics.discretisation == "finite-difference"
        self.grid = numerics.points if on_grid else None
        self.carried, self.keep = carried, keep
        self.modes: Modes = modes_of(plant, numerics.modes, self.grid) if modes is None else modes
        self.motion = propagator(self.modes, numerics.step)
        self.step = exact_step(self.modes, self.motion, numerics.step)
        self.midpoints = (np.arange(scenario.steps) + 0.5) * numerics.step
        self.x = output_points(scenario)
        with blame(plant, "initial_state"):
            self.start = plant.initial_state(self.modes)
        shapes = [np.shape(part) for part in self.start]
        if shapes != 2 * [(self.modes.count,)]:
            must = f"must give two arrays of shape {(self.modes.count,)}, but gives {shapes[0]} and {shapes[1]}"
            raise ArgumentError(f"{own_name(plant)}.initial_state {must}.")
        if not all(np.all(np.isfinite(part)) for part in self.start):
            raise ArgumentError("Argument `plant.initial` must be a shape and a rate that stay finite along the structure.")
        check_ports(scenario, self.modes)
        self.warnings = [*check_resolution(scenario, self.modes, self.site), *odd_sizes(scenario, self.modes)]
        self.check_start(scenario)
        self._stages: list[type[Stage]] = []
        self._sampled_law: Callable[..., None] | None = None
        self._barrier = "none"
        self._loads: dict[int, tuple[Array, Array, Array]] = {}
        self._factors: dict[int, tuple[Array, Array, Array]] = {}
        self._lock = RLock()  # threads may share a bench

    @cached_property
    def shapes(self) -> dict[str, Array]:
        """(points, modes) shapes at the output points, for each field."""
        return {field.name: field.shapes(self.x) for field in self.modes.fields}

    def kernel(self, scenario: Scenario, compile: bool = True) -> tuple[Any, Sequence[type[Stage]]]:
        """The kernel with all that this scenario, or another one on this bench, needs; and the stages' classes, by code."""
        composition, classes = self.composition(scenario)
        return compiled_kernel(composition) if compile else composition.bind(), classes

    def composition(self, scenario: Scenario) -> tuple[Composition, Sequence[type[Stage]]]:
        """What that kernel is made of.

        A second scenario adds only what the first did not have, so that the run without control needs no kernel of its own.
        """
        with self._lock:
            controller = scenario.controller
            for p in range(len(scenario.plant.ports)):
                check_stages(scenario.chain(p), self.step.dt)
                self._stages += [cls for cls in map(type, scenario.chain(p)) if cls not in self._stages]
            if scenario.sampled:
                self._sampled_law = type(controller).step if isinstance(controller, SampledFeedback) else port_law
            if controller.barrier_shape != "none":
                self._barrier = controller.barrier_shape
            composition = Composition(
                ports=len(scenario.plant.ports),
                steps=tuple(cls.step for cls in self._stages),
                damped=self.modes.damped,
                barrier="log" if self._barrier == "none" else self._barrier,
                sampled_law=self._sampled_law,
            )
            return composition, self._stages

    def modal_record(self, trial: int = 0) -> Any:
        """The record of all modes as a trial begins that starts from the initial state."""
        return modal_record(self.modes, self.motion, self.step, *self.state(trial))

    def state(self, trial: int = 0) -> tuple[Array, Array]:
        """Modal coordinates and rates, (modes,) each, as such a trial begins."""
        q, rate = self.start
        return q + self._misplaced(trial), rate

    def _misplaced(self, trial: int) -> Array:
        """How far a reset misses the initial state, (modes,): the ports off at random, the structure bent to them."""
        task, modes = self.scenario.task, self.modes
        spread = np.array([task.reset_error.get(name, 0.0) for name in self.scenario.ports])
        if not np.any(spread):
            return np.zeros(modes.count)
        off = spread * np.random.default_rng([task.seed, trial]).standard_normal(len(spread))
        lowest = np.min(modes.omega[modes.omega > 0], initial=np.inf)
        soft = modes.b / (1 + (modes.omega / lowest) ** 2)
        return np.asarray(soft.T @ np.linalg.solve(modes.b @ soft.T, off))

    def check_start(self, scenario: Scenario) -> None:
        """A barrier needs the tip inside it, as the modes have it: few modes can put it beyond a shape that was inside."""
        if scenario.controller.barrier_shape == "none":
            return
        low, high = (limits[0] for limits in scenario.task.limits(scenario.ports, np.zeros(1), 0))
        for p, y in enumerate(self.modes.b @ self.start[0]):
            if not scenario.controller.has_barrier(scenario.plant.ports[p]):
                continue
            middle, room = (low[p] + high[p]) / 2, (high[p] - low[p]) / 2
            if not abs(y - middle) < (1 - 1e-9) * room:
                where = f"|y| < {high[p]:g}" if middle == 0 else f"{low[p]:g} < y < {high[p]:g}"
                must = f"be larger, or the constraint wider: they start {scenario.ports[p]} at {y:.9g}, outside {where}"
                raise wrong("numerics.modes", must, self.modes.count)

    def inputs(self, scenario: Scenario, trial: int, law: PortLaw) -> Inputs:
        """What the kernel needs to know of a trial; a law that acts through samples gives nothing step by step."""
        disturbance, load, drift = self.shaking(trial)
        reference, (low, high) = scenario.reference(trial), scenario.limits(trial)
        if np.any(reference):
            drift = drift - np.diff(reference, axis=0) / self.step.dt
        low, high = (np.ascontiguousarray((limit - reference)[1:]) for limit in (low, high))
        steps = np.zeros_like(disturbance)
        feedforward, coulomb = (steps, steps) if scenario.sampled else (law.feedforward, law.coulomb)
        feedforward, coulomb, drift = map(np.ascontiguousarray, (feedforward, coulomb, drift))
        return Inputs(feedforward, coulomb, disturbance, load, drift, low, high, reference[0].copy())

    def shaking(self, trial: int, into: Array | None = None) -> tuple[Array, Array, Array]:
        """Disturbance (steps, ports), modal load (steps, modes), drift of the ports under both, (steps, ports) in m/s; kept
        while it fits, unless another bench carries it. A carried load has a column more for each port, what it gives the port.

        into: where the load is to be written, (steps, modes and ports).
        """
        if self.carried is not None:
            carrier, mix = self.carried
            disturbance, in_time, in_modes = carrier.factors(trial)
            own = in_modes @ mix
            if len(own) < in_time.shape[1]:  # the base is shaken
                own = np.vstack([own, -self._translation])
            load = np.matmul(in_time, np.hstack([own, own @ self._give]), out=into)
            return disturbance, load, load[:, self.modes.count :] + disturbance @ self.step.g
        key = self.scenario.disturbance.same_as(trial)
        with self._lock:
            if key not in self._loads:
                shaken = self._shaken(key)
                if (len(self._loads) + 1) * shaken[1].nbytes > self.keep:
                    self._loads.clear()
                self._loads[key] = shaken
            disturbance, load, drift = self._loads[key]
        if into is not None:
            into[:, : self.modes.count] = load
        return disturbance, load if into is None else into, drift

    def factors(self, trial: int) -> tuple[Array, Array, Array]:
        """Disturbance (steps, ports), and what is spread along the structure as a product, (steps, rank) by (rank, modes), to
        round-off: it has far fewer shapes than there are modes, and each bench that this one carries needs another product with
        it. Where the base is shaken, its acceleration is a column more of the first factor: how that pushes modes is each bench's
        own."""
        key = self.scenario.disturbance.same_as(trial)
        with self._lock:
            if key not in self._factors:
                from scipy.linalg import svd

                load = np.zeros((len(self.midpoints), self.modes.count))
                for part in self.scenario.disturbance.parts:
                    with blame(part, "load"):
                        self._add_load(load, part, key)
                in_time, size, in_modes = svd(load, full_matrices=False, check_finite=False)
                rank = int(np.sum(size > ROUND_OFF * size[0]))
                acceleration = self._acceleration(key)
                columns = [in_time[:, :rank], *([] if acceleration is None else [acceleration[:, None]])]
                if (len(self._factors) + 1) * in_time.nbytes > self.keep:
                    self._factors.clear()
                self._factors[key] = self._at_ports(key), np.hstack(columns), size[:rank, None] * in_modes[:rank]
            return self._factors[key]

    def _shaken(self, trial: int) -> tuple[Array, Array, Array]:
        """The same, sampled."""
        disturbance, load = self._at_ports(trial), aligned(np.zeros((len(self.midpoints), self.modes.count)))
        for part in self.scenario.disturbance.parts:
            with blame(part, "load"):
                self._add_load(load, part, trial)
        acceleration = self._acceleration(trial)
        if acceleration is not None:
            load -= np.outer(acceleration, self._translation)
        return disturbance, load, self._drift(disturbance, load)

    def _at_ports(self, trial: int) -> Array:
        """(steps, ports) disturbance at the ports."""
        disturbance = np.zeros((len(self.midpoints), len(self.site.ports)))
        for part in self.scenario.disturbance.parts:
            with blame(part, "at_ports"):
                at_ports = part.at_ports(trial, self.midpoints, self.site)
                if at_ports is not None:
                    disturbance += at_ports
        return disturbance

    def _acceleration(self, trial: int) -> Array | None:
        """(steps,) acceleration of the base [m/s^2]; None where nothing shakes it."""
        total = None
        for part in self.scenario.disturbance.parts:
            with blame(part, "base_acceleration"):
                own = part.base_acceleration(trial, self.midpoints, self.site)
                if own is not None:
                    total = np.broadcast_to(own, self.midpoints.shape) + (0.0 if total is None else total)
        return total

    @property
    def _translation(self) -> Array:
        if self.modes.translation is None:
            raise ArgumentError("Argument `disturbance` shakes the base, but this plant cannot be shaken there.")
        return self.modes.translation

    def _drift(self, disturbance: Array, load: Array) -> Array:
        """(steps, ports) mean velocities that port disturbances and modal load give the ports in a step."""
        return np.asarray(load @ self._give + disturbance @ self.step.g)

    @cached_property
    def _give(self) -> Array:
        """(modes, ports) mean velocity that a unit of modal force gives the ports in a step."""
        return (self.modes.b * self.motion.psi / self.step.dt).T

    def _add_load(self, load: Array, part: Disturbance, trial: int) -> None:
        """Add to the modal load (steps, modes) what one part of the disturbance puts along the structure."""
        modes, t = self.modes, self.midpoints
        if part.load_field is not None:
            x, matrix = modes.load_rule(part.load_field, part.content(trial, self.site).load_wave)
            for block in np.array_split(np.arange(len(t)), max(1, len(t) // LOAD_BLOCK)):
                load[block] += part.load(trial, t[block], x, self.site) @ matrix
        if part.point_field is not None:
            place, force = part.point_load(trial, t, self.site)
            load += force[:, None] * modes.field(part.point_field).shapes(place)


def output_points(scenario: Scenario) -> Array:
    """Where along the structure fields are written down [m]."""
    return np.linspace(0, scenario.plant.span, scenario.output.points)
