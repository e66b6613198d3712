"""Sampled control: what the controller reads, when its command acts, and what becomes of Sgn."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import dampen
from dampen.simulation.digital_law import implicit
from tests.conftest import scenario

SAMPLED = ("numerics.mode=sampled", "numerics.modes=80")


def variation(result: dampen.Result) -> np.ndarray:
    """(ports,) total variation of the command over the whole run."""
    commands = result["command"].reshape(-1, len(result.scenario.ports))
    return np.asarray(np.abs(np.diff(commands, axis=0)).sum(axis=0))


def residual(result: dampen.Result) -> np.ndarray:
    """(ports,) RMS of the displacements in the last trial."""
    return np.asarray(np.sqrt(np.mean(result["y"][-1] ** 2, axis=0)))


@pytest.fixture(scope="module")
def explicit_and_implicit() -> tuple[dampen.Result, dampen.Result]:
    """The paper's experiment at 1 ms, both ways; the implicit one with a compliance at which it leaves the same residual."""
    unfiltered = (*SAMPLED, "sampling.filter_time=0.0")
    explicit = dampen.simulate(scenario(*unfiltered, "sampling.switching=explicit"))
    soft = "sampling.compliance={tip_w=0.0475,tip_phi=0.0446}"
    return explicit, dampen.simulate(scenario(*unfiltered, "sampling.switching=implicit", soft))


def test_implicit_switching_chatters_a_tenth_as_much_at_no_larger_residual(
    explicit_and_implicit: tuple[dampen.Result, dampen.Result],
) -> None:
    explicit, implicit_run = explicit_and_implicit
    assert np.all(variation(implicit_run) <= 0.1 * variation(explicit))
    assert np.all(residual(implicit_run) <= residual(explicit))


def test_the_models_own_compliance_leaves_the_residual_of_the_continuous_law(
    explicit_and_implicit: tuple[dampen.Result, dampen.Result],
) -> None:
    ours = dampen.simulate(scenario(*SAMPLED, "sampling.filter_time=0.0", "sampling.switching=implicit"))
    continuous = dampen.simulate(scenario("numerics.modes=80"))
    assert variation(ours).sum() <= 0.1 * variation(explicit_and_implicit[0]).sum()
    np.testing.assert_allclose(residual(ours), residual(continuous), rtol=0.1)


def test_a_delayed_command_is_counted_in() -> None:
    """With a sample of delay the implicit law still leaves about the continuous residual; the explicit one does not."""
    late = (*SAMPLED, "sampling.delay=0.001")
    explicit = dampen.simulate(scenario(*late, "sampling.switching=explicit"))
    foresighted = dampen.simulate(scenario(*late, "sampling.switching=implicit"))
    continuous = dampen.simulate(scenario("numerics.modes=80"))
    np.testing.assert_allclose(residual(foresighted), residual(continuous), rtol=0.25)
    assert residual(explicit)[0] > 2 * residual(foresighted)[0]


@pytest.mark.parametrize(("smooth", "rate"), [(0.3, 0.0), (-2.0, 0.5), (5.0, -0.1), (0.0, 0.02), (-0.2, -0.004)])
def test_the_implicit_command_solves_its_inclusion(smooth: float, rate: float) -> None:
    damping, coulomb, compliance = 1.3, 0.6, 0.01
    u = implicit(smooth, rate, damping, coulomb, compliance)
    v = rate + compliance * u
    s = (smooth - damping * v - u) / coulomb
    if abs(v) > 1e-12:
        assert s == pytest.approx(np.sign(v))
    else:
        assert abs(s) <= 1 + 1e-12


@pytest.mark.parametrize(("delay", "late"), [(0.0, 0), (0.001, 1), (0.004, 4), (0.006, 6), (0.011, 11)])
def test_commands_are_held_and_act_after_the_delay(delay: float, late: int) -> None:
    case = scenario(*SAMPLED, "sampling.period=0.004", f"sampling.delay={delay}", "task.trials=3", "numerics.modes=20")
    result = dampen.simulate(case)
    issued = np.repeat(result["issued"].reshape(-1, 2), 4, axis=0)
    held = np.vstack([np.zeros((late, 2)), issued])[: len(issued)]
    np.testing.assert_array_equal(result["command"].reshape(-1, 2), held)


def test_readings_carry_noise_and_come_in_quanta() -> None:
    noisy = ("task.trials=2", "numerics.modes=20", "sampling.noise={tip_w=1e-4,tip_phi=3e-4}")
    result = dampen.simulate(scenario(*SAMPLED, *noisy))
    error = result["reading"] - result["y"][:, :-1]
    np.testing.assert_allclose(error.std(axis=(0, 1)), [1e-4, 3e-4], rtol=0.05)
    assert abs(np.corrcoef(error[0, :, 0], error[1, :, 0])[0, 1]) < 0.1
    again = dampen.simulate(scenario(*SAMPLED, *noisy))
    np.testing.assert_array_equal(result["reading"], again["reading"])
    other = dampen.simulate(scenario(*SAMPLED, *noisy, "sampling.seed=1"))
    assert np.abs(result["reading"] - other["reading"]).max() > 1e-5
    coarse = dampen.simulate(scenario(*SAMPLED, "task.trials=1", "numerics.modes=20", "sampling.quantum={tip_w=0.001}"))
    steps = coarse["reading"][0][:, 0] / 0.001
    np.testing.assert_allclose(steps, np.round(steps), atol=1e-9)
    assert np.abs(coarse["reading"][0][:, 0] - coarse["y"][0][:-1, 0]).max() <= 0.0005 + 1e-12
    assert np.abs(coarse["reading"][0][:, 1] - coarse["y"][0][:-1, 1]).max() == 0.0


@pytest.mark.parametrize("rate", ["difference", "observer"])
def test_the_estimated_rate_follows_a_slow_motion(rate: str) -> None:
    """Without control the estimate lags the true rate by a few milliseconds, and no more."""
    case = scenario(*SAMPLED, f"sampling.rate={rate}", "task.trials=2", "numerics.modes=8", "disturbance.kind=none")
    idle = replace(case, controller=dampen.BoundaryDamping(), claims=None)
    result = dampen.simulate(idle)
    estimate, y = result["rate_estimate"].reshape(-1, 2), result["y"][:, :-1].reshape(-1, 2)
    true = np.gradient(y, 0.001, axis=0)
    lag = min(range(12), key=lambda k: float(np.abs(estimate[200:-20, 0] - true[200 - k : -20 - k, 0]).max()))
    assert lag <= 8
    assert np.abs(estimate[200:-20, 0] - true[200 - lag : -20 - lag, 0]).max() < 0.03 * np.abs(true).max()


def test_command_limits_hold_and_the_barrier_ends_at_its_edge() -> None:
    limited = dampen.simulate(scenario(*SAMPLED, "sampling.command_limit={tip_w=0.8}", "task.trials=2"))
    assert np.abs(limited["command"][:, :, 0]).max() == 0.8
    assert np.abs(limited["command"][:, :, 1]).max() > 0.8
    lost = dampen.simulate(scenario(*SAMPLED, "actuator.all.chain=[{kind='absent'}]", "task.trials=2"))
    assert lost.status == "constraint_lost"
    assert np.abs(lost["command"]).max() < 1e3


def test_a_non_monotone_actuator_may_follow_a_held_command() -> None:
    steep = "actuator.all.chain=[{kind='bouc-wen',hysteresis=-3.0}]"
    result = dampen.simulate(scenario(*SAMPLED, steep, "task.trials=1", "numerics.modes=20"))
    assert not any("did not settle" in line for line in result.warnings)


def test_a_sampled_scenario_runs_continuously_and_uncontrolled_on_the_same_bench() -> None:
    from dampen.simulation.bench import Bench

    case = scenario(*SAMPLED, "task.trials=2")
    bench = Bench(case)
    dampen.simulate(case, bench=bench)
    continuous = dampen.simulate(case.continuous(), bench=bench)
    np.testing.assert_allclose(continuous["y"], dampen.simulate(scenario("task.trials=2"))["y"], atol=1e-12)
    assert bench.kernel(case)[0] is bench.kernel(case.uncontrolled())[0]


@pytest.mark.parametrize("switching", ["explicit", "boundary-layer", "implicit"])
def test_each_switching_compiled_is_its_plain_source(switching: str) -> None:
    case = dampen.read_scenario(
        "he2017-sampled",
        [f"sampling.switching={switching}", "task.trials=2", "task.trial_duration=0.1", "numerics.modes=6"],
    )
    compiled, plain = dampen.simulate(case), dampen.simulate(case, compile=False)
    np.testing.assert_allclose(compiled["issued"], plain["issued"], rtol=0, atol=1e-9)
    assert np.abs(compiled["issued"]).max() > 0.1
