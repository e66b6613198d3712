"""A field over all trials: a heat map of space against time, which hides nothing behind a crest as a mesh would."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dampen.report.axes import label_axis, panel, sheet, time_axis, value_axis
from dampen.report.joined import duration, field_columns, largest
from dampen.report.names import field_unit
from dampen.report.style import DIVERGING, FAINT, SINGLE, percent, quantity, symbol
from dampen.simulation.result import Result

BAR = 0.82


def draw_field(of: str, run: Result, other: Result | None) -> tuple[Figure, str]:
    """The field `of`, colours centred on zero and alike for this run and the `other`.

    Where it is soon gone, a panel on the left shows the first trials larger.
    """
    unit, peaks = field_unit(run, of), field_peaks(run, of)
    limit = max(field_peaks(r, of).max() for r in (run, other) if r is not None) or 1.0
    front = settling(peaks)
    figure = sheet()
    if front:
        early = panel(figure, left=0.52, right=SINGLE - 0.52 - 0.9, top=0.3)
        _heat_map(early, of, run, front, limit)
        axes = panel(figure, left=0.52 + 0.9 + 0.16, right=BAR, top=0.3)
        axes.tick_params(labelleft=False)
    else:
        axes = early = panel(figure, left=0.52, right=BAR, top=0.3)
    _heat_map(axes, of, run, run.trials, limit)
    label_axis(early.yaxis, f"position {symbol('x')}", "m")
    _colour_bar(figure, limit, symbol(of, "x, t"), unit)
    return figure, _sentence(of, unit, run, other, limit)


def _heat_map(axes: Axes, of: str, run: Result, trials: int, limit: float) -> None:
    """The first `trials` of a run."""
    time_axis(axes, run, trials)
    low, high = float(run.x[0]), float(run.x[-1])
    axes.set_yticks(np.linspace(low, high, 5))
    axes.spines["right"].set_visible(True)
    axes.spines["right"].set_color(FAINT)
    axes.imshow(
        field_columns(run, of, trials).T, origin="lower", aspect="auto", extent=(0, duration(run) * trials, low, high),
        cmap=DIVERGING, vmin=-limit, vmax=limit, interpolation="nearest",
    )  # fmt: skip


def _colour_bar(figure: Figure, limit: float, words: str, unit: str) -> None:
    """The scale of colours: a strip of an image, a third of the time that matplotlib's own takes."""
    axes = panel(figure, left=SINGLE - BAR + 0.1, right=BAR - 0.2, top=0.3)
    ramp = np.linspace(-1, 1, 256)[:, None]
    axes.imshow(ramp, origin="lower", aspect="auto", extent=(0, 1, -limit, limit), cmap=DIVERGING, interpolation="nearest")
    axes.spines[["top", "right"]].set_visible(True)
    axes.spines[:].set_linewidth(0.5)
    axes.set_xticks([])
    axes.yaxis.tick_right()
    axes.yaxis.set_label_position("right")
    axes.tick_params(width=0.5, length=2)
    value_axis(axes, words, unit, steps=(1, 2, 5, 10))
    axes.yaxis.labelpad = 2


def settling(peaks: np.ndarray) -> int:
    """How many first trials show a field die: up to the first with less than a tenth; 0 if that is not early in the run."""
    small = np.flatnonzero(peaks < 0.1 * peaks[0])
    front = int(small[0]) + 1 if len(small) else 0
    return front if 4 * front <= len(peaks) else 0


def field_peaks(run: Result, of: str) -> np.ndarray:
    """(trials,) largest modulus of the field `of` in each trial, ports at every step included."""
    index = list(run.layout.coordinates["field"][1]).index(of)
    return np.asarray(run["peak"][: run.trials])[:, index].astype(float)


def _sentence(of: str, unit: str, run: Result, other: Result | None, limit: float) -> str:
    value, trial, t, x = largest(run, of)
    peaks = field_peaks(run, of)
    where = f"at x = {x:.3g} m and t = {t:.4g} s (trial {trial})"
    if peaks.max() > value * (1 + 1e-6):  # ports are seen at every step, the rest in snapshots
        value, where = float(peaks.max()), f"at a port, between snapshots, in trial {int(peaks.argmax())}"
    text = f"The largest |{of}(x, t)| is {quantity(value, unit)}, {where}"
    if run.trials > 1:
        text += f"; in the last trial it is {quantity(peaks[-1], unit)}, {percent(peaks[-1] / (peaks[0] or 1.0))} of trial 0's"
    scale = " in both runs" if other is not None else ""
    return f"{text}. The colours end at ±{quantity(limit, unit)}{scale}."
