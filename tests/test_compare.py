"""Comparisons: everybody on the same terms, the table as the saved runs have it, nothing claimed that numbers do not carry."""

from __future__ import annotations

import html
import json
import math
import re
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import dampen
from dampen.analysis.merits import merits, rooms
from dampen.analysis.metrics import error_peaks, error_rms, settling_trial
from dampen.analysis.sampling_cost import chatter, effort, margin
from dampen.analysis.tallied import tallied
from dampen.cli import main
from dampen.controllers.scales import scales
from dampen.report.compare.page import write_comparison
from dampen.report.compare.tables import table
from dampen.report.style import DASH
from dampen.scenarios.kinds import KINDS
from dampen.scenarios.read import shipped
from dampen.simulation.batch import alone
from dampen.simulation.bench import Bench
from dampen.simulation.setting import setting_of
from dampen.studies.compare.api import Plan, open_comparison
from dampen.studies.compare.comparison import Comparison, Contender, Refined, Searched, from_plain
from dampen.studies.compare.judge import range_notes
from dampen.studies.compare.ranges import from_controller, from_kind, middle, stretched
from dampen.studies.compare.verdict import front, verdict
from dampen.studies.definition import tune_of
from dampen.studies.engines import Here
from dampen.studies.record import schema
from dampen.studies.study import open_study
from dampen.studies.variation import read_axis
from tests.conftest import scenario

SHORT = ("task.trials=3", "task.trial_duration=0.5", "numerics.modes=12", "numerics.step=0.002", "sampling.period=0.002",
         "output.every=50")  # fmt: skip
ARM = ("task.trials=3", "numerics.modes=6", "numerics.step=0.002", "sampling.period=0.002",
         "output.every=50")  # fmt: skip
SETTINGS = [part for setting in SHORT for part in ("--set", setting)]
BUDGET = 6


@pytest.fixture(scope="module")
def compared(tmp_path_factory: pytest.TempPathFactory) -> tuple[Comparison, Path]:
    """A small comparison in a folder: kinds, another scenario, one through samples, one as given."""
    folder = tmp_path_factory.mktemp("compared") / "out"
    contenders = ["boundary-damping", "lqg", "none", "he2017-tuned-direct"]
    short = scenario(*SHORT)
    other = dampen.read_scenario("he2017-tuned-direct", SHORT)
    found = dampen.compare(
        short, [*contenders[:3], other], budget=BUDGET, searches=2, as_given=["he2017-tuned-direct"], folder=folder, engine=Here()
    )
    return found, folder


def test_the_table_s_numbers_are_those_of_the_saved_runs(compared: tuple[Comparison, Path]) -> None:
    found, folder = compared
    assert [c.label for c in found.contenders] == ["dual-loop-ailc", "boundary-damping", "lqg", "none", "he2017-tuned-direct"]
    for c in found.contenders:
        run = dampen.load(folder / c.label / "result.nc")
        np.testing.assert_equal(c.merits, merits(tallied(run)))
        again = merits(alone(run.scenario, Bench(run.scenario)))
        np.testing.assert_allclose(list(c.merits.values()), list(again.values()), rtol=1e-12, atol=1e-15)
        limits = np.array(list(found.thresholds.values()))
        assert c.settling == settling_trial(np.column_stack([error_peaks(run, p) for p in found.counted]), limits)
        for port in run.scenario.ports:
            assert c.merits[f"residual.{port}"] == pytest.approx(np.sqrt(np.mean(error_rms(run, port) ** 2)))
            assert c.merits[f"chatter.{port}"] == pytest.approx(chatter(run, port))
            assert c.merits[f"effort.{port}"] == pytest.approx(effort(run, port))
            assert c.merits[f"margin.{port}"] == pytest.approx(margin(run, port))
            assert c.peaks[port] == tuple(error_peaks(run, port))
    assert found.thresholds == {p: 0.05 * r for p, r in zip(("tip_w", "tip_phi"), rooms(scenario(*SHORT)), strict=True)}


def test_everybody_gets_the_same_budget_seed_and_objective_or_says_so(compared: tuple[Comparison, Path]) -> None:
    found, folder = compared
    tuned = {c.label: c.tuned for c in found.contenders}
    assert tuned == {"dual-loop-ailc": True, "boundary-damping": True, "lqg": True, "none": False, "he2017-tuned-direct": False}
    for c in found.contenders:
        if c.tuned:
            assert c.candidates == 2 * BUDGET
            least = []
            for seed, name in enumerate(("study", "study-2")):
                study = open_study(folder / c.label / name)
                definition = study.definition
                assert (definition.budget, definition.seed, definition.objectives) == (BUDGET, seed, ("residual",))
                assert study.done == BUDGET
                first = study.table.iloc[0]
                assert c.start == first["residual"]
                for axis in definition.axes:
                    assert first[axis.name] == pytest.approx(dampen.studies.lens.get(definition.scenario, axis.name))
                least.append(study.table["residual"][study.table["status"] == "complete"].min())
                assert c.searches[seed].seed == seed
                assert c.searches[seed].merits["residual"] == least[-1]
            assert c.merits["residual"] == pytest.approx(min(least))
            assert c.over_searches("residual") == (min(least), max(least))
        else:
            assert (c.candidates, c.start, c.searches) == (0, None, ())
    rows = {row[0]: row[1] for row in table(found)[1]}
    assert rows["boundary-damping"] == f"tuned from mid-range gains, 2 x {BUDGET}"
    assert rows["he2017-tuned-direct"] == "as given"
    assert rows["lqg"].startswith(f"tuned from mid-range gains, 2 x {BUDGET}; through samples")
    heads, cells = table(found)
    column = {row[0]: row[heads.index("over searches")] for row in cells}
    assert column["none"] == DASH
    assert re.fullmatch(r"[\d.]+( to [\d.]+)? %", column["boundary-damping"])


def test_a_law_that_needs_samples_has_them_and_everything_else_is_shared(compared: tuple[Comparison, Path]) -> None:
    found, folder = compared
    short = scenario(*SHORT)
    for c in found.contenders:
        run = dampen.load(folder / c.label / "result.nc").scenario
        assert c.sampled == run.sampled == (c.label == "lqg")
        for name in ("plant", "disturbance", "task", "bounds", "actuators", "compensation", "sampling"):
            assert getattr(run, name) == getattr(short, name)
        assert replace(run.numerics, mode="continuous") == short.numerics


def test_finer_numerics_are_a_fresh_run_of_the_same_gains(compared: tuple[Comparison, Path]) -> None:
    found, folder = compared
    c = found["boundary-damping"]
    case = dampen.load(folder / c.label / "result.nc").scenario
    fine = replace(case, numerics=replace(case.numerics, modes=24, step=0.001), output=replace(case.output, every=100))
    assert c.refined is not None
    assert (c.refined.modes, c.refined.step) == (24, 0.001)
    assert c.refined.merits == merits(alone(fine, Bench(fine)))


def test_what_is_written_is_read_back(compared: tuple[Comparison, Path]) -> None:
    found, folder = compared
    text = (folder / "audit.json").read_text()
    assert "NaN" not in text
    jsonschema.Draft202012Validator(schema()).validate(json.loads(text))
    np.testing.assert_equal(from_plain(json.loads(text)["comparison"]), replace(found, results={}))
    assert json.loads(text)["comparison"]["contenders"][0]["label"] == "dual-loop-ailc"
    assert list(found.table.index) == [c.label for c in found.contenders]


def test_the_page_stands_alone_and_says_the_verdict(compared: tuple[Comparison, Path], tmp_path: Path) -> None:
    found, folder = compared
    np.testing.assert_equal(replace(open_comparison(folder), results={}), replace(found, results={}))
    page = write_comparison(tmp_path, open_comparison(folder)).read_text()
    assert "http://" not in page.replace("http://www.w3.org", "")
    assert found.verdict[0].split(":")[0] in page
    printed = html.unescape(re.search(r"<pre>(.*?)</pre>", page, re.S)[1])  # type: ignore[index]
    assert printed == (folder / "scenario.toml").read_text()
    assert {p.name for p in (tmp_path / "figures").iterdir()} == {
        f"{name}.{kind}" for name in ("learning", "last-trial", "pareto") for kind in ("png", "svg")
    }


def test_the_same_command_goes_on_where_it_was_interrupted(tmp_path: Path) -> None:
    short, folder = scenario(*SHORT), tmp_path / "out"

    def compare(progress: object = None) -> Comparison:
        return dampen.compare(short, ["boundary-damping"], budget=5, searches=2, folder=folder, engine=Here(), progress=progress)  # type: ignore[arg-type]

    def stop(label: str, done: int, runs: int) -> None:
        if label == "boundary-damping" and done == 20:  # in its second search
            raise KeyboardInterrupt

    part = compare(stop)
    assert not part.complete
    assert [c.label for c in part.contenders] == ["dual-loop-ailc"]
    there = from_plain(json.loads((folder / "audit.json").read_text())["comparison"])
    assert not there.complete
    assert dampen.load(folder / "dual-loop-ailc" / "result.nc").status == "complete"
    assert open_study(folder / "boundary-damping" / "study").complete
    whole = compare()
    assert whole.complete
    fresh = dampen.compare(short, ["boundary-damping"], budget=5, searches=2, engine=Here())
    for one, other in zip(whole.contenders, fresh.contenders, strict=True):
        np.testing.assert_equal(replace(one, seconds=0.0), replace(other, seconds=0.0))
    with pytest.raises(dampen.ArgumentError, match="holds a comparison of something else"):
        dampen.compare(short, ["boundary-damping"], budget=5, searches=1, folder=folder, engine=Here())
    with pytest.raises(dampen.ArgumentError, match="holds a comparison of something else"):
        dampen.compare(short, ["none"], budget=5, folder=folder, engine=Here())


def test_ctrl_c_leaves_what_is_finished(tmp_path: Path) -> None:
    out = tmp_path / "out"
    command = [sys.executable, "-m", "dampen.cli", "compare", "he2017", "none", "--budget", "100000", "--as-given", "he2017"]
    command += ["boundary-damping", *SETTINGS, "--out", str(out), "--workers", "1", "--no-report"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        end = time.monotonic() + 50
        while time.monotonic() < end and not list(out.glob("boundary-damping/study/rows/part-*.parquet")):
            time.sleep(0.1)
        process.send_signal(signal.SIGINT)
        stdout, stderr = process.communicate(timeout=30)
    assert process.returncode == 3, stderr
    assert "2 of 3 contenders are done" in stderr
    assert "Traceback" not in stderr
    assert "dual-loop-ailc" in stdout
    found = from_plain(json.loads((out / "audit.json").read_text())["comparison"])
    assert [c.label for c in found.contenders] == ["dual-loop-ailc", "none"]
    assert open_study(out / "boundary-damping" / "study").done > 0


REFUSED = {
    ("string-tip-mass",): "Contender `string-tip-mass` must be the same experiment as `he2017` under another controller, but "
    "differs in plant, disturbance, task, bounds, actuator.",
    ("he2017-hysteresis",): "Contender `he2017-hysteresis` must be the same experiment as `he2017` under another controller, but "
    "differs in actuator, compensation.",
    ("open-loop",): "Contender `open-loop` cannot be run here: it has no commands: name a scenario that has.",
    ("boundary-dampin",): "Contender `boundary-dampin` is no kind of controller, no scenario and no file; did you mean",
    ("nowhere.toml",): "Scenario file `nowhere.toml` cannot be read",
    ("none", "--as-given", "nobody"): "Option `--as-given` must name a contender, but names 'nobody'; known here",
    ("none", "--objective", "peek"): "Argument `objective` must be a figure of merit, but is 'peek'; did you mean `peak`?",
    ("none", "--set", "numerics.step=0.3"): "Argument `numerics.step` must",
}  # fmt: skip


@pytest.mark.parametrize("arguments", list(REFUSED))
def test_bad_input_is_one_line_and_leaves_nothing(
    arguments: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    settings = SETTINGS if len(arguments) > 1 else []
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", ["dampen", "compare", "he2017", *settings, *arguments])
    with pytest.raises(SystemExit) as left:
        main()
    told = capsys.readouterr().err
    assert left.value.code == 2
    assert told.startswith(REFUSED[arguments])
    assert len(told.splitlines()) == 1
    assert not list(tmp_path.iterdir())


def test_as_given_means_the_contender_so_labelled() -> None:
    short = scenario(*SHORT)
    plan = Plan(short, [short, "none"], 5, "residual", 0, ("he2017",))
    assert [e.label for e in plan.entries] == ["dual-loop-ailc", "he2017", "none"]
    assert {label: bool(found) for label, found in plan.definitions.items()} == {"dual-loop-ailc": True, "none": False}
    assert set(Plan(short, ["none"], 5, "residual", 0, ("he2017",)).definitions) == {"none"}


def test_without_a_budget_everybody_is_as_given_and_the_table_says_so(tmp_path: Path) -> None:
    found = dampen.compare(
        scenario(*SHORT), ["boundary-damping", dampen.PTypeILC(damping={"tip_w": 1.0, "tip_phi": 1.0})], budget=0, engine=Here()
    )
    assert [row[1].partition(";")[0] for row in table(found)[1]] == ["as given", "middle of its ranges", "as given"]
    assert not any(c.tuned for c in found.contenders)


def test_settings_change_the_experiment_of_contenders_named_by_scenario_too_but_not_their_law(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = ["numerics.modes=8", "task.trials=2", "controller.alpha_4=3", "numerics.step=0.01"]
    command = ["compare", "he2017", "he2017-tuned", "--budget", "0", "--no-report", "--out", str(tmp_path / "c")]
    monkeypatch.setattr(sys, "argv", ["dampen", *command, *(word for one in settings for word in ("--set", one))])
    with pytest.raises(SystemExit) as left:
        main()
    assert left.value.code == 0
    own, other = (result.scenario for result in open_comparison(tmp_path / "c").results.values())
    tuned = dampen.read_scenario("he2017-tuned").controller
    assert (own.controller, other.controller) == (replace(dampen.read_scenario("he2017").controller, alpha_4=3.0), tuned)
    assert (other.task, other.numerics) == (own.task, own.numerics)
    assert (other.task.trials, other.numerics.modes) == (2, 8)


def test_contenders_that_cannot_be_run_are_left_out_with_the_reason() -> None:
    plan = Plan(dampen.read_scenario("string-tip-mass", SHORT), None, 0, "residual", 0, ())
    assert {e.label for e in plan.entries} == {
        "boundary-damping", "none", "p-type-ilc", "pd-type-ilc", "norm-optimal-ilc", "lqg",
    }  # fmt: skip
    assert set(plan.left_out) == {"open-loop", "adaptive-boundary", "dual-loop-ailc"}
    assert plan.left_out["dual-loop-ailc"].startswith("Argument `bounds` must be given, f in N/m")


CASES = {name: ARM if name.startswith("flexible") else (*SHORT[0:1], "numerics.modes=12") for name in shipped()}


@pytest.mark.parametrize("name", list(CASES))
def test_every_controller_s_ranges_fit_every_plant(name: str) -> None:
    case = dampen.read_scenario(name, CASES[name])
    bench = Bench(case)
    tried = 0
    for kind in KINDS["controller"]:
        try:
            start = from_kind(case, kind, bench)  # type: ignore[arg-type]
        except dampen.ArgumentError as error:
            assert "bounds" in error.lines[0]
            continue
        for text in start.search:
            axis = read_axis("search", text, start.scenario)  # both ends are tried on the scenario
            own = dampen.studies.lens.get(start.scenario, axis.paths[0])
            assert axis.low <= own <= axis.high
        assert bool(start.search) == (kind.kind not in ("none", "open-loop"))
        absent = [p for p in case.ports if any(isinstance(s, dampen.Absent) for s in case.actuators.get(p, ()))]
        assert not [
            t for t in start.search for p in absent if t.startswith((f"controller.damping.{p}", f"controller.learning.{p}"))
        ]
        tried += 1
    assert tried >= 6
    assert from_controller(case, bench).scenario == case


def test_the_impedance_of_a_string_is_that_of_an_endless_one() -> None:
    string = dampen.String(length=3.0, mass_per_length=0.7, tension=50.0, tip_mass=0.0)
    case = dampen.read_scenario("string-tip-mass", SHORT)
    case = replace(case, plant=string, disturbance=dampen.NoDisturbance())
    (found,) = scales(setting_of(case))
    assert found.impedance == pytest.approx(np.sqrt(50.0 * 0.7), rel=1e-3)
    assert found.stiffness == pytest.approx(50.0 / 3.0, rel=0.05)
    assert found.room == pytest.approx(0.15)


def test_ranges_have_middles_and_are_stretched_to_what_a_scenario_has() -> None:
    assert middle("0.01:100:log") == 1.0
    assert middle("0:0.5") == 0.25
    assert stretched("0.01:100:log", 1000.0) == "0.01:1000.0:log"
    assert stretched("0.01:100:log", 0.0) == "0.01:100:log"
    assert stretched("0:0.5", 0.7) == "0:0.7"


def test_a_range_that_was_stretched_and_a_best_value_at_its_end_are_noted() -> None:
    law = ("controller.kind=boundary-damping", "controller.damping={tip_w=1e6,tip_phi=1.0}")
    case = dampen.read_scenario("he2017", (*SHORT, *law))
    start = from_controller(case, Bench(case))
    note = start.notes[0]
    assert note.startswith("the range of damping.tip_w, ")
    assert note.endswith(" is stretched to its own value, 1e+06")
    definition = tune_of(case, start.search, ["residual"], 4)
    middles = {axis.name: math.sqrt(axis.low * axis.high) for axis in definition.axes}
    assert range_notes(definition, middles) == ()
    (told,) = range_notes(definition, {**middles, "controller.damping.tip_w": 1e6})
    assert told.startswith("damping.tip_w is at the upper end of its range, ")
    assert told.endswith(" to 1e+06: a wider one may give more")


def contender(
    label: str, residual: float, fine: float, effort: float, status: str = "complete", others: Sequence[float] | None = None
) -> Contender:
    """One that was searched for twice to the same end, or once and then to the `others`."""
    figures = {"residual": residual, "effort": effort, "unsettled": 0.0}
    refined = Refined(24, 1e-3, status, {**figures, "residual": fine})
    first = Searched(0, 5, {}, status, figures, refined)
    further = [
        replace(first, merits={**figures, "residual": v}, refined=None) for v in (others if others is not None else [residual])
    ]
    searches = (first, *further)
    return Contender(label, label, "kind", True, 5, 5, None, {}, False, status, 3, figures, None, {}, refined, (), 0.0, searches)


def test_the_verdict_is_what_both_numerics_carry() -> None:
    short = scenario(*SHORT)
    own, better, near = (
        contender("own", 2e-2, 3e-2, 1.0),
        contender("better", 1e-2, 0.9e-2, 2.0),
        contender("near", 1.5e-2, 2.5e-2, 3.0),
    )
    lost = contender("lost", 1e-3, 1e-3, 0.1, "constraint_lost")
    sentences = verdict(short, [own, better, near, lost], "residual")
    assert (
        sentences[0]
        == "Best in residual as a share of the constraint: better, 1 % (0.9 % at 24 modes and 1 ms; 1 % over 2 searches)."
    )
    assert sentences[1] == "own loses in residual (2 %) to better (1 %, by a factor of at least 2)."
    assert sentences[2] == "own is not told apart from near: searches and numerics do not carry the difference."
    assert not any(sentence.startswith("near") for sentence in sentences)
    paper = replace(near, paper="Somebody 2000")
    assert "near loses in residual (1.5 %) to better (1 %, by a factor of at least 1.5)." in verdict(
        short, [own, better, paper], "residual"
    )
    assert "lost does not hold the constraint, and is not ranked." in sentences
    assert [c.label for c in front([own, better, near], "residual")] == ["own", "better"]
    fragile_here = replace(lost, status="complete", merits={**lost.merits})
    assert verdict(short, [own, fragile_here], "residual", 7, 2)[0].startswith(
        "With 7 candidates in each of 2 searches for each that is tuned: best in"
    )
    assert verdict(short, [own, fragile_here], "residual")[-1] == (
        "lost holds the constraint here, but not at 24 modes and 1 ms, and is not ranked."
    )
    fragile = verdict(short, [contender("own", 1e-4, 1e-2, 1.0)], "residual")
    assert fragile[-1].startswith("own: its gains are tuned to their numerics, its residual is 0.01 % here, but 1 % at 24 modes")


def test_what_rests_on_one_search_is_not_called_proven() -> None:
    short = scenario(*SHORT)
    own, better, worse = (contender(n, v, v, 1.0, others=()) for n, v in (("own", 2e-2), ("better", 1e-2), ("worse", 3e-2)))
    sentences = verdict(short, [own, better, worse], "residual", 7)
    assert sentences[0].startswith("With 7 candidates in one search for each that is tuned: best in residual")
    assert sentences[1].startswith("This rests on one search for each that is tuned, and proves nothing")
    assert sentences[2] == "own comes out behind in residual (2 %) in this one search: better (1 %, by a factor of 2)."
    assert sentences[3] == "own comes out ahead of worse in residual in this one search."
    assert not any(word in sentence for sentence in sentences for word in ("loses", "beats", "at least"))
    untuned = [replace(one, tuned=False, searches=()) for one in (own, better)]
    assert verdict(short, untuned, "residual")[1] == "own loses in residual (2 %) to better (1 %, by a factor of at least 2)."


def test_nobody_beats_anybody_whom_another_search_turns_round() -> None:
    short = scenario(*SHORT)
    own, lucky = contender("own", 2e-2, 2e-2, 1.0), contender("lucky", 1e-2, 1e-2, 1.0, others=[2.5e-2])
    assert lucky.span("residual") == lucky.over_searches("residual") == (1e-2, 2.5e-2)
    sentences = verdict(short, [own, lucky], "residual", 7, 2)
    assert sentences[0].endswith(
        "lucky, 1 % (1 % at 24 modes and 1 ms; 1 to 2.5 % over 2 searches); not told apart from it by these searches and "
        "numerics: own."
    )
    assert "own is not told apart from lucky: searches and numerics do not carry the difference." in sentences
    broken = replace(lucky, searches=(lucky.searches[0], replace(lucky.searches[1], status="diverged")))
    assert broken.span("residual") == (1e-2, 1e-2)
    told = verdict(short, [own, broken], "residual", 7, 2)
    assert "own is not told apart from lucky: searches and numerics do not carry the difference." in told
    assert "Not every search for lucky came to gains that hold at both numerics." in told


def test_a_factor_of_one_is_called_about_equal() -> None:
    near = [contender(n, v, v, 1.0) for n, v in (("own", 1.02e-2), ("better", 1e-2), ("worse", 1.04e-2))]
    sentences = verdict(scenario(*SHORT), near, "residual", 7, 2)
    assert "own is about equal to better and worse in residual." in sentences
    assert not any("factor" in sentence for sentence in sentences)
    ahead = [contender(n, v, v, 1.0) for n, v in (("own", 1e-2), ("worse", 2e-2), ("worst", 3e-2))]
    sentences = verdict(scenario(*SHORT), ahead, "residual", 7, 2)
    assert "own loses to none of the 2 others that hold the constraint." in sentences
    assert "own beats worse and worst in residual." in sentences
    assert not any("none of" in sentence for sentence in verdict(scenario(*SHORT), ahead[:2], "residual", 7, 2))


def test_without_a_constraint_figures_have_units_and_who_diverges_diverged() -> None:
    free = scenario(*SHORT, 'controller={kind="none"}', "task.constraint={}")
    ports = {"residual.tip_w": 1e-3, "residual.tip_phi": 2e-3}
    own, other = contender("own", 2e-3, 2e-3, 1.0), contender("other", 3e-3, 3e-3, 1.0, "diverged")
    own = replace(own, merits=own.merits | ports, refined=None, searches=())
    sentences = verdict(free, [own, other], "residual")
    assert sentences[0] == "Best in residual: own, 0.001 m at tip_w, 0.002 rad at tip_phi."
    assert "other diverged, and is not ranked." in sentences
    assert not any("constraint" in sentence for sentence in sentences)
    assert verdict(free, [other], "residual") == ("No contender runs to its end.", "other diverged, and is not ranked.")
    string = dampen.read_scenario("string-tip-mass", ('controller={kind="none"}', "task.constraint={}"))
    assert verdict(string, [own], "residual")[0] == "Best in residual: own, 0.002 m."


def test_only_a_paper_s_law_says_so() -> None:
    assert {cls.kind: cls.paper for cls in KINDS["controller"] if cls.paper} == {"dual-loop-ailc": "He et al. 2017"}  # type: ignore[attr-defined]


def test_an_interrupt_before_the_first_run_is_one_line_and_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.chdir(tmp_path)
    for where, told in (("dampen.studies.compare.api.Plan", "Interrupted: nothing is written."),
                        ("dampen.scenarios.read.read_scenario", "Interrupted.")):  # fmt: skip
        monkeypatch.setattr(where, interrupted)
        monkeypatch.setattr(sys, "argv", ["dampen", "compare", "he2017", *SETTINGS])
        with pytest.raises(SystemExit) as left:
            main()
        assert left.value.code == 3
        assert capsys.readouterr().err.splitlines() == [told]
    assert not list(tmp_path.iterdir())


def test_an_interrupt_in_code_that_a_library_makes_of_text_has_the_same_exit_status(tmp_path: Path) -> None:
    code = (
        "import sys, dampen.scenarios.read, dampen.cli\n"
        "dampen.cli.err.print('Begun.')\n"  # loads what printing needs, which is made of text as well
        "def cut(*_): exec('raise KeyboardInterrupt')\n"
        "dampen.scenarios.read.read_scenario = cut\n"
        "sys.argv = ['dampen', 'compare', 'he2017']\n"
        "dampen.cli.main()\n"
    )
    (tmp_path / "cut.py").write_text(code)
    done = subprocess.run([sys.executable, "-m", "cut"], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (3, "Begun.\nInterrupted.\n")


def test_settling_is_from_the_last_time_outside() -> None:
    errors = np.array([[3.0, 0.0], [0.5, 0.0], [2.0, 0.0], [0.5, 9.0], [0.5, 9.0]])
    assert settling_trial(errors, np.array([1.0, np.inf])) == 3
    assert settling_trial(errors, np.array([1.0, 1.0])) is None
    assert settling_trial(errors, np.array([5.0, 10.0])) == 0
