"""The report of a study: every kind has its figures, and what the sentences say are the table's own numbers."""

from __future__ import annotations

import re
from dataclasses import replace
from html import unescape
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from matplotlib.colors import LogNorm

from dampen.report.study.axes import nominal, positions
from dampen.report.study.names import axis_label, axis_names, merit_label, merit_value
from dampen.report.study.page import share_words, summary_rows, verdict_of, write_study_report
from dampen.report.study.tables import command
from dampen.report.study.views.convergence import best_so_far, draw_convergence
from dampen.report.study.views.distribution import draw_distribution
from dampen.report.study.views.heat_map import draw_heat_map
from dampen.report.study.views.learning import draw_learning
from dampen.report.study.views.line import draw_line
from dampen.report.study.views.pareto import front
from dampen.report.study.views.profile import draw_profile
from dampen.report.study.views.scatter import draw_scatter, most_important
from dampen.report.study.views.sensitivity import draw_sensitivity
from dampen.report.study.views.slices import draw_slices
from dampen.report.style import DASH, MINUS, percent, quantity
from dampen.studies.best import at_ends, end_of
from dampen.studies.definition import tune_of
from dampen.studies.statistics import proportion, robustness
from tests.conftest import scenario
from tests.synthetic import StandIn, axes, refuse, robust_study, sweep_study, tune_study

ONE = "controller.alpha_4=0.1:30:log:30"


@pytest.fixture(scope="module")
def robust() -> StandIn:
    return robust_study(128)


@pytest.fixture(scope="module")
def tuned() -> StandIn:
    return tune_study(("residual", "effort"), generations=15)


def text_of(page: Path) -> str:
    text = re.sub(r"<(style|pre).*?</\1>|<[^>]+>", " ", page.read_text("utf-8"), flags=re.DOTALL)
    return re.sub(r"\s+", " ", unescape(text))


def best_of(study: StandIn, merit: str) -> pd.Series:
    held = study.table[study.table.status == "complete"]
    return held.loc[held[merit].idxmin()]


@pytest.mark.parametrize(
    ("make", "expected"),
    [
        (lambda: sweep_study(ONE), ["sweep-peak", "sweep-effort", "sweep-margin"]),
        (lambda: sweep_study(fine=False), ["sweep-peak", "sweep-effort", "sweep-margin"]),
        (
            lambda: sweep_study("plant.tip_mass=0.05:0.2:3", "controller.barrier=log,tan", "controller.alpha_4=1:9:3"),
            ["sweep-peak"],
        ),
        (
            lambda: robust_study(64),
            ["peak-tip_w", "peak-tip_phi", "learning-tip_w", "learning-tip_phi", "sobol-peak", "sobol-margin", "scatter-peak"],
        ),
        (lambda: tune_study(generations=6), ["convergence-peak", "slices-peak"]),
        (
            lambda: tune_study(("residual", "effort"), generations=6),
            ["front-residual-effort", "convergence-residual", "convergence-effort", "slices-residual", "slices-effort"],
        ),
    ],
)
def test_every_kind_leaves_a_page_and_its_figures(tmp_path: Path, make: object, expected: list[str]) -> None:
    study: StandIn = make()  # type: ignore[operator]
    page = write_study_report(tmp_path, study)
    assert page == tmp_path / "report.html"
    for name in expected:
        for kind in ("png", "svg"):
            assert (tmp_path / "figures" / f"{name}.{kind}").stat().st_size > 1000
    text = text_of(page)
    assert f"{study.done:,} of {study.members:,}" in text
    assert "Unfinished" not in text
    assert command(study).split()[1] == study.definition.kind
    assert page.read_text("utf-8").count("<figure") == len(list((tmp_path / "figures").glob("*.svg")))


def test_the_line_tells_the_best_value_and_where() -> None:
    study = sweep_study(ONE)
    best, counts = best_of(study, "peak"), study.table.status.value_counts()
    figure, sentence = draw_line(study, "peak")
    assert f"is best, {percent(best.peak)} of the constraint, at alpha_4 = {best['controller.alpha_4']:.4g} " in sentence
    assert f"of 30 runs {counts.constraint_lost} lost the constraint and {counts.diverged} diverged." in sentence
    assert figure.axes[0].get_xscale() == "log"


def test_the_map_has_each_member_in_its_cell_and_the_best_ringed() -> None:
    study = sweep_study()
    best = best_of(study, "peak")
    figure, sentence = draw_heat_map(study, "peak")
    mesh = figure.axes[0].collections[0]
    values = np.ma.filled(mesh.get_array(), np.nan).reshape(20, 20)
    assert isinstance(mesh.norm, LogNorm)
    np.testing.assert_array_equal(values.T.ravel(), study.table.peak)  # alpha_4, the first axis, is horizontal
    assert f"at alpha_4 = {best['controller.alpha_4']:.4g}, alpha_7 = {best['controller.alpha_7']:.4g}" in sentence
    (hatched,) = [c for c in figure.axes[0].collections if c.get_hatch()]
    assert len(hatched.get_paths()) == (study.table.status == "constraint_lost").sum()


def test_a_diverged_margin_is_not_drawn() -> None:
    study = sweep_study()
    figure, _ = draw_heat_map(study, "margin")
    mesh = figure.axes[0].collections[0]
    assert np.ma.count_masked(mesh.get_array()) == (study.table.status == "diverged").sum()
    assert mesh.norm.vmin >= -1


def test_along_each_of_several_axes_stands_the_best_over_the_others() -> None:
    study = sweep_study("controller.alpha_4=0.1:10:log:9", "controller.alpha_7=0.1:10:log:9", "controller.barrier=log,tan")
    figure, sentence = draw_profile(study, "peak")
    held = study.table[study.table.status == "complete"]
    best, middle = figure.axes[0].get_lines()[:2]
    each = held.groupby("controller.alpha_4").peak
    known = np.isfinite(best.get_ydata())
    np.testing.assert_allclose(best.get_ydata()[known], each.min())
    np.testing.assert_allclose(middle.get_ydata()[known], each.median())
    assert [label.get_text() for label in figure.axes[2].get_xticklabels()] == ["log", "tan"]
    assert "barrier = log" in sentence


def test_words_and_truths_are_categories() -> None:
    study = sweep_study("controller.barrier=tan,log", "controller.compensate=true,false")
    first, second = study.definition.axes
    assert set(positions(study, first)) == {0, 1}
    assert nominal(scenario(), first) == 1
    figure, _ = draw_heat_map(study, "peak")
    assert [t.get_text() for t in figure.axes[0].get_yticklabels()] == ["yes", "no"]
    assert second.values == (True, False)


def test_the_robust_verdict_has_the_share_its_interval_the_peak_and_what_explains_it(robust: StandIn) -> None:
    found, verdict = robustness(robust), verdict_of(robust)
    share = proportion(found.lost.count, found.lost.of)
    assert f"In {found.lost.of} independent samples (768 runs) the constraint was lost in {share_words(share)}" in verdict
    assert f"the peak error is {percent(found.quantiles['peak'].values[2])} of the constraint in the median" in verdict
    assert "unbounded at worst" in verdict
    assert f"tip mass explains {percent(found.indices['peak'].first[0])} of its variance." in verdict


@pytest.mark.parametrize(
    ("count", "of", "text"),
    [(0, 2000, "0 % (95 %: 0~0.18 %)"), (1, 5000, "0.020 % (95 %: 0.00051~0.11 %)"), (30, 100, "30 % (95 %: 21~40 %)")],
)
def test_shares_have_two_digits_however_small(count: int, of: int, text: str) -> None:
    assert share_words(proportion(count, of)) == text.replace("~", DASH)


def test_the_distribution_is_of_independent_samples_and_counts_the_diverged(robust: StandIn) -> None:
    _, sentence = draw_distribution(robust, "tip_w", {"peak.tip_w": 0.0512})
    rows = robust.table[robust.table.member < 256]
    ran = rows[rows.status.isin(["complete", "constraint_lost", "diverged"])]
    values = np.sort(ran["peak.tip_w"].fillna(np.inf))
    assert f"Over {len(values)} independent samples" in sentence
    assert f"{quantity(values[-(-len(values) // 2) - 1], 'm')} in the median" in sentence
    assert f"{(ran.status == 'diverged').sum()} diverged" in sentence
    assert "own parameters give 0.0512 m" in sentence


def test_the_learning_bands_are_quantiles_of_each_trial(robust: StandIn) -> None:
    figure, sentence = draw_learning(robust, "tip_w")
    rows = robust.table[(robust.table.member < 256) & robust.table.status.isin(["complete", "constraint_lost", "diverged"])]
    last = np.sort([p[-1] if len(p) == 25 else np.inf for p in rows["peaks.tip_w"]])
    median = last[-(-len(last) // 2) - 1]
    assert figure.axes[0].get_lines()[0].get_ydata()[-1] == pytest.approx(median)
    assert f"to {quantity(median, 'm')} in trial 24 in the median" in sentence
    assert figure.axes[0].get_yscale() == "log"


def test_the_bars_are_the_indices_and_the_least_parameter_could_be_fixed(robust: StandIn) -> None:
    one = robustness(robust).indices["effort"]
    figure, sentence = draw_sensitivity(robust, "effort", one)
    widths = sorted(patch.get_width() for patch in figure.axes[0].patches)
    np.testing.assert_allclose(widths, sorted([*one.first, *one.total]))
    assert f"backlash right {percent(one.first[2])} (95 %: " in sentence
    assert "tip mass and factor on shear stiffness & rotary inertia could be fixed" in sentence
    assert f"({one.rows} base rows, {one.left_out} incomplete ones left out)" in sentence


def test_the_scatter_shows_the_two_most_important_parameters_and_where_runs_were_lost(robust: StandIn) -> None:
    shown = most_important(robust, robustness(robust).indices["peak"])
    assert [axis.name for axis in shown] == ["plant.tip_mass", "plant.bending_stiffness"]
    assert most_important(robust, None)[0].name == "plant.tip_mass"
    _, sentence = draw_scatter(robust, "peak", shown)
    lost = robust.table[robust.table.status.isin(["constraint_lost", "diverged"])]["plant.tip_mass"]
    assert f"between {lost.min():.4g} and {lost.max():.4g}" in sentence
    assert "1 was refused and 1 crashed" in sentence


def test_a_large_scatter_is_small_as_svg(tmp_path: Path) -> None:
    study = robust_study(512)
    assert len(study.table) > 3000
    write_study_report(tmp_path, study)
    assert (tmp_path / "figures" / "scatter-peak.svg").stat().st_size < 300_000


def test_convergence_tells_the_best_of_those_that_held(tuned: StandIn) -> None:
    best = best_so_far(tuned, "residual")
    held = tuned.table[tuned.table.status == "complete"]
    np.testing.assert_allclose(best, [held[held.generation <= g].residual.min() for g in range(15)])
    _, sentence = draw_convergence(tuned, "residual")
    assert f"from {percent(best[0])} of the constraint in generation 0 to {percent(best[-1])}" in sentence


def test_nothing_that_held_betters_a_row_of_the_front(tuned: StandIn) -> None:
    rows, table = front(tuned, ("residual", "effort")), tuned.table
    held = table[table.status == "complete"]
    for row in rows:
        mine = table.iloc[row]
        better = (held.residual <= mine.residual) & (held.effort <= mine.effort)
        assert better.sum() == 1
    outside = held[~held.member.isin(table.member.iloc[rows])]
    for _, one in outside.iterrows():
        assert ((table.residual.iloc[rows] <= one.residual) & (table.effort.iloc[rows] <= one.effort)).any()
    assert f"{len(rows)} members are on the front of 2 objectives" in verdict_of(tuned)


def test_a_margin_is_made_large_on_the_front() -> None:
    study = tune_study(("margin", "effort"), generations=5)
    rows = front(study, ("margin", "effort"))
    assert study.table.margin.iloc[rows[0]] == study.table.margin[study.table.status == "complete"].max()


def test_an_optimum_at_a_bound_is_told() -> None:
    study = tune_study()
    _, sentence = draw_slices(study, "peak")
    told = "controller.alpha_9 is at the upper end of its range, 0.01 to 0.9: a wider one may give more."
    assert sentence.endswith(told)
    assert "alpha_4" not in sentence
    assert verdict_of(study).endswith(told)
    (axis,) = axes("search", "controller.alpha_4=0.01:100:log")
    assert [end_of(axis, at) for at in (0.0109, 0.011, 1.0, 91.0, 92.0)] == ["lower", "", "", "", "upper"]
    (whole,) = axes("search", "controller.alpha_4=0.5:10")
    assert [end_of(replace(whole, whole=True), at) for at in (1, 2, 9, 10)] == ["lower", "", "", "upper"]


def test_an_end_beyond_which_there_is_nothing_is_not_told() -> None:
    """Damping below 0 is none that the law takes."""
    case = scenario("controller.kind=boundary-damping", "controller.damping={tip_w=1.0}")
    definition = tune_of(case, ["controller.damping.tip_w=0:10"], ["peak"], 10)
    name = definition.axes[0].name
    assert at_ends(definition, {name: 0.0}) == ""
    assert at_ends(definition, {name: 5.0}) == ""
    assert at_ends(definition, {name: 10.0}) == f"{name} is at the upper end of its range, 0 to 10: a wider one may give more"


def test_an_unfinished_study_says_so(tmp_path: Path, robust: StandIn) -> None:
    some = StandIn(robust.definition, robust.members, robust.table[robust.table.member < 60])
    text = text_of(write_study_report(tmp_path, some))
    assert "Unfinished: 60 of 768 runs are done" in text
    assert not list((tmp_path / "figures").glob("sobol-*"))
    assert (tmp_path / "figures" / "scatter-peak.png").exists()


def test_a_study_without_rows_has_a_page(tmp_path: Path, robust: StandIn) -> None:
    for kind, study in (("robust", robust), ("sweep", sweep_study(ONE)), ("tune", tune_study(generations=4))):
        nothing = StandIn(study.definition, study.members, study.table.iloc[:0])
        text = text_of(write_study_report(tmp_path / kind, nothing))
        assert "No run is done yet." in text
        assert f"Unfinished: 0 of {study.members:,}" in text
        assert summary_rows(nothing)[1] == []


@pytest.mark.parametrize("make", [lambda: sweep_study(ONE), lambda: robust_study(8), lambda: tune_study(generations=3)])
def test_a_study_that_was_refused_throughout_says_why(tmp_path: Path, make: object) -> None:
    study: StandIn = make()  # type: ignore[operator]
    why = "Argument `plant.tip_mass` must be >= 0 kg, but is -0.1."
    table = refuse(study.table, list(range(len(study.table))), why)
    text = text_of(write_study_report(tmp_path, StandIn(study.definition, study.members, table)))
    assert f"All {study.members} runs failed: {study.members} refused." in text
    assert f"No run could be made. {why}" in text
    assert "Runs that could not be made" in text


def test_axes_are_told_apart_by_as_much_of_their_path_as_it_takes() -> None:
    case = scenario()
    both = axes(
        "vary", "controller.alpha_4=1:2:2", "actuator.tip_w.chain.0.right=0.1:0.2:2", "actuator.tip_phi.chain.0.right=0.1:0.2:2"
    )
    names = axis_names(case, both)
    assert list(names.values()) == ["alpha_4", "tip_w backlash right", "tip_phi backlash right"]
    assert axis_label(case, both[0], names["controller.alpha_4"]) == r"$\alpha_{4}$ [N s/m]"
    mass, initial, limit = axes(
        "vary", "plant.tip_mass=0.1:0.2:2", "plant.initial.w.1=0.1:0.15:2", "task.constraint.tip_phi=0.2:0.3:2"
    )
    assert axis_label(case, mass, "tip_mass") == "tip mass [kg]"
    assert axis_names(case, [initial]) == {initial.name: "w[1]"}
    assert axis_label(case, limit, "tip_phi").endswith("[rad]")


def test_merits_have_their_units() -> None:
    case = scenario()
    assert merit_label("peak.tip_phi", case) == "peak error, tip φ [rad]"
    assert merit_label("peak", case) == "peak error / constraint"
    assert merit_value("peak", 0.114, case) == "11 % of the constraint"
    assert merit_value("effort.tip_w", 0.5, case) == "0.500 N"
    assert merit_value("margin", -0.02, case) == f"{MINUS}2.0 %"


def test_the_command_repeats_the_study(robust: StandIn, tuned: StandIn) -> None:
    assert command(sweep_study(ONE)) == f"dampen sweep scenario.toml --vary {ONE}"
    assert command(robust).endswith("--samples 768 --sampler sobol --seed 3")
    assert "--uncertain plant.tip_mass=+-50%" in command(robust)
    over = axes("uncertain", "plant.tip_mass=+-30%")
    study = replace(tuned, definition=replace(tuned.definition, robust_axes=over, robust_samples=16))
    assert "--objective residual --objective effort --budget 240 --population 16" in command(study)
    assert "--robust-over plant.tip_mass=+-30% --robust-samples 16 --seed 3" in command(study)
    assert "of the constraint in the worst of 16 samples, at alpha_4 = " in verdict_of(study)


def test_the_terminal_s_table_has_best_median_and_worst() -> None:
    study = sweep_study(ONE)
    heads, rows = summary_rows(study)
    ran = study.table[study.table.status != "diverged"]
    assert heads == ["Figure of merit", "Best", "Median", "Worst"]
    assert ["peak error (peak)", percent(ran.peak.min()), percent(ran.peak.median()), percent(ran.peak.max())] in rows
    assert ["margin", percent(ran.margin.max()), percent(ran.margin.median()), percent(ran.margin.min())] in rows


@pytest.mark.parametrize(("objectives", "head"), [(("peak",), "Winner"), (("residual", "effort"), "Winner in residual")])
def test_a_tuning_s_table_has_its_winner_beside_what_others_reached(objectives: tuple[str, ...], head: str) -> None:
    study = tune_study(objectives, generations=1)
    heads, rows = summary_rows(study)
    assert heads == ["Figure of merit", head, "Best", "Median", "Worst"]
    table = study.table
    winner = table[table.status == "complete"].sort_values(objectives[0]).iloc[0]
    told = {row[0]: row[1] for row in rows}
    assert told["peak error (peak)"] == percent(winner.peak)
    assert told["rms force (effort; N, N m together)"] == f"{winner.effort:#.3g}"
    assert verdict_of(study).startswith("After 1 generation the best")
