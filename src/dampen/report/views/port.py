"""The motion of a port over all trials, against what it is to follow, its constraint and the run without control."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from dampen.analysis.metrics import error_peaks, first_beyond, fraction_of_limit
from dampen.report.axes import constraint, legend_row, note_peak, panel, sheet, time_axis, value_axis, value_range
from dampen.report.joined import extremes, gapped, trial_peaks, uncontrolled
from dampen.report.limits import limits_of
from dampen.report.names import PortNames, course, port_names, tracked
from dampen.report.style import DASHES, MINUS, REFERENCE, UNCONTROLLED, colour, percent, quantity, ranges
from dampen.simulation.result import Result


def draw_port(of: str, run: Result, other: Result | None) -> tuple[Figure, str]:
    """y(t) at the port `of`; the other run in grey behind it, unless this is the run without control."""
    port, limits, follows = port_names(run, of), limits_of(run.scenario, of), tracked(run, of)
    behind = None if uncontrolled(run) else other
    ink = UNCONTROLLED if uncontrolled(run) else colour(port.motion)
    figure = sheet()
    axes = panel(figure)
    time_axis(axes, run)
    t, y = extremes(run, "y", port.index)
    handles = axes.plot(
        *gapped(run, t, y), color=ink, lw=0.8, label="no control" if uncontrolled(run) else "with control", zorder=3
    )
    contents = [y]
    if behind is not None:
        t_grey, y_grey = extremes(behind, "y", port.index)
        style: dict[str, Any] = {"color": UNCONTROLLED, "lw": 0.6, "alpha": 0.75, "label": "no control", "zorder": 2}
        handles += axes.plot(*gapped(behind, t_grey, y_grey), **style)
        contents.append(y_grey)
    if follows:
        t_ref, wanted = extremes(run, "reference", port.index)
        dashed: dict[str, Any] = {"color": REFERENCE, "lw": 0.7, "ls": DASHES, "label": "reference", "zorder": 4}
        handles += axes.plot(*gapped(run, t_ref, wanted), **dashed)
        contents.append(wanted)
    curves = None if limits is None else limits.curves(run)
    level = not follows and (limits is None or (limits.symmetric and limits.fixed))
    low, high, limited = value_range(contents, [values for _, values in curves or ()], level)
    margin = 0.17 * (high - low)
    axes.set_ylim(low - margin, high + margin)
    value_axis(axes, port.label, port.motion)
    if limited and limits is not None and curves is not None:
        handles.append(constraint(axes, *curves, limits.label))
    if not follows:
        k = int(np.abs(y).argmax())
        height = high + margin / 2 if y[k] > 0 else low - margin / 2
        note_peak(axes, float(t[k]), float(y[k]), f"peak {quantity(float(y[k]), port.motion)}", ink, height)
    if len(handles) > 1:
        legend_row(figure, handles)
    return figure, _sentence(port, run, behind, of)


def _sentence(port: PortNames, run: Result, behind: Result | None, of: str) -> str:
    limits, follows = limits_of(run.scenario, of), tracked(run, of)
    peaks = error_peaks(run, of) if follows else trial_peaks(run, "y", port.index)
    text = f"The largest error |{port.text} {MINUS} reference|" if follows else f"The largest |{port.text}|"
    if run.trials == 1:
        text += f" is {quantity(peaks[0], port.motion)} in the only trial"
    else:
        text += course(peaks, port.motion, " of a trial")
    if limits is not None:
        text += f"; {limits.words} {against(run, of)}"
    if behind is not None:
        grey = error_peaks(behind, of) if follows else trial_peaks(behind, "y", port.index)
        text += f". Without control it is {quantity(grey[-1], port.motion)} in trial {behind.trials - 1}"
        text += f", and {quantity(grey.max(), port.motion)} at its largest"
    return text + "."


def against(run: Result, of: str) -> str:
    """What became of the constraint: kept with what margin, or broken when and by how much."""
    shares, beyond = fraction_of_limit(run, of), first_beyond(run, of)
    if beyond is None:
        return f"is never reached, the margin is {percent(1 - shares.max())}"
    broken = np.flatnonzero(shares >= 1)
    when = f"trial {broken[0]}" if len(broken) == 1 else f"{len(broken)} of {len(shares)} trials"
    which = f" ({ranges(broken.tolist())})" if 1 < len(broken) < len(shares) else ""
    trial, t = beyond
    at = f"first at t = {t + trial * float(run.scenario.task.trial_duration):.4g} s"
    return f"is broken in {when}{which}, {at}, by {percent(shares.max() - 1)} at most"
