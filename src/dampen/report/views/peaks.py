"""How a field's largest value falls from trial to trial."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from dampen.report.axes import legend_row, log_axis, panel, sheet, value_axis
from dampen.report.joined import uncontrolled
from dampen.report.names import course, field_unit
from dampen.report.style import INK, SMALL, UNCONTROLLED, colour, percent, quantity, symbol
from dampen.report.views.field import field_peaks
from dampen.simulation.result import Result

SETTLED = 0.03
MARKED = 60


def draw_peaks(of: str, run: Result, other: Result | None) -> tuple[Figure, str]:
    """Largest |field| of each trial on a log axis, with the line at 3 % of trial 0's."""
    unit, peaks = field_unit(run, of), field_peaks(run, of)
    behind = None if uncontrolled(run) else other
    figure = sheet()
    axes = panel(figure, top=0.3)
    trials, few = np.arange(run.trials), run.trials <= MARKED
    handles = []
    if behind is not None:
        grey = field_peaks(behind, of)
        style: dict[str, Any] = {
            "color": UNCONTROLLED,
            "marker": "s" if few else "",
            "ms": 2.8,
            "mfc": "white",
            "mew": 0.7,
            "lw": 0.7,
        }
        handles += axes.plot(np.arange(len(grey)), _positive(grey), label="no control", zorder=2, **style)
    ink, name = (UNCONTROLLED, "no control") if uncontrolled(run) else (colour(unit), "with control")
    handles = (
        axes.plot(trials, _positive(peaks), color=ink, marker="o" if few else "", ms=3.2, lw=0.9, label=name, zorder=3) + handles
    )
    handles.append(axes.axhline(SETTLED * peaks[0], color=INK, lw=0.7, ls=":", label="3 % of trial 0", zorder=1))
    axes.set_xlabel("trial")
    axes.xaxis.set_major_locator(MaxNLocator(6, integer=True, steps=[1, 2, 5, 10]))
    pad = max(0.5, 0.03 * run.trials)
    axes.set_xlim(-pad, max(run.trials - 1, 1) + pad)
    words = f"largest $|${symbol(of, 'x, t')}$|$".replace("$$", "")
    everything = np.concatenate([peaks, SETTLED * peaks[:1], *([] if behind is None else [field_peaks(behind, of)])])
    if peaks.max() > 0:
        log_axis(axes, f"{words} [{unit}]", 0.4 * everything[everything > 0].min(), 1.7 * everything.max())
    else:
        value_axis(axes, words, unit)
    _note_ends(axes, peaks, unit, ink)
    legend_row(figure, handles)
    return figure, _sentence(of, unit, run, behind, peaks)


def _positive(values: np.ndarray) -> np.ndarray:
    """What a log axis can show."""
    return np.where(values > 0, values, np.nan)


def _note_ends(axes: Axes, peaks: np.ndarray, unit: str, ink: str) -> None:
    """The values of the first and the last trial."""
    ends = [(0, "left", (9, -17))] + ([(len(peaks) - 1, "right", (3, -10))] if len(peaks) > 2 else [])
    for j, side, shift in ends:
        if peaks[j] > 0:
            text = quantity(peaks[j], unit)
            box = {"boxstyle": "square,pad=0.1", "fc": "white", "ec": "none", "alpha": 0.85}
            axes.annotate(text, (j, peaks[j]), shift, textcoords="offset points", ha=side, fontsize=SMALL, color=ink, bbox=box)


def _sentence(of: str, unit: str, run: Result, behind: Result | None, peaks: np.ndarray) -> str:
    name, last = f"The largest |{of}(x, t)|", run.trials - 1
    if run.trials == 1:
        return f"{name} is {quantity(peaks[0], unit)} in the only trial."
    text = f"{name}{course(peaks, unit, ' of a trial')}"
    if peaks[0] > 0:
        above = np.flatnonzero(peaks >= SETTLED * peaks[0])[-1]
        text += f", {percent(peaks[-1] / peaks[0])} of it"
        text += f"; it stays below 3 % from trial {above + 1} on" if above < last else "; it is not below 3 % at the end"
    if behind is not None:
        text += f". Without control it is {quantity(field_peaks(behind, of)[-1], unit)} in trial {behind.trials - 1}"
    return text + "."
