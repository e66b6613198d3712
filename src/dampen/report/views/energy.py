"""The energy of the structure and of the barrier over all trials."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from dampen.report.axes import legend_row, log_axis, panel, sheet, time_axis, value_axis
from dampen.report.joined import extremes, uncontrolled
from dampen.report.names import trend
from dampen.report.style import CONSTRAINT, DOUBLE, INK, UNCONTROLLED, number, quantity
from dampen.simulation.result import Result

DECADES = 6.0


def draw_energy(of: str, run: Result, other: Result | None) -> tuple[Figure, str]:
    """Energy of the structure, of the barrier (`of` is not used) and, in grey, of the run without control, on a log axis."""
    behind = None if uncontrolled(run) else other
    figure = sheet(DOUBLE)
    axes = panel(figure)
    time_axis(axes, run)
    t, energy = extremes(run, "energy")
    ink, name = (UNCONTROLLED, "structure, no control") if uncontrolled(run) else (INK, "structure")
    handles = axes.plot(t, _positive(energy), color=ink, lw=0.9, label=name, zorder=3)
    top, low = float(energy.max()), float(_positive(energy[1:]).min())
    t_barrier, barrier = extremes(run, "barrier_energy")
    if np.any(barrier > 0):
        handles += axes.plot(t_barrier, _positive(barrier), color=CONSTRAINT, lw=0.7, ls=(0, (4, 1)), label="barrier", zorder=2)
        top = max(top, float(barrier[np.isfinite(barrier)].max()))
    if behind is not None:
        t_grey, grey = extremes(behind, "energy")
        handles += axes.plot(t_grey, _positive(grey), color=UNCONTROLLED, lw=0.7, label="structure, no control", zorder=1)
        top = max(top, float(grey.max()))
    if top > 0:
        log_axis(axes, "energy [J]", max(top * 10**-DECADES, low / 10), top * 2)
    else:
        value_axis(axes, "energy", "J")
    legend_row(figure, handles)
    return figure, _sentence(run, energy, barrier)


def _positive(values: np.ndarray) -> np.ndarray:
    """What a log axis can show."""
    return np.where((values > 0) & np.isfinite(values), values, np.nan)


def _sentence(run: Result, energy: np.ndarray, barrier: np.ndarray) -> str:
    text = f"The energy of the structure {trend(energy[0], energy[-1])} from {quantity(energy[0], 'J')} at the start"
    text += f" to {quantity(energy[-1], 'J')} at the end; its largest value is {quantity(float(energy.max()), 'J')}"
    if np.any(barrier > 0):
        crossed = not np.all(np.isfinite(barrier))
        text += "; the barrier was crossed" if crossed else f", that of the barrier {number(float(barrier.max()))} J"
    return text + "."
