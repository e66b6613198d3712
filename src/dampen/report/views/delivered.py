"""What the actuator of a port delivers over all trials, and its loop against the command."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from dampen.report.axes import legend_row, note_peak, panel, sheet, time_axis, value_axis
from dampen.report.joined import extremes, trial_peaks
from dampen.report.names import PortNames, course, port_names
from dampen.report.style import DOUBLE, colour, number, quantity
from dampen.report.views.loop import both_loops, departure, gain
from dampen.simulation.result import Result

LOOP = 2.35


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
    beside = panel(figure, left=DOUBLE - LOOP + 0.45)
    legend_row(figure, both_loops(beside, port, run, ink))
    return figure, _sentence(port, run, force)


def _sentence(port: PortNames, run: Result, force: np.ndarray) -> str:
    peaks, unit, last = trial_peaks(run, "delivered", port.index), port.effort, run.trials - 1
    name = f"The {port.effort_words}"
    if not np.any(force):
        return f"{name} is zero."
    text = f"{name} stays between {number(float(force.min()))} and {quantity(float(force.max()), unit)}"
    if last:
        text += f"; its largest modulus{course(peaks, unit)}"
    slope, off = number(gain(run, port.index)), quantity(departure(run, port.index), unit)
    return f"{text}. Without play or limits it would be {slope} times the command, from which it differs by {off} at most."
