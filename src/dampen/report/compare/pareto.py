"""What a small error costs: the objective against the effort, a mark for each contender."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from dampen.report.axes import panel, sheet
from dampen.report.compare.looks import looks
from dampen.report.compare.tables import objective_value
from dampen.report.study.axes import log_ticks, merit_axis
from dampen.report.study.names import merit_label, merit_value, merit_words
from dampen.report.style import INK
from dampen.simulation.scenario import Scenario
from dampen.studies.compare.comparison import Comparison, Contender
from dampen.studies.compare.verdict import EFFORT, front, holds, nobody

WIDTH, HEIGHT = 3.9, 3.2


def draw_pareto(found: Comparison, scenario: Scenario) -> tuple[Figure, str]:
    """A mark for each contender, hollow where the constraint is lost at either of the numerics, a bar over its searches and
    both numerics; those that hold it and that nobody betters in both are joined. No effort at all stands at the left edge."""
    figure = sheet(WIDTH, HEIGHT)
    axes = panel(figure, left=0.72, right=0.2, top=0.2 + 0.16 * -(-len(found.contenders) // 3), bottom=0.46)
    shown = [c for c in found.contenders if np.isfinite(c.merits[found.objective]) and np.isfinite(c.merits[EFFORT])]
    ends = np.array([value for c in shown for value in c.span(found.objective)])
    merit_axis(axes, merit_label(found.objective, scenario), ends)
    if scenario.task.constraint and found.objective in ("peak", "residual"):
        axes.yaxis.set_major_formatter(FuncFormatter(lambda v, _: f"{100 * v:g} %"))
    places = effort_axis(axes, merit_label(EFFORT, scenario), [c.merits[EFFORT] for c in shown])
    at = {c.label: (x, c.merits[found.objective]) for c, x in zip(shown, places, strict=True)}
    best = [at[c.label] for c in front([c for c in shown if holds(c)], found.objective)]
    if best:
        axes.plot(*zip(*best, strict=True), color=INK, lw=0.7, ls=(0, (4, 2)), drawstyle="steps-post", zorder=2)
    styles, handles = looks(found), list[Any]()
    for c in shown:
        look, x = styles[c.label], at[c.label][0]
        axes.plot([x, x], c.span(found.objective), color=look["color"], lw=0.8, zorder=3, solid_capstyle="butt")
        face = look["color"] if holds(c) else "white"
        mark = {"marker": look["marker"], "ms": 5.0, "mfc": face, "mec": look["color"], "mew": 1.0, "ls": "none"}
        handles += axes.plot(*at[c.label], label=c.label, zorder=4, **mark)
    legend_above(figure, handles)
    return figure, sentence(found, scenario, shown)


def effort_axis(axes: Axes, label: str, values: Sequence[float]) -> list[float]:
    """A logarithmic axis of efforts; where each stands: an effort of nothing at the left edge."""
    known = [v for v in values if v > 0]
    low, high = (min(known), max(known)) if known else (0.1, 1.0)
    pad = max((high / low) ** 0.12, 1.5)
    edge = low / pad / (pad if len(known) < len(values) else 1)
    axes.set_xscale("log")
    axes.set_xlim(edge / 1.15, high * pad)
    log_ticks(axes.xaxis, edge, high * pad, 5)
    axes.set_xlabel(label + (", 0 at the edge" if len(known) < len(values) else ""))
    return [v if v > 0 else edge for v in values]


def legend_above(figure: Figure, handles: Sequence[Any]) -> None:
    """Names above the axes, three in a row: marks may lie too close to one another to be named where they are."""
    figure.legend(
        handles=handles, loc="upper left", bbox_to_anchor=(0.1 / WIDTH, 1 - 0.03 / HEIGHT), ncols=3, frameon=False, fontsize=6.5,
        borderpad=0, borderaxespad=0.2, handletextpad=0.3, columnspacing=1.0, labelspacing=0.35, handlelength=1.2,
    )  # fmt: skip


def sentence(found: Comparison, scenario: Scenario, shown: Sequence[Contender]) -> str:
    """Who is on the front, from the least effort to the least error."""
    best = front([c for c in shown if holds(c)], found.objective)
    if not best:
        return nobody(scenario)
    parts = [
        f"{c.label} ({objective_value(found, c.merits)} for {merit_value(EFFORT, c.merits[EFFORT], scenario)})" for c in best
    ]
    text = f"Nobody is better in both {merit_words(found.objective)} and effort than {', '.join(parts)}"
    lost = [c.label for c in shown if not holds(c)]
    what = "the constraint is not held" if scenario.task.constraint else "does not run to its end"
    text += f"; hollow: {what}, here or at finer numerics ({', '.join(lost)})" if lost else ""
    over = "finer numerics and the best of each search" if any(len(c.searches) > 1 for c in shown) else "finer numerics"
    return f"{text}. Bars go over {over}."
