"""Scenario files and the command line: what goes in, what comes out, and what is said about bad input."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import dampen
from dampen.scenarios.read import build, override, parse, shipped, source_text
from dampen.toml import to_toml
from tests.conftest import scenario


def dampen_command(*arguments: str, cwd: Path, **options: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "dampen.cli", *arguments]
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, timeout=300, **options)  # type: ignore[call-overload,no-any-return]


@pytest.mark.parametrize("name", list(shipped()))
def test_a_shipped_scenario_written_out_reads_back_the_same(name: str) -> None:
    original = dampen.read_scenario(name)
    assert build(parse(to_toml(original), name)) == original


def test_the_shipped_scenario_is_table_1_and_section_5() -> None:
    case = dampen.read_scenario("he2017")
    beam = case.plant
    assert isinstance(beam, dampen.TimoshenkoBeam)
    numbers = (beam.mass_per_length, beam.length, beam.tip_mass, beam.bending_stiffness, beam.rotary_inertia, beam.tip_inertia)
    assert (*numbers, beam.shear_stiffness) == (1, 1, 0.1, 35, 2, 0.1, 15)
    assert beam.initial == dampen.BeamState(w=(0, 0.16), phi=(0, 0.18), w_rate=(0.1,), phi_rate=(0.1,))
    assert case.actuators == {port: (dampen.Backlash(0.3, 0.1, -0.2),) for port in ("tip_w", "tip_phi")}
    assert case.bounds == {"f": 0.15, "tip_w": 0.3, "tip_phi": 0.3}
    assert (case.task.trials, case.task.trial_duration, case.task.constraint) == (25, 2.0, {"tip_w": 0.2, "tip_phi": 0.2})


BAD = {
    "plant.tip_mas=1": "Argument `plant.tip_mas` is not known; did you mean `tip_mass`?",
    "alpha_4=1": "Argument `alpha_4` is not known; did you mean `controller.alpha_4`?",
    "plant.modes=9": "Argument `plant.modes` is not known; did you mean `numerics.modes`?",
    "controler.kind=none": "Argument `controler` is not known; did you mean `controller`?",
    "plant.tip_mass=heavy": "Argument `plant.tip_mass` must be a number in kg, but is 'heavy'.",
    "plant.tip_mass=-0.1": "Argument `plant.tip_mass` must be >= 0 kg, but is -0.1.",
    "plant.tip_mass=nan": "Argument `plant.tip_mass` must be a finite number in kg, but is nan.",
    "actuator.all.chain.0={kind='saturation', low=0.0, high=0.0}": "Argument `actuator.all.chain[0].low` must be < `high`",
    "controller.alpha_2=0.5": "Argument `controller.alpha_2` must be >= 1, but is 0.5.",
    "controller.alpha_3=-1": "Argument `controller.alpha_3` must be > 0 N m, but is -1.",
    "plant.initial.w=[0, 0.25]": "Argument `plant.initial` must put tip_w inside its constraint, |y| < 0.2, but is 0.25.",
    "numerics.step=0.003": "Argument `numerics.step` must divide task.trial_duration = 2 s, but is 0.003.",
    "numerics.step=1e-9": "Argument `numerics.step` must be larger",
    "task.trials=0": "Argument `task.trials` must be >= 1, but is 0.",
    "task.trials=2.5": "Argument `task.trials` must be a whole number, but is 2.5.",
    "task.constraint.tip=1": "Argument `task.constraint.tip` is not a port of this plant; known here: tip_w, tip_phi.",
    "controller.kind=pid": "Argument `controller.kind` must be a known kind of controller, but is 'pid'; known here",
    "output.every=7": "Argument `output.every` must divide the 2000 steps of a trial, but is 7.",
    "numerics.modes=2000": "Argument `numerics.modes` must be <= 1000, but is 2000.",
    "controller.alpha_8": "Option `--set` must look like table.key=value, without spaces or in quotes, but is 'con",
    "plant.tip_mass=1,2": "Option `--set plant.tip_mass` must have a TOML value, but has '1,2'; did you mean --set",
    "plant.tip_mass.x=1": "Option `--set plant.tip_mass.x` must name a key, but `tip_mass` is a value, 0.1, not a table.",
    "plant=3": "Argument `plant` must be a table, but is 3.",
}


@pytest.mark.parametrize("setting", list(BAD))
def test_bad_input_gets_one_clear_line(setting: str) -> None:
    with pytest.raises(dampen.ArgumentError) as error:
        scenario(setting)
    assert len(error.value.lines) == 1
    assert error.value.lines[0].startswith(BAD[setting])


def test_all_faults_are_reported_at_once() -> None:
    with pytest.raises(dampen.ArgumentError) as error:
        scenario("plant.tip_mass=-1", "task.trials=0", "controller.alpha_5=0")
    assert len(error.value.lines) == 3


def test_broken_toml_is_reported_with_line_and_column() -> None:
    with pytest.raises(dampen.ArgumentError, match=r"at line 2, column \d"):
        parse("[plant]\nkind = = 3\n", "x.toml")


def test_a_new_kind_starts_its_table_afresh_whatever_the_order() -> None:
    table = parse(source_text("he2017"), "he2017")
    changed = override(table, ["controller.alpha_4=2.0", "controller.kind=dual-loop-ailc"])
    assert changed["controller"] == {"kind": "dual-loop-ailc", "alpha_4": 2.0}


def test_python_arguments_are_checked_like_files() -> None:
    with pytest.raises(dampen.ArgumentError, match=r"Argument `tip_mass` must be >= 0 kg, but is -0\.1\."):
        dampen.TimoshenkoBeam(tip_mass=-0.1)
    with pytest.raises(dampen.ArgumentError, match="Argument `initial` must be a BeamState"):
        dampen.TimoshenkoBeam(initial=(0.0, 0.1))  # type: ignore[arg-type]
    assert dampen.TimoshenkoBeam(tip_mass=np.float64(1)).tip_mass == 1.0  # type: ignore[arg-type]


tables = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.sampled_from(["kind", "w", "trials", "chain", "x", "tip_w", "f"]), inner, max_size=3)
    ),
    max_leaves=6,
)


@settings(max_examples=150, deadline=None)
@given(
    key=st.sampled_from(
        ["plant", "controller", "task", "bounds", "actuator", "disturbance", "numerics", "output", "name", "claims"]
    ),
    value=tables,
)
def test_any_table_whatsoever_is_read_or_refused_in_words(key: str, value: object) -> None:
    table = parse(source_text("he2017"), "he2017")
    table[key] = value
    try:
        build(table)
    except dampen.ArgumentError as error:
        assert all("`" in line for line in error.lines)


def test_what_cannot_be_resolved_is_refused_or_warned_about() -> None:
    with pytest.raises(
        dampen.ArgumentError, match=r"`numerics.step` must be < 0.0033 s to resolve the 75 Hz that shake trial 24"
    ):
        dampen.simulate(scenario("numerics.step=0.004", "output.every=1"))
    thin = dampen.simulate(scenario("numerics.step=0.002", "numerics.modes=40", "task.trials=25"))
    assert any("`numerics.step` = 0.0013 would do" in line for line in thin.warnings)
    enough = next(line for line in thin.warnings if "numerics.modes" in line)
    modes = int(enough.split("= ")[-1].split()[0])
    assert not any("modes" in line for line in dampen.simulate(scenario(f"numerics.modes={modes + 2}")).warnings)
    assert not dampen.simulate(scenario()).warnings


def test_run_writes_everything_and_says_where(tmp_path: Path) -> None:
    done = dampen_command("run", "he2017", "--set", "task.trials=3", "--out", "here", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    folder = tmp_path / "here"
    names = {p.name for p in folder.iterdir()}
    assert names == {"result.nc", "uncontrolled.nc", "scenario.toml", "audit.json", "figures", "report.html"}
    drawn = {p.name for p in (folder / "figures").iterdir()}
    assert drawn >= {f"fig{i:02}.{ext}" for i in range(5, 17) for ext in ("png", "svg")}
    assert "report.html" in done.stdout
    assert "F11" in done.stdout
    page = (folder / "report.html").read_text()
    assert 'src="http' not in page
    assert 'href="http' not in page
    assert build(parse((folder / "scenario.toml").read_text(), "x")) == scenario("task.trials=3")


def test_a_result_file_reads_back_as_it_was(tmp_path: Path) -> None:
    assert dampen_command("run", "he2017", "--set", "task.trials=2", "--no-report", "--out", ".", cwd=tmp_path).returncode == 0
    loaded, made = dampen.load(tmp_path / "result.nc"), dampen.simulate(scenario("task.trials=2"))
    assert loaded.scenario == made.scenario
    assert (loaded.status, loaded.trials, loaded.version) == ("complete", 2, dampen.version())
    for name in made.layout.variables:
        np.testing.assert_array_equal(loaded[name][:], made[name], err_msg=name)
    data = loaded.dataset
    assert data["y"].dims == ("trial", "time", "port")
    assert list(data["motion_unit"].values) == ["m", "rad"]
    assert data.attrs["dampen_version"] == dampen.version()


def test_files_that_are_no_results_are_refused(tmp_path: Path) -> None:
    junk = tmp_path / "junk.nc"
    junk.write_bytes(b"not a result")
    for path in (junk, tmp_path / "missing.nc"):
        with pytest.raises(dampen.ArgumentError, match="Result file"):
            dampen.load(path)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["run", "he2018"], "did you mean `he2017`?"),
        (["run", "missing.toml"], "cannot be read: No such file"),
        (["run", "."], "must be a file, but is a folder."),
        (["run", "broken.toml"], "at line 1, column"),
        (["run", "he2017", "--set", "task.trials"], "--set"),
        (["run", "he2017", "--out", "/dev/null/x"], "cannot be written"),
        (["run", "he2017", "--set", "plant.tip_mass=-1"], "`plant.tip_mass` must be >= 0 kg"),
        (["run"], "scenario"),
        (["run", "he2017", "--nonsense"], "--nonsense"),
    ],
)
def test_bad_arguments_end_with_status_2_and_no_traceback(tmp_path: Path, arguments: list[str], words: str) -> None:
    (tmp_path / "broken.toml").write_text("= 3")
    done = dampen_command(*arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert words.lower() in done.stderr.lower()  # older typers write SCENARIO
    assert "Traceback" not in done.stderr
    assert len(done.stderr.strip().splitlines()) == 1


def test_an_interrupt_keeps_the_finished_trials(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "dampen.cli", "run", "he2017", "--no-report", "--out", "cut"]
    command += ["--set", "task.trials=100000", "--set", "disturbance.frozen_at=0"]
    process = subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    file = tmp_path / "cut" / "result.nc"
    deadline = time.time() + 120
    while time.time() < deadline and not (file.exists() and file.stat().st_size > 5e6):
        time.sleep(0.1)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 3
    assert "Traceback" not in errors
    kept = dampen.load(file)
    assert kept.status == "interrupted"
    assert kept.trials > 2
    assert np.all(np.isfinite(kept["energy"][: kept.trials]))


def test_default_folders_never_overwrite_one_another(tmp_path: Path) -> None:
    for _ in range(2):
        assert dampen_command("run", "he2017", "--set", "task.trials=1", "--no-report", cwd=tmp_path).returncode == 0
    assert {p.name for p in (tmp_path / "runs").iterdir()} == {"he2017", "he2017-2"}


def test_list_and_show_come_from_the_code(tmp_path: Path) -> None:
    listed = dampen_command("list", cwd=tmp_path).stdout
    for word in ("he2017", "timoshenko", "backlash", "dual-loop-ailc", "alpha_9", "kg/m", "initial.w_rate", "trial_duration"):
        assert word in listed
    one = dampen_command("list", "backlash", cwd=tmp_path).stdout
    assert one.startswith('[actuator] kind = "backlash"')
    assert len(one.splitlines()) == 4
    unknown = dampen_command("list", "backlsh", cwd=tmp_path)
    assert (unknown.returncode, "did you mean `backlash`?" in unknown.stderr) == (2, True)
    for command in ("run", "list"):
        assert all(name in dampen_command(command, "--help", cwd=tmp_path).stdout for name in ("flexible-arm", "lag", "lqg"))
    shown = dampen_command("show", "he2017", cwd=tmp_path).stdout
    assert build(parse(shown, "shown")) == scenario()
    assert dampen_command("--version", cwd=tmp_path).stdout.strip() == f"dampen {dampen.version()}"


def test_importing_dampen_brings_in_nothing_heavy() -> None:
    heavy = [
        "matplotlib",
        "numba",
        "xarray",
        "netCDF4",
        "scipy",
        "jinja2",
        "typer",
        "rich",
        "pandas",
        "pyarrow",
        "optuna",
        "loky",
        "distributed",
    ]
    code = f"import sys, dampen; print([m for m in {heavy} if m in sys.modules])"
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=dict(os.environ))
    assert out.stdout.strip() == "[]"


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="reads the peak where Linux keeps it")
def test_memory_does_not_grow_with_the_number_of_trials(tmp_path: Path) -> None:
    """1,000 trials written to a file stay under 1 GiB resident."""
    code = (
        "import sys; from pathlib import Path; from dampen import cli\n"
        "sys.argv = ['dampen', 'run', 'he2017', '--no-report', '--out', 'long', '--set', 'task.trials=1000',"
        " '--set', 'disturbance.frozen_at=0']\n"
        "try: cli.main()\nexcept SystemExit as e: print('status', e.code)\n"
        "peak = next(line for line in Path('/proc/self/status').read_text().splitlines() if line.startswith('VmHWM'))\n"
        "print('MiB', int(peak.split()[1]) / 1024)"  # unlike getrusage's, this process's own: not what its parent had
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True, timeout=300)
    out = done.stdout
    assert "status 0" in out
    assert float(out.split("MiB")[1]) < 1024


def test_the_readme_s_python_runs() -> None:
    readme = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")
    blocks = [block.split("```")[0] for block in readme.split("```python\n")[1:]]
    names: dict[str, Any] = {}
    exec("".join(blocks).replace("task.trials=40", "task.trials=3").replace("budget=100", "budget=8"), names)
    assert isinstance(names["result"], dampen.Result)
    assert isinstance(names["better"], dampen.Scenario)
    assert np.abs(dampen.simulate(names["strip"])["y"][-1][:, 0]).max() < 0.005
