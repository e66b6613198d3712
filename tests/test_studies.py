"""Studies: what goes in, what stands in the table, and that nothing is lost, whatever happens on the way."""

from __future__ import annotations

import errno
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas
import pytest

import dampen
from dampen.analysis.merits import merits
from dampen.report.study.page import verdict_of
from dampen.simulation.batch import alone
from dampen.simulation.bench import Bench
from dampen.studies.api import resume, robust, sweep, tune
from dampen.studies.best import best_row, best_scenario, nearest_row, outcome, write_best
from dampen.studies.definition import robust_of, sweep_of, tune_of
from dampen.studies.engines import Cores, Here
from dampen.studies.search import clipped
from dampen.studies.study import Study, new_study, open_study
from dampen.studies.variation import Option, member, read_axis
from tests.conftest import scenario
from tests.test_scenarios import dampen_command

SHORT = ("task.trials=3", "task.trial_duration=0.5", "numerics.modes=12", "numerics.step=0.002", "output.every=50")
FROZEN = (*SHORT[1:], "disturbance.frozen_at=0")  # for many trials
SETTINGS = [part for setting in SHORT for part in ("--set", setting)]
GAINS = {"controller.alpha_1": "0.01:10:log", "controller.alpha_4": "0.1:10:log", "controller.alpha_7": "0.1:10:log"}
KILLS = int(os.environ.get("DAMPEN_KILLS", "2"))


@pytest.fixture
def short() -> dampen.Scenario:
    return scenario(*SHORT)


READ: dict[tuple[Option, str], tuple[Any, ...]] = {
    ("vary", "controller.alpha_4=0.1:10:log:3"): (0.1, 1.0, 10.0),
    ("vary", "controller.alpha_4=1:2:3"): (1.0, 1.5, 2.0),
    ("vary", "task.trials=5:25:3"): (5, 15, 25),
    ("vary", "controller.barrier=log,tan"): ("log", "tan"),
    ("vary", "controller.compensate=true,false"): (True, False),
    ("uncertain", "plant.tip_mass=+-30%"): (0.07, 0.13),
    ("uncertain", "plant.tip_mass=0.2+-0.05"): (0.15, 0.25),
    ("uncertain", "plant.tip_mass=0.1+-10%:normal"): (0.07, 0.13),
    ("uncertain", "plant.tip_mass,plant.bending_stiffness=±20%"): (0.8, 1.2),
    ("uncertain", "plant.initial.w.1=0.1:0.18"): (0.1, 0.18),
    ("search", "controller.alpha_3=0.01:10:log"): (0.01, 10.0),
}


@pytest.mark.parametrize(("option", "text"), list(READ))
def test_ranges_are_read(option: Option, text: str) -> None:
    axis = read_axis(option, text, scenario())
    found = axis.values or (axis.low, axis.high)
    assert found == pytest.approx(READ[option, text]) if not isinstance(found[0], str) else found == READ[option, text]
    assert axis.name == text.partition("=")[0]


VARY = "Option `--vary controller.alpha_4`"
BAD: dict[tuple[Option, str], str] = {
    ("vary", "controller.alpha_44=1:2:3"): "Argument `controller.alpha_44` is not known; did you mean `alpha_4`?",
    ("vary", "controler.alpha_4=1:2:3"): "Argument `controler.alpha_4` is not known; did you mean `controller`?",
    ("vary", "controller.alpha_4.x=1:2:3"): "Argument `controller.alpha_4.x` must name a value, but `controller.alpha_4` is one",
    ("vary", "actuator.all.chain.7.right=1:2:3"): "Argument `actuator.all.chain.7.right` is not known; known here: 0.",
    ("vary", "actuator.tip_w.right=1:2:3"): "Argument `actuator.tip_w.right` must look like actuator.PORT.chain.0.PARAMETER",
    ("vary", "controller.alpha_4"): "Option `--vary` must look like PATH=RANGE",
    ("vary", "controller.alpha_4=2:1:3"): f"{VARY} must have a range with LOW < HIGH, but has 2:1.",
    ("vary", "controller.alpha_4=0:1:log:3"): f"{VARY} must have LOW > 0 for a logarithmic range, but has 0.",
    ("vary", "controller.alpha_4=-1:1:log:3"): f"{VARY} must have LOW > 0 for a logarithmic range, but has -1.",
    ("vary", "controller.alpha_4=1:2:1"): f"{VARY} must have a count of points from 2 to 100000, but has 1.",
    ("vary", "controller.alpha_4=1:2:lg:3"): f"{VARY} must have a range like LOW:HIGH:COUNT",
    ("vary", "controller.alpha_4=-1:1:3"): f"{VARY} cannot be -1.0: Argument `controller.alpha_4` must be > 0",
    ("vary", "controller.barrier=lg"): "Option `--vary controller.barrier` cannot be 'lg': Argument",
    ("vary", "controller.alpha_4=1,1"): "Option `--vary` must name each value once",
    ("vary", "controller=1:2:3"): "Option `--vary controller` must name a number, but it is DualLoopAILC",
    ("vary", "task.constraint.tip_w=-1:1:3"): "Option `--vary task.constraint.tip_w` cannot be -1.0: Argument",
    ("uncertain", "plant.tip_mass=+-130%"): "Option `--uncertain plant.tip_mass` cannot be -0.03: Argument",
    ("uncertain", "plant.tip_mass=+-0%"): "Option `--uncertain plant.tip_mass` must have a spread > 0, but has 0.",
    ("uncertain", "controller.barrier=+-1%"): "Option `--uncertain controller.barrier` must name a number, but it is 'log'.",
    ("uncertain", "plant.tip_mass,plant.tip_mass=+-1%"): "Option `--uncertain plant.tip_mass,plant.tip_mass` must name each",
    ("search", "controller.alpha_3=1:2:3"): "Option `--search controller.alpha_3` must have a range like LOW:HIGH",
}  # fmt: skip


@pytest.mark.parametrize(("option", "text"), list(BAD))
def test_a_range_that_is_none_gets_one_clear_line(option: Option, text: str) -> None:
    with pytest.raises(dampen.ArgumentError) as error:
        read_axis(option, text, scenario())
    assert len(error.value.lines) == 1
    assert error.value.lines[0].startswith(BAD[option, text])


def test_several_paths_take_the_same_factor(short: dampen.Scenario) -> None:
    axis = read_axis("uncertain", "actuator.all.chain.0.right,actuator.all.chain.0.left=+-50%", short)
    made = member(short, (axis,), {axis.name: 1.5})
    assert made.actuators == {port: (dampen.Backlash(0.3, 0.1 * 1.5, -0.2 * 1.5),) for port in short.ports}


def test_a_sweep_s_rows_are_its_members_runs(short: dampen.Scenario) -> None:
    study = sweep(short, {"controller.alpha_4": "0.1:10:log:3", "controller.barrier": ["log", "tan"]}, engine=Here())
    table = study.table
    assert list(table["member"]) == list(range(6))
    assert list(table["controller.barrier"]) == ["log", "tan"] * 3
    for row in table.to_dict("records"):
        made = member(short, study.definition.axes, row)
        expected = merits(alone(made, Bench(made)))
        assert {name: row[name] for name in expected} == expected
        assert row["status"] == "complete"
        assert max(row["peaks.tip_w"]) == row["largest.tip_w"]
    grid = study.dataset
    assert grid["peak"].dims == ("controller.alpha_4", "controller.barrier")
    assert float(grid["peak"].sel({"controller.barrier": "tan"})[2]) == table["peak"][5]
    assert grid["peak.tip_w"].attrs["units"] == "m"
    assert "dual-loop-ailc" in grid.attrs["scenario"]


def test_members_that_fail_are_rows_that_say_so(short: dampen.Scenario) -> None:
    starts = sweep(short, {"plant.initial.w.1": [0.1, 0.19999999, 0.16]}, engine=Here()).table
    assert list(starts["status"]) == ["complete", "refused", "complete"]
    assert "numerics.modes" in starts["message"][1]
    assert np.isnan(starts["peak"][1])
    free = sweep(
        scenario(*SHORT, "controller.kind=none", "task.trial_duration=2.0"), {"plant.tip_mass": [0.1, 0.2]}, engine=Here()
    )
    assert list(free.table["status"]) == ["constraint_lost"] * 2
    assert np.all(free.table["margin"] < 0)


def test_a_tuning_finds_better_gains_and_keeps_the_constraint(short: dampen.Scenario) -> None:
    study = tune(short, GAINS, "energy", budget=48, population=12, seed=3, engine=Here())
    table = study.table
    assert list(table["generation"]) == [i // 12 for i in range(48)]
    first, best = table.iloc[0], best_row(study, "energy")
    assert best is not None
    assert (first["controller.alpha_1"], first["controller.alpha_7"]) == (1.0, 1.0)  # the search begins where the scenario is
    assert best["energy"] < 0.8 * first["energy"]
    found = best_scenario(study)
    assert found.name == "he2017-tuned"
    assert merits(alone(found, Bench(found)))["energy"] == best["energy"]


def test_several_objectives_spread_along_a_front(short: dampen.Scenario) -> None:
    study = tune(short, GAINS, ["residual", "effort"], budget=60, population=20, engine=Here())
    least = {name: best_row(study, name) for name in ("residual", "effort")}
    assert least["residual"]["effort"] > least["effort"]["effort"]  # type: ignore[index]
    assert least["residual"]["residual"] < least["effort"]["residual"]  # type: ignore[index]


def test_candidates_that_lose_the_constraint_come_last() -> None:
    pushed = scenario(*SHORT, "controller.kind=boundary-damping", "controller.damping={tip_w=1.0,tip_phi=1.0}",
                      "controller.stiffness={tip_w=1.0}", "task.trial_duration=2.0")  # fmt: skip
    study = tune(pushed, {"controller.damping.tip_w": "0.001:30:log"}, "effort.tip_w", budget=30, engine=Here())
    table, best = study.table, best_row(study, "effort.tip_w")
    assert {"complete", "constraint_lost"} == set(table["status"])
    lost = table[table["status"] == "constraint_lost"]
    assert best is not None
    assert best["status"] == "complete"
    assert lost["effort.tip_w"].min() < best["effort.tip_w"]  # it would have been cheaper to lose it


def test_where_nothing_keeps_the_constraint_the_nearest_is_told_and_written(tmp_path: Path) -> None:
    """So little damping does not hold the tip; the nearest is the row with the largest margin."""
    weak = scenario(*SHORT, "controller.kind=boundary-damping", "controller.damping={tip_w=0.001,tip_phi=0.001}",
                    "task.trial_duration=2.0")  # fmt: skip
    study = tune(weak, {"controller.damping.tip_w": "0.001:0.2"}, budget=6, folder=tmp_path / "study", engine=Here())
    table = study.table
    assert set(table["status"]) == {"constraint_lost"}
    best = table.iloc[int(table["margin"].argmax())]
    found = nearest_row(study.rows.rows, "peak")
    assert found is not None
    assert found["member"] == best["member"]
    assert outcome(study).endswith(f"member {best['member']}, broke it by {-100 * best['margin']:.3g} %.")
    (path,) = write_best(study)
    assert path.name == "nearest.toml"
    assert f"by {-100 * best['margin']:.3g} %" in path.read_text().splitlines()[0]
    assert dampen.read_scenario(path).controller.damping["tip_w"] == best["controller.damping.tip_w"]  # type: ignore[attr-defined]
    told = verdict_of(study)
    assert told.startswith("None of 6 runs held the constraint; the nearest broke it by ")
    assert f"damping tip w = {best['controller.damping.tip_w']:.4g}" in told


def test_a_start_outside_of_the_range_is_told() -> None:
    case = scenario("controller.alpha_1=5.0")
    definition = tune_of(case, ["controller.alpha_1=0.01:2:log", "controller.alpha_7=0.01:100:log"], ["peak"], 4)
    assert clipped(definition) == ["controller.alpha_1 is 5, outside its range, 0.01 to 2: the search begins at 2"]


def test_a_robust_tuning_s_row_is_its_worst_sample(short: dampen.Scenario) -> None:
    study = tune(short, GAINS, budget=4, population=4, robust_over={"plant.tip_mass": "+-30%"}, robust_samples=3, engine=Here())
    row, definition = study.table.iloc[2], study.definition
    axes = (*definition.axes, *definition.robust_axes)
    made = [member(short, axes, {**row[[a.name for a in definition.axes]], **more}) for more in definition.robust_design]
    found = [merits(alone(one, Bench(one))) for one in made]
    assert row["peak"] == pytest.approx(max(figures["peak"] for figures in found), rel=1e-3)
    assert row["margin"] == pytest.approx(min(figures["margin"] for figures in found), rel=1e-6)


def test_the_same_seed_gives_the_same_study_and_another_one_another(short: dampen.Scenario) -> None:
    uncertain = {"plant.tip_mass": "+-30%", "controller.alpha_4": "+-10%"}
    one, two, other = (robust(short, uncertain, samples=16, seed=seed, engine=Here()).table for seed in (1, 1, 2))
    pandas.testing.assert_frame_equal(one, two, check_exact=True)
    assert not np.any(one["plant.tip_mass"].to_numpy() == other["plant.tip_mass"].to_numpy())


def test_a_study_with_classes_of_the_caller_s_own_runs_in_this_process(short: dampen.Scenario) -> None:
    class Softer(dampen.BoundaryDamping):
        pass

    own = short.with_controller(Softer(damping={"tip_w": 1.0}))
    study = sweep(own, {"controller.damping.tip_w": [2.0, 3.0]})
    assert list(study.table["status"]) == ["complete"] * 2
    with pytest.raises(dampen.ArgumentError, match="no other process can make"):
        sweep(own, {"controller.damping.tip_w": [1.0, 2.0]}, engine=2)


POISON = """
import os
import dampen
from dataclasses import dataclass

@dataclass(frozen=True)
class Poison(dampen.BoundaryDamping):
    level: float = 0.0

    def begin(self, setting):
        if self.level == 1.0:
            os.kill(os.getpid(), 9)
        if self.level == 2.0:
            raise MemoryError("too much")
        return {}
"""


def test_a_member_that_takes_its_worker_down_is_a_row_and_no_other_is_lost(tmp_path: Path) -> None:
    (tmp_path / "poison.py").write_text(POISON)
    text = "based_on = 'he2017'\nname = 'poisoned'\n[controller]\nkind = 'poison:Poison'\ndamping = { tip_w = 1.0 }\n"
    (tmp_path / "mine.toml").write_text(text)
    levels = ",".join(str(level) for level in [0.1, 0.2, 1.0, 0.3, 2.0, *np.arange(3, 19)])
    arguments = ("sweep", "mine.toml", "--vary", f"controller.level={levels}", "--out", "study", "--no-report", *SETTINGS)
    done = dampen_command(*arguments, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    table = open_study(tmp_path / "study").table
    assert len(table) == 21
    expected = [
        "crashed" if level == 1.0 else "refused" if level == 2.0 else "constraint_lost" for level in table["controller.level"]
    ]
    assert list(table["status"]) == expected
    assert "worker died" in table["message"][2]
    assert "begin failed: MemoryError: too much" in table["message"][4]


def test_a_study_folder_is_one_study_s_own(short: dampen.Scenario, tmp_path: Path) -> None:
    definition = sweep_of(short, ["controller.alpha_4=1:2:2"])
    new_study(definition, tmp_path / "a").run(Here())
    with pytest.raises(dampen.ArgumentError, match=r"holds this study already, 2 of 2 rows: `dampen resume"):
        new_study(definition, tmp_path / "a")
    with pytest.raises(dampen.ArgumentError, match="must be another one: it holds a study of something else"):
        new_study(sweep_of(short, ["controller.alpha_4=1:2:3"]), tmp_path / "a")
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "thesis.tex").touch()
    with pytest.raises(dampen.ArgumentError, match="must be empty or new"):
        new_study(definition, tmp_path / "b")
    with pytest.raises(dampen.ArgumentError, match="is not a study"):
        open_study(tmp_path / "b")
    text = (tmp_path / "a" / "scenario.toml").read_text()
    (tmp_path / "a" / "scenario.toml").write_text(text.replace("tip_mass = 0.1", "tip_mass = 0.11"))
    with pytest.raises(dampen.ArgumentError, match="has rows of another study"):
        open_study(tmp_path / "a")


def test_rows_are_read_by_anything_that_reads_parquet(short: dampen.Scenario, tmp_path: Path) -> None:
    study = dampen.sweep(short, {"controller.alpha_4": [1.0, 2.0]}, folder=tmp_path / "study", engine=Here())
    table = pandas.read_parquet(tmp_path / "study" / "rows").set_index("member").sort_index()
    assert table["controller.alpha_4"].tolist() == [1.0, 2.0]
    np.testing.assert_array_equal(table["residual"], study.table["residual"])


def test_a_definition_written_down_reads_back_the_same(short: dampen.Scenario, tmp_path: Path) -> None:
    over = ["plant.tip_mass=+-30%"]
    definitions = {
        "sweep": sweep_of(short, ["controller.alpha_4=1:2:2", "controller.barrier=log,tan"]),
        "robust": robust_of(short, over, 30, "latin", 4),
        "tune": tune_of(short, ["controller.alpha_4=1:2"], ["peak", "effort"], 30, 10, 5, over, 3),
    }
    for kind, definition in definitions.items():
        new_study(definition, tmp_path / kind)
        found = open_study(tmp_path / kind)
        assert found.definition.fingerprint == definition.fingerprint
        assert (found.members, found.done, found.definition.axes) == (definition.members, 0, definition.axes)


def test_a_full_disk_is_one_clear_line_and_keeps_what_is_there(
    short: dampen.Scenario, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    study, real, calls = new_study(sweep_of(short, ["controller.alpha_4=1:2:20"]), tmp_path / "a"), os.fsync, iter(range(99))

    def full_at_last(file: int) -> None:
        if next(calls) >= 2:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        real(file)

    monkeypatch.setattr(os, "fsync", full_at_last)
    with pytest.raises(dampen.ArgumentError, match=r"cannot be written: No space left on device; \d+ rows are kept") as error:
        study.run(Here())
    assert len(error.value.lines) == 1
    monkeypatch.undo()
    there = open_study(tmp_path / "a")
    assert 0 < there.done < 20
    there.run(Here())
    whole = sweep(short, {"controller.alpha_4": "1:2:20"}, engine=Here())
    pandas.testing.assert_frame_equal(open_study(tmp_path / "a").table, whole.table, check_exact=True)


COMMANDS = {
    "sweep": ["--vary", "controller.alpha_4=0.1:10:log:12", "--vary", "controller.alpha_7=0.1:10:log:12"],
    "tune": ["--search", "controller.alpha_4=0.1:10:log", "--search", "controller.alpha_7=0.1:10:log", "--budget", "96"],
}  # fmt: skip


def parts(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted((folder / "rows").glob("part-*.parquet"))}


@pytest.mark.parametrize("kind", list(COMMANDS))
def test_killed_at_any_moment_a_study_goes_on_and_ends_as_if_undisturbed(kind: str, tmp_path: Path) -> None:
    """kill -9, again and again; no finished row is computed twice. DAMPEN_KILLS sets how often."""
    random, killed = np.random.default_rng(len(kind)), 0
    longer = [part for setting in (f"task.trials={1000 * KILLS}", *FROZEN) for part in ("--set", setting)]
    new = [kind, "he2017", *COMMANDS[kind], "--out", "study", "--no-report", "--workers", "2", *longer]
    whole = new_study_of(kind, longer)
    moments = iter(random.uniform(0.0, 2.0, 10 * KILLS))
    command, before = new, dict[str, bytes]()
    while killed < KILLS:
        process = subprocess.Popen([sys.executable, "-m", "dampen.cli", *command], cwd=tmp_path, start_new_session=True)
        wait_for(tmp_path / "study" / "rows", before, process)
        time.sleep(next(moments))
        if process.poll() is not None:
            break
        process.kill()
        process.wait()
        killed += 1
        now = parts(tmp_path / "study")
        assert {name: now[name] for name in before} == before, "what was finished stays as it was"
        command, before = ["resume", "study", "--no-report", "--workers", "2"], now
    assert killed == KILLS, "it was finished before"
    done = dampen_command("resume", "study", "--no-report", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    now = parts(tmp_path / "study")
    assert {name: now[name] for name in before} == before
    there = open_study(tmp_path / "study")
    kept = sorted((tmp_path / "study" / "rows").glob("part-*.parquet"))
    members = [int(member) for path in kept for member in pandas.read_parquet(path)["member"]]
    assert sorted(members) == list(range(there.members)), "every row is there, and once"
    pandas.testing.assert_frame_equal(there.table, whole.table, check_exact=True)


def new_study_of(kind: str, settings: list[str]) -> Study:
    case = scenario(*settings[1::2])
    options = COMMANDS[kind][1::2]
    definition = sweep_of(case, options) if kind == "sweep" else tune_of(case, options[:2], ["peak"], int(options[2]))
    return Study(definition).run(Cores(2))


def wait_for(rows: Path, before: dict[str, bytes], process: subprocess.Popen[bytes]) -> None:
    """Until a new part is there, so that each round gets on; killed at once now and then all the same."""
    end = time.monotonic() + 60
    while len(list(rows.glob("part-*.parquet"))) <= len(before) and process.poll() is None and time.monotonic() < end:
        time.sleep(0.02)


def test_ctrl_c_ends_a_study_cleanly(tmp_path: Path) -> None:
    longer = [part for setting in ("task.trials=1000", *FROZEN) for part in ("--set", setting)]
    command = ["sweep", "he2017", *COMMANDS["sweep"], "--out", "study", "--no-report", *longer]
    process = subprocess.Popen(
        [sys.executable, "-m", "dampen.cli", *command], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    wait_for(tmp_path / "study" / "rows", {}, process)  # type: ignore[arg-type]
    process.send_signal(signal.SIGINT)
    _, stderr = process.communicate(timeout=60)
    assert process.returncode == 3, stderr
    assert "`dampen resume study` goes on" in stderr
    assert "Traceback" not in stderr
    there = open_study(tmp_path / "study")
    assert 0 < there.done < there.members
    assert resume(tmp_path / "study").complete


@pytest.fixture
def cluster() -> Iterator[Any]:
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, host="127.0.0.1", dashboard_address=None, silence_logs=50
    ) as made:
        yield made


def test_a_cluster_by_address_gives_the_same_table_though_a_worker_is_killed(cluster: Any, tmp_path: Path) -> None:
    case = scenario("task.trials=1000", *FROZEN)
    vary = {"controller.alpha_4": "0.1:10:log:10", "plant.tip_mass": "0.08:0.12:10"}
    local = sweep(case, vary, engine=2)
    killed: list[int] = []

    def kill_one(done: int, total: int, failed: int) -> None:
        if not killed and done >= 10:
            worker = next(iter(cluster.workers.values()))
            killed.append(worker.process.process.pid)
            os.kill(killed[0], signal.SIGKILL)

    remote = sweep(case, vary, folder=tmp_path / "study", engine=cluster.scheduler_address, progress=kill_one)
    assert killed
    pandas.testing.assert_frame_equal(remote.table, local.table, check_exact=True)
    pandas.testing.assert_frame_equal(open_study(tmp_path / "study").table, local.table, check_exact=True)


def test_a_scheduler_that_is_not_there_is_one_clear_line(short: dampen.Scenario) -> None:
    with pytest.raises(dampen.ArgumentError, match="Argument `engine` must be the address of a running scheduler"):
        sweep(short, {"controller.alpha_4": "1:2:2"}, engine="nonsense://127.0.0.1:1")


MASS = ("--uncertain", "plant.tip_mass=+-30%")
SEARCH = ("--search", "controller.alpha_4=1:2")
LINES = {
    ("sweep", "he2017"): "Option `--vary` must be given at least once.",
    ("sweep", "he2018", "--vary", "controller.alpha_4=1:2:3"): "Scenario `he2018` is neither a shipped scenario nor a file",
    ("sweep", "he2017", "--vary", "controller.alpha_44=1:2:3"): "Argument `controller.alpha_44` is not known; did you mean",
    ("tune", "he2017", *SEARCH, "--objective", "peek"): "Argument `objective` must be a figure of merit, but is 'peek'; did you",
    ("tune", "he2017", "--search", "controller.alpha_4=0:2:log"): "Option `--search controller.alpha_4` must have LOW > 0",
    ("tune", "he2017", *SEARCH, "--budget", "0"): "Argument `budget` must be a whole number >= 1, but is 0.",
    ("robust", "he2017", *MASS, "--samples", "0"): "Argument `samples` must be a whole number >= 1, but is 0.",
    ("robust", "he2017", *MASS, "--sampler", "halton"): 'Argument `sampler` must be "sobol" or "latin", but is',
    ("robust", "he2017", *MASS, *MASS): "Option `--uncertain plant.tip_mass` must be given once, but is given 2 times.",
    ("resume", "nowhere"): "Study folder `nowhere` is not a study: study.toml and scenario.toml cannot be read: No such file",
    ("plot", "nowhere"): "Study folder `nowhere` is not a study",
}


@pytest.mark.parametrize("arguments", list(LINES), ids=" ".join)
def test_bad_input_on_the_command_line_is_one_line_and_status_2(arguments: tuple[str, ...], tmp_path: Path) -> None:
    done = dampen_command(*arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert len(done.stderr.strip().splitlines()) == 1, done.stderr
    assert done.stderr.startswith(LINES[arguments])
    assert list(tmp_path.iterdir()) == [], "nothing was written"


def test_two_processes_do_not_run_one_study(short: dampen.Scenario, tmp_path: Path) -> None:
    study = new_study(sweep_of(short, ["controller.alpha_4=1:2:4"]), tmp_path / "a")
    held: list[str] = []

    def meanwhile(done: int, total: int, failed: int) -> None:
        if not held:
            other = dampen_command("resume", "a", "--no-report", cwd=tmp_path)
            held.append(other.stderr)
            assert other.returncode == 2

    study.run(Here(), meanwhile)
    assert held == ["Study folder `a` is being run by another process.\n"]
    assert study.complete


def test_lists_can_be_varied_and_are_kept_as_they_are_written(tmp_path: Path) -> None:
    case = scenario(*SHORT, "controller.barrier=none")
    study = sweep(case, {"task.constraint.tip_w": [[-0.1, 0.2], [-0.2, 0.2], 0.3]}, folder=tmp_path / "a", engine=Here())
    assert list(study.table["task.constraint.tip_w"]) == ["[-0.1, 0.2]", "[-0.2, 0.2]", 0.3]
    assert list(open_study(tmp_path / "a").table["task.constraint.tip_w"]) == ["[-0.1, 0.2]", "[-0.2, 0.2]", "0.3"]
    assert study.table["margin"].is_monotonic_increasing


def test_whole_numbers_are_each_as_likely_and_stay_within_their_range(short: dampen.Scenario) -> None:
    axis = read_axis("uncertain", "task.trials=1:3", short)
    taken = axis.at(np.linspace(0, 1, 300, endpoint=False))
    assert list(np.unique(taken, return_counts=True)[1]) == [100, 100, 100]
    found = tune(short, {"task.trials": "1.5:3.5"}, "effort", budget=8, population=8, engine=Here()).table
    assert set(found["task.trials"]) <= {2, 3}
    with pytest.raises(dampen.ArgumentError, match="must have a range with a whole number in it"):
        read_axis("search", "numerics.modes=10.2:10.4", short)


def test_a_scenario_s_own_modules_are_found_again(tmp_path: Path) -> None:
    (tmp_path / "own_module_of_a_study.py").write_text(POISON)
    text = "based_on = 'he2017'\nname = 'own'\n[controller]\nkind = 'own_module_of_a_study:Poison'\ndamping = { tip_w = 5.0 }\n"
    (tmp_path / "mine.toml").write_text(text)
    case = dampen.read_scenario(tmp_path / "mine.toml", SHORT)
    study = sweep(case, {"controller.damping.tip_w": [2.0, 3.0]}, folder=tmp_path / "study", engine=1)
    assert "refused" not in set(study.table["status"])
    assert open_study(tmp_path / "study").definition.home == tmp_path.resolve()


BAD_CALLS: dict[str, Any] = {
    "must have a range as text, or a list of values": lambda s: sweep(s, {"controller.alpha_4": 1.0}),
    "`samples` must be a whole number >= 1, but is 10.5": lambda s: robust(s, {"plant.tip_mass": "+-30%"}, samples=10.5),
    "`seed` must be a whole number >= 0, but is -1": lambda s: robust(s, {"plant.tip_mass": "+-30%"}, seed=-1),
    "`budget` must be a whole number >= 1, but is 5.5": lambda s: tune(s, GAINS, budget=5.5),
    "`engine` must be a whole number >= 1, or an Engine, or text, or None, but is 0": lambda s: sweep(
        s, {"controller.alpha_4": [1.0, 2.0]}, engine=0
    ),
    "`scenario` must be a Scenario": lambda s: sweep("he2017", {"controller.alpha_4": [1.0, 2.0]}),
}


@pytest.mark.parametrize("says", list(BAD_CALLS))
def test_a_wrong_argument_in_python_is_one_clear_line(says: str, short: dampen.Scenario) -> None:
    with pytest.raises(dampen.ArgumentError) as error:
        BAD_CALLS[says](short)
    assert len(error.value.lines) == 1
    assert says in error.value.lines[0]


def test_numpy_arrays_are_values_too(short: dampen.Scenario) -> None:
    assert sweep_of(short, ["controller.alpha_4=1.0,2.0"]).axes[0].values == (1.0, 2.0)
    study = sweep(short, {"controller.alpha_4": np.linspace(1.0, 2.0, 2)}, engine=Here())
    assert list(study.table["controller.alpha_4"]) == [1.0, 2.0]
    with pytest.raises(dampen.ArgumentError, match="`objective` must be a figure of merit, but is 'foo'"):
        best_scenario(study, "foo")


def test_a_study_that_could_not_begin_leaves_nothing_behind(tmp_path: Path) -> None:
    arguments = ("sweep", "he2017", "--vary", "controller.alpha_4=1:2:2", "--out", "a", "--scheduler", "tcp://127.0.0.1:1")
    done = dampen_command(*arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert len(done.stderr.strip().splitlines()) == 1
    assert list(tmp_path.iterdir()) == []
