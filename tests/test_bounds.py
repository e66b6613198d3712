"""A-priori bounds of passive laws: what they rest on, that runs keep them, and that wrong ones are found out."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from pydantic import TypeAdapter
from scipy.integrate import solve_ivp

import dampen
from dampen.analysis.audit.loop import bound_rows
from dampen.analysis.bounds import Bounds, bounds, energy
from dampen.analysis.growth import largest_energy
from dampen.analysis.supply import deviation
from dampen.controllers.inner_loop import FlankInverse
from dampen.simulation.bench import Bench
from dampen.simulation.compose import BARRIERS
from tests.conftest import scenario

PORTS = ("tip_w", "tip_phi")
DAMPED = dampen.BoundaryDamping(damping=dict.fromkeys(PORTS, 1.0))
LIKE = {"tip_w": 0.3, "tip_phi": 0.3}


def beam(law: dampen.Controller, *overrides: str, **parts: Any) -> dampen.Scenario:
    base = scenario("numerics.modes=64", "task.trials=3", *overrides)
    return replace(base, controller=law, **parts)


def of(case: dampen.Scenario) -> Bounds:
    return bounds(dampen.simulate(case))


def kept(answer: Bounds) -> bool:
    """What `holds` says, read from the figures by trial."""
    ports = all(m <= b for port in answer.ports for b, m in zip(port.bound, port.measured, strict=False))
    return ports and all(m <= b * (1 + 1e-9) for b, m in zip(answer.bound, answer.measured, strict=False))


@pytest.mark.parametrize(("initial", "power", "push"), [(0.7, 0.3, 0.2), (0.0, 0.1, 0.5), (0.4, 0.2, 1e-7), (2.0, 1e-9, 0.3)])
def test_the_largest_energy_solves_its_differential_equation_from_above(initial: float, power: float, push: float) -> None:
    t = np.linspace(0, 20, 101)
    begin = max(initial, 1e-12)
    exact = solve_ivp(lambda _, v: power + push * np.sqrt(2 * v), (0, 20), [begin], t_eval=t, rtol=1e-11, atol=1e-14).y[0]
    found = largest_energy(t, initial, power, push)
    np.testing.assert_allclose(found, exact, rtol=1e-6, atol=1e-8)
    assert found[0] == pytest.approx(initial)
    assert np.all(np.diff(found) > 0)


ACTUATORS = [
    (dampen.Backlash(),), (FlankInverse(dampen.AssumedBacklash()), dampen.Backlash()), (dampen.DeadZone(right=0.2, left=-0.05),),
    (FlankInverse(dampen.AssumedBacklash(slope=0.5, left=-0.1)), dampen.Backlash()), (dampen.PrandtlIshlinskii(),),
    (dampen.BacklashInverse(), dampen.Backlash()), (dampen.DeadZoneInverse(), dampen.DeadZone()), (dampen.BoucWen(),),
    (dampen.PrandtlIshlinskiiInverse(), dampen.PrandtlIshlinskii()), (dampen.Ideal(),), (dampen.Absent(),),
    (dampen.Backlash(), dampen.DeadZone(slope=2.0), dampen.Backlash(slope=0.5)), (dampen.BoucWen(hysteresis=-0.4),),
]  # fmt: skip


@pytest.mark.parametrize("chain", ACTUATORS)
def test_no_chain_is_farther_off_its_slope_than_it_says(chain: tuple[dampen.Stage, ...]) -> None:
    rng = np.random.default_rng(3)
    states = [np.array(stage.start() or (0.0,), float) for stage in chain]
    gain, (low, high), off = float(np.prod([stage.gain for stage in chain])), deviation(chain), []
    for command in np.cumsum(rng.normal(size=4000) * rng.choice([0.01, 0.3], 4000)):
        out = float(command)
        for stage, state in zip(chain, states, strict=True):
            new = state.copy()
            out = float(type(stage).step(out, state, np.array(stage.row(0.001), float), new))
            state[:] = new
        off.append(out - gain * command)
    assert low - 1e-12 <= min(off)
    assert max(off) <= high + 1e-12


def test_the_flank_inverse_before_a_backlash_deviates_by_the_papers_d_b() -> None:
    assert deviation((FlankInverse(dampen.AssumedBacklash()), dampen.Backlash())) == pytest.approx((-0.3 * 0.3, 0.0))
    assert deviation((dampen.Backlash(),)) == pytest.approx((-0.03, 0.06))


@pytest.mark.parametrize("shape", ["log", "tan"])
def test_the_reach_of_a_barrier_is_the_inverse_of_its_potential(shape: str) -> None:
    barrier = BARRIERS[shape]
    for y in (0.0, 1e-3, 0.1, 0.19, 0.2 * (1 - 1e-9)):
        assert barrier.reach(barrier.potential(y, 0.2), 0.2) == pytest.approx(y, rel=1e-7, abs=1e-12)


@pytest.mark.parametrize(
    ("reading", "barrier"), [("designed", "log"), ("direct", "log"), ("designed", "tan"), ("direct", "none")]
)
def test_the_papers_inner_loop_stays_within_its_bound(reading: str, barrier: Any) -> None:
    law = dampen.AdaptiveBoundary(compensate=reading == "designed", barrier=barrier)
    answer = of(beam(law))
    assert answer.holds
    assert kept(answer)
    assert answer.trials == 3
    force, torque = answer.ports
    if reading == "designed":  # alpha_1, alpha_2 on the bounds outweigh disturbance and d_b at the force port; not at the other
        assert force.push == 0
        assert torque.push == pytest.approx(0.09)
    if barrier != "none":
        assert max(max(port.bound) for port in answer.ports) < 0.2


SHAKEN = [
    dampen.ConstantLoad(force=LIKE, load_density=0.15),
    dampen.ConstantLoad(force=LIKE),
    dampen.FunctionDisturbance(
        highest_frequency=20.0,
        force=dict.fromkeys(PORTS, lambda t: 0.3 * np.sign(np.sin(2 * np.pi * 0.79 * t))),
        load_function=lambda x, t: 0.15 * np.sign(np.sin(2 * np.pi * 0.79 * t)) + 0 * x,
    ),
]


@pytest.mark.parametrize("law", [DAMPED, replace(DAMPED, stiffness=dict.fromkeys(PORTS, 5.0)), dampen.NoControl()])
@pytest.mark.parametrize("shaking", SHAKEN)
@pytest.mark.parametrize("ideal", [True, False])
def test_disturbances_at_their_bound_do_not_break_it(law: dampen.Controller, shaking: dampen.Disturbance, ideal: bool) -> None:
    case = beam(law, disturbance=shaking, **({"actuators": {}} if ideal else {}))
    answer = of(case)
    assert not answer.reason
    assert answer.holds
    assert kept(answer)
    if ideal:
        assert all(port.push == pytest.approx(0.3) for port in answer.ports)


LIGHT = [
    dampen.AdaptiveBoundary(alpha_3=0.01, alpha_6=0.01, compensate=False),
    dampen.BoundaryDamping(damping={"tip_w": 2.0, "tip_phi": 0.05}),
]


@pytest.mark.parametrize("law", LIGHT)
def test_the_bound_of_a_light_boom_holds_under_both_of_its_laws(law: dampen.Controller) -> None:
    """With ideal actuators, and told of gusts as strong as they come."""
    base = dampen.read_scenario("euler-bernoulli-payload")
    undamped = replace(base.plant, damping=dampen.Damping())
    told = {"f": 0.0, "tip_w": 1.0, "tip_phi": 0.05}
    run = dampen.simulate(replace(base, plant=undamped, controller=law, actuators={}, bounds=told))
    assert np.all(np.abs(run["disturbance"]) <= [1.0, 0.05])
    answer = bounds(run)
    assert not answer.reason
    assert answer.holds


STILL = ("numerics.modes=12", "plant.initial={}", "task.trials=2")


def damped_by(damping: float, step: float, disturbance: dampen.Disturbance, stiffness: float = 0.0) -> dampen.Scenario:
    law = dampen.BoundaryDamping(damping=dict.fromkeys(PORTS, damping), stiffness=dict.fromkeys(PORTS, stiffness))
    base = scenario(*STILL, f"numerics.step={step}", "output.every=20", "task.trial_duration=5")
    task = replace(base.task, constraint={})
    return replace(base, controller=law, actuators={}, disturbance=disturbance, bounds=LIKE, task=task)


@pytest.mark.parametrize(("damping", "step"), [(500.0, 1e-3), (50.0, 5e-3), (500.0, 5e-4)])
def test_what_the_steps_compliance_lets_in_is_in_the_bound(damping: float, step: float) -> None:
    """Strong damping holds the port; what the constant force then does, it does through the compliance."""
    answer = of(damped_by(damping, step, dampen.ConstantLoad(force=LIKE)))
    assert answer.holds
    assert answer.broken is None


def test_what_the_compliance_adds_to_the_bound_falls_with_the_step() -> None:
    law, load = 1.0, dampen.ConstantLoad(force=LIKE)
    exact = 2 * 0.3**2 / (4 * law) * 10
    beyond = [of(damped_by(law, step, load)).bound[-1] - exact for step in (1e-2, 5e-3)]
    assert 0 < beyond[1] < 0.6 * beyond[0]


@pytest.mark.parametrize(("damping", "stiffness", "step"), [
    (0.1, 0.0, 1e-2), (5.0, 0.0, 1e-2), (500.0, 0.0, 1e-2), (5000.0, 0.0, 1e-2), (50.0, 50.0, 1e-2), (50.0, 5000.0, 5e-3),
])  # fmt: skip
def test_bang_bang_disturbances_in_phase_with_the_motion_do_not_break_the_bound(
    damping: float, stiffness: float, step: float
) -> None:
    """Each round pushes with the sign of what the last one moved, from a first push that is all one way and one at random."""
    case = replace(damped_by(damping, step, dampen.NoDisturbance(), stiffness), task=dampen.Task(trials=1, trial_duration=1.0))
    case = replace(case, output=dampen.Output(every=1, points=2))
    for signs in (np.ones((case.steps, 2)), np.sign(np.random.default_rng(1).standard_normal((case.steps, 2)))):
        for _ in range(4):
            table = signs
            force = {
                port: lambda t, p=p, table=table: 0.3 * table[np.clip((t / step).astype(int), 0, len(table) - 1), p]
                for p, port in enumerate(PORTS)
            }
            run = dampen.simulate(replace(case, disturbance=dampen.FunctionDisturbance(highest_frequency=3.0, force=force)))
            answer = bounds(run)
            assert answer.holds, answer.broken
            signs = np.where(np.diff(np.asarray(run["y"][0]), axis=0) >= 0, 1.0, -1.0)


def test_a_broken_bound_is_told_where_it_broke() -> None:
    strong = dampen.ConstantLoad(force={"tip_w": 3.0})
    run = dampen.simulate(
        beam(replace(DAMPED, damping=dict.fromkeys(PORTS, 0.1)), actuators={}, disturbance=strong, bounds={"tip_w": 0.0})
    )
    answer = bounds(run)
    assert answer.broken is not None
    k = int(np.argmin(np.abs(run.time - answer.broken.time)))
    if answer.broken.what == "V":
        assert energy(run, answer.broken.trial)[k] == answer.broken.value
    assert answer.broken.value > answer.broken.bound
    (finding,) = bound_rows(answer, run.scenario)
    assert finding.verdict == "FAIL"
    assert f"trial {answer.broken.trial}, {answer.broken.time:.6g} s" in finding.measured


def test_without_a_disturbance_energy_cannot_rise_and_the_bound_is_the_start() -> None:
    for law in (DAMPED, dampen.NoControl()):
        answer = of(beam(law, actuators={}, disturbance=dampen.NoDisturbance(), bounds={}))
        assert answer.holds
        assert answer.bound == pytest.approx((answer.measured[0],) * 3)
        assert answer.notes == ()


def test_the_bound_is_sharp_where_a_force_pushes_along_with_the_motion() -> None:
    """One mode that moves fast through zero, for a hundredth of its period: nothing pushes harder."""
    case = beam(
        dampen.NoControl(), plant=dampen.TimoshenkoBeam(initial=dampen.BeamState(w_rate=(0.0, 1.0))), actuators={},
        disturbance=dampen.ConstantLoad(force={"tip_w": 20.0}), bounds={"tip_w": 20.0},
        task=dampen.Task(trials=1, trial_duration=0.01), numerics=dampen.Numerics(modes=1, step=1e-4),
    )  # fmt: skip
    answer, start = of(case), float(np.sum(Bench(case).start[1] ** 2) / 2)
    assert answer.holds
    assert answer.measured[0] - start == pytest.approx(answer.bound[0] - start, rel=5e-3)
    assert answer.measured[0] > 1.2 * start


def test_bounds_that_were_stated_too_low_are_found_out() -> None:
    weak = replace(DAMPED, damping=dict.fromkeys(PORTS, 0.1))
    strong = dampen.ConstantLoad(force={"tip_w": 3.0})
    told = {"actuators": {}, "disturbance": strong}
    assert of(beam(weak, **told, bounds={"tip_w": 0.0})).holds is False
    assert of(beam(weak, **told, bounds={"tip_w": 3.0})).holds is True


def test_a_law_that_learns_has_the_bound_of_trial_0_alone(run: Any) -> None:
    answer = bounds(run("numerics.modes=64", "task.trials=3"))
    assert answer.trials == len(answer.bound) == 1
    assert len(answer.measured) == 3
    assert answer.holds
    assert "trial 0" in answer.notes[0]
    inner = of(beam(dampen.AdaptiveBoundary()))
    assert answer.bound[0] == inner.bound[0]


def test_a_reset_begins_the_bound_anew() -> None:
    answer = of(beam(DAMPED, 'task.start="reset"', actuators={}))
    assert answer.bound == pytest.approx((answer.bound[0],) * 3)
    assert answer.holds


@pytest.fixture(scope="module")
def ideal_run() -> dampen.Result:
    return dampen.simulate(beam(DAMPED, actuators={}))


WHY = [
    ({"actuators": {"tip_w": (dampen.Saturation(),)}}, "Saturation"),
    ({"actuators": {"tip_w": (dampen.FirstOrderLag(),)}}, "FirstOrderLag"),
    ({"actuators": {"tip_w": (dampen.RateLimit(),)}}, "RateLimit"),
    ({"bounds": {"f": 0.15, "tip_w": 0.3}}, "at tip_phi"),
    ({"bounds": LIKE}, "distributed load"),
    ({"disturbance": dampen.MovingLoad(force=0.3, speed=1.0)}, "concentrated load"),
    ({"disturbance": dampen.BaseShaking(frequencies=(2.0,), amplitudes=(0.5,))}, "base is shaken"),
    ({"numerics": dampen.Numerics(modes=64, mode="sampled")}, "through samples"),
    ({"task": dampen.Task(trials=1, reference={"tip_w": dampen.Sinusoid(0.01, 1.0)})}, "reference"),
]


@pytest.mark.parametrize(("parts", "why"), WHY, ids=lambda value: value if isinstance(value, str) else "")
def test_where_there_is_no_bound_the_reason_is_given_and_the_measured_values_stay(
    parts: dict[str, Any], why: str, ideal_run: dampen.Result
) -> None:
    answer = bounds(replace(ideal_run, scenario=replace(ideal_run.scenario, **parts)))
    assert why in answer.reason
    assert answer.holds is None
    assert answer.bound == ()
    assert answer.measured[0] > 0
    assert answer.ports[0].measured[0] > 0


def test_an_actuator_that_nobody_commands_does_not_spoil_the_bound() -> None:
    free = dampen.simulate(beam(dampen.NoControl(), actuators={}))
    saturating = replace(free, scenario=replace(free.scenario, actuators={"tip_w": (dampen.Saturation(),)}))
    assert bounds(saturating) == bounds(free)


def test_the_answer_is_plain_values() -> None:
    answer = of(beam(DAMPED))
    adapter = TypeAdapter(Bounds)
    assert adapter.validate_json(adapter.dump_json(answer)) == answer
