"""What the actuator of a port delivers over all trials, and its loop against the command."""

from __future__ import annotations

from math import prod

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dampen.report.axes import legend_row, note_peak, panel, sheet, time_axis, value_axis
from dampen.report.joined import blocks, extremes, trial_peaks
from dampen.report.names import PortNames, port_names, trend
from dampen.report.style import DOUBLE, INK, LEARNED, colour, number, plain_number, quantity
from dampen.simulation.result import Result

LOOP = 2.35
DRAWN = 1500


def draw_delivered(of: str, run: Result, other: Result | None) -> tuple[Figure, str]:
    """Delivered force at the port `of` over time, and beside it the loop command-delivered of the first and last trial."""
    port = port_names(run, of)
    ink = colour(port.effort)
    figure = sheet(DOUBLE)
    axes = panel(figure, right=LOOP + 0.25)
    time_axis(axes, run)
    t, force = extremes(run, "delivered", port.index)
    axes.plot(t, force, color=ink, lw=0.7)
    low, high = min(float(force.min()), 0.0), max(float(force.max()), 0.0)
    margin = 0.16 * (high - low) or 1.0
    axes.set_ylim(low - margin, high + margin)
    value_axis(axes, port.effort_words, port.effort)
    k = int(np.abs(force).argmax())
    level = high + margin / 2 if force[k] > 0 else low - margin / 2
    note_peak(axes, float(t[k]), float(force[k]), f"peak {quantity(float(force[k]), port.effort)}", ink, level)
    _loop(figure, port, run, ink)
    return figure, _sentence(port, run, force)


def gain(run: Result, index: int) -> float:
    """Slope of the delivered force against the law's value in full motion: the actuator without its play."""
    return float(prod(stage.gain for stage in run.scenario.chain(index)))


def _loop(figure: Figure, port: PortNames, run: Result, ink: str) -> None:
    """Command against delivered force, with the ideal line behind."""
    axes = panel(figure, left=DOUBLE - LOOP + 0.45)
    slope, last = gain(run, port.index), run.trials - 1
    first = [np.asarray(run[name][0])[:, port.index] for name in ("command", "delivered")]
    final = [np.asarray(run[name][last])[:, port.index] for name in ("command", "delivered")]
    ends = 2 * np.array([min(first[0].min(), final[0].min()), max(first[0].max(), final[0].max())])
    ideal = axes.plot(ends, slope * ends, color="#C4C4C4", lw=3, label=f"ideal, slope {plain_number(slope)}", zorder=1)
    handles = axes.plot(*thinned(*first), color=ink, lw=0.7, label="trial 0", zorder=2)
    if last:
        handles += axes.plot(*thinned(*final), color=LEARNED, lw=0.5, label=f"trial {last}", zorder=3)
    _around(axes, first, final)
    axes.set_xlabel(f"command [{port.effort}]")
    axes.set_ylabel(f"delivered [{port.effort}]", labelpad=1)
    axes.axhline(0, color=INK, lw=0.3, zorder=0)
    axes.axvline(0, color=INK, lw=0.3, zorder=0)
    axes.locator_params(nbins=5)
    legend_row(figure, handles + ideal)


def _around(axes: Axes, first: list[np.ndarray], final: list[np.ndarray]) -> None:
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


def thinned(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The path without the points at which nothing moved by a visible amount."""
    scale = max(float(np.ptp(x)), float(np.ptp(y))) / DRAWN or 1.0
    cells = np.round(np.stack([x, y]) / scale)
    moved = np.concatenate([[True], np.any(np.diff(cells, axis=1) != 0, axis=0)])
    moved[-1] = True
    return x[moved], y[moved]


def _sentence(port: PortNames, run: Result, force: np.ndarray) -> str:
    peaks, unit, last = trial_peaks(run, "delivered", port.index), port.effort, run.trials - 1
    name = f"The {port.effort_words}"
    if not np.any(force):
        return f"{name} is zero."
    text = f"{name} stays between {number(float(force.min()))} and {quantity(float(force.max()), unit)}"
    if last:
        verb = trend(peaks[0], peaks[-1])
        text += f"; its largest modulus {verb} from {quantity(peaks[0], unit)} in trial 0"
        text += f" to {quantity(peaks[-1], unit)} in trial {last}"
    slope, off = gain(run, port.index), 0.0
    for (_, given), (_, got) in zip(blocks(run, "command", port.index), blocks(run, "delivered", port.index), strict=True):
        off = max(off, float(np.abs(got - slope * given).max()))
    return f"{text}. It differs from the ideal actuator's by {quantity(off, unit)} at most."
