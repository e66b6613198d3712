"""Controllers: learning against the lifted matrix, monotone norms, LQG against LQR, feedback alone, the inner loop."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.signal import butter, sosfiltfilt

import dampen
from dampen.controllers import norm_optimal_ilc, p_type_ilc
from dampen.controllers.sampled_plant import under_way
from dampen.simulation.bench import Bench
from dampen.simulation.setting import setting_of

BEAM = dampen.TimoshenkoBeam(damping=dampen.Damping(ratio=0.02))
STEP, DURATION = 0.002, 0.8


def case(controller: dampen.Controller, period: float | None = None, delay: float = 0.0, **changes: object) -> dampen.Scenario:
    """A reset task with a repeated disturbance, a reference and ideal actuators; with a `period`, through samples."""
    move, sway = dampen.MinimumJerk(target=0.05, duration=0.6), dampen.Sinusoid(amplitude=0.02, frequency=2.0)
    parts: dict[str, object] = {
        "plant": BEAM,
        "controller": controller,
        "disturbance": dampen.HarmonicFamilies(frozen_at=0),
        "task": dampen.Task(trials=6, trial_duration=DURATION, start="reset", reference={"tip_w": move, "tip_phi": sway}),
        "numerics": dampen.Numerics(modes=16, step=STEP, mode="sampled" if period else "continuous"),
        "sampling": dampen.Sampling(period=period or STEP, delay=delay),
    }
    return dampen.Scenario(**{**parts, **changes})  # type: ignore[arg-type]


def lifted(scenario: dampen.Scenario) -> np.ndarray:
    """P of the plant alone, from the matrix exponential of its state equations: (steps ports, steps ports)."""
    modes, (steps, dt) = Bench(scenario).modes, scenario.law_grid
    n, ports = modes.count, len(scenario.ports)
    a = np.zeros((2 * n + ports, 2 * n + ports))
    a[:n, n : 2 * n] = np.eye(n)
    a[n : 2 * n, :n], a[n : 2 * n, n : 2 * n] = -np.diag(modes.omega**2), -2 * np.diag(modes.decay)
    a[n : 2 * n, 2 * n :] = modes.b.T
    step = expm(a * dt)
    free, push, see = step[: 2 * n, : 2 * n], step[: 2 * n, 2 * n :], np.hstack([modes.b, np.zeros((ports, n))])
    markov = []
    for _ in range(steps):
        markov.append(see @ push)
        push = free @ push
    p = np.zeros((steps * ports, steps * ports))
    for k in range(steps):
        for i in range(k + 1):
            p[ports * k : ports * k + ports, ports * i : ports * i + ports] = markov[k - i]
    return p


def errors(result: dampen.Result) -> np.ndarray:
    """(trials, intervals ports): errors r - y at the ends of the law's intervals."""
    steps, dt = result.scenario.law_grid
    each = round(dt / result.scenario.numerics.step)
    assert result.layout.shape(result.layout.variables["y"])[0] == steps * each + 1
    return (result["reference"] - result["y"])[:, each::each].reshape(result.trials, -1)


@pytest.mark.parametrize("period", [None, 0.004])
def test_p_type_errors_obey_the_lifted_recursion(period: float | None) -> None:
    gain = 15.0
    scenario = case(dampen.PTypeILC(learning={"tip_w": gain, "tip_phi": gain}), period)
    e, p = errors(dampen.simulate(scenario)), lifted(scenario)
    for before, after in pairwise(e):
        np.testing.assert_allclose(after, before - p @ (gain * before), atol=1e-9 * np.abs(e).max())


def test_pd_type_errors_obey_the_lifted_recursion() -> None:
    law = dampen.PDTypeILC(learning={"tip_w": 5.0, "tip_phi": 5.0}, rate_learning={"tip_w": 0.5, "tip_phi": 0.5}, forgetting=0.05)
    scenario = case(law)
    result, p = dampen.simulate(scenario), lifted(scenario)
    e, u = errors(result), result["learned"].reshape(result.trials, -1)
    for j in range(1, result.trials - 1):
        wanted = e[j] - p @ (u[j] - u[j - 1])
        np.testing.assert_allclose(e[j + 1], wanted, atol=1e-9 * np.abs(e).max())
        rate = np.diff(e[j].reshape(-1, 2), axis=0, prepend=np.zeros((1, 2))).ravel() / STEP
        interior = slice(2, None)
        np.testing.assert_allclose(
            u[j][interior], (0.95 * u[j - 1] + 5.0 * e[j] + 0.5 * rate)[interior], atol=1e-9 * np.abs(u).max()
        )


def test_the_model_s_response_is_the_lifted_matrix() -> None:
    for scenario in (case(dampen.PTypeILC()), case(dampen.PTypeILC(), 0.004)):
        setting = setting_of(scenario, Bench(scenario))
        ports = len(setting.ports)
        first_columns = lifted(scenario)[:, :ports].reshape(setting.steps, ports, ports)
        np.testing.assert_allclose(setting.response(), first_columns, atol=1e-13)


@pytest.mark.parametrize("feedback", [0.0, 3.0])
@pytest.mark.parametrize("period", [None, 0.004])
def test_norm_optimal_errors_fall_monotonically(period: float | None, feedback: float) -> None:
    law = dampen.NormOptimalILC(
        change_weight=1e-5, damping={"tip_w": feedback, "tip_phi": feedback}, stiffness={"tip_w": feedback}
    )
    norms = np.linalg.norm(errors(dampen.simulate(case(law, period))), axis=1)
    assert np.all(np.diff(norms) < 0)
    assert norms[-1] < 0.03 * norms[0]


def test_norm_optimal_learning_solves_its_normal_equations() -> None:
    law = dampen.NormOptimalILC(error_weight={"tip_w": 3.0, "tip_phi": 0.5}, effort_weight=2e-4, change_weight=1e-3)
    scenario = case(law)
    result, p = dampen.simulate(scenario), lifted(scenario)
    e, u = errors(result), result["learned"].reshape(result.trials, -1)
    weight = np.tile([3.0, 0.5], scenario.steps)
    matrix = p.T @ (weight[:, None] * p) + (2e-4 + 1e-3) * np.eye(len(p))
    expected = np.linalg.solve(matrix, 1e-3 * u[1] + p.T @ (weight * (e[2] + p @ u[1])))
    np.testing.assert_allclose(u[2], expected, atol=1e-9 * np.abs(u[2]).max())


def block_toeplitz(response: np.ndarray) -> np.ndarray:
    """The lifted matrix, (steps ports, steps ports), of a response (steps, ports, ports)."""
    steps, ports, _ = response.shape
    p = np.zeros((steps, ports, steps, ports))
    for k in range(steps):
        for i in range(k + 1):
            p[k, :, i] = response[k - i]
    return p.reshape(steps * ports, -1)


@pytest.mark.parametrize("few", [0, 150])
def test_factors_and_conjugate_gradients_solve_the_normal_equations(few: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """One port is seen but has no actuator, one moves but is not seen; factors are kept for the trials that follow."""
    monkeypatch.setattr(norm_optimal_ilc, "FEW", few)
    random, weight, ridge = np.random.default_rng(4), np.array([3.0, 0.5, 2.0]), 1e-2
    response = random.standard_normal((9, 3, 3)) * 0.8 ** np.arange(9)[:, None, None]
    response[:, :, 1], response[:, 2] = 0.0, 0.0
    lifted, p = norm_optimal_ilc.Lifted(response), block_toeplitz(response)
    matrix = p.T @ (np.tile(weight, 9)[:, None] * p) + ridge * np.eye(27)
    for _ in range(3):
        right = random.standard_normal((9, 3))
        np.testing.assert_allclose(lifted(right).ravel(), p @ right.ravel(), atol=1e-13)
        np.testing.assert_allclose(lifted.back(right).ravel(), p.T @ right.ravel(), atol=1e-13)
        found = lifted.solve(weight, ridge, right)
        np.testing.assert_allclose(found.ravel(), np.linalg.solve(matrix, right.ravel()), rtol=1e-9, atol=1e-11)
    assert (lifted.factors is None) == (few > 0)


@pytest.mark.parametrize("delay", [0.0, 0.004, 0.006, 0.01])
def test_lqg_without_noise_equals_lqr(delay: float) -> None:
    """From rest, nothing unknown: the filter's estimate is exact, and the commands are those of the state fed back."""
    law = dampen.LQG(modes=16, error_weight={"tip_w": 1e3, "tip_phi": 1e3})
    scenario = case(law, 0.004, delay, disturbance=dampen.NoDisturbance())
    bench = Bench(scenario)
    setting = setting_of(scenario, bench)
    design = law.design(setting)
    x, commands = np.zeros(len(design.a)), []
    for reference in setting.reference[:-1]:
        u = design.feed @ reference - design.hold @ x
        commands.append(u)
        x = design.a @ x + design.b @ u
    result = dampen.simulate(replace(scenario, task=replace(scenario.task, trials=1)), bench=bench)
    np.testing.assert_allclose(result["issued"][0], commands, atol=1e-9 * np.abs(commands).max())


def test_lqg_s_gains_are_those_of_an_independent_recursion() -> None:
    """The Riccati difference equation, run until it stands, instead of the algebraic one."""
    law = dampen.LQG(modes=4, error_weight={"tip_w": 10.0}, effort_weight=0.05)
    scenario = case(law, 0.004)
    setting = setting_of(scenario, Bench(scenario))
    d, omega = law.design(setting), setting.model().omega[:4]
    weight = np.diag([*omega**2, 1, 1, 1, 1]) + 10.0 * np.outer(d.c[0], d.c[0])
    cost = weight.copy()
    for _ in range(20_000):
        hold = np.linalg.solve(0.05 * np.eye(2) + d.b.T @ cost @ d.b, d.b.T @ cost @ d.a)
        cost = weight + d.a.T @ cost @ (d.a - d.b @ hold)
    np.testing.assert_allclose(d.hold, hold, rtol=1e-7, atol=1e-9)
    assert np.abs(np.linalg.eigvals(d.a - d.b @ d.hold)).max() < 1
    assert np.abs(np.linalg.eigvals(d.a - d.a @ d.correct @ d.c)).max() < 1


@pytest.mark.parametrize("factor", [1e-8, 1e8])
def test_only_ratios_of_lqg_s_weights_and_of_its_noises_count(factor: float) -> None:
    """Where one port has a weight and another neither weight nor actuator: however small the weight, only the one is asked."""
    noises = {"force_noise": 0.1, "sensor_noise": 1e-4}
    weights = {"energy_weight": 1.0, "error_weight": {"tip_w": 1e-4}, "effort_weight": 0.01}
    law = dampen.LQG(modes=4, **noises, **weights)  # type: ignore[arg-type]
    other = dampen.LQG(
        modes=4, energy_weight=factor, error_weight={"tip_w": 1e-4 * factor}, effort_weight=0.01 * factor,
        **{name: factor * value for name, value in noises.items()},  # type: ignore[arg-type]
    )  # fmt: skip
    scenario = case(law, 0.004, actuators={"tip_phi": (dampen.Absent(),)}, task=dampen.Task(trials=1, trial_duration=DURATION))
    setting = setting_of(scenario, Bench(scenario))
    for one, same in zip(law.design(setting), other.design(setting), strict=True):
        np.testing.assert_allclose(same, one, rtol=1e-6, atol=1e-6 * np.abs(one).max())


def test_a_delay_of_so_many_periods_has_as_many_commands_under_way_however_it_rounds() -> None:
    setting = setting_of(case(dampen.PTypeILC()))
    for dt in (0.1, 0.003, 0.001):
        for count in range(40):
            delay = sum([dt] * count)  # not always count * dt
            assert under_way(replace(setting, dt=dt, delay=delay)) == count
            assert under_way(replace(setting, dt=dt, delay=delay + 1e-3 * dt)) == count + 1


def test_lqg_comes_to_rest_on_its_reference() -> None:
    law = dampen.LQG(modes=16, error_weight={"tip_w": 1e4, "tip_phi": 1e4}, effort_weight=1e-3)
    task = dampen.Task(trials=1, trial_duration=20.0, reference={"tip_w": dampen.Hold(0.03), "tip_phi": dampen.Hold(-0.02)})
    result = dampen.simulate(case(law, 0.004, disturbance=dampen.NoDisturbance(), task=task))
    np.testing.assert_allclose(result["y"][0][-1], [0.03, -0.02], rtol=1e-6)


def test_the_inner_loop_alone_is_the_first_trial_of_the_dual_loop() -> None:
    adaptive = dampen.read_scenario("he2017", ["controller.kind=adaptive-boundary", "task.trials=2"])
    dual = dampen.read_scenario("he2017", ["task.trials=2"])
    alone, both = dampen.simulate(adaptive), dampen.simulate(dual)
    np.testing.assert_array_equal(alone["y"][0], both["y"][0])
    assert np.abs(alone["y"][1] - both["y"][1]).max() > 1e-4


def test_a_backlash_believed_at_torques_is_meant_there_alone() -> None:
    force, torque = dampen.AssumedBacklash(0.5, 0.4, -0.1), dampen.AssumedBacklash(0.25, 0.1, -0.3)
    law = dampen.DualLoopAILC(assumed_backlash=force, assumed_torque_backlash=torque)
    scenario = dampen.read_scenario("he2017", ["task.trials=1"])
    first, second = (law.compensation(port)[0].row(0.001) for port in scenario.plant.ports)
    assert (first, second) == ((2.0, -0.1), (4.0, -0.3))
    np.testing.assert_allclose(law.learning_row(setting_of(scenario))[2], [0.25, 0.1], rtol=1e-15)
    same = replace(law, assumed_torque_backlash=None)
    assert [same.assumed_at(port) for port in scenario.plant.ports] == [force, force]


def test_a_barrier_acts_where_it_has_a_gain_and_none_acts_nowhere() -> None:
    limited = dampen.Task(trials=1, trial_duration=DURATION, constraint={"tip_w": 0.2})
    law = dampen.BoundaryDamping(barrier="log", barrier_gain={"tip_w": 0.5})
    scenario = case(law, task=limited)
    setting = setting_of(scenario)
    np.testing.assert_array_equal(law.law({}, setting).barrier, [0.5, 0.0])
    assert [law.has_barrier(port) for port in scenario.plant.ports] == [True, False]
    with pytest.raises(dampen.ArgumentError, match=r"`task.constraint.tip_phi` must be given"):
        case(replace(law, barrier_gain={"tip_w": 0.5, "tip_phi": 0.1}), task=limited)
    for off in (replace(law, barrier="none"), dampen.AdaptiveBoundary(barrier="none")):
        free = case(off, task=replace(limited, constraint={}), bounds={"f": 0.1, "tip_w": 0.1, "tip_phi": 0.1})
        assert not off.law(off.begin(setting_of(free)), setting_of(free)).barrier.any()
        assert not off.has_barrier(scenario.plant.ports[0])


def test_open_loop_and_feedforward_command_what_they_are_told() -> None:
    signal = dampen.Sinusoid(amplitude=0.4, frequency=1.5)
    given = {"tip_w": signal, "tip_phi": 0.1}
    result = dampen.simulate(case(dampen.OpenLoop(command=given)))
    t = (np.arange(result.scenario.steps) + 0.5) * STEP
    np.testing.assert_allclose(result["delivered"][3], np.column_stack([signal.sample(t, 0), np.full(len(t), 0.1)]), atol=1e-12)
    fed = dampen.simulate(case(dampen.BoundaryDamping(feedforward=given)))
    np.testing.assert_array_equal(fed["delivered"], result["delivered"])


def test_stiffness_holds_a_static_load_as_hooke_s_law_says() -> None:
    """At rest under a constant force F a port with stiffness k in front of compliance c gives way by F c / (1 + k c)."""
    law = dampen.BoundaryDamping(stiffness={"tip_w": 40.0}, damping={"tip_w": 3.0, "tip_phi": 3.0})
    task = dampen.Task(trials=1, trial_duration=20.0)
    numerics, push = dampen.Numerics(modes=16, step=0.004), dampen.ConstantLoad(force={"tip_w": 0.5})
    scenario = case(law, task=task, disturbance=push, numerics=numerics)
    c = Bench(scenario).modes
    compliance = float((c.b[0] ** 2 / c.omega**2).sum())
    assert dampen.simulate(scenario)["y"][0][-1, 0] == pytest.approx(0.5 * compliance / (1 + 40.0 * compliance), rel=1e-6)


def test_a_q_filter_keeps_what_is_slow_and_drops_what_is_fast() -> None:
    from dampen.controllers.p_type_ilc import low_pass

    t = np.arange(2000) * 0.001
    slow, fast = np.sin(2 * np.pi * 2 * t), np.sin(2 * np.pi * 100 * t)
    kept = low_pass(np.column_stack([slow, fast]), 20.0, 0.001)[200:-200]
    np.testing.assert_allclose(kept[:, 0], slow[200:-200], atol=2e-3)
    assert np.abs(kept[:, 1]).max() < 0.01
    assert low_pass(slow, None, 0.001) is slow
    assert low_pass(slow, 500.0, 0.001) is slow


def test_a_q_filter_treats_the_ends_as_scipy_s_own_does() -> None:
    """Mirrored by three samples for each coefficient, or by as many as a short trial has."""
    signal = np.random.default_rng(2).standard_normal((40, 2))
    section = butter(2, 20.0, fs=1000.0, output="sos")
    np.testing.assert_array_equal(p_type_ilc.low_pass(signal, 20.0, 0.001), sosfiltfilt(section, signal, axis=0))
    np.testing.assert_array_equal(
        p_type_ilc.low_pass(signal[:4], 20.0, 0.001), sosfiltfilt(section, signal[:4], axis=0, padlen=3)
    )


def test_lqg_brings_the_port_that_is_asked_to_its_reference_when_another_has_no_actuator() -> None:
    """A rest position is the plant's, not the sample period's; a port without actuator, weight and reference is left free."""
    beam = dampen.EulerBernoulliBeam(tip_mass=0.1, mass_per_length=0.5, bending_stiffness=4.0, damping=dampen.Damping(ratio=0.05))
    law = dampen.LQG(modes=6, error_weight={"tip_w": 1e4}, effort_weight=1e-3)
    task = dampen.Task(trials=1, trial_duration=6.0, reference={"tip_w": dampen.MinimumJerk(target=0.05, duration=0.6)})
    calm, no_motor = dampen.NoDisturbance(), {"tip_phi": (dampen.Absent(),)}
    for period in (0.002, 0.004):
        numerics = dampen.Numerics(modes=6, step=STEP, mode="sampled")
        result = dampen.simulate(
            case(law, period, plant=beam, task=task, disturbance=calm, actuators=no_motor, numerics=numerics)
        )
        np.testing.assert_allclose(result["y"][0][-1, 0], 0.05, rtol=1e-6)
        assert result.warnings == []


def test_lqg_warns_where_the_modes_it_leaves_out_grow_and_a_blown_up_run_has_diverged() -> None:
    beam = dampen.EulerBernoulliBeam(tip_mass=0.1, mass_per_length=0.5, bending_stiffness=4.0, damping=dampen.Damping(ratio=0.05))
    law = dampen.LQG(modes=4, error_weight={"tip_w": 1e4}, effort_weight=1e-3)
    task = dampen.Task(trials=1, trial_duration=6.0, reference={"tip_w": dampen.MinimumJerk(target=0.05, duration=0.6)})
    numerics = dampen.Numerics(modes=6, step=0.001, mode="sampled")
    result = dampen.simulate(case(law, 0.001, plant=beam, task=task, disturbance=dampen.NoDisturbance(), numerics=numerics))
    assert result.status == "diverged"
    assert any("spillover" in line for line in result.warnings)
