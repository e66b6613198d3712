"""Parts that several figures share: the sheet, the trial axis on top, the constraint, the note at a peak, the legend row."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter
from matplotlib.transforms import blended_transform_factory

from dampen.report.joined import duration
from dampen.report.style import CONSTRAINT, FAINT, HEIGHT, INK, SINGLE, SMALL, plain_number, ten_to
from dampen.simulation.result import Result

LEFT, RIGHT, BOTTOM, TOP = 0.62, 0.12, 0.42, 0.42
TICKS = 60
FAR = 4.0
Curve = tuple[np.ndarray, np.ndarray]


def sheet(width: float = SINGLE, height: float = HEIGHT) -> Figure:
    """An empty figure of a paper's size [in]."""
    return Figure(figsize=(width, height))


def panel(figure: Figure, left: float = LEFT, right: float = RIGHT, bottom: float = BOTTOM, top: float = TOP) -> Axes:
    """Axes with these margins [in] from the sheet's edges."""
    width, height = figure.get_size_inches()
    box = (left / width, bottom / height, (width - left - right) / width, (height - bottom - top) / height)
    axes = figure.add_axes(box)
    axes.spines[["top", "right"]].set_visible(False)
    return axes


def time_axis(axes: Axes, run: Result, trials: int | None = None) -> None:
    """Time of the first `trials` (default: all) below, trial boundaries as faint ticks on top, some with the trial's number."""
    trials = trials or run.trials
    width = axes.get_window_extent().width / axes.figure.dpi
    axes.set_xlim(0, duration(run) * trials)
    label_axis(axes.xaxis, "time", "s")
    axes.xaxis.set_major_locator(MaxNLocator(int(max(3, min(6, 2.5 * width))), steps=[1, 2, 2.5, 5, 10]))
    axes.spines["top"].set_visible(True)
    axes.spines["top"].set_color(FAINT)
    stride = next(s for s in nice_strides() if trials <= TICKS * s)
    above = blended_transform_factory(axes.transData, axes.transAxes)
    starts = duration(run) * np.arange(0, trials + 1, stride)
    axes.plot(starts, np.ones_like(starts), marker=2, ms=2.5, mew=0.5, color=FAINT, ls="none", transform=above, clip_on=False)
    labelled = next(s for s in nice_strides() if trials <= max(2, 2.4 * width) * s)
    for j in range(0, trials, labelled):
        text, place = (f"trial {j}", "left") if j == 0 else (str(j), "center")
        axes.annotate(text, (j * duration(run), 1), (0, 4), above, "offset points", ha=place, fontsize=6, color="#666666")


def nice_strides() -> Sequence[int]:
    """1, 2, 5, 10, 20, 50, ..."""
    return [m * 10**k for k in range(9) for m in (1, 2, 5)]


def value_axis(axes: Axes, words: str, unit: str, steps: Sequence[float] = (1, 2, 2.5, 5, 10)) -> None:
    """A linear axis of values, its limits already set, with about five ticks at these multiples of powers of ten."""
    axes.yaxis.set_major_locator(MaxNLocator(5, steps=steps))
    label_axis(axes.yaxis, words, unit)


def label_axis(axis: Axis, words: str, unit: str) -> None:
    """Words and unit at a linear axis, its limits already set; in thousands(ths) where its numbers are very small or large."""
    reach = float(np.max(np.abs(axis.get_view_interval())))
    power = 3 * int(np.floor(np.log10(reach) / 3)) if reach < 0.02 or reach >= 2e4 else 0
    if power:
        axis.set_major_formatter(FuncFormatter(lambda number, _: plain_number(number / 10.0**power)))
        unit = f"{ten_to(power)} {unit}"
    axis.set_label_text(f"{words} [{unit}]")


def log_axis(axes: Axes, label: str, low: float, high: float) -> None:
    """A logarithmic axis of values from `low` to `high`; minor ticks while there are few decades, numbers between powers of
    ten where there is hardly one of them."""
    axes.set_yscale("log")
    axes.set_ylim(low, high)
    axes.set_ylabel(label)
    narrow = high < 30 * low
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if narrow else (1,), numticks=7))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda y, _: plain_number(y) if narrow else ten_to(round(np.log10(y)))))
    axes.yaxis.set_minor_locator(LogLocator(subs=range(2, 10) if high < 1e5 * low else (1.0,), numticks=60))
    axes.yaxis.set_minor_formatter(NullFormatter())


def constraint(axes: Axes, low: Curve, high: Curve, label: str) -> Any:
    """Lower and upper limit, each as times and values, as dashed lines with the forbidden side hatched; returns the legend's
    handle. The axes' limits must be set already."""
    bottom, top = axes.get_ylim()
    lines = []
    for (t, edge), end in ((high, top), (low, bottom)):
        inside = np.clip(edge, bottom, top)
        if np.any(inside != end):
            axes.fill_between(t, inside, end, facecolor="none", hatch="//////", ec=CONSTRAINT, lw=0, alpha=0.45, zorder=0)
            lines += axes.plot(t, edge, color=CONSTRAINT, ls=(0, (5, 3)), lw=0.8, zorder=2.5)
    lines[0].set_label(label)
    return lines[0]


def value_range(contents: Sequence[np.ndarray], edges: Sequence[np.ndarray], level: bool) -> tuple[float, float, bool]:
    """Least and greatest value to be drawn, and whether limits are among them: those far beyond all `contents` are not.

    level: as far below zero as above it.
    """
    low, high = _extent(contents)
    reach = FAR * max(abs(low), abs(high))
    near = [values for edge in edges if len(values := edge[np.abs(edge) <= reach])]
    low, high = _extent([*contents, *near])
    if level:
        low, high = -max(-low, high), max(-low, high)
    return (low, high, bool(near)) if low < high else (low - 1, high + 1, False)


def _extent(values: Sequence[np.ndarray]) -> tuple[float, float]:
    return min(float(np.nanmin(v)) for v in values), max(float(np.nanmax(v)) for v in values)


def note_peak(axes: Axes, t: float, y: float, text: str, colour: str, level: float) -> None:
    """A marker at a peak, and its value at the height `level`, above or below everything that is drawn."""
    left, right = axes.get_xlim()
    share = (t - left) / (right - left)
    side, shift = ("left", 4) if share < 0.3 else ("right", -4) if share > 0.7 else ("center", 0)
    side, shift = ("left", 4) if share < 0.02 else ("right", -4) if share > 0.98 else (side, 0)
    axes.plot([t], [y], marker="o", ms=3, mfc="white", mec=colour, mew=0.8, ls="none", zorder=5, clip_on=False)
    axes.annotate(
        text, (t, level), (shift, 0), textcoords="offset points", ha=side, va="center", fontsize=SMALL, color=INK, zorder=6,
        bbox={"boxstyle": "square,pad=0.15", "fc": "white", "ec": "none"},
    )  # fmt: skip


def legend_row(figure: Figure, handles: Sequence[Any], right: float = RIGHT) -> None:
    """The legend as one row along the sheet's upper edge, clear of all data; closer together where it would be too long."""
    width, height = figure.get_size_inches()
    letters = sum(len(str(handle.get_label())) for handle in handles)
    full = 0.043 * letters + 0.42 * len(handles) > width - 0.1
    close = {"fontsize": 6, "handlelength": 1.3, "handletextpad": 0.35, "columnspacing": 0.8}
    usual = {"handlelength": 1.8, "handletextpad": 0.5, "columnspacing": 1.2}
    corner = (1 - (right - 0.03) / width, 1 - 0.01 / height)
    figure.legend(
        handles=list(handles), loc="upper right", bbox_to_anchor=corner, ncols=len(handles),
        frameon=False, borderpad=0.1, borderaxespad=0.2, **(close if full else usual),
    )  # fmt: skip
