"""Where runs lie against the least that any forces at the same ports could reach."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from dampen.analysis.limit.curve import Limit
from dampen.analysis.limit.standing import Standing
from dampen.report.axes import legend_row, log_axis, panel, sheet
from dampen.report.style import (
    INK,
    SMALL,
    TIMES,
    UNCONTROLLED,
    colour,
    number,
    plain_number,
    plain_text,
    quantity,
    symbol,
    ten_to,
    tint,
)

Array = np.ndarray
Placed = Sequence[tuple[str, Standing]]
MARKERS = "osD^v<>p"
TIGHT = 1.1  # where bound and reached are nearer than that, their ratio is the run's ratio to the limit


def draw_limit(limit: Limit, standings: Placed) -> tuple[Figure, str]:
    """The limit, with what lies below it hatched; the level without control; the runs that spent any effort, named in the
    lower left corner, where no run can be."""
    figure = sheet(height=2.6)
    axes = panel(figure, left=0.68, top=0.3, right=0.14)
    ink = colour(limit.unit)
    runs = [(label, one) for label, one in standings if one.effort > 0 and one.rms > 0]
    x, y = curve(limit)
    efforts, rms = np.array([*x, *(one.effort for _, one in runs)]), np.array([*y, *(one.rms for _, one in runs)])
    _axes(axes, limit, efforts, rms, room=(0.15 * len(runs) + 0.1) / axes.get_position().height / figure.get_figheight())
    axes.fill_between(x, axes.get_ylim()[0], y, facecolor="none", hatch="//////", ec=tint(ink, 0.4), lw=0, zorder=0)
    handles = axes.plot(x, y, color=ink, lw=1.2, label="limit, for any forces", zorder=3)
    axes.plot([x[-1], axes.get_xlim()[1]], [y[-1], y[-1]], color=ink, lw=0.8, ls=(0, (1, 1.2)), zorder=3)
    handles.append(axes.axhline(limit.uncontrolled, color=UNCONTROLLED, lw=0.8, ls=(0, (4, 2)), label="no control", zorder=1))
    named = []
    for i, (label, one) in enumerate(runs):
        shape = MARKERS[i % len(MARKERS)]
        text = plain_text(label) + (f": {number(one.ratio or 0)} {TIMES} limit" if _is_tight(one) else "")
        named += axes.plot([one.effort], [one.rms], shape, ms=4, mfc="white", mec=INK, mew=0.9, zorder=5, label=text)
    if named:
        box = {
            "fontsize": SMALL,
            "frameon": True,
            "framealpha": 1.0,
            "edgecolor": "white",
            "borderpad": 0.3,
            "handletextpad": 0.2,
        }
        axes.legend(handles=named, loc="lower left", **box).set_zorder(2)
    legend_row(figure, handles)
    return figure, _sentence(limit, runs)


def curve(limit: Limit) -> tuple[Array, Array]:
    """Efforts [N] and limits, through all points and with their slopes, which are known: d rms^2 / d effort^2 = -weight."""
    from scipy.interpolate import CubicHermiteSpline

    points = [point for point in limit.points if point.effort > 0 and point.rms > 0]
    if len(points) < 2:
        return np.array([point.effort or 1.0 for point in limit.points]), np.array([point.rms for point in limit.points])
    effort, rms, weight = (np.array([getattr(point, name) for point in points]) for name in ("effort", "rms", "weight"))
    spline = CubicHermiteSpline(np.log(effort), np.log(rms), -weight * (effort / rms) ** 2)
    x = np.linspace(np.log(effort[0]), np.log(effort[-1]), 400)
    return np.exp(x), np.exp(spline(x))


def _axes(axes: Axes, limit: Limit, efforts: Array, rms: Array, room: float) -> None:
    """Logarithmic axes around all that is shown, with room for the names below it, a share of the height."""
    words = symbol(limit.of, "x, t") if len(limit.of) == 1 or limit.of == "phi" else plain_text(limit.of)
    low, high = float(rms.min(initial=np.inf, where=rms > 0)), max(limit.uncontrolled, float(rms.max()))
    low, high = (low, 1.5 * high) if low < high else (high / 10 or 0.1, 1.5 * high or 1.0)
    log_axis(axes, f"RMS of {words} [{limit.unit}]", low * (low / high) ** (room / (1 - room)), high)
    left, right = efforts.min() / 1.3, efforts.max() * 1.5
    axes.set_xscale("log")
    axes.set_xlim(left, right)
    axes.set_xlabel("RMS of the delivered forces [N]")
    narrow = right < 100 * left
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5) if narrow else (1,), numticks=7))
    axes.xaxis.set_major_formatter(
        FuncFormatter(lambda v, _: plain_number(v) if narrow or 1e-3 < v < 1e4 else ten_to(round(np.log10(v))))
    )
    axes.xaxis.set_minor_locator(LogLocator(subs=range(2, 10), numticks=60))
    axes.xaxis.set_minor_formatter(NullFormatter())


def _is_tight(one: Standing) -> bool:
    return one.ratio is not None and one.reached < TIGHT * one.bound


def _sentence(limit: Limit, runs: Placed) -> str:
    last, worst = limit.points[-1], max(point.gap for point in limit.points)
    text = (
        f"The least RMS of {limit.of} that any forces at the same ports could reach, knowing the disturbance in advance, falls "
    )
    text += f"from {quantity(limit.uncontrolled, limit.unit)} without forces to {quantity(last.rms, limit.unit)} with "
    text += f"{quantity(last.effort, 'N')} (duality gap {'at round-off' if worst < 1e-12 else number(worst, 1)})"
    for label, one in runs:
        text += f". {label}: {quantity(one.rms, limit.unit)} with {quantity(one.effort, 'N')}, {_against(one)}"
    text += ". Peaks are not bounded by it"
    if runs:
        text += ": " + ", ".join(f"{label} {quantity(one.peak, limit.unit)}" for label, one in runs)
    return text + "."


def _against(one: Standing) -> str:
    """How a run compares with the limit at its own effort."""
    if one.below:
        return f"below the limit of {quantity(one.bound, one.unit)}, which cannot be: do not trust this run"
    if _is_tight(one):
        return f"{number(one.ratio or 0)} times the limit of {quantity(one.bound, one.unit)} at that effort"
    return f"where {quantity(one.reached, one.unit)} can be had for no more"
