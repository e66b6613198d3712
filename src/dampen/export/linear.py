"""The plant of a scenario as matrices A, B, C, D: its modes, forces in, displacements out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from dampen.component import ArgumentError, is_number, is_whole, wrong
from dampen.export.names import distinct
from dampen.export.residual import residual_compliance
from dampen.modal import propagator
from dampen.plants.base import Modes
from dampen.simulation.kernel import MODES_AT_MOST
from dampen.simulation.pieces import modes_of
from dampen.simulation.scenario import Scenario

Array = np.ndarray
Source = Literal["ports", "base", "modal"]


@dataclass(frozen=True)
class LinearModel:
    """x' = A x + B u, or x(t + dt) = A x(t) + B u(t) where `dt` > 0, u held in between;  y = C x + D u.

    states, inputs, outputs: (name, unit) of every row.   dt: sample time [s], 0: continuous.
    """

    a: Array
    b: Array
    c: Array
    d: Array
    states: tuple[tuple[str, str], ...]
    inputs: tuple[tuple[str, str], ...]
    outputs: tuple[tuple[str, str], ...]
    dt: float = 0.0


def linear_model(
    scenario: Scenario,
    modes: int | None = None,
    *,
    inputs: Sequence[Source] = ("ports",),
    rates: bool = False,
    residual: bool = False,
    dt: float = 0.0,
) -> LinearModel:
    """The scenario's plant, damped as it is, rigid-body modes included; actuators, disturbance and controller stay outside.

        q_i'' + 2 decay_i q_i' + omega_i^2 q_i = sum_p b_pi F_p - translation_i a + f_i,    y_p = sum_i b_pi q_i + sum_r R_pr F_r

    modes:    how many of the lowest; left out: as many as the scenario computes with.
    inputs:   "ports": forces F [N, N m];  "base": acceleration a of the base [m/s^2], y then is seen from the base;  "modal":
              f_i of a distributed load, int f(x, t) phi_i(x) dx for mass-normalised shapes [N/sqrt(kg)].
    rates:    y' as outputs behind y; they know nothing of R.
    residual: R, the static compliance that the modes left out would have added, as feedthrough; without it R = 0. Rigid-body
              modes are in the model in any case.
    dt:       > 0: the model at the times of a sampler [s], exact for inputs held in between: the simulation's own step.

    x is all q, then all q'. Raises ArgumentError for what the plant does not have.
    """
    _check(scenario, modes, inputs, dt)
    grid = scenario.numerics.points if scenario.numerics.discretisation == "finite-difference" else None
    found = modes_of(scenario.plant, scenario.numerics.modes if modes is None else modes, grid)
    push, given = _pushes(found, inputs)
    a, b = _dynamics(found, push, dt)
    n, ports = found.count, len(found.ports)
    c = np.hstack([found.b, np.zeros_like(found.b)])
    d = np.zeros((ports, len(given)))
    if residual and "ports" in inputs:
        first = sum(_width(found, source) for source in inputs[: list(inputs).index("ports")])
        d[:, first : first + ports] = residual_compliance(scenario.plant, found, grid)
    outputs = [(port.name, port.motion_unit) for port in found.ports]
    if rates:
        c = np.vstack([c, np.hstack([np.zeros_like(found.b), found.b])])
        d = np.vstack([d, np.zeros_like(d)])
        outputs += [(f"{port.name}_rate", f"{port.motion_unit}/s") for port in found.ports]
        outputs = list(zip(distinct([name for name, _ in outputs]), [unit for _, unit in outputs], strict=True))
    states = [(f"q_{i + 1}", "m sqrt(kg)") for i in range(n)] + [(f"q_{i + 1}_rate", "m sqrt(kg)/s") for i in range(n)]
    return LinearModel(a, b, c, d, tuple(states), tuple(given), tuple(outputs), dt)


def _check(scenario: Scenario, modes: int | None, inputs: Sequence[str], dt: float) -> None:
    if modes is not None and not (is_whole(modes) and 1 <= modes <= MODES_AT_MOST):
        raise wrong("modes", f"be a whole number from 1 to {MODES_AT_MOST}", modes)
    if not (is_number(dt) and dt >= 0):
        raise wrong("dt", "be >= 0 s", dt)
    known = get_args(Source)
    listed = isinstance(inputs, Sequence) and not isinstance(inputs, str)
    if not listed or not inputs or any(name not in known for name in inputs) or len(set(inputs)) < len(inputs):
        raise wrong("inputs", f"be one or more of {', '.join(known)}", tuple(inputs) if listed else inputs)


def _pushes(modes: Modes, inputs: Sequence[str]) -> tuple[Array, list[tuple[str, str]]]:
    """(modes, inputs) how every input pushes the modes, and names and units of the inputs."""
    columns: list[Array] = []
    given: list[tuple[str, str]] = []
    for source in inputs:
        if source == "ports":
            columns.append(modes.b.T)
            given += [(f"{port.name}_{port.kind}", port.effort_unit) for port in modes.ports]
        elif source == "modal":
            columns.append(np.eye(modes.count))
            given += [(f"load_{i + 1}", "N/sqrt(kg)") for i in range(modes.count)]
        else:
            if modes.translation is None:
                raise ArgumentError('Argument `inputs` asks for "base", but this plant cannot be shaken there.')
            columns.append(-modes.translation[:, None])
            given.append(("base_acceleration", "m/s^2"))
    return np.hstack(columns), given


def _width(modes: Modes, source: str) -> int:
    """How many inputs a source has."""
    return {"ports": len(modes.ports), "modal": modes.count, "base": 1}[source]


def _dynamics(modes: Modes, push: Array, dt: float) -> tuple[Array, Array]:
    """A and B of the modes, (2 modes, ...)."""
    n = modes.count
    if dt == 0:
        a = np.block([[np.zeros((n, n)), np.eye(n)], [-np.diag(modes.omega**2), -2 * np.diag(modes.decay)]])
        return a, np.vstack([np.zeros_like(push), push])
    p = propagator(modes, dt)
    a = np.block([[np.diag(p.c11), np.diag(p.c12)], [np.diag(p.c21), np.diag(p.c22)]])
    return a, np.vstack([p.psi[:, None] * push, p.c12[:, None] * push])
