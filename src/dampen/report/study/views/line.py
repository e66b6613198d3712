"""A merit along the one axis of a sweep."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from dampen.report.axes import legend_row, panel, sheet
from dampen.report.study.axes import (
    BEST,
    best_row,
    is_listed,
    merit_axis,
    merits_of,
    nominal,
    padded,
    parameter_axis,
    positions,
    rows_words,
    scatter,
    where_words,
)
from dampen.report.study.names import axis_names, merit_label, merit_value, merit_words
from dampen.report.style import DISPLACEMENT, DOTS, FAINT
from dampen.studies.rows import statuses
from dampen.studies.study import Study


def draw_line(study: Study, merit: str) -> tuple[Figure, str]:
    """The merit against the axis: held, lost and diverged points, the best one ringed, the scenario's own value dotted."""
    scenario, axis = study.definition.scenario, study.definition.axes[0]
    names = axis_names(scenario, [axis])
    x, y = positions(study, axis), merits_of(study, merit)
    figure = sheet()
    axes = panel(figure, left=0.68, top=0.3)
    axes.set_xlim(padded(axis))
    parameter_axis(axes, axis, scenario, "x", names[axis.name])
    axes.set_xlim(padded(axis))
    merit_axis(axes, merit_label(merit, scenario), y)
    handles = []
    own = nominal(scenario, axis)
    if own is not None and padded(axis)[0] <= own <= padded(axis)[1]:
        handles.append(axes.axvline(own, color=FAINT, lw=0.8, ls=DOTS, label="scenario's own", zorder=1))
    order = np.argsort(x)
    if not is_listed(axis):
        axes.plot(x[order], y[order], color=DISPLACEMENT, lw=0.7, alpha=0.6, zorder=2)
    handles = [*scatter(axes, study, x, y, DISPLACEMENT), *handles]
    best = best_row(study, merit)
    if best is not None:
        handles += axes.plot([x[best]], [y[best]], "o", ms=6.5, mfc="none", mec=BEST, mew=1.2, label="best", ls="none", zorder=4)
    legend_row(figure, handles)
    return figure, _sentence(study, merit, best, names)


def _sentence(study: Study, merit: str, best: int | None, names: dict[str, str]) -> str:
    scenario, y = study.definition.scenario, merits_of(study, merit)
    if best is None:
        return f"No run held the constraint{rows_words(study)}."
    held = y[(statuses(study) == "complete") & np.isfinite(y)]
    worst = held.max() if y[best] == held.min() else held.min()
    text = f"The {merit_words(merit)} is best, {merit_value(merit, y[best], scenario)}, at {where_words(study, best, names)}"
    text += f" and worst, {merit_value(merit, worst, scenario)}, among the {len(held):,} runs that held"
    return f"{text}{rows_words(study)}."
