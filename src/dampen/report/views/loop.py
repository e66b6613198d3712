"""Delivered force against command: what play, hysteresis, dead zone, lag and saturation do, the ideal line behind."""

from __future__ import annotations

from math import prod
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dampen.report.axes import BOTTOM, LEFT, label_axis, legend_row, panel, sheet
from dampen.report.joined import blocks
from dampen.report.names import PortNames, port_names
from dampen.report.style import DOUBLE, INK, LEARNED, MINUS, colour, percent, quantity
from dampen.simulation.result import Result

Pair = tuple[np.ndarray, np.ndarray]
DRAWN, DOTTED = 1500, 300
SIDE = 2.2
IDEAL = "#C4C4C4"


def draw_loop(of: str, run: Result, other: Result | None) -> tuple[Figure, str]:
    """The loop at the port `of` in the last trial, and beside it how far it and the first one are from the ideal line."""
    port, last = port_names(run, of), run.trials - 1
    slope, ink = gain(run, port.index), colour(port.effort)
    figure = sheet(DOUBLE, SIDE + BOTTOM + 0.3)
    whole = panel(figure, right=DOUBLE / 2 + 0.1, top=0.3)
    beside = panel(figure, left=DOUBLE / 2 + LEFT + 0.05, top=0.3)
    pairs = {j: loop(run, j, port.index) for j in sorted({0, last})}
    command, delivered = pairs[last]
    ideal = _ideal(whole, run, port.index, 2 * np.array([command.min(), command.max()]))
    handles: list[Any] = []
    for j, (given, got) in pairs.items():
        style: dict[str, Any] = {
            "color": LEARNED if j else ink,
            "lw": 0.5 if j else 0.7,
            "label": f"trial {j}",
            "zorder": 2 + (j > 0),
        }
        handles += beside.plot(*_cloud(given, got - slope * given), marker="o", ms=1.2, mew=0, **(style | {"ls": "none"}))
        if j == last:
            whole.plot(*thinned(given, got), **style)
    beside.axhline(0, color=IDEAL, lw=3, zorder=1)
    whole.set_xlim(*_margins(command))
    whole.set_ylim(*_margins(delivered))
    _axes_words(whole, port)
    _axes_words(beside, port, f"delivered {MINUS} no play")
    legend_row(figure, handles + ideal)
    return figure, _sentence(port, run)


def both_loops(axes: Axes, port: PortNames, run: Result, ink: str) -> list[Any]:
    """The loops of the first and of the last trial on top of each other, with the ideal line; returns the legend's handles."""
    last = run.trials - 1
    first, final = loop(run, 0, port.index), loop(run, last, port.index)
    ends = 2 * np.array([min(first[0].min(), final[0].min()), max(first[0].max(), final[0].max())])
    ideal = _ideal(axes, run, port.index, ends)
    handles = axes.plot(*thinned(*first), color=ink, lw=0.7, label="trial 0", zorder=2)
    if last:
        handles += axes.plot(*thinned(*final), color=LEARNED, lw=0.5, label=f"trial {last}", zorder=3)
    _around(axes, first, final)
    _axes_words(axes, port)
    return handles + ideal


def loop(run: Result, trial: int, index: int) -> Pair:
    """Command and delivered force of a trial, (steps,) each."""
    command, delivered = (np.asarray(run[name][trial])[:, index] for name in ("command", "delivered"))
    return command, delivered


def gain(run: Result, index: int) -> float:
    """Slope of the delivered force against the law's value in full motion: the actuator without its play."""
    return float(prod(stage.gain for stage in run.scenario.chain(index)))


def departure(run: Result, index: int) -> float:
    """Largest distance of the delivered force from the ideal actuator's over the run [N, N m]."""
    slope, off = gain(run, index), 0.0
    for (_, given), (_, got) in zip(blocks(run, "command", index), blocks(run, "delivered", index), strict=True):
        off = max(off, float(np.abs(got - slope * given).max()))
    return off


def _ideal(axes: Axes, run: Result, index: int, ends: np.ndarray) -> list[Any]:
    slope = gain(run, index)
    return axes.plot(ends, slope * ends, color=IDEAL, lw=3, label=f"no play, slope {slope:.3g}", zorder=1)


def _axes_words(axes: Axes, port: PortNames, words: str = "delivered") -> None:
    axes.axhline(0, color=INK, lw=0.3, zorder=0)
    axes.axvline(0, color=INK, lw=0.3, zorder=0)
    axes.locator_params(nbins=5)
    label_axis(axes.xaxis, "command", port.effort)
    label_axis(axes.yaxis, words, port.effort)
    axes.yaxis.labelpad = 1


def _margins(values: np.ndarray) -> tuple[float, float]:
    low, high = float(values.min()), float(values.max())
    margin = 0.06 * (high - low) or 1.0
    return low - margin, high + margin


def _around(axes: Axes, first: Pair, final: Pair) -> None:
    """Both loops; where the last would be lost in the first's range, its surroundings, and the first is cut there."""
    limits = []
    for wide, narrow in zip(first, final, strict=True):
        low, high = float(narrow.min()), float(narrow.max())
        margin = 0.35 * (high - low)
        if not 0 < 2 * (high - low) < np.ptp(wide):
            low, high = min(low, float(wide.min())), max(high, float(wide.max()))
            margin = 0.06 * (high - low) or 1.0
        limits.append((low - margin, high + margin))
    axes.set_xlim(limits[0])
    axes.set_ylim(limits[1])


def thinned(x: np.ndarray, y: np.ndarray) -> Pair:
    """The path without the points at which nothing moved by a visible amount."""
    cells = np.round([values * (DRAWN / (float(np.ptp(values)) or 1.0)) for values in (x, y)])
    moved = np.concatenate([[True], np.any(np.diff(cells, axis=1) != 0, axis=0)])
    moved[-1] = True
    return x[moved], y[moved]


def _cloud(x: np.ndarray, y: np.ndarray) -> Pair:
    """The points without those that would fall on each other."""
    cells = np.round([values * (DOTTED / (float(np.ptp(values)) or 1.0)) for values in (x, y)])
    kept = np.unique(cells, axis=1, return_index=True)[1]
    return x[kept], y[kept]


def _sentence(port: PortNames, run: Result) -> str:
    last = run.trials - 1
    most = quantity(departure(run, port.index), port.effort)
    text = f"The {port.effort_words} differs from the actuator's without play by {most} at most"
    command, delivered = loop(run, last, port.index)
    kind = port.effort_words.removeprefix("delivered ")
    reach, off = float(np.abs(delivered).max()), float(np.abs(delivered - gain(run, port.index) * command).max())
    if reach > 0:
        text += f"; in trial {last} by {quantity(off, port.effort)}, {percent(off / reach)} of the largest {kind} there"
    return text + "."
