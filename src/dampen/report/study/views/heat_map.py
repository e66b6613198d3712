"""A merit over the two axes of a sweep, as a map."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes as Panel
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm, Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from dampen.report.axes import legend_row, panel, sheet
from dampen.report.study.axes import (
    best_row,
    is_listed,
    is_log,
    linear_ticks,
    log_ticks,
    merits_of,
    nominal,
    parameter_axis,
    positions,
    rows_words,
    where_words,
)
from dampen.report.study.names import axis_names, merit_label, merit_value, merit_words
from dampen.report.style import INK, SINGLE
from dampen.studies.rows import Array, statuses
from dampen.studies.study import Study
from dampen.studies.variation import Axis

HEIGHT = 2.9
BAR = 0.85  # in, from the map to the sheet's right edge
MANY = 2000
FLAT = 0.02  # values that differ by a smaller share than this are shown as alike


def draw_heat_map(study: Study, merit: str) -> tuple[Figure, str]:
    """Colour by the merit; lost cells hatched, those without a value crossed, the best ringed, the scenario's own a plus."""
    scenario, pair = study.definition.scenario, study.definition.axes
    names = axis_names(scenario, pair)
    figure = sheet(SINGLE, HEIGHT)
    axes = panel(figure, left=_left(pair[1]), right=BAR, top=0.3)
    for which, axis in zip("xy", pair, strict=True):
        parameter_axis(axes, axis, scenario, which, names[axis.name])
    grids, places = [_grid(axis) for axis in pair], [_cells(study, axis) for axis in pair]
    values = np.full((len(grids[1]), len(grids[0])), np.nan)
    values[places[1], places[0]] = merits_of(study, merit)
    edges = [_edges(grid, axis) for grid, axis in zip(grids, pair, strict=True)]
    _colours(figure, axes, edges, values, merit_label(merit, scenario))
    axes.set_xlim(edges[0][0], edges[0][-1])
    axes.set_ylim(edges[1][0], edges[1][-1])
    handles = _statuses(axes, study, grids, edges, places)
    best = best_row(study, merit)
    at = [np.array([nominal(scenario, axis)], dtype=float) for axis in pair]
    if all(edge[0] <= p[0] <= edge[-1] for edge, p in zip(edges, at, strict=True)):
        look: dict[str, Any] = {"ls": "none", "marker": "P", "ms": 6, "mfc": "white", "mec": INK, "mew": 0.6, "zorder": 7}
        handles += axes.plot(*at, label="scenario's own", **look)
    if best is not None:
        spot = [grid[place[best : best + 1]] for grid, place in zip(grids, places, strict=True)]
        axes.plot(*spot, ls="none", marker="o", ms=8, mfc="none", mec=INK, mew=2.4, zorder=5)
        handles += axes.plot(*spot, ls="none", marker="o", ms=8, mfc="none", mec="white", mew=1.1, zorder=6, label="best")
        handles[-1] = axes.plot([], [], ls="none", marker="o", ms=5.5, mfc="none", mec=INK, mew=1.1, label="best")[0]
    legend_row(figure, handles)
    return figure, _sentence(study, merit, best, names)


def _left(axis: Axis) -> float:
    """Room for the names of categories."""
    longest = max((len(str(value)) for value in axis.values), default=0) if is_listed(axis) else 0
    return min(1.25, 0.62 + 0.05 * max(0, longest - 5))


def _grid(axis: Axis) -> Array:
    """The axis's points in ascending order."""
    return np.arange(len(axis.values), dtype=float) if is_listed(axis) else np.unique(np.asarray(axis.values, dtype=float))


def _cells(study: Study, axis: Axis) -> Array:
    """(rows,) the number of each row's cell along an axis."""
    return np.abs(_grid(axis)[None, :] - positions(study, axis)[:, None]).argmin(axis=1)


def _edges(grid: Array, axis: Axis) -> Array:
    """Cells end half-way between points, on the axis's own scale."""
    if len(grid) == 1:
        return np.array([grid[0] - 0.5, grid[0] + 0.5])
    points = np.log(grid) if is_log(axis) and not is_listed(axis) else grid
    inner = (points[1:] + points[:-1]) / 2
    edges = np.concatenate([[2 * points[0] - inner[0]], inner, [2 * points[-1] - inner[-1]]])
    return np.exp(edges) if is_log(axis) and not is_listed(axis) else edges


def _colours(figure: Figure, axes: Panel, edges: list[Array], values: Array, label: str) -> None:
    """The map and its bar of colour; values far above the others, as of motions on the way to divergence, share one colour."""
    known = values[np.isfinite(values)]
    low, high = (float(known.min()), float(known.max())) if len(known) else (0.0, 1.0)
    log = low > 0 and high > 5 * low
    middle = float(np.median(known)) if len(known) else 0.0
    high = min(high, 30 * middle) if middle > 0 else high
    low = max(low, -1.0) if high > -1 else low  # a margin: what was allowed has been used twice
    lacking = max(FLAT * max(abs(low), abs(high)) - (high - low), 0.0)
    low, high = low - lacking / 2, high + lacking / 2
    norm = LogNorm(low, high) if log else Normalize(low, high if high > low else low + 1)
    drawn = axes.pcolormesh(*edges, np.ma.masked_invalid(values), cmap="cividis", norm=norm, rasterized=values.size > MANY)
    width = float(figure.get_size_inches()[0])
    box = axes.get_position()
    beside = figure.add_axes((box.x1 + 0.07 / width, box.y0, 0.1 / width, box.height))
    beyond = (bool((known < low).any()), bool((known > high).any()))
    extend = {(False, False): "neither", (True, False): "min", (False, True): "max", (True, True): "both"}[beyond]
    bar = figure.colorbar(drawn, cax=beside, extend=extend)
    bar.outline.set_linewidth(0.5)
    bar.set_label(label)
    if log:
        log_ticks(beside.yaxis, low, high, 5)
    else:
        linear_ticks(beside.yaxis, 5)


def _statuses(axes: Panel, study: Study, grids: list[Array], edges: list[Array], places: list[Array]) -> list[Any]:
    """Hatches over lost cells, crosses in those that diverged, dots in those that did not run; the legend's handles."""
    found = statuses(study)
    handles: list[Any] = []
    lost = found == "constraint_lost"
    if lost.any():
        cells = [_corners(edges, column, row) for column, row in zip(places[0][lost], places[1][lost], strict=True)]
        axes.add_collection(PolyCollection(cells, facecolors="none", edgecolors="white", hatch="//////", lw=0), autolim=False)
        handles.append(Patch(facecolor="#8a8a8a", edgecolor="white", hatch="/////", lw=0, label="lost"))
    size = float(np.clip(60.0 / max(len(grids[0]), len(grids[1])), 1.5, 6))
    for mine, marker, label in (
        (found == "diverged", "x", "diverged"),
        (np.isin(found, ("refused", "crashed")), ".", "refused"),
    ):
        if mine.any():
            spots = [grid[place[mine]] for grid, place in zip(grids, places, strict=True)]
            axes.plot(*spots, ls="none", marker=marker, ms=size, mew=0.7, color=INK, zorder=4)
            handles += axes.plot([], [], ls="none", marker=marker, ms=4, mew=0.8, color=INK, label=label)
    return handles


def _corners(edges: list[Array], column: int, row: int) -> Array:
    """(4, 2) of a cell."""
    (left, right), (low, high) = edges[0][column : column + 2], edges[1][row : row + 2]
    return np.array([[left, low], [right, low], [right, high], [left, high]])


def _sentence(study: Study, merit: str, best: int | None, names: dict[str, str]) -> str:
    scenario = study.definition.scenario
    if best is None:
        return f"No run held the constraint{rows_words(study)}."
    y = merits_of(study, merit)
    text = f"The {merit_words(merit)} is best, {merit_value(merit, y[best], scenario)}, at {where_words(study, best, names)}"
    held = y[(statuses(study) == "complete") & np.isfinite(y)]
    worst = held.max() if y[best] == held.min() else held.min()
    return f"{text}; where the constraint holds it is {merit_value(merit, worst, scenario)} at worst{rows_words(study)}."
