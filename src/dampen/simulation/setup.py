"""What is computed once, before the first trial: modes, the exact step, the records of ports and stages, the loads."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, cached_property
from typing import Any

import numpy as np

from dampen.controllers.base import PortLaw
from dampen.plants.base import Modes
from dampen.simulation import kernel
from dampen.simulation.closure import SOFTNESS
from dampen.simulation.compiled import bind, compiled, is_cached
from dampen.simulation.kernel import PORT, STAGE, STAGE_PARAMETERS, STAGE_STATES, Inputs, Step
from dampen.simulation.scenario import Scenario
from dampen.stage import Stage

Array = np.ndarray
LOADS_KEPT = 128 * 2**20


class Bench:
    """The plant, set up for a scenario's task and disturbance; controllers can be changed without setting it up again."""

    def __init__(self, scenario: Scenario):
        numerics, plant = scenario.numerics, scenario.plant
        self.scenario = scenario
        self.modes: Modes = plant.modes(numerics.modes, numerics.discretisation, numerics.points)
        self.step = exact_step(self.modes, numerics.step)
        self.midpoints = (np.arange(scenario.steps) + 0.5) * numerics.step
        self.x = output_points(scenario)
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
        return compiled_kernel(steps) if compile else compose(steps), self._stages

    def initial_state(self) -> tuple[Array, Array]:
        q, rate = self.scenario.plant.initial_state(self.modes)
        return aligned(q), aligned(rate)

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
            disturbance = np.ascontiguousarray(source.at_ports(key, self.midpoints, self.modes.ports))
            load = aligned(self._modal_load(key))
            drift = load @ (self.modes.b * self.step.psi).T / self.step.dt + disturbance @ self.step.g
            if (len(self._loads) + 1) * load.nbytes > LOADS_KEPT:
                self._loads.clear()
            self._loads[key] = disturbance, load, drift
        return self._loads[key]

    def _modal_load(self, trial: int) -> Array:
        source, modes = self.scenario.disturbance, self.modes
        if source.load_field is None:
            return np.zeros((len(self.midpoints), modes.count))
        content = source.content(trial, self.scenario.task.trial_duration, modes.ports, self.scenario.plant.span)
        x, matrix = modes.load_rule(source.load_field, content.load_wave)
        return source.load(trial, self.midpoints, x) @ matrix


def output_points(scenario: Scenario) -> Array:
    """Where along the structure fields are written down [m]."""
    return np.linspace(0, scenario.plant.span, scenario.output.points)


def exact_step(modes: Modes, dt: float) -> Step:
    """The exact step of every (undamped) mode under a held force, and what the ports see of it."""
    omega, b = modes.omega, modes.b
    cosine, sine = np.cos(omega * dt), np.sin(omega * dt)
    c12 = sine / omega
    psi = 2 * (np.sin(omega * dt / 2) / omega) ** 2
    v_q, v_rate, g = -b * psi * omega**2 / dt, b * c12 / dt, (b * psi) @ b.T / dt
    rows = (cosine, c12, -omega * sine, cosine, psi, omega**2, b, v_q, v_rate, g, g, *[np.zeros_like(omega)] * 4)
    return Step(dt, *(aligned(row) for row in rows))


def port_records(scenario: Scenario, step: Step, classes: Sequence[type[Stage]]) -> tuple[Array, Array]:
    """The records of all ports and stages as trial 0 begins; a stage's code is the place of its class among `classes`."""
    chains = [scenario.chain(p) for p in range(len(scenario.plant.ports))]
    ports = np.zeros(len(chains), PORT).view(np.recarray)
    stages = np.zeros(max(1, sum(map(len, chains))), STAGE).view(np.recarray)
    ports.soft, ports.limit, ports.gain = SOFTNESS * np.diag(step.g), scenario.limits, 1.0
    s = 0
    for port, chain in zip(ports, chains, strict=True):
        port.first, port.last = s, s + len(chain)
        for stage in chain:
            row = stage.row()
            if len(row) > STAGE_PARAMETERS or stage.states > STAGE_STATES:
                raise ValueError(f"{type(stage).__name__} needs more than {STAGE_PARAMETERS} parameters or {STAGE_STATES} states.")
            stages[s].code, stages[s].states = classes.index(type(stage)), stage.states
            stages[s].parameters[: len(row)] = row
            port.gain *= stage.gain
            s += 1
    return ports, stages


def compose(steps: tuple[Callable[..., float], ...]) -> Callable[..., int]:
    """The kernel with these stage functions bound to the codes 0, 1, ...: plain Python."""
    dispatch: Any = no_stage
    for code in reversed(range(len(steps))):
        dispatch = bind(one_stage, own_code=code, own_step=steps[code], other_stage=dispatch)
    return bind(kernel.run_trial, stage_step=dispatch)


@cache
def compiled_kernel(steps: tuple[Callable[..., float], ...]) -> Any:
    """The same, compiled; see `is_ready` for whether that will take a while."""
    return compiled(compose(steps))


def is_ready(kernel_function: Any) -> bool:
    """Whether the compiled kernel is there already, in memory or on disk."""
    return bool(kernel_function.signatures) or is_cached(kernel_function)


def one_stage(code, command, state, parameters, new_state):
    """One link of the dispatch from a stage's code to its step function."""
    if code == own_code:  # noqa: F821  (bound by `compose`)
        return own_step(command, state, parameters, new_state)  # noqa: F821
    return other_stage(code, command, state, parameters, new_state)  # noqa: F821


def no_stage(code, command, state, parameters, new_state):
    """The end of the dispatch."""
    return command


def aligned(a: Array) -> Array:
    """A contiguous copy that starts on a cache line: a tenth of the kernel's time."""
    a = np.ascontiguousarray(a, dtype=float)
    buffer = np.empty(a.nbytes + 64, np.uint8)
    offset = -buffer.ctypes.data % 64
    out = buffer[offset : offset + a.nbytes].view(float).reshape(a.shape)
    out[...] = a
    return out
