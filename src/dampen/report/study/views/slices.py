"""Where a tuning's optimum sits: an objective against every gain."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from dampen.report.axes import legend_row, sheet
from dampen.report.study.axes import (
    BEST,
    best_row,
    is_listed,
    is_log,
    merit_axis,
    merits_of,
    padded,
    parameter_axis,
    positions,
    scatter,
    value_text,
)
from dampen.report.study.names import axis_names, merit_label, merit_value, merit_words, plain_name
from dampen.report.study.panels import panels_across, small_panels
from dampen.report.style import DISPLACEMENT, DOTS, DOUBLE, FAINT
from dampen.studies.study import Study
from dampen.studies.variation import Axis

NEAR = 0.02  # of the range: that near to a bound the optimum touches it


def draw_slices(study: Study, objective: str) -> tuple[Figure, str]:
    """All members in one panel for each gain, its bounds dotted, the best ringed."""
    scenario, varied, y = study.definition.scenario, study.definition.axes, merits_of(study, objective)
    names, best = axis_names(scenario, varied), best_row(study, objective)
    figure = sheet(DOUBLE, 2.0)
    handles = []
    for i, (axis, axes) in enumerate(zip(varied, small_panels(figure, len(varied)), strict=True)):
        x = positions(study, axis)
        parameter_axis(axes, axis, scenario, "x", names[axis.name])
        axes.set_xlim(padded(axis, 0.06))
        merit_axis(axes, merit_label(objective, scenario), y)
        handles = scatter(axes, study, x, y, DISPLACEMENT, ms=2.0, alpha=0.4)
        for end in (axis.low, axis.high) if axis.low < axis.high else ():
            bound = axes.axvline(end, color=FAINT, lw=0.8, ls=DOTS, zorder=1, label="bound")
            handles = [h for h in handles if h.get_label() != "bound"] + [bound]
        if best is not None:
            look: dict[str, Any] = {"ms": 6.5, "mfc": "none", "mec": BEST, "mew": 1.4, "ls": "none", "zorder": 6}
            handles += axes.plot([x[best]], [y[best]], "o", label="best", **look)
        if i % panels_across(len(varied)):
            axes.set_ylabel("")
    legend_row(figure, handles)
    return figure, _sentence(study, objective, best, names)


def touched(axis: Axis, value: float) -> str:
    """ "lower" or "upper" where the value is at that bound of the axis, else ""."""
    if is_listed(axis) or not axis.low < axis.high:
        return ""
    low, high, at = axis.low, axis.high, value
    if is_log(axis):
        low, high, at = np.log(low), np.log(high), np.log(value)
    share = (at - low) / (high - low)
    return "lower" if share <= NEAR else "upper" if share >= 1 - NEAR else ""


def _sentence(study: Study, objective: str, best: int | None, names: dict[str, str]) -> str:
    if best is None:
        return "No member held the constraint."
    value = merit_value(objective, merits_of(study, objective)[best], study.definition.scenario)
    text = f"The best {merit_words(objective)}, {value}, "
    ends = []
    for axis in study.definition.axes:
        at = positions(study, axis)[best]
        side = touched(axis, at)
        if side:
            ends.append(f"{plain_name(names[axis.name])} = {value_text(at)} is at its {side} bound")
    if not ends:
        return f"{text}lies inside the bounds of all {len(names)} parameters."
    return f"{text}touches a bound: {', '.join(ends)}; a wider range may give more."
