"""Figures, captions and page: what they show of tracking, constraints, samples, and of plants of the user's own."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from html import unescape
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex

import dampen
from dampen.analysis.energy import energy_account
from dampen.analysis.metrics import error_rms, first_beyond, fraction_of_limit
from dampen.analysis.sampling_cost import Cost
from dampen.cli import main
from dampen.plants.base import Damping, Field
from dampen.report.facts import cost_row, facts, status_sentence
from dampen.report.figures import VIEWS, file_names
from dampen.report.limits import limits_of
from dampen.report.plan import MOST, default_plan
from dampen.report.style import CONSTRAINT, MINUS, REFERENCE, TIMES
from dampen.report.views.samples import liveliest
from dampen.report.write import write_report
from dampen.simulation.stores import FileStore
from dampen.studies.experiment import continuous_twin
from tests.conftest import scenario

COARSE = ("numerics.modes=16", "numerics.step=2e-3", "disturbance.frozen_at=0", "task.trials=4")
RAISE = dampen.MinimumJerk(target=0.1, duration=1.0, begin=0.2)
FUNNEL = dampen.Decay(start=0.2, final=0.02)


@dataclass(frozen=True)
class Mass(dampen.Plant):
    """A mass on a spring, known by one number."""

    @property
    def ports(self) -> tuple[dampen.Port, ...]:
        return (dampen.Port("the $hand/left_$", "", 1.0),)

    def modes(self, count: int, grid: int | None = None) -> dampen.Modes:
        return dampen.Modes(omega=np.array([9.0]), b=np.array([[1.0]]), decay=np.array([0.1]), ports=self.ports)


@dataclass(frozen=True)
class Named(Mass):
    """A mass with a field that is called as told."""

    name: str = "deflection $x_1"

    @property
    def fields(self) -> tuple[tuple[str, str], ...]:
        return ((self.name, "m"),)

    def modes(self, count: int, grid: int | None = None) -> dampen.Modes:
        shape = Field(self.name, "m", lambda x: x[:, None], lambda x: np.ones(len(x)))
        return replace(super().modes(count), fields=(shape,))


def coarse(*more: str, **task: object) -> dampen.Scenario:
    """A small version of the paper's scenario, without its claims, with another task."""
    small = scenario(*COARSE, *more)
    return replace(small, claims=None, task=replace(small.task, **task))  # type: ignore[arg-type]


def tracking(controller: dampen.Controller, **task: object) -> dampen.Scenario:
    """The beam from rest, raised by 0.1 m in every trial."""
    small = scenario(*COARSE)
    given = {"start": "reset", "reference": {"tip_w": RAISE}, "constraint": {}} | task
    return replace(
        small,
        claims=None,
        plant=replace(small.plant, initial=dampen.BeamState()),  # type: ignore[type-var]
        task=replace(small.task, **given),  # type: ignore[arg-type]
        actuators={},
        controller=controller,
    )


def push(t: np.ndarray) -> np.ndarray:
    """A force of the user's own."""
    return np.sin(t)


def mass(plant: dampen.Plant | None = None, **changes: object) -> dampen.Scenario:
    """A plant of the user's own under damping."""
    port = "the $hand/left_$"
    task = dampen.Task(trials=3, trial_duration=1.0, constraint={port: (-0.5, 1.0)}, reference={port: dampen.Sinusoid(0.1, 1.0)})
    given: dict[str, object] = {
        "plant": plant or Mass(),
        "controller": dampen.PTypeILC(learning={port: 0.5}, damping={port: 1.0}),
        "disturbance": dampen.FunctionDisturbance(highest_frequency=1.0, force={port: push}),
        "task": task,
        "numerics": dampen.Numerics(modes=1, step=5e-3),
        "actuators": {port: (dampen.Backlash(),)},
        "output": dampen.Output(points=3, every=10),
    }
    return dampen.Scenario(**(given | changes))  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def tracked() -> tuple[dampen.Result, dampen.Result]:
    """Norm-optimal learning along a reference, and the same without control."""
    case = tracking(dampen.NormOptimalILC(damping={"tip_w": 1.0, "tip_phi": 1.0}))
    return dampen.simulate(case), dampen.simulate(case.uncontrolled())


@pytest.fixture(scope="module")
def both() -> tuple[dampen.Result, dampen.Result]:
    """The paper's law through samples, and continuous."""
    case = coarse("numerics.mode=sampled", "sampling.period=0.004", "sampling.delay=0.002", "sampling.noise={tip_w=1e-4}")
    return dampen.simulate(case), dampen.simulate(case.continuous())


def text_of(page: Path) -> str:
    """A page without its tags."""
    return re.sub(r"\s+", " ", unescape(re.sub(r"<(style|pre).*?</\1>|<[^>]+>", " ", page.read_text("utf-8"), flags=re.DOTALL)))


def lines_of(figure: object, colour: str) -> list[object]:
    """The curves of a figure's first panel with a colour."""
    return [line for line in figure.axes[0].get_lines() if to_hex(line.get_color()) == colour.lower()]  # type: ignore[attr-defined]


def test_the_port_view_draws_the_reference_and_tells_the_largest_error(tracked: tuple[dampen.Result, dampen.Result]) -> None:
    figure, sentence = VIEWS["port"]("tip_w", *tracked)
    (line,) = lines_of(figure, REFERENCE)
    assert line.get_label() == "reference"  # type: ignore[attr-defined]
    assert np.nanmax(line.get_ydata()) == pytest.approx(0.1)  # type: ignore[attr-defined]
    worst = np.abs(np.asarray(tracked[0]["y"]) - tracked[0]["reference"]).max(axis=1)[:, 0]
    assert f"falls from {worst[0]:#.3g} m in trial 0 to {worst[-1]:#.3g} m in trial 3" in sentence
    assert not lines_of(VIEWS["port"]("tip_phi", *tracked)[0], REFERENCE)


def test_an_uneven_constraint_is_drawn_where_it_is() -> None:
    run = dampen.simulate(coarse(constraint={"tip_w": (-0.15, 0.2), "tip_phi": 0.2}))
    figure, sentence = VIEWS["port"]("tip_w", run, None)
    heights = {float(y) for line in lines_of(figure, CONSTRAINT) for y in line.get_ydata()}  # type: ignore[attr-defined]
    assert heights == {-0.15, 0.2}
    assert [c.get_hatch() for c in figure.axes[0].collections] == ["//////"] * 2
    y = np.asarray(run["y"])[:, :, 0]
    margin = 1 - max(y.max() / 0.2, -y.min() / 0.15)
    assert f"the constraint of {MINUS}0.15 m to 0.2 m is never reached, the margin is {100 * margin:.0f} %" in sentence
    assert ("Constraint", f"{MINUS}0.15 m < tip_w < 0.2 m; |tip_phi| < 0.2 rad") in facts(run)


def test_a_moving_constraint_is_drawn_as_a_curve_that_starts_again_in_every_trial() -> None:
    case = coarse(start="reset", constraint={"tip_w": dampen.Constraint(high=FUNNEL), "tip_phi": 0.2})
    run = dampen.simulate(case)
    figure, sentence = VIEWS["port"]("tip_w", run, None)
    high = lines_of(figure, CONSTRAINT)[0]
    t, edge = high.get_xdata(), high.get_ydata()  # type: ignore[attr-defined]
    assert np.isnan(edge).sum() == run.trials - 1
    there = np.isfinite(edge) & (t % 2.0 > 1e-6)
    np.testing.assert_allclose(edge[there], FUNNEL.sample(t[there] % 2.0, 0), rtol=1e-9)
    assert "which moves from 0.2 m at the start of a trial to 0.0233 m at its end, is never reached" in sentence
    share = max(fraction_of_limit(run, "tip_w"))
    assert f"the margin is {100 * (1 - share):.{0 if 1 - share > 0.0995 else 1}f} %" in sentence


def test_a_constraint_on_the_error_is_told_as_such() -> None:
    constraint = {"tip_w": dampen.Constraint(high=0.05, on="error")}
    case = tracking(dampen.NoControl(), constraint=constraint)
    limits = limits_of(case, "tip_w")
    assert limits is not None
    assert (limits.on_error, limits.moving, limits.label) == (True, False, "constraint ±0.05 m about reference")
    run = dampen.simulate(case)
    assert run.status == "constraint_lost"
    beyond = first_beyond(run, "tip_w")
    assert beyond is not None
    assert (
        f"the constraint on the error of 0.05 m is broken in 4 of 4 trials, first at t = {beyond[1]:.4g} s"
        in (VIEWS["port"]("tip_w", run, None)[1])
    )
    low, _ = case.limits(0)
    drawn = lines_of(VIEWS["tracking"]("tip_w", run, None)[0], CONSTRAINT)[-1]
    np.testing.assert_array_equal(drawn.get_ydata(), low[:, 0])  # type: ignore[attr-defined]


def test_a_lost_constraint_is_no_broken_run() -> None:
    run = dampen.simulate(tracking(dampen.NoControl(), constraint={"tip_w": dampen.Constraint(high=0.05, on="error")}))
    told = status_sentence(run, None)
    assert told == next(line for line in run.warnings if "was lost" in line)
    assert "broke off" not in told
    assert status_sentence(replace(run, status="diverged"), None).startswith("The run broke off (diverged) after 4 of 4 trials.")
    good = dampen.simulate(coarse())
    assert status_sentence(good, run) == ""
    assert status_sentence(good, replace(run, status="interrupted")).startswith("The run without control broke off (interrupted)")


def test_the_learning_curve_is_the_rms_and_the_peak_of_the_error(tracked: tuple[dampen.Result, dampen.Result]) -> None:
    figure, sentence = VIEWS["error"]("tip_w", *tracked)
    errors = [(np.asarray(run["y"]) - run["reference"])[:, :, 0] for run in tracked]
    wanted = [f(e) for e in errors for f in (lambda e: np.sqrt((e**2).mean(axis=1)), lambda e: np.abs(e).max(axis=1))]
    for line, values in zip(figure.axes[0].get_lines(), wanted, strict=True):
        np.testing.assert_allclose(line.get_ydata(), values, rtol=1e-12)
    assert figure.axes[0].get_yscale() == "log"
    assert f"to {wanted[0][-1]:#.3g} m in trial 3" in sentence
    assert f"Without control the RMS is {wanted[2][-1]:#.3g} m" in sentence
    assert "the RMS rises in no trial" in sentence


def test_the_tracking_view_overlays_first_middle_and_last_trial_on_the_trial_s_clock(
    tracked: tuple[dampen.Result, dampen.Result],
) -> None:
    figure, sentence = VIEWS["tracking"]("tip_w", *tracked)
    upper, lower = figure.axes
    assert [line.get_label() for line in upper.get_lines()] == ["trial 0", "trial 1", "trial 3", "reference"]
    assert upper.get_xlim() == lower.get_xlim() == (0, 2)
    assert lower.get_yscale() == "log"
    final = upper.get_lines()[2].get_ydata()
    assert np.max(final) == pytest.approx(np.max(tracked[0]["y"][3][:, 0]))
    end = abs(tracked[0]["y"][3][-1, 0] - 0.1)
    assert f"at the end of that trial it is {end:#.3g} m" in sentence


def test_the_loop_tells_how_far_the_actuator_is_from_ideal() -> None:
    run = dampen.simulate(coarse("controller.compensate=false"))
    figure, sentence = VIEWS["loop"]("tip_phi", run, None)
    off = np.abs(np.asarray(run["delivered"]) - 0.3 * np.asarray(run["command"]))[:, :, 1]
    assert f"by {off.max():#.3g} N m at most; in trial 3 by {off[3].max():#.3g} N m" in sentence
    ideal = figure.axes[0].get_lines()[0]
    assert ideal.get_label() == "no play, slope 0.3"
    np.testing.assert_allclose(ideal.get_ydata(), 0.3 * np.asarray(ideal.get_xdata()))


def test_samples_are_shown_where_the_command_varies_most(both: tuple[dampen.Result, dampen.Result]) -> None:
    values = np.zeros(50)
    values[20:24] = 1, -1, 1, -1
    assert liveliest(values, 6) == (19, 25)
    assert liveliest(values, 99) == (0, 50)
    figure, sentence = VIEWS["samples"]("tip_w", both[0], None)
    command, delivered = figure.axes[0].get_lines()
    assert (command.get_drawstyle(), len(command.get_xdata())) == ("steps-post", 30 * 2 + 1)
    k = round(command.get_xdata()[0] / 2e-3)
    np.testing.assert_array_equal(delivered.get_ydata()[:-1], both[0]["delivered"][3][k : k + 60, 0])
    readings = next(line for line in figure.axes[1].get_lines() if line.get_label() == "reading")
    np.testing.assert_array_equal(readings.get_ydata(), both[0]["reading"][3][k // 2 : k // 2 + 30, 0])
    worst = np.abs(both[0]["reading"][3][:, 0] - both[0]["y"][3][:-1:2, 0]).max()
    assert f"a reading is up to {worst:#.3g} m off" in sentence


def test_what_sampling_costs_is_what_one_computes_by_hand(both: tuple[dampen.Result, dampen.Result]) -> None:
    table = {(cost.metric, cost.of): cost for cost in dampen.sampling_cost(*both)}
    for run, which in zip(both, ("sampled", "continuous"), strict=True):
        data = run.dataset
        for p, port in enumerate(("tip_w", "tip_phi")):
            command = np.concatenate([trial[:, p] for trial in data["command"].values])
            y = data["y"].values[:, :, p]
            wanted = {
                "chatter": np.abs(np.diff(command)).sum(),
                "margin": 1 - np.abs(y).max() / 0.2,
                "residual": np.sqrt(np.mean(y[-1] ** 2)),
                "effort": np.sqrt(np.mean(data["delivered"].values[:, :, p] ** 2)),
            }
            for metric, value in wanted.items():
                assert getattr(table[metric, port], which) == pytest.approx(value, rel=1e-9), (metric, port, which)
        field = np.sqrt(np.mean(data["w"].values[-1].astype(float) ** 2))
        assert getattr(table["residual", "w"], which) == pytest.approx(field, rel=1e-9)
    assert len(table) == 10
    assert table["chatter", "tip_w"].ratio == table["chatter", "tip_w"].sampled / table["chatter", "tip_w"].continuous > 2
    assert Cost("margin", "p", "", -0.1, 0.2).ratio is None
    with pytest.raises(ValueError, match="one plant at one task"):
        dampen.sampling_cost(both[0], dampen.simulate(coarse("task.trials=1")))


def test_a_reset_is_no_chatter() -> None:
    run = dampen.simulate(tracking(dampen.OpenLoop({"tip_w": dampen.Decay(start=1.0, final=0.0)})))
    total = {cost.of: cost.continuous for cost in dampen.sampling_cost(run, run) if cost.metric == "chatter"}
    first = np.asarray(run["command"])[0, :, 0]
    assert total["tip_w"] == pytest.approx(4 * (first[0] - first[-1]))


def test_the_energy_account_closes_over_resets(tracked: tuple[dampen.Result, dampen.Result]) -> None:
    account = energy_account(tracked[0])
    assert account.error < 1e-11
    assert abs(account.resets) > 1e-6


def views_of(run: dampen.Result) -> dict[str, list[str]]:
    plan: dict[str, list[str]] = {}
    for figure in default_plan(run):
        plan.setdefault(figure.view, []).append(figure.of)
    return plan


def test_the_figures_are_chosen_by_the_task(
    tracked: tuple[dampen.Result, dampen.Result], both: tuple[dampen.Result, dampen.Result], paper_runs: tuple[dampen.Result, ...]
) -> None:
    ports, fields = ["tip_w", "tip_phi"], ["w", "phi"]
    suppression = {"field": fields, "port": ports, "peaks": fields, "delivered": ports, "loop": ports}
    assert views_of(paper_runs[0]) == {**suppression, "field": [*fields, *fields]}
    assert views_of(paper_runs[1]) == {"field": fields, "port": ports, "peaks": fields}
    assert views_of(both[0]) == {**suppression, "samples": ports}
    follow = {"tracking": ["tip_w"], "error": ["tip_w"], "port": ["tip_phi"], "delivered": ports, "field": fields}
    assert views_of(tracked[0]) == follow
    assert len(default_plan(both[0])) <= MOST


def test_facts_tell_task_and_sampling() -> None:
    case = tracking(dampen.NoControl(), reset_error={"tip_w": 0.001}, constraint={"tip_w": 0.2, "tip_phi": 0.2})
    sampling = dampen.Sampling(period=0.004, delay=0.002, noise={"tip_w": 1e-4}, switching="implicit")
    case = replace(
        case,
        controller=coarse().controller,
        sampling=sampling,
        numerics=replace(case.numerics, mode="sampled"),
        plant=replace(case.plant, damping=Damping(ratio=0.01)),  # type: ignore[type-var, call-arg]
        compensation={"tip_w": (dampen.Ideal(),)},
    )
    run = replace(dampen.simulate(coarse("task.trials=1")), scenario=case)
    told = dict(facts(run))
    assert told["Damping"] == "ratio 0.01"
    assert told["Compensation"] == "tip_w: ideal"
    assert told["Reference"] == "tip_w: minimum-jerk (target 0.1, duration 1 s, begin 0.2 s)"
    assert told["Trials"] == "4 of 2 s, each reset to the initial state, with a random error (tip_w 0.001 m)"
    wanted = "every 4 ms; delay 2 ms; implicit switching; rate from differences; noise tip_w 0.0001 m"
    assert told["Sampling"] == wanted


class Checked(HTMLParser):
    """Refuses tags that are not closed in order."""

    open: list[str]

    def handle_starttag(self, tag: str, attrs: object) -> None:
        if tag not in ("meta", "img", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def written(folder: Path, case: dampen.Scenario, **more: dampen.Result) -> tuple[dampen.Result, Path]:
    """What `dampen run` does: runs into files, then the page; the result as read back."""
    result = dampen.simulate(case, store=FileStore(folder / "result.nc"))
    baseline = dampen.simulate(case.uncontrolled(), store=FileStore(folder / "uncontrolled.nc"))
    page = write_report(folder, result, baseline, [], None, **more)
    parser = Checked()
    parser.open = []
    parser.feed(page.read_text("utf-8"))
    assert parser.open == []
    return dampen.load(folder / "result.nc"), page


def test_a_plant_without_fields_goes_all_the_way(tmp_path: Path) -> None:
    case = mass()
    loaded, page = written(tmp_path, case)
    made = dampen.simulate(case)
    assert (loaded.status, loaded.trials, loaded.layout.variables.keys()) == (made.status, 3, made.layout.variables.keys())
    for name in made.layout.variables:
        np.testing.assert_array_equal(loaded[name][:], made[name], err_msg=name)
    assert "peak" not in loaded.layout.variables
    assert "field" not in loaded.dataset.dims
    drawn = {path.stem for path in (tmp_path / "figures").iterdir()}
    wanted = {f"{view}_the_hand_left__" for view in ("tracking", "error", "delivered", "loop")} | {"energy"}
    assert drawn == wanted
    text = text_of(page)
    rms = error_rms(made, "the $hand/left_$")
    assert f"{rms[0]:#.3g} m in trial 0" in text
    assert "the $hand/left_$" in text


def test_a_sampled_one_port_plant_tells_what_sampling_costs(tmp_path: Path) -> None:
    numerics, sampling = dampen.Numerics(modes=1, step=5e-3, mode="sampled"), dampen.Sampling(period=0.01)
    case = mass(numerics=numerics, sampling=sampling)
    continuous = dampen.simulate(case.continuous())
    loaded, page = written(tmp_path, case, continuous=continuous)
    text = text_of(page)
    for cost in dampen.sampling_cost(loaded, continuous):
        assert " ".join(cost_row(cost)) in re.sub(r" +", " ", text)
    assert "What sampling costs" in text
    assert (tmp_path / "figures" / "samples_the_hand_left__.svg").exists()


def test_fields_may_have_any_name_that_is_free(tmp_path: Path) -> None:
    _, page = written(tmp_path, mass(Named()))
    assert "deflection $x_1" in page.read_text("utf-8")
    assert (tmp_path / "figures" / "field_deflection_x_1.png").exists()
    for name, words in {"v": "use themselves", "time": "use themselves", "a/b": "cannot stand in a file"}.items():
        with pytest.raises(dampen.ArgumentError, match=words):
            dampen.simulate(mass(Named(name=name)))


def test_figures_never_share_a_file() -> None:
    assert file_names(["port_a b", "port_a/b", "port_a_b"]) == ["port_a_b", "port_a_b-2", "port_a_b-3"]


@pytest.mark.parametrize("make", [lambda: coarse("task.trials=1"), lambda: tracking(dampen.NoControl(), trials=1)])
def test_a_single_trial_has_all_its_figures(tmp_path: Path, make: Callable[[], dampen.Scenario]) -> None:
    case = make()
    _, page = written(tmp_path, case)
    assert "in the only trial" in text_of(page)


def test_run_puts_the_continuous_run_beside_a_sampled_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    settings = (part for value in (*COARSE, "numerics.mode=sampled", "sampling.period=0.002") for part in ("--set", value))
    monkeypatch.setattr(sys, "argv", ["dampen", "run", "he2017", *settings, "--out", str(tmp_path)])
    with pytest.raises(SystemExit, match=r"^0$"):
        main()
    assert {"result.nc", "uncontrolled.nc", "continuous.nc", "report.html"} <= {p.name for p in tmp_path.iterdir()}
    text = capsys.readouterr().out
    assert "What sampling costs" in text
    row = dampen.sampling_cost(dampen.load(tmp_path / "result.nc"), dampen.load(tmp_path / "continuous.nc"))[0]
    assert re.search(r"\s+".join(map(re.escape, cost_row(row))), text)
    assert (tmp_path / "figures" / "samples_tip_w.png").exists()


def test_there_is_no_continuous_run_of_a_law_that_needs_samples() -> None:
    sampled = coarse("numerics.mode=sampled", "sampling.period=0.002")
    twin = continuous_twin(sampled)
    assert twin is not None
    assert not twin.sampled
    assert continuous_twin(replace(sampled, controller=dampen.LQG())) is None
    assert continuous_twin(twin) is None


def test_a_limit_of_any_size_is_written_as_it_is() -> None:
    task = dampen.Task(trials=1, trial_duration=0.1, constraint={"tip_w": [-3e-14, 2e-14]})
    case = dampen.Scenario(dampen.String(), dampen.NoControl(), dampen.NoDisturbance(), task, numerics=dampen.Numerics(modes=2))
    found = limits_of(case, "tip_w")
    assert found is not None
    np.testing.assert_allclose((found.low[0], found.high[0]), (-3e-14, 2e-14), rtol=1e-14)
    assert found.words == f"the constraint of {MINUS}3.00 {TIMES} 10\u207b\u00b9\u2074 m to 2.00 {TIMES} 10\u207b\u00b9\u2074 m"
