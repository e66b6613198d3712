"""The audit finds what is there, and only that."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import pytest

import dampen
from dampen.analysis.audit.assumptions import repetition
from dampen.analysis.audit.audit import Audit, audit
from dampen.analysis.audit.boundedness import FOOLED, bounded, bounded_by_chance, late_ones, late_trials
from dampen.analysis.audit.energetics import dissipation_by_quadrature
from dampen.analysis.audit.resolution import resolution
from dampen.analysis.audit.sticking import left, longest_stick
from dampen.analysis.refinement import figures_of_merit
from dampen.port import Site
from dampen.simulation.bench import Bench

DIRECT = ("controller.compensate=false", "task.trials=12", "numerics.modes=40")


@cache
def ran(name: str, *sets: str) -> dampen.Result:
    return dampen.simulate(dampen.read_scenario(name, sets))


@cache
def audited(name: str, *sets: str) -> Audit:
    return audit(ran(name, *sets), refine=False)


def assumptions_that_fail(found: Audit) -> set[str]:
    return {f.id.removeprefix("assumption.") for f in found.failed if f.section == "assumptions"}


@pytest.mark.parametrize(
    ("broken", "expected"),
    [
        ((), set()),
        (("task.start=reset",), {"alignment"}),
        (("disturbance.load_amplitude=0.1",), {"bound.f"}),
        (("disturbance.force_amplitude=0.2",), {"bound.tip_w"}),
        (("disturbance.torque_amplitude=0.2",), {"bound.tip_phi"}),
        (("controller.alpha_5=60", "controller.alpha_7=30"), {"moving.tip_phi"}),
    ],
)
def test_a_scenario_that_breaks_one_assumption_is_flagged_for_that_one(broken: tuple[str, ...], expected: set[str]) -> None:
    assert assumptions_that_fail(audited("he2017", *DIRECT, *broken)) == expected


def test_learning_laws_are_held_to_equal_starts_and_to_repetition() -> None:
    arm = ("task.trials=3", "task.reset_error={}")
    assert assumptions_that_fail(audited("flexible-arm-point-to-point", *arm)) == set()
    assert assumptions_that_fail(audited("flexible-arm-point-to-point", "task.trials=3")) == {"equal-starts"}
    drifting = ('disturbance={kind="harmonics", frequencies=[0.7], force={hub=[0.05]}, trials="continue"}',)
    assert assumptions_that_fail(audited("flexible-arm-point-to-point", *arm, *drifting)) == {"repetition"}


@dataclass(frozen=True)
class Silent(dampen.Disturbance):
    """The same in every trial, or from some trial on another one, without saying so."""

    changes: int = 99

    def at_ports(self, trial: int, t: np.ndarray, site: Site) -> np.ndarray:
        return np.outer(np.sin(2 * np.pi * t) * (2.0 if trial >= self.changes else 1.0), np.full(len(site.ports), 0.01))


@pytest.mark.parametrize(("changes", "differ"), [(99, ()), (1, tuple(range(1, 8))), (7, (7,))])
def test_a_disturbance_that_does_not_say_that_it_repeats_is_looked_at(changes: int, differ: tuple[int, ...]) -> None:
    arm = dampen.read_scenario("flexible-arm-point-to-point", ["task.trials=8", "task.reset_error={}"])
    result = dampen.simulate(replace(arm, disturbance=Silent(changes)))
    (row,) = repetition(result, Bench(result.scenario))
    assert row.values["trials that differ"].value == differ
    assert row.verdict == ("FAIL" if differ else "PASS")


def test_noise_is_named_where_a_sampled_law_feeds_energy_in() -> None:
    blow = 'disturbance={kind="impulse", duration=0.02, impulse={tip=0.1}, trial=0}'
    row = audited("assembled-from-fe", blow)["energy.control-takes"]
    assert row.verdict == "FAIL"
    assert "noise of 1e-05 m" in row.meaning
    assert "RMS" in row.meaning
    exact = audited("assembled-from-fe", blow, "sampling.noise={}")["energy.control-takes"]
    assert "noise" not in exact.meaning


def test_a_law_that_feeds_energy_in_is_flagged() -> None:
    push = 'controller={kind="open-loop", command={tip_w={kind="sinusoid", amplitude=0.2, frequency=0.79}}}'
    sets = ("disturbance.kind=none", "plant.initial={}", "actuator.all.chain=[]", "task.trials=4", push)
    row, result = audited("he2017", *sets)["energy.control-takes"], ran("he2017", *sets)
    given = row.values["given by the control, by trial"].value
    assert row.verdict == "FAIL"
    assert isinstance(given, tuple)
    stored = float(result["compliance_energy"][3][-1] - result["compliance_energy"][0][0])
    change = float(result["energy"][3][-1] - result["energy"][0][0])
    assert sum(map(float, filter(None, given))) == pytest.approx(change + stored, rel=1e-9)
    assert audited("he2017", *DIRECT)["energy.control-takes"].verdict == "PASS"


def test_an_account_with_a_wrong_work_does_not_close() -> None:
    result = ran("he2017", *DIRECT)
    arrays = dict(result.arrays)
    arrays["work_load"] = np.asarray(arrays["work_load"]) * 1.0001
    assert audited("he2017", *DIRECT)["energy.account"].verdict == "PASS"
    assert audit(replace(result, arrays=arrays), refine=False)["energy.account"].verdict == "FAIL"


def test_every_work_of_the_account_is_named_and_they_add_up() -> None:
    values = audited("string-tip-mass")["energy.account"].values
    works = ("law", "actuator", "disturbance at tip_w", "load", "dissipated", "resets")
    total = sum(float(values[name].value) for name in works)  # type: ignore[arg-type]
    change = float(values["final"].value) - float(values["initial"].value)  # type: ignore[arg-type]
    assert total == pytest.approx(change, rel=1e-11)
    assert float(values["dissipated"].value) < 0  # type: ignore[arg-type]


@pytest.mark.parametrize("name", ["string-tip-mass", "flexible-arm-point-to-point", "euler-bernoulli-payload"])
def test_dissipation_by_quadrature_is_what_the_account_has_and_not_what_another_damping_would_give(name: str) -> None:
    result = ran(name, "task.trials=1")
    steps = np.arange(0, result.scenario.steps, 7)
    kept = float(np.sum(np.asarray(result["dissipated"][0])[steps]))
    assert dissipation_by_quadrature(result, Bench(result.scenario), steps) == pytest.approx(kept, rel=1e-9)
    other = dampen.read_scenario(name, ["task.trials=1", "plant.damping={ratio=0.02}"])
    assert dissipation_by_quadrature(result, Bench(other), steps) != pytest.approx(kept, rel=0.05)


def test_a_mode_that_is_far_too_fast_for_points_within_a_step_is_left_out_and_said_so() -> None:
    stiff = audited("string-tip-mass", "task.trials=1", "plant.mass_per_length=1e-9")
    assert stiff["energy.dissipated"].verdict == "n/a"
    assert "turns by" in stiff["energy.dissipated"].meaning


def test_resolution_rows_are_the_runs_with_twice_the_modes_and_half_the_step() -> None:
    scenario = dampen.read_scenario("he2017", ["task.trials=2", "numerics.modes=20"])
    rows = {f.id.removeprefix("resolution."): f for f in resolution(dampen.simulate(scenario))}
    modes = figures_of_merit(dampen.simulate(replace(scenario, numerics=replace(scenario.numerics, modes=40))))
    finer = replace(scenario, numerics=replace(scenario.numerics, step=0.0005), output=replace(scenario.output, every=20))
    step = figures_of_merit(dampen.simulate(finer))
    for (name, unit), value in modes.items():
        assert rows[name].values["twice the modes"].value == pytest.approx(value, rel=1e-12)
        assert rows[name].values["half the step"].value == pytest.approx(step[name, unit], rel=1e-12)


def test_a_structure_without_more_modes_says_so() -> None:
    scenario = dampen.read_scenario(
        "he2017", ["task.trials=2", "numerics.modes=40", "numerics.discretisation=finite-difference", "numerics.points=21"]
    )
    rows = list(resolution(dampen.simulate(scenario)))
    assert all(row.values["twice the modes"].value is None and "80 modes cannot be had" in row.meaning for row in rows)


def test_more_modes_than_the_kernel_takes_are_not_called_twice_as_many() -> None:
    scenario = dampen.read_scenario("string-tip-mass", ["task.trials=1", "numerics.modes=600"])
    rows = list(resolution(dampen.simulate(scenario)))
    assert all(row.values["twice the modes"].value is None and "more than can be had" in row.meaning for row in rows)


AUTHORITY: dict[str, tuple[str, ...]] = {
    "ours": (),
    "damping": ("controller.alpha_4=10", "controller.alpha_7=10"),
    "switching": ("controller.alpha_1=5", "controller.alpha_2=5", "controller.alpha_5=5"),
}


def test_too_much_authority_leaves_a_residual_that_is_trapped_energy() -> None:
    """The paper's page: damping of 10 leaves some 0.03 m, switching gains of 5 some 0.12 m; the audit says what holds it."""
    peaks = {name: float(np.abs(ran("he2017", *sets)["y"][24])[:, 0].max()) for name, sets in AUTHORITY.items()}
    rows = {name: audited("he2017", *sets)["residual.trapped-energy"] for name, sets in AUTHORITY.items()}
    assert {name: row.verdict for name, row in rows.items()} == {"ours": "PASS", "damping": "FAIL", "switching": "FAIL"}
    assert 0.02 < peaks["damping"] < 0.04
    assert 0.1 < peaks["switching"] < 0.15
    for name in ("damping", "switching"):
        kept, static, taken = (
            float(rows[name].values[key].value)  # type: ignore[arg-type]
            for key in ("left, last trials", "of it static", "taken a trial, last trials")
        )
        assert static > 0.9 * kept, "nearly all of it bends the beam to where its tip is stuck"
        assert taken < 0.1 * kept
        assert static == pytest.approx(held_off(ran("he2017", *AUTHORITY[name])), rel=0.2)


@pytest.mark.parametrize("name", list(AUTHORITY))
def test_a_residual_that_stands_still_is_called_an_offset(name: str) -> None:
    result, row = ran("he2017", *AUTHORITY[name]), audited("he2017", *AUTHORITY[name])["residual.offset.tip_w"]
    late = np.concatenate([np.asarray(result["y"][j])[:, 0] for j in range(20, 25)])
    assert late.std() < 0.02 * abs(late.mean())
    assert row.verdict == "FAIL"
    assert row.values["mean, last trials"].value == pytest.approx(late.mean())


def test_locking_by_damping_is_trapped_energy_though_nothing_sticks() -> None:
    locked = audited("he2017", "controller.alpha_4=1e6", "controller.alpha_7=1e6", "task.trials=10")
    assert locked["residual.trapped-energy"].verdict == "FAIL"
    rest = audited("he2017", "disturbance.kind=none", "plant.initial={}", "task.trials=10")
    assert rest["residual.trapped-energy"].verdict == "n/a"
    assert "at rest" in rest["residual.trapped-energy"].meaning


def test_only_ports_that_are_held_count_as_held_off_their_rest() -> None:
    lone = ran(
        "he2017", "actuator.tip_phi.chain=[{kind='absent'}]", "controller.alpha_2=3.0", "task.trials=8", "numerics.modes=40"
    )
    static = left(lone, Bench(lone.scenario)).static
    modes, y = Bench(lone.scenario).modes, np.mean([np.mean(lone["y"][j][:, 0]) for j in range(3, 8)])
    assert static == pytest.approx(float(y**2 / np.sum((modes.b[0] / modes.omega) ** 2)) / 2, rel=1e-6)


def test_the_longest_stick_is_told_on_the_clock_of_the_whole_run() -> None:
    stuck = np.zeros((3, 10), bool)
    stuck[0, 8:] = stuck[1, :2] = True
    stuck[2, 4:7] = True
    assert longest_stick(stuck, chained=True) == (4, 8)
    assert longest_stick(stuck, chained=False) == (3, 24)


@pytest.mark.parametrize("growth", [np.arange(1.0, 121.0), 1.009 ** np.arange(200.0), np.arange(1.0, 26.0)])
def test_what_grows_with_the_trials_is_flagged_however_long_the_run(growth: np.ndarray) -> None:
    assert bounded("d_hat", "tip_w", growth, "N").verdict == "FAIL"
    assert bounded("d_hat", "tip_w", 1 + np.exp(-growth), "N").verdict == "PASS"


@pytest.mark.parametrize("trials", [10, 12, 15, 25, 60])
def test_chance_alone_seldom_passes_for_growth_and_growth_is_found(trials: int) -> None:
    """Independent draws: the stated probability is that of the k largest all being late, and an upper bound of false alarms."""
    rng, (most, chance) = np.random.default_rng(trials), late_ones(trials)
    draws = np.exp(0.4 * rng.standard_normal((4000, trials)))
    late = late_trials(trials)
    places = np.argsort(draws, axis=1)[:, -most:]
    fooled = np.mean(np.all(places >= trials - late, axis=1))
    assert most > late / 2
    assert chance <= FOOLED
    assert fooled == pytest.approx(chance, abs=4 * np.sqrt(chance / 4000) + 1e-12)
    alarms = np.mean([bounded_by_chance("y", "tip_w", one, "m").verdict == "FAIL" for one in draws])
    assert alarms <= fooled
    growing = np.arange(1, trials + 1) ** 2 * np.exp(0.05 * rng.standard_normal((200, trials)))
    found = np.mean([bounded_by_chance("y", "tip_w", one, "m").verdict == "FAIL" for one in growing])
    assert found > 0.95
    assert bounded_by_chance("y", "tip_w", np.arange(1.0, trials + 1), "m").verdict == "FAIL"
    assert np.mean([bounded("y", "tip_w", one, "m").verdict == "FAIL" for one in draws]) > 0.1


def test_a_row_of_trials_that_differ_by_chance_states_its_criterion_and_how_likely_chance_fails_it() -> None:
    peaks = np.array([1.0, 1.2, 0.9, 1.1, 1.0, 1.3, 1.3, 0.8, 1.27, 1.0])
    row = bounded_by_chance("y", "tip_w", peaks, "m")
    assert row.criterion == "largest |y| at tip_w > 105 % of all before in fewer than 5 of the last 5 trials"
    assert row.measured == "1.3 m; 3 of the last 5 above 105 % of those before"
    assert "chance alone fails this row in 0.4 % of runs at most" in row.meaning  # 1 / C(10, 5) = 1 / 252
    assert row.verdict == "PASS"
    assert bounded_by_chance("y", "", peaks[:9], "").verdict == "n/a"
    assert bounded_by_chance("y", "", np.append(peaks, np.inf), "").verdict == "FAIL"


@pytest.mark.parametrize("seed", range(4))
def test_noise_that_is_drawn_anew_does_not_pass_for_growth(seed: int) -> None:
    law = ("controller.kind=boundary-damping", "controller.damping={tip_w=2.0,tip_phi=0.05}", "numerics.modes=10")
    case = dampen.read_scenario("euler-bernoulli-payload", law)
    noisy = replace(case.disturbance, terms=tuple(
        replace(term, seed=seed) if isinstance(term, dampen.BandNoise) else term for term in case.disturbance.parts
    )) if isinstance(case.disturbance, dampen.Sum) else replace(case.disturbance, seed=seed)  # fmt: skip
    found = audit(dampen.simulate(replace(case, disturbance=noisy)), refine=False)
    rows = [row for row in found.findings if row.id.startswith("bounded.")]
    assert len(rows) >= 9
    assert all(row.verdict == "PASS" and "by chance" in row.meaning for row in rows)


def test_what_makes_trials_differ_by_chance() -> None:
    steady, anew = dampen.BandNoise({"tip_w": 1.0}, 1, 2, trials="repeat"), dampen.BandNoise({"tip_w": 1.0}, 1, 2)
    assert [one.by_chance for one in (steady, anew, replace(anew, trials="continue"))] == [False, True, True]
    assert not replace(anew, rms={"tip_w": 0.0}).by_chance
    assert dampen.Sum((steady, anew)).by_chance
    assert not dampen.Sum((steady, steady)).by_chance
    shaking = dampen.BaseShaking(rms=1.0, low=1.0, high=2.0)
    assert [replace(shaking, trials=t).by_chance for t in ("repeat", "random", "continue")] == [False, True, True]
    assert not dampen.BaseShaking(frequencies=(1.0,), amplitudes=(1.0,), trials="continue").by_chance
    case = dampen.read_scenario("he2017")
    assert not case.by_chance
    assert dampen.read_scenario("he2017", ["task.start=reset", "task.reset_error={tip_w=0.001}"]).by_chance
    assert dampen.read_scenario("he2017-sampled", ["sampling.noise={tip_w=0.001}"]).by_chance
    assert not dampen.read_scenario("he2017", ["sampling.noise={tip_w=0.001}"]).by_chance


def held_off(result: dampen.Result) -> float:
    """Least elastic energy of the beam with its ports where they are at the end, from the whole discretisation's compliance."""
    modes = result.scenario.plant.modes(result.scenario.numerics.modes)
    assert modes.compliance is not None
    y = result["y"][24][-1]
    return float(y @ np.linalg.solve(modes.compliance, y)) / 2


def test_sticking_is_counted_as_it_was() -> None:
    result, found = ran("he2017", *DIRECT), audited("he2017", *DIRECT)
    stuck = np.concatenate([np.asarray(result["v"][j])[:, 0] == 0 for j in range(12)])
    row = found["assumption.moving.tip_w"]
    assert row.values["share of steps stuck"].value == pytest.approx(stuck.mean())
    longest = max(len(run) for run in "".join("s" if s else " " for s in stuck).split())
    assert row.values["longest stick"].value == pytest.approx(longest * 1e-3)


def test_the_gain_against_the_load_is_judged_by_the_inequality_of_the_proof() -> None:
    """Against a plain evaluation of both sums for one j and lambda."""
    result, j, decay = ran("he2017", *DIRECT), 7, 0.5
    t = np.asarray(result.layout.coordinates["step"][1])
    weight = np.exp(-decay * t)
    left = sum(float(weight @ result["work_load"][i]) for i in range(1, j + 1))
    right = sum(float(weight @ np.abs(np.diff(result["y"][i][:, 0]))) for i in range(1, j + 1))
    slack = audited("he2017", *DIRECT)["gain.alpha_1"].values["slack by trial, lambda = 0.5 1/s"].value
    assert isinstance(slack, tuple)
    assert slack[j - 1] == pytest.approx(2 * 0.15 * right - left, rel=1e-9)
    small = audited("he2017", *DIRECT, "controller.alpha_1=0.001")["gain.alpha_1"]
    assert small.verdict == "FAIL"
    assert float(small.values["alpha_1 needed for this motion"].value) > 0.001  # type: ignore[arg-type]


def test_what_is_lost_or_grows_is_flagged() -> None:
    free = audited("he2017", "controller.kind=none", "task.trials=12")
    assert free["margin.tip_w"].verdict == "FAIL"
    held = audited("he2017", "controller.kind=none", "task.trials=25", "disturbance.frozen_at=0")
    assert held["bounded.energy"].verdict == "FAIL"
    assert free["energy.control-takes"].verdict == "n/a"


def test_a_result_without_a_trial_is_refused() -> None:
    result = replace(ran("he2017", *DIRECT), trials=0)
    with pytest.raises(dampen.ArgumentError, match="must have a finished trial"):
        audit(result)


def test_a_sampled_run_and_one_trial_are_audited_too() -> None:
    sampled = audited("he2017-sampled", "task.trials=3")
    assert sampled["assumption.moving"].verdict == "n/a"
    single = audited("he2017", "task.trials=1")
    assert single["gain.alpha_1"].verdict == "n/a"
    assert single["composite-energy.lambda=1"].verdict == "n/a"
