"""What a small error costs: the objective against the effort, a mark for each contender."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
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
from dampen.studies.compare.verdict import EFFORT, front, holds

WIDTH, HEIGHT = 3.9, 2.9
Box = tuple[float, float, float, float]


def draw_pareto(found: Comparison, scenario: Scenario) -> tuple[Figure, str]:
    """A mark for each contender, hollow where the constraint is lost at either of the numerics, a bar to its value at finer
    ones; those that hold it and that nobody betters in both are joined. No effort at all stands at the left edge."""
    figure = sheet(WIDTH, HEIGHT)
    axes = panel(figure, left=0.72, right=0.2, top=0.14, bottom=0.46)
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
    styles = looks(found)
    for c in shown:
        look, x = styles[c.label], at[c.label][0]
        axes.plot([x, x], c.span(found.objective), color=look["color"], lw=0.8, zorder=3, solid_capstyle="butt")
        face = look["color"] if holds(c) else "white"
        axes.plot(*at[c.label], marker=look["marker"], ms=5.5, mfc=face, mec=look["color"], mew=1.0, ls="none", zorder=4)
    name_all(axes, shown, at, best)
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


def name_all(
    axes: Axes, shown: Sequence[Contender], at: dict[str, tuple[float, float]], steps: Sequence[tuple[float, float]]
) -> None:
    """Each mark's name beside it, where it is in nobody's way: right, left, above or below, whatever is freest. steps: corners
    of the line through the best, which are in the way too."""
    pixel = {label: axes.transData.transform(place) for label, place in at.items()}
    box, dpi = axes.get_window_extent(), axes.figure.dpi
    taken: list[Box] = [(x - 0.05 * dpi, y - 0.05 * dpi, x + 0.05 * dpi, y + 0.05 * dpi) for x, y in pixel.values()]
    taken += dots([axes.transData.transform(corner) for corner in steps], 0.03 * dpi)
    for c in shown:
        x, y = pixel[c.label]
        wide, high, off = 0.056 * dpi * len(c.label), 0.11 * dpi, 0.07 * dpi
        options = [
            ("left", x + off, y - high / 2), ("right", x - off - wide, y - high / 2), ("center", x - wide / 2, y + off),
            ("center", x - wide / 2, y - off - high), ("left", x + off, y + off / 2), ("left", x + off, y - high - off / 2),
            ("right", x - off - wide, y + off / 2), ("right", x - off - wide, y - high - off / 2),
        ]  # fmt: skip
        boxes = [(left, bottom, left + wide, bottom + high) for _, left, bottom in options]
        i = int(np.argmin([sum(overlap(b, other) for other in taken) + 1e4 * outside(b, box) for b in boxes]))
        taken.append(boxes[i])
        side, left, bottom = options[i]
        anchor = {"left": left, "right": left + wide, "center": left + wide / 2}[side]
        at_x, at_y = axes.transAxes.inverted().transform((anchor, bottom + high / 2))
        axes.annotate(c.label, (at_x, at_y), xycoords="axes fraction", ha=side, va="center", fontsize=6.5, zorder=5,
                      bbox={"boxstyle": "square,pad=0.08", "fc": "white", "ec": "none", "alpha": 0.8})  # fmt: skip


def dots(corners: Sequence[np.ndarray], half: float) -> list[Box]:
    """Small boxes along the steps through some corners, [pixels]."""
    found: list[Box] = []
    for (x0, y0), (x1, y1) in pairwise(corners):
        found += [(x - half, y0 - half, x + half, y0 + half) for x in np.arange(x0, x1, 2 * half)]
        found += [(x1 - half, y - half, x1 + half, y + half) for y in np.arange(min(y0, y1), max(y0, y1), 2 * half)]
    return found


def overlap(a: Box, b: Box) -> float:
    """Area that two boxes share."""
    return max(0.0, min(a[2], b[2]) - max(a[0], b[0])) * max(0.0, min(a[3], b[3]) - max(a[1], b[1]))


def outside(a: Box, box: Any) -> bool:
    """Whether a box sticks out of the axes."""
    return a[0] < box.x0 or a[2] > box.x1 + 12 or a[1] < box.y0 or a[3] > box.y1


def sentence(found: Comparison, scenario: Scenario, shown: Sequence[Contender]) -> str:
    """Who is on the front, from the least effort to the least error."""
    best = front([c for c in shown if holds(c)], found.objective)
    if not best:
        return "No contender holds the constraint."
    parts = [
        f"{c.label} ({objective_value(found, c.merits)} for {merit_value(EFFORT, c.merits[EFFORT], scenario)})" for c in best
    ]
    text = f"Nobody is better in both {merit_words(found.objective)} and effort than {', '.join(parts)}"
    lost = [c.label for c in shown if not holds(c)]
    text += f"; hollow: the constraint is not held, here or at finer numerics ({', '.join(lost)})" if lost else ""
    return f"{text}. Bars go to the value at finer numerics."
