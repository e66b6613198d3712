"""The motion of a port over all trials, against its constraint and the run without control."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from dampen.report.axes import constraint, legend_row, note_peak, panel, sheet, time_axis, value_axis
from dampen.report.joined import extremes, trial_peaks, uncontrolled
from dampen.report.names import PortNames, port_names, trend
from dampen.report.style import UNCONTROLLED, colour, percent, plain_number, quantity, ranges
from dampen.simulation.result import Result

FAR = 4.0


def draw_port(of: str, run: Result, other: Result | None) -> tuple[Figure, str]:
    """y(t) at the port `of`; the other run in grey behind it, unless this is the run without control."""
    port = port_names(run, of)
    behind = None if uncontrolled(run) else other
    ink = UNCONTROLLED if uncontrolled(run) else colour(port.motion)
    figure = sheet()
    axes = panel(figure)
    time_axis(axes, run)
    t, y = extremes(run, "y", port.index)
    handles = axes.plot(t, y, color=ink, lw=0.8, label="no control" if uncontrolled(run) else "with control", zorder=3)
    top = float(np.abs(y).max())
    if behind is not None:
        t_grey, y_grey = extremes(behind, "y", port.index)
        handles += axes.plot(t_grey, y_grey, color=UNCONTROLLED, lw=0.6, alpha=0.75, label="no control", zorder=2)
        top = max(top, float(np.abs(y_grey).max()))
    limit = float(run.scenario.limits()[1][0, port.index])
    shown = limit <= FAR * top
    drawn = max(top, limit if shown else 0.0) or 1.0
    reach = 1.34 * drawn
    axes.set_ylim(-reach, reach)
    value_axis(axes, port.label, port.motion)
    if shown:
        handles.append(constraint(axes, limit, port.motion))
    k = int(np.abs(y).argmax())
    level = float(np.copysign((drawn + reach) / 2, y[k]))
    note_peak(axes, float(t[k]), float(y[k]), f"peak {quantity(float(y[k]), port.motion)}", ink, level)
    if len(handles) > 1:
        legend_row(figure, handles)
    return figure, _sentence(port, run, behind, limit, t, y)


def _sentence(port: PortNames, run: Result, behind: Result | None, limit: float, t: np.ndarray, y: np.ndarray) -> str:
    peaks = trial_peaks(run, "y", port.index)
    first, last = quantity(peaks[0], port.motion), quantity(peaks[-1], port.motion)
    text = f"The largest |{port.text}|"
    if run.trials == 1:
        text += f" is {first} in the only trial"
    elif (verb := trend(peaks[0], peaks[-1])) == "stays":
        text += f" is {first} in trial 0 and {last} in trial {run.trials - 1}"
    else:
        text += f" of a trial {verb} from {first} in trial 0 to {last} in trial {run.trials - 1}"
    if np.isfinite(limit):
        text += "; " + _against(limit, port.motion, peaks, t, y)
    if behind is not None:
        grey = trial_peaks(behind, "y", port.index)
        text += f". Without control it is {quantity(grey[-1], port.motion)} in trial {behind.trials - 1}"
        text += f", and {quantity(grey.max(), port.motion)} at its largest"
    return text + "."


def _against(limit: float, unit: str, peaks: np.ndarray, t: np.ndarray, y: np.ndarray) -> str:
    """The constraint, in words: kept with what margin, or broken when and by how much."""
    value = f"the constraint of {plain_number(limit)} {unit}"
    if peaks.max() < limit:
        return f"{value} is never reached, the margin is {percent(1 - peaks.max() / limit)}"
    broken = np.flatnonzero(peaks >= limit)
    when = f"trial {broken[0]}" if len(broken) == 1 else f"{len(broken)} of {len(peaks)} trials"
    which = f" ({ranges(broken.tolist())})" if 1 < len(broken) < len(peaks) else ""
    first = float(t[np.abs(y) >= limit][0])
    return f"{value} is broken in {when}{which}, first near t = {first:.4g} s, by {percent(peaks.max() / limit - 1)} at most"
