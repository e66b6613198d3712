"""Tasks: resets, references, constraints that are uneven or move, and what becomes of a run that loses its constraint."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import dampen
from dampen.analysis.metrics import fraction_of_limit, largest
from dampen.simulation.bench import Bench
from tests.conftest import scenario

SHORT = ("numerics.modes=40", "task.trials=4", "disturbance.frozen_at=0")


def task(**changes: object) -> dampen.Scenario:
    case = scenario(*SHORT)
    return replace(case, task=replace(case.task, **changes), claims=None)  # type: ignore[arg-type]


def test_exact_resets_repeat_the_same_trial_without_learning() -> None:
    case = replace(task(start="reset"), controller=dampen.AdaptiveBoundary())
    result = dampen.simulate(case)
    for j in range(1, 4):
        np.testing.assert_array_equal(result["y"][j], result["y"][0])
        np.testing.assert_array_equal(result["delivered"][j], result["delivered"][0])


def test_chained_trials_go_on_where_the_last_one_ended() -> None:
    result = dampen.simulate(task())
    for j in range(1, 4):
        np.testing.assert_allclose(result["y"][j][0], result["y"][j - 1][-1], atol=1e-15)
        assert result["energy"][j][0] == pytest.approx(result["energy"][j - 1][-1], rel=1e-12)


def test_a_reset_misses_by_as_much_as_it_was_told() -> None:
    case = task(start="reset", reset_error={"tip_w": 1e-3, "tip_phi": 2e-3}, seed=5)
    bench = Bench(case)
    off = []
    for j in range(400):
        modal = bench.modal_record(j)
        off.append(bench.modes.b @ (modal.q[0, : bench.modes.count] - bench.start[0]))
    spread, mean = np.std(off, axis=0), np.mean(off, axis=0)
    np.testing.assert_allclose(spread, [1e-3, 2e-3], rtol=0.1)
    np.testing.assert_allclose(mean, 0, atol=3e-4)
    np.testing.assert_array_equal(bench.modal_record(7).q, Bench(case).modal_record(7).q)
    assert not np.array_equal(bench.modal_record(7).q, Bench(task(start="reset", reset_error={"tip_w": 1e-3})).modal_record(7).q)


@pytest.mark.parametrize("step", ["1e-3", "4e-3"])
def test_uneven_limits_hold_under_the_barrier(step: str) -> None:
    case = scenario(*SHORT, f"numerics.step={step}", "task.constraint={tip_w=[-0.05,0.17],tip_phi=[-0.1,0.19]}")
    result = dampen.simulate(case)
    assert result.status == "complete"
    assert result["y"][:, :, 0].min() > -0.05
    assert result["y"][:, :, 0].max() < 0.17
    low, high = case.limits()
    np.testing.assert_array_equal([low[5], high[5]], [[-0.05, -0.1], [0.17, 0.19]])


def test_the_barrier_holds_a_limit_that_tightens() -> None:
    funnel = dampen.Constraint(high=dampen.Decay(start=0.2, final=0.01, time_constant=0.3), on="error")
    case = task(constraint={"tip_w": funnel, "tip_phi": 0.2}, start="reset")
    result = dampen.simulate(case)
    low, high = case.limits(1)
    t = result.time
    np.testing.assert_allclose(high[:, 0], 0.01 + 0.19 * np.exp(-t / 0.3))
    np.testing.assert_array_equal(low, -high)
    assert result.status == "complete"
    assert np.all(np.abs(result["y"]) < high)
    assert 0.8 < fraction_of_limit(result, "tip_w").max() < 1
    without = replace(case, controller=replace(case.controller, barrier="none"))  # type: ignore[type-var]
    assert dampen.simulate(without).status == "constraint_lost"


def test_limits_on_the_error_move_with_the_reference() -> None:
    path = dampen.Sinusoid(amplitude=0.05, frequency=0.5)
    case = task(
        reference={"tip_w": path}, constraint={"tip_w": dampen.Constraint(high=0.2, low=-0.1, on="error"), "tip_phi": 0.2}
    )
    low, high = case.limits()
    r = path.sample(case.times, 0)
    np.testing.assert_allclose(high[:, 0], r + 0.2)
    np.testing.assert_allclose(low[:, 0], r - 0.1)


def test_a_reference_outside_its_constraint_is_refused() -> None:
    path = dampen.Sinusoid(amplitude=0.3, frequency=0.5)
    with pytest.raises(dampen.ArgumentError, match=r"`task.constraint.tip_w` must leave room for the reference, but at t = 0.2"):
        dampen.simulate(task(reference={"tip_w": path}))


def test_the_paper_s_law_follows_a_reference() -> None:
    """Slow motion of the tip: the error is a small share of it, and the result keeps the reference."""
    path = dampen.Sinusoid(amplitude=0.02, frequency=0.5, ramp=0.5)
    case = replace(task(reference={"tip_w": path}, trials=8), disturbance=dampen.NoDisturbance())
    case = replace(case, plant=replace(case.plant, initial=dampen.BeamState()))  # type: ignore[type-var]
    result = dampen.simulate(case)
    error = result["y"][-1][:, 0] - result["reference"][-1][:, 0]
    np.testing.assert_array_equal(result["reference"][3][:, 0], path.sample(result.time, 3))
    assert np.abs(error).max() < 0.2 * 0.02
    plain = dampen.simulate(case.uncontrolled())
    assert np.abs(plain["y"]).max() < 1e-15


def test_a_lost_constraint_is_a_status_with_its_time_and_the_run_goes_on() -> None:
    case = scenario(*SHORT, "actuator.all.chain=[{kind='saturation',low=-0.02,high=0.02}]")
    result = dampen.simulate(case)
    assert (result.status, result.trials, result.broke_off) == ("constraint_lost", 4, False)
    first = np.flatnonzero(np.abs(result["y"][0][:, 0]) >= 0.2)[0]
    assert f"The constraint of tip_w was lost, first at t = {first * 0.001:.4g} s of trial 0." in result.warnings
    assert fraction_of_limit(result, "tip_w").max() == pytest.approx(largest(result, "y", "tip_w").max() / 0.2)


def test_without_control_the_constraint_is_judged_too() -> None:
    assert dampen.simulate(scenario(*SHORT).uncontrolled()).status == "constraint_lost"


def test_the_tan_barrier_keeps_the_constraint_and_its_energy_account() -> None:
    result = dampen.simulate(scenario(*SHORT, "controller.barrier=tan", "controller.compensate=false"))
    assert result.status == "complete"
    assert np.abs(result["y"]).max() < 0.2


BAD = {
    "task.constraint.tip_w=-1": "`task.constraint.tip_w` must be > 0, but is -1",
    "task.constraint.tip_w=[0.2,0.1]": "`task.constraint.tip_w` must be [low, high] with low < high, but is [0.2, 0.1]",
    "task.constraint.tip_w={high='a'}": "`task.constraint.tip_w.high` must be a number",
    "task.constraint.tip_w={high=1,top=1}": "`task.constraint.tip_w.top` is not known",
    "task.reset_error={tip_w=0.1}": '`task.reset_error` must be left out unless `start` is "reset"',
    "task.start=resett": "`task.start` must be 'chained' or 'reset'",
    "task.reference.tip_w={kind='jerk'}": "`task.reference.tip_w.kind` must be a known kind of signal",
    "task.reference.tap={kind='hold'}": "`task.reference.tap` is not a port of this plant",
    "sampling.period=0.0015": "`sampling.period` must divide",
    "sampling.period=0.00001": "`sampling.period` must be a multiple of numerics.step",
    "sampling.delay=0.0015": "`sampling.delay` must be a multiple of numerics.step",
    "sampling.noise={tip=1.0}": "`sampling.noise.tip` is not a port of this plant",
    "sampling.noise={tip_w=-1.0}": "`sampling.noise.tip_w` must be >= 0",
    "sampling.switching=smooth": "`sampling.switching` must be 'explicit', 'boundary-layer' or 'implicit'",
    "controller.barrier=log10": "`controller.barrier` must be 'log', 'tan' or 'none'",
}


@pytest.mark.parametrize("setting", list(BAD))
def test_bad_input_gets_one_clear_line(setting: str) -> None:
    with pytest.raises(dampen.ArgumentError) as error:
        scenario("numerics.mode=sampled", setting)
    assert len(error.value.lines) == 1
    assert BAD[setting] in error.value.lines[0]


def test_a_barrier_at_one_port_needs_a_constraint_there_alone() -> None:
    law = dampen.BoundaryDamping(damping={"tip_w": 1.0}, barrier="log", barrier_gain={"tip_w": 0.1})
    case = replace(task(), controller=law)
    alone, other = (replace(case.task, constraint={port: 0.2}) for port in ("tip_w", "tip_phi"))
    assert dampen.simulate(replace(case, task=alone)).status == "complete"
    with pytest.raises(dampen.ArgumentError, match=r"`task.constraint.tip_w` must be given"):
        replace(case, task=other)


def test_what_acts_through_samples_alone_says_so() -> None:
    with pytest.raises(dampen.ArgumentError, match=r'`numerics.mode` must be "sampled": LQG acts through samples'):
        scenario("controller.kind=lqg")
