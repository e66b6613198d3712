"""The whole run: anchor values, energy, convergence, sticking, constraint."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import dampen
from dampen.analysis.energy import energy_account
from dampen.analysis.metrics import largest
from tests.conftest import COARSE, FINE, READINGS, scenario

Run = Callable[..., dampen.Result]
TRIALS = [0, 1, 4, 9]
# By three independent programs at 100 modes and 0.1 ms: largest |w(L, t)| in trials 0, 1, 4, 9.
ANCHORS = {"designed": [0.16044, 0.00951, 0.00255, 0.00291], "direct": [0.16386, 0.09022, 0.00693, 0.00247]}


@pytest.mark.parametrize("reading", READINGS)
def test_anchor_values_at_fine_resolution(run: Run, reading: str) -> None:
    result = run(READINGS[reading], *FINE)
    np.testing.assert_allclose(largest(result, "y", "tip_w")[TRIALS], ANCHORS[reading], rtol=0.01)


@pytest.mark.parametrize("reading", READINGS)
def test_anchor_values_at_coarse_resolution(run: Run, reading: str) -> None:
    peaks = largest(run(READINGS[reading], *COARSE), "y", "tip_w")[TRIALS]
    assert np.all(np.abs(peaks - ANCHORS[reading]) <= np.maximum(0.01 * np.array(ANCHORS[reading]), 4e-4))


def test_anchor_values_without_control(run: Run) -> None:
    peaks = largest(run("controller.kind=none", "numerics.modes=100", "numerics.step=1e-4", "task.trials=2"), "y", "tip_w")
    np.testing.assert_allclose(peaks, [0.26331, 0.23279], rtol=1e-4)


@pytest.mark.parametrize("law", ["controller.kind=none", *READINGS.values()])
@pytest.mark.parametrize("grid", ["numerics.discretisation=spectral", "numerics.discretisation=finite-difference"])
def test_energy_closes_over_25_trials(run: Run, law: str, grid: str) -> None:
    result = run(law, grid)
    assert energy_account(result).error <= 1e-11
    change = np.diff(result["energy"], axis=1)
    work = (result["work_control"] + result["work_disturbance"]).sum(axis=2) + result["work_load"]
    assert np.abs(change - work).max() <= 1e-14


@pytest.mark.parametrize("reading", READINGS)
def test_the_laws_work_goes_where_the_law_says(run: Run, reading: str) -> None:
    """The account, split: feedforward, damping, switching, barrier and compliance add up to the law's part of the work."""
    result = run(READINGS[reading], *COARSE)
    law, gain = result.scenario.controller, 1.0 if reading == "designed" else 0.3
    assert isinstance(law, dampen.DualLoopAILC)
    stuck = result["v"] == 0
    moved = np.diff(result["y"], axis=1)
    zeta = np.concatenate([np.zeros((1, 2000, 2)), result["zeta"][:-1]])
    d_hat = np.concatenate([np.zeros((1, 2000, 2)), result["d_hat"][:-1]])
    robust = np.array([2 * law.alpha_1 * 0.15 + law.alpha_2 * 0.3, law.alpha_5 * 0.3])
    damping = np.array([law.alpha_4 + law.alpha_8, law.alpha_7 + law.alpha_9])
    known = zeta - damping * result["v"] - (d_hat + robust) * np.sign(result["v"])
    slipping = np.where(stuck, 0.0, gain * (result["command"] - known) * moved)
    y = np.moveaxis(np.asarray(result["y"]), 2, 0)
    stored = [gain * a / 4 * np.log1p(-((s / 0.2) ** 2)) ** 2 for a, s in zip((law.alpha_3, law.alpha_6), y, strict=True)]
    released = -np.moveaxis(np.diff(np.array(stored), axis=2), 0, 2)
    np.testing.assert_allclose(slipping, np.where(stuck, 0.0, released), atol=1e-12)
    barrier = np.asarray(result["barrier_energy"])
    np.testing.assert_allclose(barrier, np.array(stored).sum(axis=0), rtol=1e-12, atol=1e-300)


@pytest.mark.parametrize("reading", READINGS)
def test_what_the_compliance_stores_and_loses_is_its_work(run: Run, reading: str) -> None:
    """delivered (v - v_law) dt = stored change + loss, port by port: nothing of the cure is outside the account."""
    result = run(READINGS[reading], *COARSE)
    dt = result.scenario.numerics.step
    slip_of_port = np.diff(result["y"], axis=1) - dt * result["v"]
    taken = -(result["delivered"] * slip_of_port).sum(axis=2)
    np.testing.assert_allclose(taken, np.diff(result["compliance_energy"], axis=1) + result["compliance_loss"], atol=1e-14)
    assert np.all(np.asarray(result["compliance_loss"]) >= 0)


def test_uncontrolled_motion_converges_at_second_order_in_the_step() -> None:
    def motion(step: float) -> np.ndarray:
        result = dampen.simulate(
            scenario("controller.kind=none", "numerics.modes=24", f"numerics.step={step}", "task.trials=3", "output.every=1")
        )
        return np.asarray(result["y"])[:, :: round(0.008 / step)]

    reference = motion(0.00025)
    errors = [np.abs(motion(step) - reference).max() for step in (0.008, 0.004, 0.002)]
    np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / errors[1:]), 2, atol=0.1)


def direction_changes(result: dampen.Result) -> np.ndarray:
    """For each port, the share of stuck steps at which the delivered force turns round within a stick.

    At the first two steps of a stick the force may turn because slip ended; zig-zag is what it does after that.
    """
    stuck = np.concatenate(np.asarray(result["v"]) == 0)
    turn = np.diff(np.concatenate(np.asarray(result["delivered"])), axis=0)
    within = stuck[2:] & stuck[1:-1] & stuck[:-2]
    return ((turn[1:] * turn[:-1] < 0) & within).sum(axis=0) / within.sum(axis=0)


@pytest.mark.parametrize("reading", READINGS)
@pytest.mark.parametrize(("numerics", "allowed"), [(FINE, 0.03), (("task.trials=25",), 0.20)])
def test_a_stuck_ports_force_does_not_zigzag(run: Run, reading: str, numerics: tuple[str, ...], allowed: float) -> None:
    result = run(READINGS[reading], *numerics)
    within = direction_changes(result)
    assert np.all(within <= allowed), within
    assert np.all(np.mean(np.asarray(result["v"]) == 0, axis=(0, 1)) > 0.01), "ports do stick, so the test has something to see"


@pytest.mark.parametrize("reading", READINGS)
@pytest.mark.parametrize("step", ["1e-3", "5e-3"])
def test_the_constraint_holds_for_200_random_gain_sets(reading: str, step: str) -> None:
    random = np.random.default_rng(2017)
    for _ in range(200):
        gains = {f"alpha_{i}": 10 ** random.uniform(-2, 1.3) for i in (1, 3, 4, 6, 7, 8, 9)}
        gains |= {f"alpha_{i}": 10 ** random.uniform(0, 1) for i in (2, 5)}
        overrides = [f"controller.{name}={value!r}" for name, value in gains.items()]
        changes = (
            "task.trials=3",
            f"numerics.step={step}",
            "numerics.modes=40",
            READINGS[reading],
            "disturbance.base_frequency=0.5",
        )
        result = dampen.simulate(scenario(*changes, *overrides))
        assert np.abs(result["y"]).max() < 0.2, gains
        assert np.all(np.isfinite(result["energy"]))


@pytest.mark.parametrize("reading", READINGS)
def test_thirty_times_the_initial_velocity_stays_finite(reading: str) -> None:
    result = dampen.simulate(
        scenario("plant.initial.w_rate=[3.0]", "plant.initial.phi_rate=[3.0]", "task.trials=5", READINGS[reading])
    )
    assert result.status == "complete"
    assert energy_account(result).error <= 1e-11
    for name in result.layout.variables:
        assert np.all(np.isfinite(result[name])), name
    assert np.abs(result["y"]).max() < 0.2


@pytest.mark.parametrize("reading", READINGS)
@pytest.mark.parametrize("speed", ["10.0", "30.0"])
def test_beyond_the_edge_of_the_barrier_a_passive_law_adds_no_energy(reading: str, speed: str) -> None:
    """More energy than the barrier can hold in double precision: the constraint is lost by a hair, and said to be; no more."""
    changes = (f"plant.initial.w_rate=[{speed}]", "disturbance.kind=none", "task.trials=2", READINGS[reading])
    result = dampen.simulate(scenario(*changes))
    for name in result.layout.variables:
        if name != "barrier_energy":
            assert np.all(np.isfinite(result[name])), name
    assert np.max(result["energy"]) < 1.05 * result["energy"][0][0]
    assert np.abs(result["y"]).max() < 0.2 * (1 + 1e-6)
    lost = bool(np.abs(result["y"]).max() >= 0.2)
    assert lost == any("was lost" in line for line in result.warnings)


def test_a_lagging_actuator_pumps_but_never_without_bound() -> None:
    wide = "actuator.all.chain=[{kind='backlash', slope=0.3, right=100.0, left=-200.0}]"
    result = dampen.simulate(scenario(wide, "task.trials=3"))
    assert np.all(np.isfinite(result["command"]))
    assert np.max(result["energy"]) < 1e4


def test_few_modes_that_start_beyond_the_barrier_are_refused() -> None:
    with pytest.raises(
        dampen.ArgumentError, match=r"`numerics.modes` must be larger, or the constraint wider: they start tip_w at 0\.20"
    ):
        dampen.simulate(scenario("numerics.modes=1"))
