"""How long a controller in the loop took: the share of its answers that took longer than a time, against that time."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from dampen.report.axes import panel, sheet
from dampen.report.figures import save_all
from dampen.report.style import CONSTRAINT, DASHES, DISPLACEMENT, number

Array = np.ndarray
UNIT = 1e6  # microseconds


def draw_exchange_times(trips: Array, period: float, folder: Path) -> dict[str, Path]:
    """Write folder/exchanges.png and .svg; trips (samples,) and the sample period [s]. Returns the files by kind."""
    [(_, _, files)] = save_all([("exchanges", partial(exchange_times, trips, period))], folder)
    return files


def exchange_times(trips: Array, period: float) -> tuple[Figure, str]:
    """The figure, and what it shows."""
    took, share = np.sort(trips) * UNIT, np.arange(len(trips), 0, -1) / len(trips)
    figure = sheet()
    axes = panel(figure, top=0.12)
    axes.loglog(took, share, color=DISPLACEMENT, drawstyle="steps-post", label="answers")
    axes.axvline(period * UNIT, color=CONSTRAINT, linestyle=DASHES, label="sample period")
    axes.set_xlabel("round trip [µs]")
    axes.set_ylabel("share that took longer")
    axes.legend(frameon=False, loc="lower left")
    late = int((trips > period).sum())
    return figure, f"Of {number(len(trips))} answers {late:,} took longer than the sample period."
