"""Parts that several figures of studies share: the axis of a parameter, marks by status, bars of colour, what is best."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter, NullLocator

from dampen.report.axes import log_axis
from dampen.report.study.names import axis_label, axis_names, is_low_better, plain_name
from dampen.report.style import CONSTRAINT, INK, plain_number, ten_to
from dampen.simulation.scenario import Scenario
from dampen.studies.lens import get
from dampen.studies.rows import Array, column, statuses
from dampen.studies.study import Study
from dampen.studies.variation import Axis

NEAR_RED = "#B03A2E"  # what has diverged: neither a port's colour nor the constraint's
BEST = "#009E73"
MARKS: dict[str, dict[str, Any]] = {
    "complete": {"marker": "o", "ms": 2.8, "mew": 0, "label": "held"},
    "constraint_lost": {"marker": "X", "ms": 4.4, "mew": 0.4, "mec": "white", "color": CONSTRAINT, "label": "constraint lost"},
    "diverged": {"marker": "x", "ms": 3.6, "mew": 0.9, "color": NEAR_RED, "label": "diverged"},
    "refused": {"marker": "|", "ms": 5, "mew": 0.8, "color": INK, "label": "refused"},
    "crashed": {"marker": "+", "ms": 5, "mew": 0.8, "color": INK, "label": "crashed"},
}
AT_EDGE = {"diverged": 1.0, "refused": 0.0, "crashed": 0.0}  # what has no value stands at the upper or lower edge


def is_listed(axis: Axis) -> bool:
    """Whether the axis is of categories: words, or a list whose values are not all numbers."""
    return any(isinstance(value, str | bool) or not isinstance(value, int | float) for value in axis.values)


def positions(study: Study, axis: Axis) -> Array:
    """(rows,) where each row stands on the axis: its value, or the number of its category."""
    values = list(study.table[axis.name])
    if is_listed(axis):
        places = {str(value): i for i, value in enumerate(axis.values)}  # a table keeps a list of several kinds as text
        return np.array([places[str(value)] for value in values], dtype=float)
    return np.asarray(values, dtype=float)


def is_log(axis: Axis) -> bool:
    """Whether the axis is logarithmic: as it was written, or a list that spans more than a decade and a half."""
    if axis.values and not is_listed(axis) and not axis.low < axis.high:
        low, high = min(axis.values), max(axis.values)
        return bool(low > 0 and high > 30 * low)
    return axis.log


def value_text(value: Any) -> str:
    """What an axis takes, for reading."""
    if isinstance(value, bool | np.bool_):
        return "yes" if value else "no"
    if isinstance(value, int | float | np.number):
        return plain_number(float(f"{float(value):.4g}"))
    return str(value) if isinstance(value, str) else ", ".join(map(str, value)) if isinstance(value, tuple) else str(value)


def nominal(scenario: Scenario, axis: Axis) -> float | None:
    """Where the scenario itself stands on an axis; None where it does not: several values, or not one of the list."""
    if axis.factor:
        return 1.0
    own = [get(scenario, path) for path in axis.paths]
    if any(value != own[0] for value in own):
        return None
    if is_listed(axis):
        return float(axis.values.index(own[0])) if own[0] in axis.values else None
    return float(own[0]) if isinstance(own[0], int | float) else None


def parameter_axis(axes: Axes, axis: Axis, scenario: Scenario, which: str = "x", name: str = "") -> None:
    """Scale, ticks and label of the axis `which` for a parameter; its limits are set by whoever knows what is drawn."""
    side = axes.xaxis if which == "x" else axes.yaxis
    label = axis_label(scenario, axis, name or axis_names(scenario, [axis])[axis.name])
    (axes.set_xlabel if which == "x" else axes.set_ylabel)(label)
    width = axes.get_window_extent().width if which == "x" else 1.6 * axes.get_window_extent().height
    few = max(3, min(6, int(2.2 * width / axes.figure.dpi)))
    if is_listed(axis):
        side.set_major_locator(MaxNLocator(len(axis.values)))
        side.set_ticks(range(len(axis.values)), [value_text(value) for value in axis.values])
    elif is_log(axis):
        (axes.set_xscale if which == "x" else axes.set_yscale)("log")
        log_ticks(side, *limits(axis), few)
    else:
        linear_ticks(side, few, axis.whole)


def linear_ticks(side: Any, few: int, whole: bool = False) -> None:
    """Ticks of a linear axis, each with its whole number: no offset that a reader would have to add."""
    side.set_major_locator(MaxNLocator(few, steps=[1, 2, 2.5, 5, 10], integer=whole))
    side.set_major_formatter(FuncFormatter(lambda v, _: plain_number(round(v, 12))))


def log_ticks(side: Any, low: float, high: float, few: int) -> None:
    """Ticks of a logarithmic axis from `low` to `high`, with numbers between powers of ten where there is hardly one."""
    narrow = high < 100 * low
    side.set_major_locator(LogLocator(subs=(1, 2, 5) if narrow else (1,), numticks=few + 1))
    side.set_major_formatter(FuncFormatter(lambda v, _: _log_number(v, high)))
    side.set_minor_locator(LogLocator(subs=range(2, 10), numticks=60) if high < 1e5 * low else NullLocator())
    side.set_minor_formatter(NullFormatter())


def _log_number(value: float, high: float) -> str:
    return plain_number(value) if 1e-3 <= value < 1e4 and high < 1e4 else ten_to(round(np.log10(value)))


def limits(axis: Axis) -> tuple[float, float]:
    """The ends of an axis's range."""
    if is_listed(axis):
        return -0.5, len(axis.values) - 0.5
    if axis.low < axis.high:
        return axis.low, axis.high
    return (min(axis.values), max(axis.values)) if axis.values else (0.0, 1.0)


def padded(axis: Axis, share: float = 0.04) -> tuple[float, float]:
    """The ends of an axis's range, and a little more on both sides."""
    low, high = limits(axis)
    if is_listed(axis):
        return low, high
    if is_log(axis):
        more = (high / low) ** share
        return low / more, high * more
    return (low - share * (high - low), high + share * (high - low)) if low < high else (low - 1, high + 1)


def merits_of(study: Study, name: str) -> Array:
    """(rows,) a merit, nan where the motion diverged: its margin is a number, but one without meaning."""
    return np.where(statuses(study) == "diverged", np.nan, column(study, name))


def merit_axis(axes: Axes, label: str, values: Array, log: bool | None = None) -> bool:
    """A vertical axis for values of a merit, logarithmic where they are positive and span more than a factor of five.

    Returns whether it is logarithmic. A linear axis ends at -1, where what was allowed has been used twice: only a margin is
    negative, and one further down would flatten all others.
    """
    values = values[np.isfinite(values)]
    if not len(values):
        axes.set_ylim(0, 1)
        axes.set_ylabel(label)
        axes.set_yticks([])
        return False
    low, high = float(values.min()), float(values.max())
    if (log is None and low > 0 and high > 5 * low) or (log and low > 0):
        grow = max((high / low) ** 0.08, 1.05)
        log_axis(axes, label, low / grow, high * grow)
        log_ticks(axes.yaxis, low / grow, high * grow, 5)
        return True
    low = max(low, -1.0) if high > -1 else low
    room = 0.08 * (high - low) or 0.1 * abs(high) or 1.0
    axes.set_ylim(low - room, high + room)
    linear_ticks(axes.yaxis, 5)
    axes.set_ylabel(label)
    return False


def scatter(
    axes: Axes, study: Study, x: Array, y: Array, colour: str, label: str = "held", only: Array | None = None, **style: Any
) -> list[Any]:
    """Rows as marks that tell their status, those without a value at the edge; drawn as pixels where there are many.

    only: (rows,) which rows to draw, if not all.    Returns the legend's handles. Limits must be set already.
    """
    found, handles = statuses(study), []
    bottom, top = axes.get_ylim()
    at = axes.transAxes.inverted().transform(axes.transData.transform(np.column_stack([x, np.full(len(x), top)])))[:, 0]
    for status, look in MARKS.items():
        mine = (found == status) & (True if only is None else only)
        if not mine.any():
            continue
        look = {"color": colour, "ls": "none", "zorder": 3, **look, **(style if status == "complete" else {})}
        if status == "complete":
            look["label"] = label
        many = bool(len(x) > 300)
        kept = np.clip(y, bottom, top)
        edge = mine & ~np.isfinite(y)
        axes.plot(x[mine & ~edge], kept[mine & ~edge], rasterized=many, **look)
        if edge.any():
            height = np.full(int(edge.sum()), AT_EDGE.get(status, 1.0))
            axes.plot(at[edge], height, rasterized=many, transform=axes.transAxes, clip_on=False, **look)
        handles.append(Line2D([], [], **{**look, "alpha": 1, "ms": max(3.2, look["ms"])}))
    return handles


def best_row(study: Study, name: str, among: Array | None = None) -> int | None:
    """The row with the best value of a merit among those that held the constraint; None if there is none."""
    fit = (statuses(study) == "complete") & np.isfinite(column(study, name))
    if among is not None:
        fit &= among
    if not fit.any():
        return None
    values = column(study, name) * (1 if is_low_better(name) else -1)
    return int(np.argmin(np.where(fit, values, np.inf)))


def where_words(study: Study, row: int, names: dict[str, str], few: int = 4) -> str:
    """What a row's axes take: "tip mass = 0.13, alpha_4 = 2.5"."""
    axes: Sequence[Axis] = study.definition.axes
    parts = [f"{plain_name(names[a.name])} = {value_text(study.table[a.name].iloc[row])}" for a in axes[:few]]
    return ", ".join(parts) + (", ..." if len(axes) > few else "")


def rows_words(study: Study) -> str:
    """How many rows a figure is of, by status, in words; "" if all of them held."""
    found = statuses(study)
    words = {
        "constraint_lost": ("lost the constraint", "lost the constraint"),
        "diverged": ("diverged", "diverged"),
        "refused": ("was refused", "were refused"),
        "crashed": ("crashed", "crashed"),
    }
    parts = [f"{n:,} {word[n > 1]}" for status, word in words.items() if (n := int((found == status).sum()))]
    return f"; of {len(found):,} runs {' and '.join([', '.join(parts[:-1]), parts[-1]] if parts[1:] else parts)}" if parts else ""
