"""Which uncertain parameters a merit depends on: first-order and total Sobol indices."""

from __future__ import annotations

from textwrap import wrap

import numpy as np
from matplotlib.figure import Figure

from dampen.component import listed
from dampen.report.axes import legend_row, panel, sheet
from dampen.report.study.names import axis_names, math_name, merit_words, plain_name
from dampen.report.style import DISPLACEMENT, INK, SINGLE, percent, tint
from dampen.studies.statistics import Indices
from dampen.studies.study import Study

NOTABLE = 0.05
BAR = 0.36
WIDEST = 22  # letters of a label in one line
ROW = 0.27  # in, for a parameter


def draw_sensitivity(study: Study, merit: str, found: Indices) -> tuple[Figure, str]:
    """Two bars for each parameter, the most important at the top, with 95 % intervals by bootstrap."""
    names = axis_names(study.definition.scenario, study.definition.axes)
    wrapped = [wrap(plain_name(names[axis.name].removeprefix("factor on ")), WIDEST) for axis in study.definition.axes]
    labels = ["\n".join(map(math_name, lines)) for lines in wrapped]
    order = np.argsort(found.total)  # barh counts from below
    figure = sheet(SINGLE, max(1.5, 0.85 + ROW * len(labels)))
    left = 0.2 + 0.062 * max(len(line) for lines in wrapped for line in lines)
    axes = panel(figure, left=left, top=0.3)
    handles = []
    places = np.arange(len(labels))
    for values, interval, shift, ink, label in (
        (found.first, found.first_interval, BAR / 2, DISPLACEMENT, "first order"),
        (found.total, found.total_interval, -BAR / 2, tint(DISPLACEMENT, 0.35), "total, with interactions"),
    ):
        error = np.abs(interval[:, order] - values[order])
        style = {"elinewidth": 0.7, "ecolor": INK, "capsize": 1.6, "capthick": 0.7}
        handles.append(axes.barh(places + shift, values[order], BAR, color=ink, label=label, xerr=error, error_kw=style))
    axes.axvline(0, color=INK, lw=0.6)
    axes.spines["left"].set_visible(False)
    axes.set_yticks(places, [labels[i] for i in order])
    axes.tick_params(axis="y", length=0)
    reach = [float(found.first_interval[0].min()), float(found.total_interval[1].max())]
    axes.set_xlim(min(0.0, 1.05 * reach[0]), max(1.0, 1.05 * reach[1]))
    axes.set_xlabel(f"Sobol index, {merit_words(merit)}")
    legend_row(figure, handles)
    return figure, _sentence(study, merit, found)


def _sentence(study: Study, merit: str, found: Indices) -> str:
    names = axis_names(study.definition.scenario, study.definition.axes)
    plain = [plain_name(names[axis.name]) for axis in study.definition.axes]
    if not found.total.any():
        return f"The {merit_words(merit)} does not vary."
    order = [i for i in np.argsort(-found.total) if found.first[i] >= NOTABLE][:3] or [int(np.argmax(found.total))]
    parts = [f"{plain[i]} {percent(found.first[i])} (95 %: {_interval(found.first_interval[:, i])})" for i in order]
    text = f"Shares of the variance of the {merit_words(merit)}, each parameter alone: {listed(parts)}"
    rest = 1 - float(found.first.sum())
    text += f"; interactions make {percent(rest)}" if rest >= NOTABLE else "; interactions matter little"
    idle = [plain[i] for i in range(len(plain)) if found.total_interval[1, i] < NOTABLE]
    text += f"; {listed(idle)} could be fixed" if idle else ""
    text += f" ({found.rows:,} base rows" + (f", {found.left_out:,} incomplete ones left out)" if found.left_out else ")")
    return text + "."


def _interval(ends: np.ndarray) -> str:
    low, high = (min(100, max(0, round(100 * float(end)))) for end in ends)  # beyond is noise
    return f"{low}\N{EN DASH}{high} %"
