"""A port and what it is to follow, on the trial's own clock: first, middle and last trial, and their errors below."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from dampen.analysis.metrics import error_peaks, tracking_error
from dampen.report.axes import constraint, label_axis, legend_row, log_axis, panel, sheet, value_axis, value_range
from dampen.report.joined import duration, pick_extremes, uncontrolled
from dampen.report.limits import limits_of
from dampen.report.motion import against
from dampen.report.names import PortNames, course, port_names, tracked
from dampen.report.style import COLUMNS, DASHES, DOTS, INK, REFERENCE, SINGLE, UNCONTROLLED, colour, percent, quantity, tint
from dampen.simulation.result import Result

HEIGHT, LOWER = 3.4, 1.5
BINS = 60
STYLES: tuple[dict[str, Any], ...] = ({"ls": DOTS, "lw": 1.1}, {"ls": (0, (5, 1.2)), "lw": 0.8}, {"ls": "-", "lw": 0.9})


def draw_tracking(of: str, run: Result, other: Result | None) -> tuple[Figure, str]:
    """Reference and displacement of the port `of` in three trials, and below the error, on a log axis once it is learned."""
    port, limits = port_names(run, of), limits_of(run.scenario, of)
    ink = UNCONTROLLED if uncontrolled(run) else colour(port.motion)
    trials = sorted({0, (run.trials - 1) // 2, run.trials - 1})
    figure = sheet(SINGLE, HEIGHT)
    axes = panel(figure, bottom=LOWER + 0.3, top=0.28)
    below = panel(figure, top=HEIGHT - LOWER - 0.12)
    colours = dict(zip(trials, _shades(ink, len(trials)), strict=True))
    contents, lines = [], []
    for j in trials:
        y = np.asarray(run["y"][j])[:, port.index]
        contents.append(y)
        lines += axes.plot(*_thinned(run.time, y), color=colours[j], label=f"trial {j}", zorder=3, **_style(j, trials))
    handles = _references(axes, port, run, of, trials, contents) + lines
    last = run.trials - 1
    edges = () if limits is None else tuple(side[:, port.index] for side in run.scenario.limits(last))
    low, high, limited = value_range(contents, edges, False)
    margin = 0.08 * (high - low)
    axes.set_ylim(low - margin, high + margin)
    value_axis(axes, port.short, port.motion)
    for each in (axes, below):
        each.set_xlim(0, duration(run))
    axes.tick_params(labelbottom=False)
    if limited:
        handles.append(constraint(axes, (run.time, edges[0]), (run.time, edges[1]), "constraint"))
    _errors(below, port, run, of, trials, colours)
    legend_row(figure, handles)
    return figure, _sentence(port, run, of)


def _shades(ink: str, count: int) -> list[str]:
    """The later the darker."""
    return [tint(ink, share) for share in (0.55, 0.75, 1.0)[3 - count :]]


def _style(trial: int, trials: list[int]) -> dict[str, Any]:
    return STYLES[3 - len(trials) + trials.index(trial)]


def _references(axes: Axes, port: PortNames, run: Result, of: str, trials: list[int], contents: list[np.ndarray]) -> list[Any]:
    """The reference; where it differs from trial to trial, that of each of these. Adds to `contents` what it draws."""
    if not tracked(run, of):
        return []
    wanted = [np.asarray(run["reference"][j])[:, port.index] for j in trials]
    different = [r for k, r in enumerate(wanted) if not any(np.array_equal(r, later) for later in wanted[k + 1 :])]
    contents += different
    style: dict[str, Any] = {"color": REFERENCE, "lw": 0.8, "ls": DASHES, "label": "reference", "zorder": 4}
    return [axes.plot(*_thinned(run.time, r), **style)[0] for r in different][-1:]


def _errors(axes: Axes, port: PortNames, run: Result, of: str, trials: list[int], colours: dict[int, str]) -> None:
    """Errors as they are; where the last is small beside the first, their largest moduli over short spans, on a log axis."""
    errors = {j: tracking_error(run, of, j) for j in trials}
    peaks = {j: float(np.abs(e).max()) for j, e in errors.items()}
    label_axis(axes.xaxis, "time in the trial", "s")
    if peaks[trials[0]] > 10 * peaks[trials[-1]] > 0:
        spans = {j: _envelope(run.time, np.abs(e)) for j, e in errors.items()}
        for j, (t, e) in spans.items():
            axes.plot(t, np.where(e > 0, e, np.nan), color=colours[j], drawstyle="steps-post", zorder=3, **_style(j, trials))
        floor = min(float(e[e > 0].min()) for _, e in spans.values() if np.any(e > 0))
        top = max(peaks.values())
        log_axis(axes, f"|error| [{port.motion}]", max(0.5 * floor, 1e-7 * top), 2 * top)
        return
    for j, e in errors.items():
        axes.plot(*_thinned(run.time, e), color=colours[j], zorder=3, **_style(j, trials))
    axes.axhline(0, color=INK, lw=0.3, zorder=0)
    low, high, _ = value_range(list(errors.values()), (), False)
    axes.set_ylim(low - 0.08 * (high - low), high + 0.08 * (high - low))
    value_axis(axes, "error", port.motion)


def _thinned(t: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    keep = pick_extremes(y[None], COLUMNS // 2)[0]
    return t[keep], y[keep]


def _envelope(t: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Largest value over each of some spans of time, to be drawn as steps from the start of a span on."""
    starts = np.unique(np.linspace(0, len(t) - 1, min(BINS, len(t) - 1) + 1).astype(int)[:-1])
    largest = np.maximum.reduceat(values, starts)
    return np.append(t[starts], t[-1]), np.append(largest, largest[-1])


def _sentence(port: PortNames, run: Result, of: str) -> str:
    peaks, unit, last = error_peaks(run, of), port.motion, run.trials - 1
    end = quantity(abs(float(tracking_error(run, of, last)[-1])), unit)
    if run.trials == 1:
        text = f"{port.text} is {quantity(peaks[0], unit)} off its reference at most, and {end} at the end of the trial"
    else:
        text = f"The largest error of {port.text}{course(peaks, unit)}"
        text += f", {percent(peaks[-1] / peaks[0])} of it" if peaks[0] > 0 else ""
        text += f"; at the end of that trial it is {end}"
    limits = limits_of(run.scenario, of)
    if limits is not None:
        text += f"; {limits.words} {against(run, of)}"
    return text + "."
