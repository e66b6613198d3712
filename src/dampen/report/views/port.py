"""The motion of a port over all trials, against what it is to follow, its constraint and the run without control."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from dampen.report.axes import constraint, legend_row, note_peak, panel, sheet, time_axis, value_axis, value_range
from dampen.report.joined import extremes, gapped, uncontrolled
from dampen.report.limits import limits_of
from dampen.report.motion import port_in_words
from dampen.report.names import port_names, tracked
from dampen.report.style import DASHES, REFERENCE, UNCONTROLLED, colour, quantity
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
    return figure, port_in_words(run, of, behind)
