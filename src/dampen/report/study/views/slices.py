"""Where a tuning's optimum sits: an objective against every gain."""

from __future__ import annotations

from typing import Any

from matplotlib.figure import Figure

from dampen.report.axes import legend_row, sheet
from dampen.report.study.axes import (
    BEST,
    best_row,
    merit_axis,
    merits_of,
    padded,
    parameter_axis,
    positions,
    scatter,
)
from dampen.report.study.names import axis_names, merit_label, merit_value, merit_words
from dampen.report.study.panels import panels_across, small_panels
from dampen.report.style import DISPLACEMENT, DOTS, DOUBLE, FAINT
from dampen.studies.best import at_ends
from dampen.studies.study import Study


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


def _sentence(study: Study, objective: str, best: int | None, names: dict[str, str]) -> str:
    if best is None:
        return "No member held the constraint."
    value = merit_value(objective, merits_of(study, objective)[best], study.definition.scenario)
    text, ends = f"The best {merit_words(objective)} is {value}", at_ends(study.definition, study.table.iloc[best])
    return f"{text}. {ends}." if ends else f"{text}, at no end of the ranges of its {len(names)} parameters."
