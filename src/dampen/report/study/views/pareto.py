"""What two objectives of a tuning cost each other."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dampen.report.axes import legend_row, panel, sheet
from dampen.report.study.axes import BEST, linear_ticks, log_ticks, merit_axis, merits_of, rows_words, scatter
from dampen.report.study.names import is_low_better, merit_label, merit_value, merit_words
from dampen.report.style import FAINT
from dampen.studies.rows import Array, statuses
from dampen.studies.study import Study


def front(study: Study, objectives: tuple[str, ...]) -> Array:
    """Rows that held the constraint and that no other such row equals or betters in every objective, by the first one."""
    signs = [1.0 if is_low_better(name) else -1.0 for name in objectives]
    values = np.column_stack([sign * merits_of(study, name) for sign, name in zip(signs, objectives, strict=True)])
    fit = np.flatnonzero((statuses(study) == "complete") & np.isfinite(values).all(axis=1))
    order = fit[np.lexsort(values[fit].T[::-1])]
    kept: list[int] = []
    for row in order:  # whoever betters a row comes before it in this order
        if not any(np.all(values[other] <= values[row]) for other in kept):
            kept.append(int(row))
    return np.array(kept, dtype=int)


def draw_pareto(study: Study, first: str, second: str) -> tuple[Figure, str]:
    """All members, faint; those of the front of these two objectives joined by a line."""
    scenario = study.definition.scenario
    x, y = merits_of(study, first), merits_of(study, second)
    rows = front(study, (first, second))
    figure = sheet(height=2.6)
    axes = panel(figure, left=0.68, top=0.3)
    _first_axis(axes, merit_label(first, scenario), x)
    merit_axis(axes, merit_label(second, scenario), y)
    both = np.isfinite(x) & np.isfinite(y)  # a member without the one cannot be placed by the other
    handles = scatter(axes, study, x, y, FAINT, "dominated", both, ms=2.2, alpha=0.5)
    style: dict[str, Any] = {"color": BEST, "lw": 0.9, "ms": 3.6, "marker": "o", "zorder": 5}
    handles += axes.plot(x[rows], y[rows], drawstyle="default", label="front", **style)
    legend_row(figure, handles)
    return figure, _sentence(study, first, second, rows)


def _first_axis(axes: Axes, label: str, values: Array) -> None:
    """The horizontal axis of a merit, logarithmic by the same rule as a vertical one."""
    known = values[np.isfinite(values)]
    low, high = (float(known.min()), float(known.max())) if len(known) else (0.0, 1.0)
    axes.set_xlabel(label)
    if low > 0 and high > 5 * low:
        axes.set_xscale("log")
        axes.set_xlim(low / 1.1, high * 1.1)
        log_ticks(axes.xaxis, low / 1.1, high * 1.1, 6)
        return
    room = 0.06 * (high - low) or 0.1
    axes.set_xlim(low - room, high + room)
    linear_ticks(axes.xaxis, 6)


def _sentence(study: Study, first: str, second: str, rows: Array) -> str:
    scenario = study.definition.scenario
    if not len(rows):
        return f"No member held the constraint{rows_words(study)}."
    x, y = merits_of(study, first)[rows], merits_of(study, second)[rows]
    text = f"{len(rows):,} of {len(study.table):,} members are on the front"
    if len(rows) == 1:
        return f"{text}, which is best in both{rows_words(study)}."
    ends = [(merit_value(first, x[i], scenario), merit_value(second, y[i], scenario)) for i in (0, -1)]
    text += f": from the {merit_words(first)} at {ends[0][0]} with the {merit_words(second)} at {ends[0][1]} "
    text += f"to {ends[1][0]} with {ends[1][1]}"
    return f"{text}{rows_words(study)}."
