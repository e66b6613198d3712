"""How a port's tracking error falls from trial to trial: the learning curve."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from dampen.analysis.metrics import error_peaks, error_rms
from dampen.report.axes import legend_row, log_axis, panel, sheet, value_axis
from dampen.report.joined import uncontrolled
from dampen.report.names import PortNames, course, port_names, tracked
from dampen.report.style import DASHES, SMALL, UNCONTROLLED, colour, percent, quantity
from dampen.simulation.result import Result

MARKED = 60


def draw_error(of: str, run: Result, other: Result | None) -> tuple[Figure, str]:
    """RMS and peak of the error at the port `of` in each trial, on a log axis; the run without control in grey behind."""
    port = port_names(run, of)
    behind = None if uncontrolled(run) else other
    figure = sheet()
    axes = panel(figure, top=0.3)
    ink = UNCONTROLLED if uncontrolled(run) else colour(port.motion)
    rms, peaks = error_rms(run, of), error_peaks(run, of)
    handles = _curves(axes, rms, peaks, ink, "", 3)
    shown = [rms, peaks]
    if behind is not None:
        grey = error_rms(behind, of), error_peaks(behind, of)
        handles.append(_curves(axes, *grey, UNCONTROLLED, "no control", 2)[0])
        shown += grey
    axes.set_xlabel("trial")
    axes.xaxis.set_major_locator(MaxNLocator(6, integer=True, steps=[1, 2, 5, 10]))
    pad = max(0.5, 0.03 * run.trials)
    axes.set_xlim(-pad, max(run.trials - 1, 1) + pad)
    words = f"error of {port.math}".removesuffix(" of ") if tracked(run, of) else port.label
    everything = np.concatenate(shown)
    if np.any(everything > 0):
        log_axis(axes, f"{words} [{port.motion}]", 0.4 * everything[everything > 0].min(), 1.8 * everything.max())
    else:
        value_axis(axes, words, port.motion)
    if run.trials > 2 and rms[-1] > 0:
        text, box = quantity(rms[-1], port.motion), {"boxstyle": "square,pad=0.1", "fc": "white", "ec": "none", "alpha": 0.85}
        end, near = (run.trials - 1, rms[-1]), (3, -10)
        axes.annotate(text, end, near, textcoords="offset points", ha="right", fontsize=SMALL, color=ink, bbox=box)
    legend_row(figure, handles)
    return figure, _sentence(port, run, behind, of, rms, peaks)


def _curves(axes: Axes, rms: np.ndarray, peaks: np.ndarray, ink: str, name: str, order: int) -> list[Any]:
    """RMS as a full line, peak as a dashed one."""
    few = len(rms) <= MARKED
    trials, prefix = np.arange(len(rms)), f"{name}: " if name else ""
    style: dict[str, Any] = {"color": ink, "lw": 0.7 if name else 0.9, "mew": 0.7, "zorder": order}
    style |= {"mfc": "white" if name else ink}
    full = axes.plot(trials, _positive(rms), marker="o" if few else "", ms=3, label=name or "RMS", **style)
    style |= {"mfc": "white", "ls": DASHES}
    return full + axes.plot(trials, _positive(peaks), marker="^" if few else "", ms=3.2, label=f"{prefix}peak", **style)


def _positive(values: np.ndarray) -> np.ndarray:
    """What a log axis can show."""
    return np.where(values > 0, values, np.nan)


def _sentence(port: PortNames, run: Result, behind: Result | None, of: str, rms: np.ndarray, peaks: np.ndarray) -> str:
    what, unit, last = "error of " if tracked(run, of) else "", port.motion, run.trials - 1
    text = f"The RMS {what}{port.text}" if what else f"The RMS of {port.text}"
    if run.trials == 1:
        text += f" is {quantity(rms[0], unit)} in the only trial, its peak {quantity(peaks[0], unit)}"
    else:
        text += course(rms, unit, " over a trial")
        text += f", {percent(rms[-1] / rms[0])} of it" if rms[0] > 0 else ""
        text += f"; the peak{course(peaks, unit)}"
        if np.all(np.diff(rms) <= 0) and rms[-1] < rms[0]:
            text += "; the RMS rises in no trial"
        elif (best := int(np.argmin(rms))) != last:
            text += f"; the RMS is least in trial {best}, {quantity(rms[best], unit)}"
    if behind is not None:
        grey = error_rms(behind, of)
        text += f". Without control the RMS is {quantity(grey[-1], unit)} in trial {behind.trials - 1}"
    return text + "."
