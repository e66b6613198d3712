"""A merit against the parameters that matter most."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from dampen.report.axes import legend_row, sheet
from dampen.report.study.axes import merit_axis, merits_of, padded, parameter_axis, positions, rows_words, scatter, value_text
from dampen.report.study.names import axis_names, merit_label, merit_value, merit_words, plain_name
from dampen.report.study.panels import small_panels
from dampen.report.style import DISPLACEMENT, DOUBLE, INK
from dampen.studies.rows import Array, statuses
from dampen.studies.statistics import Indices
from dampen.studies.study import Study
from dampen.studies.variation import Axis

MOST = 2
GROUPS = 12


def most_important(study: Study, found: Indices | None) -> list[Axis]:
    """The axes with the largest total indices, or, as long as there are none, with the largest rank correlation."""
    axes = study.definition.axes
    if found is not None and found.total.any():
        weight = found.total
    else:
        weight = np.array([_rank_correlation(positions(study, axis), merits_of(study, "peak")) for axis in axes])
    return [axes[i] for i in np.argsort(-weight, kind="stable")[:MOST]]


def _rank_correlation(x: Array, y: Array) -> float:
    """|Spearman's rho| of what is known; 0 where that is nothing."""
    from scipy.stats import rankdata

    known = np.isfinite(x) & np.isfinite(y)
    if known.sum() < 3 or np.ptp(x[known]) == 0 or np.ptp(y[known]) == 0:
        return 0.0
    return float(abs(np.corrcoef(rankdata(x[known]), rankdata(y[known]))[0, 1]))


def draw_scatter(study: Study, merit: str, axes_shown: list[Axis]) -> tuple[Figure, str]:
    """Every run, those that lost the constraint marked, those that diverged at the upper edge; the running median."""
    scenario, y = study.definition.scenario, merits_of(study, merit)
    names = axis_names(scenario, study.definition.axes)
    figure = sheet(DOUBLE, 2.4)
    handles = []
    for i, (axis, axes) in enumerate(zip(axes_shown, small_panels(figure, len(axes_shown), 1.75), strict=True)):
        x = positions(study, axis)
        parameter_axis(axes, axis, scenario, "x", names[axis.name])
        axes.set_xlim(padded(axis))
        merit_axis(axes, merit_label(merit, scenario), y)
        size = float(np.clip(40 / max(len(x), 1) ** 0.5, 1.1, 2.8))
        handles = scatter(axes, study, x, y, DISPLACEMENT, ms=size, alpha=1.0 if len(x) < 300 else 0.35)
        at, middle = _running(x, y)
        handles += axes.plot(at, middle, color=INK, lw=1.2, label="median", zorder=6)
        if i:
            axes.set_ylabel("")
    legend_row(figure, handles)
    return figure, _sentence(study, merit, axes_shown, names)


def _running(x: Array, y: Array) -> tuple[Array, Array]:
    """Medians of as many rows each along x."""
    known = np.flatnonzero(np.isfinite(x) & np.isfinite(y))
    order = known[np.argsort(x[known], kind="stable")]
    parts = [part for part in np.array_split(order, min(GROUPS, max(1, len(order) // 5))) if len(part)]
    return np.array([np.median(x[part]) for part in parts]), np.array([np.median(y[part]) for part in parts])


def _sentence(study: Study, merit: str, shown: list[Axis], names: dict[str, str]) -> str:
    scenario, y = study.definition.scenario, merits_of(study, merit)
    axis = shown[0]
    x = positions(study, axis)
    at, middle = _running(x, y)
    if not len(at):
        return "No run has a value."
    values = [merit_value(merit, float(v), scenario) for v in (middle[0], middle[-1])]
    over = f"{plain_name(names[axis.name])} goes from {value_text(at[0])} to {value_text(at[-1])}"
    verb = "rises" if middle[-1] > middle[0] else "falls"
    text = f"The median {merit_words(merit)} {verb} from {values[0]} to {values[1]} as {over}"
    if len(at) < 2 or values[0] == values[1]:
        text = f"The median {merit_words(merit)} is {values[0]} throughout"
    lost = np.isin(statuses(study), ("constraint_lost", "diverged"))
    if lost.any():
        text += f"; runs that lost the constraint or diverged have it between {value_text(x[lost].min())} and "
        text += value_text(x[lost].max())
    return f"{text}{rows_words(study)}."
