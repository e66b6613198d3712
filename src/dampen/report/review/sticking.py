"""Where the energy stays: the structure's energy along the run, and the times in which all driven ports stick."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter
from matplotlib.transforms import blended_transform_factory

from dampen.analysis.audit.sticking import Sticking
from dampen.report.axes import legend_row, log_axis, panel, sheet, time_axis
from dampen.report.joined import extremes
from dampen.report.style import DISPLACEMENT, DOUBLE, FAINT, INK, LEARNED, ROTATION, SMALL, percent, quantity
from dampen.simulation.result import Result

BAND = 0.055  # of the panel's height, for each port's row of sticks
DECADES = 6.0
FINEST = 1000  # columns of time in which sticks are drawn


def draw_sticking(run: Result, found: Sticking) -> tuple[Figure, str]:
    """Energy on a log axis; below it a row for each driven port, dark where it sticks; per trial what is kept while all stick."""
    figure = sheet(DOUBLE, 2.5)
    axes = panel(figure, left=0.72)
    time_axis(axes, run)
    t, energy = extremes(run, "energy")
    handles = axes.plot(t, np.where(energy > 0, energy, np.nan), color=INK, lw=0.8, label="energy of the structure", zorder=3)
    middle = (np.arange(run.trials) + 0.5) * run.scenario.task.trial_duration
    kept = np.array([np.nan if value is None else value for value in found.kept_by_trial])
    style: dict[str, Any] = {"marker": "o", "ms": 3.2, "mfc": "white", "ls": "none", "color": LEARNED, "zorder": 4}
    handles += axes.plot(middle, kept, label="kept while all ports stick, mean of a trial", **style)
    high = 2 * float(energy.max())
    low = max(float(energy[energy > 0].min()), high / 2 * 10**-DECADES) / 1.5
    rows = len(found.ports) + 0.6
    floor = low / (high / low) ** (BAND * rows / (1 - BAND * rows))
    log_axis(axes, "energy [J]", floor, high)
    written = axes.yaxis.get_major_formatter()
    axes.yaxis.set_major_formatter(FuncFormatter(lambda y, i: written(y, i) if y > low else ""))  # clear of the rows
    draw_sticks(axes, run, found)
    legend_row(figure, handles)
    return figure, sentence(found)


def draw_sticks(axes: Axes, run: Result, found: Sticking) -> None:
    """A row at the bottom for each driven port, filled where it sticks: in columns of time, for more than half of one."""
    below = blended_transform_factory(axes.transData, axes.transAxes)
    dt = run.scenario.numerics.step
    names = list(run.scenario.ports)
    units = dict(zip(names, run.layout.coordinates["motion_unit"][1], strict=True))
    for row, port in enumerate(reversed(found.ports)):
        p = names.index(port)
        stuck = np.concatenate([np.asarray(run["v"][j])[:, p] == 0 for j in range(run.trials)])
        width = max(1, len(stuck) // FINEST)
        columns = stuck[: len(stuck) // width * width].reshape(-1, width).mean(axis=1) > 0.5
        edges = width * np.flatnonzero(np.diff(np.concatenate([[0], columns.astype(int), [0]])))
        spans = [(begin * dt, (end - begin) * dt) for begin, end in zip(edges[::2], edges[1::2], strict=True)]
        ink = ROTATION if units[port] == "rad" else DISPLACEMENT
        axes.broken_barh(spans, (BAND * (row + 0.2), BAND * 0.75), facecolors=ink, lw=0, transform=below, zorder=2)
        place = (0, BAND * (row + 0.575))
        axes.annotate(f"{port} sticks", place, (-3, 0), below, "offset points", ha="right", va="center", fontsize=5.5, color=ink)
    axes.axhline(axes.get_ylim()[0], color=FAINT, lw=0.4)
    axes.tick_params(axis="y", labelsize=SMALL)


def sentence(found: Sticking) -> str:
    """What the figure shows, in numbers."""
    text = f"In the last five trials all driven ports stick {percent(found.together)} of the time"
    kept = [value for value in found.kept_by_trial[-5:] if value is not None]
    text += f", with {quantity(sum(kept) / len(kept), 'J')} in the structure" if kept else ""
    offs = [
        f"{port} stands {quantity(offset, unit)} off (RMS {quantity(rms, unit)})"
        for port, offset, rms, (unit, _) in zip(found.ports, found.offset, found.rms, found.units, strict=True)
    ]
    return f"{text}; in the mean {', '.join(offs)}."
