"""The energy account, step by step, against what follows from the law's own definition."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np
import pytest

import dampen
from tests.own_parts import Everything, lumps

STEPS, STEP, SLOPE = 200, 2e-3, 0.4


def case(shape: Literal["log", "tan"], tracking: bool = False) -> dampen.Scenario:
    """Two ports, uneven limits, actuators that deliver 0.4 of the command, no switching: all that the law does is smooth."""
    law = Everything(damping=(0.6, 0.2), stiffness=(3.0, 8.0), barrier_gain=(0.02, 0.05), coulomb=(0.0, 0.0), push=(0.0, 0.0),
                     barrier=shape)  # fmt: skip
    shaking = dampen.Harmonics(frequencies=(1.3, 4.0), force={"p0": (0.3, 0.2), "p1": (0.1, -0.3)}, trials="continue")
    still = dampen.Hold(0.01) if tracking else dampen.Hold(0.0)
    task = dampen.Task(trials=1, trial_duration=STEPS * STEP, reference={"p0": still},
                       constraint={"p0": (-0.09, 0.05), "p1": (-0.06, 0.11)})  # fmt: skip
    slope = (dampen.Saturation(SLOPE, -1e9, 1e9),)
    return dampen.Scenario(
        plant=lumps(np.random.default_rng(11), 2, 22, 0.3), controller=law, disturbance=shaking, task=task,
        numerics=dampen.Numerics(modes=22, step=STEP), output=dampen.Output(every=STEPS), actuators={"p0": slope, "p1": slope},
    )  # fmt: skip


@pytest.mark.parametrize("shape", ["log", "tan"])
def test_barrier_and_stiffness_hold_what_the_smooth_force_without_damping_puts_in(shape: Literal["log", "tan"]) -> None:
    scenario = case(shape)
    result = dampen.simulate(scenario)
    y, v, force = (np.asarray(result[name][0]) for name in ("y", "v", "delivered"))
    assert np.any(y < 0)
    assert np.any(y > 0)
    drawn = ((force + SLOPE * np.array([0.6, 0.2]) * v) * np.diff(y, axis=0)).sum(axis=1)
    held = np.asarray(result["barrier_energy"][0])
    np.testing.assert_allclose(np.diff(held), -drawn, atol=1e-12 * held.max(), rtol=0)
    assert np.abs(np.diff(held)).max() > 1e-3 * held.max()


def test_works_are_forces_times_displacements_with_a_reference_too() -> None:
    result = dampen.simulate(case("log", tracking=True))
    y, u, force = (np.asarray(result[name][0]) for name in ("y", "command", "delivered"))
    moved = np.diff(y, axis=0)
    np.testing.assert_allclose(result["work_control"][0], force * moved, atol=1e-15)
    np.testing.assert_allclose(result["work_actuator"][0], (force - SLOPE * u) * moved, atol=1e-15)


@pytest.mark.parametrize("shape", ["log", "tan"])
def test_force_and_energy_of_a_barrier_are_those_of_the_limit_at_the_end_of_each_step(shape: Literal["log", "tan"]) -> None:
    """One limit of each port moves, the other stays; the second port follows a reference that begins beside zero."""
    scenario = case(shape)
    limits = {
        "p0": dampen.Constraint(low=-0.09, high=dampen.Sinusoid(amplitude=0.01, frequency=2.0, offset=0.06), on="error"),
        "p1": dampen.Constraint(low=dampen.Decay(-0.07, -0.05, 0.1), high=0.11, on="error"),
    }
    scenario = replace(scenario, task=replace(scenario.task, constraint=limits, reference={"p1": dampen.Hold(0.005)}))
    result = dampen.simulate(scenario)
    y, v, force = (np.asarray(result[name][0]) for name in ("y", "v", "delivered"))
    np.testing.assert_allclose(y[0], scenario.plant.initial_ports(), atol=1e-15)
    e, t = y - [0.0, 0.005], np.arange(STEPS + 1) * STEP
    low = np.column_stack([np.full(len(t), -0.09), -0.05 - 0.02 * np.exp(-t / 0.1)])
    high = np.column_stack([0.06 + 0.01 * np.sin(2 * np.pi * 2.0 * t), np.full(len(t), 0.11)])
    before, after = (potential(error, low[1:], high[1:], shape) for error in (e[:-1], e[1:]))
    step = np.diff(e, axis=0)
    spring = np.array([3.0, 8.0]) * (e[1:] + e[:-1]) / 2
    expected = -SLOPE * (np.array([0.02, 0.05]) * (after - before) / step + spring + np.array([0.6, 0.2]) * v)
    far = np.abs(step) > 1e-5  # else the quotient has no digits left
    np.testing.assert_allclose(force[far], expected[far], atol=1e-8 * np.abs(expected).max(), rtol=0)
    held = SLOPE * (np.array([0.02, 0.05]) * after + np.array([3.0, 8.0]) * e[1:] ** 2 / 2).sum(axis=1)
    np.testing.assert_allclose(result["barrier_energy"][0][1:], held, rtol=1e-10)
    assert all(np.any(side[far]) for side in (e[1:] > 0, e[1:] < 0))


def potential(e: np.ndarray, low: np.ndarray, high: np.ndarray, shape: str) -> np.ndarray:
    """V of both barriers as their papers have it."""
    square = (e / np.where(e > 0, high, low)) ** 2
    return np.asarray(np.tan(np.pi / 2 * square) / np.pi if shape == "tan" else np.log(1 - square) ** 2 / 4)
