"""Every shipped scenario, run as a user runs it: it does what its file says, its account closes, its report is written."""

from __future__ import annotations

import re
import sys
from dataclasses import replace
from html import unescape
from pathlib import Path

import numpy as np
import pytest

import dampen
from dampen.analysis.energy import energy_account
from dampen.analysis.metrics import fraction_of_limit
from dampen.scenarios.read import build, parse, shipped, source_text, table_of
from dampen.toml import to_toml
from tests.test_scenarios import dampen_command

NAMES = list(shipped())


@pytest.fixture(scope="module")
def runs() -> dict[str, dampen.Result]:
    return {}


def run(runs: dict[str, dampen.Result], name: str) -> dampen.Result:
    if name not in runs:
        runs[name] = dampen.simulate(dampen.read_scenario(name))
    return runs[name]


def rms(result: dampen.Result, trial: int) -> np.ndarray:
    """(ports,) RMS of the errors in a trial."""
    error = result["y"][trial] - result.scenario.reference(trial)
    return np.asarray(np.sqrt(np.mean(error**2, axis=0)))


@pytest.mark.parametrize("name", NAMES)
def test_it_keeps_its_constraint_and_closes_its_account(name: str, runs: dict[str, dampen.Result]) -> None:
    result = run(runs, name)
    assert (result.status, result.warnings) == ("complete", [])
    assert energy_account(result).error < 1e-11
    assert all(fraction_of_limit(result, port).max() < 1 for port in result.scenario.ports)


@pytest.mark.parametrize("name", NAMES)
def test_the_command_line_writes_its_report(name: str, tmp_path: Path) -> None:
    done = dampen_command("run", name, "--set", "task.trials=2", "--out", "here", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    page = unescape((tmp_path / "here" / "report.html").read_text(encoding="utf-8"))
    assert dampen.read_scenario(name).title in page
    assert len(list((tmp_path / "here" / "figures").glob("*.svg"))) >= 4
    kept = dampen.load(tmp_path / "here" / "result.nc")
    assert kept.scenario == dampen.read_scenario(name, ["task.trials=2"])
    assert kept.trials == 2


@pytest.mark.parametrize("name", NAMES)
def test_its_file_reads_as_documentation(name: str) -> None:
    text = source_text(name)
    comments = [line for line in text.splitlines() if line.startswith("#")]
    assert len(comments) >= 4
    assert table_of(name)["name"] == name
    scenario = dampen.read_scenario(name)
    assert build(parse(to_toml(scenario), name), shipped()[name].parent) == scenario


def test_a_scenario_may_be_based_on_a_file_or_a_shipped_one(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_text('based_on = "he2017"\nname = "a"\n[plant]\ntip_mass = 0.3\n[controller]\nkind = "none"\n')
    (tmp_path / "b.toml").write_text('based_on = "a.toml"\n[task]\ntrials = 3\n')
    scenario = dampen.read_scenario(tmp_path / "b.toml")
    assert (scenario.name, scenario.task.trials, scenario.plant.tip_mass) == ("a", 3, 0.3)  # type: ignore[attr-defined]
    assert scenario.controller == dampen.NoControl()
    (tmp_path / "c.toml").write_text('based_on = "d.toml"\n')
    (tmp_path / "d.toml").write_text('based_on = "c.toml"\n')
    with pytest.raises(dampen.ArgumentError, match="`based_on` must not lead back"):
        dampen.read_scenario(tmp_path / "c.toml")
    (tmp_path / "e.toml").write_text("based_on = 3\n")
    with pytest.raises(dampen.ArgumentError, match="`based_on` must name a scenario or a file, but is 3"):
        dampen.read_scenario(tmp_path / "e.toml")


def test_the_wing_s_file_is_what_the_example_writes(tmp_path: Path) -> None:
    pytest.importorskip("skfem")
    examples = str(Path(__file__).parents[1] / "examples")
    sys.path.insert(0, examples)
    try:
        from fe_wing import wing
    finally:
        sys.path.remove(examples)
    kept = np.load(shipped()["assembled-from-fe"].parent / "wing.npz")
    made = wing()
    assert set(kept.files) == set(made)
    for name, array in made.items():
        if array.dtype.kind == "f":
            np.testing.assert_allclose(kept[name], array, rtol=1e-12, atol=1e-12, err_msg=name)
        else:
            np.testing.assert_array_equal(kept[name], array, err_msg=name)


def test_norm_optimal_learning_brings_the_arm_to_its_point(runs: dict[str, dampen.Result]) -> None:
    result = run(runs, "flexible-arm-point-to-point")
    tip = result.scenario.ports.index("tip_w")
    assert rms(result, 3)[tip] < 0.01 * rms(result, 0)[tip]
    np.testing.assert_array_equal(result["delivered"][:, :, tip], 0.0)


def test_gusts_on_the_boom_are_cut_tenfold(runs: dict[str, dampen.Result]) -> None:
    controlled = run(runs, "euler-bernoulli-payload")
    free = dampen.simulate(controlled.scenario.uncontrolled())
    late = range(2, 10)
    ratio = np.mean([rms(controlled, j) for j in late], axis=0) / np.mean([rms(free, j) for j in late], axis=0)
    assert np.all(ratio < 0.1)


def test_the_matched_damping_swallows_a_blow_faster_than_weaker_and_stronger_ones() -> None:
    def left(damping: float) -> float:
        blow = dampen.Impulse(duration=0.1, impulse={"tip_w": 8.0}, trial=0)
        scenario = dampen.read_scenario("string-tip-mass", [f"controller.damping.tip_w={damping}", "task.trials=1"])
        controller = replace(scenario.controller, barrier="none", barrier_gain={})  # type: ignore[type-var]
        energy = dampen.simulate(replace(scenario, disturbance=blow, controller=controller))["energy"][0]
        return float(energy[-1] / energy.max())

    assert left(49.0) < 0.05
    assert left(49.0) < 0.2 * left(5.0)
    assert left(49.0) < 0.5 * left(500.0)


def test_modes_that_the_controller_does_not_know_spill_over_on_an_undamped_wing() -> None:
    def energy(modes: int) -> float:
        settings = ["plant.damping.ratio=0.0", f"controller.modes={modes}"]
        return float(dampen.simulate(dampen.read_scenario("assembled-from-fe", settings))["energy"].mean())

    assert energy(2) > 1000 * energy(6)


@pytest.mark.parametrize("numerics", [("numerics.modes=64",), ("numerics.modes=128", "numerics.step=0.00025", "output.every=40")])
@pytest.mark.parametrize("name", ["he2017-tuned", "he2017-tuned-direct"])
def test_tuned_gains_hold_the_tip_at_their_own_resolution_and_at_a_finer_one(name: str, numerics: tuple[str, ...]) -> None:
    scenario = dampen.read_scenario(name, numerics)
    result = dampen.simulate(scenario)
    assert np.abs(result["y"][-5:]).max() <= 3e-4  # of both ports, m and rad
    assert result.status == "complete"
    assert max(fraction_of_limit(result, port).max() for port in scenario.ports) < 0.91


def test_the_search_that_a_tuned_scenario_s_file_names_can_be_run() -> None:
    """Its first generation: it begins where he2017 is, and finds something better."""
    text = source_text("he2017-tuned")
    search = re.findall(r"--search (\S+)", text)
    assert len(search) == 9
    study = dampen.tune(dampen.read_scenario("he2017", ["numerics.modes=64"]), search, budget=30, population=30, seed=2)
    assert study.table["peak"].min() < study.table["peak"][0]
    paths = [option.partition("=")[0] for option in search]
    assert list(study.table.loc[0, paths]) == [1.0, 1.0, 0.1, 1.0, 1.0, 0.1, 1.0, 0.1, 0.1]
