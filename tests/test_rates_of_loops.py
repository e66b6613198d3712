"""Decay rates of closed loops: against exact answers, and against what runs do."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest
from pydantic import TypeAdapter
from scipy.linalg import eig

import dampen
from dampen.analysis.audit.loop import rate_rows
from dampen.analysis.loops import closed_loop
from dampen.analysis.rate_notes import payload_note
from dampen.analysis.rates import NoRates, Rates, rates
from dampen.plants.base import Damping
from dampen.simulation.bench import Bench
from dampen.simulation.passes import passes
from dampen.simulation.setting import setting_of
from tests.conftest import scenario

PORTS = ("tip_w", "tip_phi")
ONE = dampen.BoundaryDamping(damping=dict.fromkeys(PORTS, 1.0))


def beam(law: dampen.Controller, modes: int = 64, **changes: Any) -> dampen.Scenario:
    """The paper's beam with ideal actuators and nothing that shakes it."""
    base = scenario(f"numerics.modes={modes}")
    parts = {"controller": law, "actuators": {}, "disturbance": dampen.NoDisturbance(), **changes}
    return replace(base, **parts)


def found(scenario: dampen.Scenario) -> Rates:
    answer = rates(scenario)
    assert isinstance(answer, Rates), answer
    return answer


@pytest.fixture(scope="module")
def damped_beam() -> Rates:
    return found(beam(ONE))


def measured(mode: int, step: float, duration: float = 2.0, modes: int = 64) -> float:
    """The rate of a run that starts in one mode of the closed loop, from the amplitude of that mode along the run.

    q is written down at every step; q' follows from two of them and the forces in between, by the exact step.
    """
    case = beam(ONE, modes)
    case = replace(
        case, task=dampen.Task(trials=1, trial_duration=duration), output=dampen.Output(every=1, points=2),
        numerics=replace(case.numerics, step=step),
    )  # fmt: skip
    bench, n = Bench(case), modes
    value, left, right = eig(closed_loop(bench.modes, np.ones(2), np.zeros(2), [(), ()]), left=True, right=True)
    wanted = rates(case, bench).modes[mode - 1].frequency  # type: ignore[union-attr]
    k = int(np.argmin(np.abs(value.imag - 2 * np.pi * wanted)))
    start = 0.1 * np.real(right[:, k] / np.abs(right[:, k]).max())
    bench.start = start[:n], start[n:]
    (run,) = passes(case, bench)
    m, q = bench.motion, run.record.q
    rate = (q[1:] - m.c11 * q[:-1] - m.psi * (run.record.delivered @ bench.modes.b)) / m.c12
    amplitude = np.abs(np.hstack([q[:-1], rate]) @ left[:, k].conj())
    return float(-np.polyfit(np.arange(len(rate)) * step, np.log(amplitude), 1)[0])


def test_rates_of_a_viscous_tip_law_are_those_of_runs_to_one_percent_for_the_first_ten_modes(damped_beam: Rates) -> None:
    predicted = np.array([m.rate for m in damped_beam.modes[:10]])
    seen = np.array([measured(i, 2e-4) for i in range(1, 11)])
    np.testing.assert_allclose(seen, predicted, rtol=0.01)


def test_the_difference_to_runs_falls_with_the_step(damped_beam: Rates) -> None:
    """The ports' numerical compliance and forces held over a step: at least first order together."""
    errors = np.array(
        [[abs(measured(i, dt) / damped_beam.modes[i - 1].rate - 1) for dt in (1e-3, 5e-4, 2.5e-4)] for i in (1, 10)]
    )
    assert np.all(errors[:, 1:] < 0.6 * errors[:, :-1]), errors


@pytest.mark.parametrize(("modes", "rate"), [(16, 0.16554), (32, 0.038978), (64, 0.0097769), (128, 0.0024116)])
def test_with_a_payload_the_slowest_rate_falls_as_modes_are_added(modes: int, rate: float) -> None:
    answer = found(beam(ONE, modes))
    assert answer.rate == pytest.approx(rate, rel=1e-3)
    assert [n for n, _ in answer.with_modes] == [modes // 4, modes // 2, modes]
    assert np.all(np.diff([slow for _, slow in answer.with_modes]) < 0)
    assert any("inertia where the law damps" in note and "no uniform decay rate" in note for note in answer.notes)


@pytest.mark.parametrize("kappa", [0.5, 2.0])
def test_a_string_without_payload_decays_uniformly_at_the_exact_rate(kappa: float) -> None:
    """w(0) = 0, T w_x = -D w_t: with kappa = D / sqrt(T rho) every mode decays at c / (2 L) ln |(1 + kappa) / (1 - kappa)|."""
    string = dampen.String(tip_mass=0.0)
    law = dampen.BoundaryDamping(damping={"tip_w": kappa * np.sqrt(50 * 0.0062)})
    answer = found(still(string, law, 128))
    exact = np.sqrt(50 / 0.0062) / 2 * np.log((1 + kappa) / abs(1 - kappa))
    np.testing.assert_allclose([m.rate for m in answer.modes[:8]], exact, rtol=3e-3)
    assert not answer.with_modes
    assert not answer.notes


def test_a_matched_damper_on_a_string_takes_everything_at_once() -> None:
    """D = sqrt(T rho) reflects nothing: in the continuum all is gone after 2 L / c, and rates grow with the modes kept."""
    law = dampen.BoundaryDamping(damping={"tip_w": np.sqrt(50 * 0.0062)})
    few, many = (found(still(dampen.String(tip_mass=0.0), law, n)).modes[0] for n in (32, 128))
    assert many.rate > 1.25 * few.rate
    assert many.rate > 2 * found(still(dampen.String(tip_mass=0.0), replace(law, damping={"tip_w": 0.1}), 128)).modes[0].rate


def still(plant: dampen.Plant, law: dampen.Controller, modes: int = 16, **parts: Any) -> dampen.Scenario:
    numerics = dampen.Numerics(modes=modes)
    return dampen.Scenario(plant=plant, controller=law, disturbance=dampen.NoDisturbance(), numerics=numerics, **parts)


def through_samples(law: dampen.Controller, modes: int) -> dampen.Scenario:
    case = beam(dampen.NoControl(), modes)
    numerics = replace(case.numerics, mode="sampled")
    return replace(case, controller=law, numerics=numerics, sampling=dampen.Sampling(period=0.002))


def test_rates_of_plant_and_viscous_law_add_up() -> None:
    """A drag on every mass alike moves all eigenvalues by -viscous / 2, to first order in the rates over the frequency."""
    light = dampen.BoundaryDamping(damping=dict.fromkeys(PORTS, 1e-3))
    dragged = replace(scenario().plant, damping=Damping(viscous=0.02))
    alone, both = found(beam(light, 16)), found(beam(light, 16, plant=dragged))
    np.testing.assert_allclose([m.rate for m in both.modes], [m.rate + 0.01 for m in alone.modes], rtol=1e-5)
    assert all(m.plant_rate == pytest.approx(0.01) for m in both.modes)
    assert any("structure's own damping sets the slowest rate" in note for note in both.notes)


def test_without_control_the_rates_are_the_plants() -> None:
    answer = found(beam(dampen.NoControl(), 16, plant=replace(scenario().plant, damping=Damping(ratio=0.02, kelvin_voigt=6e-2))))
    assert any(m.frequency == 0 for m in answer.modes)  # overdamped ones among them
    for m in answer.modes:
        assert m.rate == pytest.approx(m.plant_rate, rel=1e-9)
        assert m.frequency == pytest.approx(m.plant_frequency, abs=1e-9)


def test_a_lag_is_a_state_of_the_loop_and_can_turn_damping_into_growth() -> None:
    """One mode of mass 1: q'' + omega^2 q = -D b^2 q' / (1 + tau s), the roots of a cubic; stiffness behind a lag drives."""
    model = replace(Bench(still(dampen.String(), dampen.NoControl(), 1)).modes)
    omega, b, tau = float(model.omega[0]), float(model.b[0, 0]), 0.02
    law = dampen.BoundaryDamping(damping={"tip_w": 0.3}, stiffness={"tip_w": 40.0})
    answer = found(still(dampen.String(), law, 1, actuators={"tip_w": (dampen.FirstOrderLag(tau),)}))
    cubic = np.roots([tau, 1, tau * omega**2 + 0.3 * b**2, omega**2 + 40 * b**2])
    exact = cubic[np.argmax(cubic.imag)]
    assert answer.modes[0].rate == pytest.approx(-exact.real, rel=1e-9)
    assert answer.modes[0].frequency == pytest.approx(exact.imag / 2 / np.pi, rel=1e-9)
    assert [other.part for other in answer.others] == ["actuator"]
    assert answer.growing == (1,)
    assert answer.rate < 0
    assert "not stable" in answer.notes[0]


def test_a_law_with_dry_friction_has_no_rates_and_says_why() -> None:
    answer = rates(scenario())
    assert isinstance(answer, NoRates)
    assert "coulomb" in answer.reason
    assert "tip_w, tip_phi" in answer.reason


def test_an_actuator_counts_with_its_slope_and_is_named() -> None:
    answer, weak = found(replace(scenario(), controller=ONE)), found(beam(replace(ONE, damping=dict.fromkeys(PORTS, 0.3)), 80))
    np.testing.assert_allclose([m.rate for m in answer.modes], [m.rate for m in weak.modes], rtol=1e-9)
    assert any("slope 0.3 of Backlash" in note for note in answer.notes)
    assert not any("slope" in note for note in weak.notes)


@pytest.mark.parametrize(("shape", "stiffness"), [("log", 0.0), ("tan", 2.0 / 0.2**2)])
def test_a_barrier_counts_with_its_curvature_at_zero(shape: Any, stiffness: float) -> None:
    barred = found(beam(replace(ONE, barrier=shape, barrier_gain={"tip_w": 2.0}), 16))
    sprung = found(beam(replace(ONE, stiffness={"tip_w": stiffness}), 16))
    np.testing.assert_allclose([m.rate for m in barred.modes], [m.rate for m in sprung.modes], rtol=1e-9)
    assert any("barrier" in note for note in barred.notes)


def test_spillover_of_a_reduced_law_is_told_from_its_own_modes_and_its_observer() -> None:
    """Two modes of sixteen are known: some that were left out grow. With all known, none does."""
    case = through_samples(dampen.LQG(modes=2), 16)
    answer, full = found(case), found(through_samples(dampen.LQG(modes=16), 16))
    assert answer.loop == "sampled"
    assert answer.spillover is not None
    assert answer.spillover.known == 2
    assert answer.spillover.left_out == 14
    assert answer.spillover.growing
    assert set(answer.spillover.growing) <= set(range(3, 17))
    worst = answer.modes[(answer.spillover.worst or 0) - 1]
    assert worst.rate - worst.plant_rate == pytest.approx(answer.spillover.change)
    assert len(answer.others) == 2
    assert {other.part for other in answer.others} == {"controller"}
    assert full.spillover is None
    assert min(m.rate for m in full.modes) > 0


def test_a_sampled_loop_that_grows_grows_in_a_run_at_its_rate() -> None:
    """Bold weights on two modes of sixteen: here it is the observer that runs away, and the energy with twice its rate."""
    case = through_samples(dampen.LQG(modes=2, energy_weight=1e3, effort_weight=1e-3, sensor_noise=1e-6), 16)
    answer = found(case)
    assert answer.slowest is None
    assert answer.rate < -10
    assert "not stable" in answer.notes[0]
    assert f"grows by {-answer.rate:.3g} 1/s" in case.controller.notes(setting_of(case))[0]
    run = dampen.simulate(replace(case, task=dampen.Task(trials=1, trial_duration=1.0)))
    growth = np.polyfit(run.time[500:], np.log(run["energy"][0][500:]), 1)[0]
    assert growth == pytest.approx(-2 * answer.rate, rel=0.03)


def test_an_observer_that_knows_all_modes_leaves_the_regulator_its_own_eigenvalues() -> None:
    """Separation: the plant's modes get the eigenvalues of A - B hold, what is left those of the filter."""
    law = dampen.LQG(modes=6)
    case = through_samples(law, 6)
    d = law.design(setting_of(case))
    held = np.log(np.linalg.eigvals(d.a - d.b @ d.hold).astype(complex)) / 0.002
    answer = found(case)
    np.testing.assert_allclose(sorted(m.rate for m in answer.modes), sorted(-held[held.imag > 0].real), rtol=1e-6)


def test_a_law_port_by_port_through_fast_samples_has_the_rates_of_the_continuous_law(damped_beam: Rates) -> None:
    case = beam(ONE)
    errors = []
    for period in (1e-4, 5e-5):
        sampling = dampen.Sampling(period=period, filter_time=0.0)
        fast = replace(case, numerics=replace(case.numerics, mode="sampled", step=period), sampling=sampling)
        answer = found(fast)
        assert answer.loop == "sampled"
        errors.append([abs(fast.rate / slow.rate - 1) for fast, slow in zip(answer.modes[:6], damped_beam.modes, strict=False)])
    assert np.all(np.array(errors[0]) < 0.05), errors
    assert np.all(np.array(errors[1]) < 0.6 * np.array(errors[0])), errors


BOOM = ("disturbance.kind=none", "task.constraint={}", "bounds={}", "numerics.mode=sampled", "controller.kind=boundary-damping")
LATE = [
    ("controller.damping={tip_w=30}", "sampling={period=0.02,delay=0.02}", "actuator={}"),
    ("controller.damping={tip_w=30}", 'sampling={period=0.02,delay=0.02,switching="implicit"}', "actuator={}"),
    (
        "controller.damping={tip_w=2,tip_phi=0.5}", 'sampling={period=0.002,delay=0.003,switching="implicit"}',
        'actuator={all={chain=[{kind="lag",time_constant=0.004}]}}',
    ),
    ("controller.damping={tip_w=2,tip_phi=0.5}", 'sampling={period=0.002,delay=0.003,rate="observer"}', "task.trial_duration=0.8",
     "actuator={}"),
]  # fmt: skip


@pytest.mark.parametrize("sets", LATE)
def test_a_law_port_by_port_that_samples_make_unstable_grows_in_a_run_at_its_rate(sets: tuple[str, ...]) -> None:
    """It damps where it acts continuously; late, it drives: the twin's rates say nothing of that."""
    case = dampen.read_scenario("euler-bernoulli-payload", [*BOOM, *sets, "task.trials=1"])
    answer, run = found(case), dampen.simulate(case)
    assert answer.rate < -1
    assert answer.growing
    energy = run["energy"][0]
    k = np.arange(len(energy) // 4, len(energy))
    assert np.polyfit(run.time[k], np.log(energy[k]), 1)[0] == pytest.approx(-2 * answer.rate, rel=0.02)


def wing(*sets: str) -> dampen.Scenario:
    quiet = ("disturbance.kind=none", "sampling.noise={}", "task.constraint={}", "task.trials=1", "task.trial_duration=12")
    return dampen.read_scenario("assembled-from-fe", [*quiet, *sets])


def lag(seconds: float) -> str:
    return f'actuator={{all={{chain=[{{kind="lag", time_constant={seconds}}}]}}}}'


BOLD = ("plant.damping={ratio=0.0002}", "controller.modes=16", "controller.effort_weight=1e-5")
LAGGING = [
    (("plant.damping={ratio=0}", lag(0.002)), 7), (("plant.damping={ratio=0}", lag(0.01)), 5), ((*BOLD, lag(0.01)), 3),
    ((*BOLD, lag(0.002)), 10), (("plant.damping={ratio=0}",), 7),
]  # fmt: skip


@pytest.mark.parametrize(("sets", "mode"), LAGGING)
def test_actuators_that_lag_are_in_the_loop_of_a_sampled_law(sets: tuple[str, ...], mode: int) -> None:
    """A mode starts alone; its envelope goes as its eigenvalue says, growing or decaying, to 2 % and what 12 s can tell."""
    case = wing(*sets)
    bench = Bench(replace(case, output=dampen.Output(every=4, points=2)))
    answer, predicted = rates(case, bench), found(case).modes[mode - 1].rate
    assert isinstance(answer, Rates)
    start = np.zeros(bench.modes.count)
    start[mode - 1] = 1e-6 / bench.modes.omega[mode - 1]
    bench.start = start, np.zeros_like(start)
    (run,) = passes(bench.scenario, bench)
    envelope = np.abs(run.record.q[:, mode - 1]).reshape(-1)[1:].reshape(20, -1).max(axis=1)
    seen = -np.polyfit(np.arange(4, 20) * 0.6, np.log(envelope[4:]), 1)[0]
    assert seen == pytest.approx(predicted, rel=0.02, abs=5e-4)
    assert (seen < 0) == (mode in answer.growing)


def test_a_loop_told_by_the_user_without_the_lags_has_no_rates() -> None:
    @dataclass(frozen=True)
    class Forgetful(dampen.LQG):
        def sampled_loop(self, setting: dampen.Setting) -> Any:
            return super().sampled_loop(replace(setting, lags=()))

    case = wing()
    answer = rates(replace(case, controller=Forgetful(modes=6)))
    assert isinstance(answer, NoRates)
    assert "lag at engine, tip" in answer.reason


def row(case: dampen.Scenario) -> Any:
    return next(rate_rows(rates(case), case))


def test_what_nothing_damps_does_not_decay_and_round_off_is_no_growth() -> None:
    sprung = dampen.BoundaryDamping(stiffness={"tip_w": 3.0})
    answer = found(still(dampen.String(), sprung))
    finding = row(still(dampen.String(), sprung))
    assert answer.rate == 0.0
    assert not answer.growing
    assert answer.still == tuple(range(1, 17))
    assert finding.verdict == "FAIL"
    assert finding.meaning == "Modes 1, 2, 3, 4 and so on (16 modes) do not decay: nothing damps them."


def test_rigid_motion_that_nothing_holds_is_told() -> None:
    arm = dampen.read_scenario("flexible-arm-point-to-point", ["task.reference={}", "plant.damping={ratio=0.01}"])
    finding = row(replace(arm, controller=dampen.BoundaryDamping(damping={"hub": 1.0})))
    assert finding.verdict == "FAIL"
    assert "rigid motion" in finding.meaning


def test_the_structure_alone_is_told_of_and_not_judged() -> None:
    finding = row(still(dampen.String(), dampen.NoControl()))
    assert finding.verdict == "note"
    assert "alone" in finding.criterion


def test_a_loop_that_decays_slowly_is_told_from_one_that_does_not() -> None:
    """256 modes: it is next to nothing against the largest eigenvalue."""
    finding = row(beam(ONE, 256))
    assert finding.verdict == "PASS"
    assert "to fall to a third" in finding.meaning


def test_the_warning_of_an_inertia_shows_figures_only_where_they_bear_it_out() -> None:
    few = dampen.read_scenario("euler-bernoulli-payload", ["controller.kind=boundary-damping", "controller.damping={tip_w=2}"])
    own = found(replace(few, plant=replace(few.plant, damping=Damping(viscous=0.02))))
    text = next(note for note in own.notes if "inertia" in note)
    rates_shown = [rate for _, rate in own.with_modes]
    assert ("modes." in text) == bool(np.all(np.diff(rates_shown) < 0)), text
    constant = payload_note({"hub": 1.0}, ((5, 1.55), (10, 1.55), (20, 1.55)), plant_damped=True, own=True)
    assert "structure's own damping sets the slowest rate" in constant
    assert "1.55" not in constant
    assert "payload" not in constant
    law_sets = dampen.read_scenario("flexible-arm-point-to-point")
    assert "not yet what sets the slowest rate" in row(law_sets).meaning
    assert "structure's own damping sets the slowest rate" in row(dampen.read_scenario("string-tip-mass")).meaning


def held_step(sample, state, parameters, command):  # type: ignore[no-untyped-def]
    for p in range(len(command)):
        command[p] = -parameters[0] * sample.rate[p]


@dataclass(frozen=True)
class Silent(dampen.SampledFeedback):
    """A sampled law that does not tell its loop."""

    step = staticmethod(held_step)

    def row(self, setting: dampen.Setting) -> np.ndarray:
        return np.array([1.0])


def test_a_sampled_law_of_ones_own_without_a_loop_has_no_rates() -> None:
    answer = rates(through_samples(Silent(), 8))
    assert isinstance(answer, NoRates)
    assert "sampled_loop" in answer.reason


def test_the_answer_is_plain_values(damped_beam: Rates) -> None:
    adapter = TypeAdapter(Rates)
    assert adapter.validate_json(adapter.dump_json(damped_beam)) == damped_beam
