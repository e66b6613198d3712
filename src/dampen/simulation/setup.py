"""What is computed once, before the first trial: modes, the exact step, the records of ports and stages, the loads."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, cached_property
from typing import Any

import numpy as np

from dampen.component import ArgumentError, wrong
from dampen.controllers.base import PortLaw
from dampen.disturbances.base import Disturbance
from dampen.modal import Propagator, propagator
from dampen.plants.base import Modes
from dampen.port import Site
from dampen.simulation import kernel
from dampen.simulation.closure import SOFTNESS
from dampen.simulation.compiled import bind, compiled, is_cached
from dampen.simulation.kernel import MODAL, PORT, STAGE, STAGE_PARAMETERS, STAGE_STATES, Inputs, Step
from dampen.simulation.resolution import check_resolution
from dampen.simulation.scenario import Scenario
from dampen.stage import Stage

Array = np.ndarray
LOADS_KEPT = 128 * 2**20
LOAD_BLOCK = 100  # steps whose load is sampled at a time: what fits a processor's cache


class Bench:
    """The plant, set up for a scenario's task and disturbance; controllers can be changed without setting it up again.

    Raises ArgumentError for what modes and step cannot resolve; `warnings` says where that is thin.
    """

    def __init__(self, scenario: Scenario):
        numerics, plant = scenario.numerics, scenario.plant
        self.scenario = scenario
        self.site = Site(plant.ports, plant.span, scenario.task.trial_duration)
        on_grid = numerics.discretisation == "finite-difference"
        self.modes: Modes = plant.modes(numerics.modes, numerics.points) if on_grid else plant.modes(numerics.modes)
        self.motion = propagator(self.modes, numerics.step)
        self.step = exact_step(self.modes, self.motion, numerics.step)
        self.midpoints = (np.arange(scenario.steps) + 0.5) * numerics.step
        self.x = output_points(scenario)
        self.start = plant.initial_state(self.modes)
        self.warnings = check_resolution(scenario, self.modes, self.site)
        self.check_start(scenario)
        self._stages: list[type[Stage]] = []
        self._loads: dict[int, tuple[Array, Array, Array]] = {}

    @cached_property
    def shapes(self) -> dict[str, Array]:
        """(points, modes) shapes at the output points, for each field."""
        return {field.name: field.shapes(self.x) for field in self.modes.fields}

    def kernel(self, scenario: Scenario, compile: bool = True) -> tuple[Any, Sequence[type[Stage]]]:
        """The kernel with the stages that this scenario, or another one on this bench, needs; and their classes, by code.

        A second scenario adds only what the first did not have, so that the run without control needs no kernel of its own.
        """
        for p in range(len(scenario.plant.ports)):
            self._stages += [cls for cls in map(type, scenario.chain(p)) if cls not in self._stages]
        steps = tuple(cls.step for cls in self._stages)
        ports = len(scenario.plant.ports)
        return compiled_kernel(ports, steps) if compile else compose(ports, steps), self._stages

    def initial_state(self) -> Any:
        """The record of all modes as trial 0 begins."""
        return modal_record(self.modes, self.motion, *self.start)

    def check_start(self, scenario: Scenario) -> None:
        """A barrier needs the tip inside it, as the modes have it: few modes can put it beyond a shape that was inside."""
        if not scenario.controller.uses_barrier:
            return
        for port, y, limit in zip(self.modes.ports, self.modes.b @ self.start[0], scenario.limits, strict=True):
            if not abs(y) < (1 - 1e-9) * limit:
                must = f"be larger, or the constraint wider: they start {port.name} at {y:.9g}, outside |y| < {limit:g}"
                raise wrong("numerics.modes", must, self.modes.count)

    def inputs(self, trial: int, law: PortLaw) -> Inputs:
        """What the kernel needs to know of a trial."""
        disturbance, load, drift = self.shaking(trial)
        return Inputs(np.ascontiguousarray(law.feedforward), np.ascontiguousarray(law.coulomb), disturbance, load, drift)

    def shaking(self, trial: int) -> tuple[Array, Array, Array]:
        """Disturbance (steps, ports), modal load (steps, modes), drift of the ports under both, (steps, ports) in m/s; kept
        while it fits."""
        source = self.scenario.disturbance
        key = source.same_as(trial)
        if key not in self._loads:
            disturbance = np.zeros((len(self.midpoints), len(self.site.ports)))
            load = aligned(np.zeros((len(self.midpoints), self.modes.count)))
            for part in source.parts:
                at_ports = part.at_ports(key, self.midpoints, self.site)
                if at_ports is not None:
                    disturbance += at_ports
                self._add_load(load, part, key)
            drift = load @ (self.modes.b * self.motion.psi / self.step.dt).T + disturbance @ self.step.g
            if (len(self._loads) + 1) * load.nbytes > LOADS_KEPT:
                self._loads.clear()
            self._loads[key] = disturbance, load, drift
        return self._loads[key]

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
        acceleration = part.base_acceleration(trial, t, self.site)
        if acceleration is not None:
            if modes.translation is None:
                raise ArgumentError("Argument `disturbance` shakes the base, but this plant cannot be shaken there.")
            load -= np.outer(acceleration, modes.translation)


def output_points(scenario: Scenario) -> Array:
    """Where along the structure fields are written down [m]."""
    return np.linspace(0, scenario.plant.span, scenario.output.points)


def exact_step(modes: Modes, motion: Propagator, dt: float) -> Step:
    """What the ports see of a step of the modes under held forces."""
    b = modes.b
    g = (b * motion.psi) @ b.T / dt
    pad = np.zeros((len(b) % 2, modes.count))
    fall = -(modes.omega**2) * motion.psi  # c11 - 1, without cancellation
    rows = (np.vstack([part, pad]) for part in (b, b * fall / dt, b * motion.c12 / dt))
    b_rows, q_rows, rate_rows = map(aligned, rows)
    return Step(dt, b_rows, q_rows, rate_rows, aligned(g), aligned(g))


def modal_record(modes: Modes, motion: Propagator, q: Array, rate: Array) -> Any:
    """The kernel's record of all modes, in the state q, rate."""
    n = modes.count
    modal = on_cache_line(MODAL.itemsize).view(MODAL).view(np.recarray)
    rows = {"q": q, "rate": rate, "omega2": modes.omega**2}
    rows |= {name: getattr(motion, name) for name in ("c11", "c12", "c21", "c22", "psi")}
    rows |= {f"b{p}": row for p, row in enumerate(modes.b[:2])}
    for name, row in rows.items():
        modal[name][0, :n] = row
    modal["count"] = n
    return modal


def port_records(scenario: Scenario, step: Step, classes: Sequence[type[Stage]]) -> tuple[Any, Any]:
    """The records of all ports and stages as trial 0 begins; a stage's code is the place of its class among `classes`."""
    chains = [scenario.chain(p) for p in range(len(scenario.plant.ports))]
    ports = np.zeros(len(chains), PORT).view(np.recarray)
    stages = np.zeros(max(1, sum(map(len, chains))), STAGE).view(np.recarray)
    ports.soft, ports.limit, ports.gain = SOFTNESS * np.diag(step.g), scenario.limits, 1.0
    ports.feedthrough = 1.0
    s = 0
    for port, chain in zip(ports, chains, strict=True):
        port.first, port.last = s, s + len(chain)
        for stage in chain:
            row = stage.row(step.dt)
            if len(row) > STAGE_PARAMETERS or stage.states > STAGE_STATES:
                raise ValueError(
                    f"{type(stage).__name__} needs more than {STAGE_PARAMETERS} parameters or {STAGE_STATES} states."
                )
            stages[s].code, stages[s].states = classes.index(type(stage)), stage.states
            stages[s].parameters[: len(row)] = row
            stages[s].state[: stage.states] = stage.start()
            port.gain *= stage.gain
            port.feedthrough *= stage.feedthrough(step.dt)
            s += 1
    return ports, stages


def compose(ports: int, steps: tuple[Callable[..., float], ...]) -> Callable[..., int]:
    """The kernel for this number of ports, with these stage functions bound to the codes 0, 1, ...: plain Python."""
    dispatch: Any = no_stage
    for code in reversed(range(len(steps))):
        dispatch = bind(one_stage, own_code=code, own_step=steps[code], other_stage=dispatch)
    return bind(kernel.run_trial, stage_step=dispatch, PORTS=ports)


@cache
def compiled_kernel(ports: int, steps: tuple[Callable[..., float], ...]) -> Any:
    """The same, compiled; see `is_ready` for whether that will take a while."""
    return compiled(compose(ports, steps))


def is_ready(kernel_function: Any) -> bool:
    """Whether the compiled kernel is there already, in memory or on disk."""
    return bool(kernel_function.signatures) or is_cached(kernel_function)


def one_stage(code, command, state, parameters, new_state):  # type: ignore[no-untyped-def]
    """One link of the dispatch from a stage's code to its step function."""
    if code == own_code:  # type: ignore[name-defined]  # noqa: F821  (bound by `compose`)
        return own_step(command, state, parameters, new_state)  # type: ignore[name-defined]  # noqa: F821
    return other_stage(code, command, state, parameters, new_state)  # type: ignore[name-defined]  # noqa: F821


def no_stage(code, command, state, parameters, new_state):  # type: ignore[no-untyped-def]
    """The end of the dispatch."""
    return command


def aligned(a: Array) -> Array:
    """A contiguous copy that starts on a cache line: a tenth of the kernel's time."""
    out = on_cache_line(8 * a.size).view(float).reshape(a.shape)
    out[...] = a
    return out


def on_cache_line(size: int) -> Array:
    """`size` zero bytes that start on a cache line."""
    buffer = np.zeros(size + 64, np.uint8)
    offset = -buffer.ctypes.data % 64
    return buffer[offset : offset + size]
