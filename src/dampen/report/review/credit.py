"""What each part is worth: residual, margin and effort of every ablation."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter, PercentFormatter

from dampen.analysis.credit import AtPort, Credit, Variant
from dampen.report.axes import sheet
from dampen.report.style import (
    CONSTRAINT,
    DOUBLE,
    FAINT,
    INK,
    SMALL,
    UNCONTROLLED,
    colour,
    plain_number,
    plain_text,
    quantity,
    ten_to,
)

ROW, HEAD, FOOT = 0.185, 0.28, 0.46  # in: a variant, above and below all
LETTER, GAP, RIGHT = 0.058, 0.17, 0.08
LEAST_MARGIN = -0.5


def draw_credit(credit: Credit) -> tuple[Figure, str]:
    """A row for each variant, a column for each figure: a dot where it comes to, a line from where the whole law comes to."""
    shown = drawable(credit)
    columns = columns_of(credit)
    height = HEAD + FOOT + ROW * len(shown)
    figure = sheet(DOUBLE, height)
    left = 0.1 + LETTER * max(len(variant.name) for variant in shown)
    width = (DOUBLE - left - RIGHT - GAP * (len(columns) - 1)) / len(columns)
    for i, (label, unit, value, log) in enumerate(columns):
        box = ((left + i * (width + GAP)) / DOUBLE, FOOT / height, width / DOUBLE, ROW * len(shown) / height)
        axes = figure.add_axes(box)
        values = np.array([value(variant) for variant in shown])
        draw_column(axes, shown, values, unit, log)
        axes.set_title(label, fontsize=SMALL, pad=4)
        axes.set_xlabel(f"[{unit}]" if unit else "share", fontsize=SMALL, labelpad=2)
        axes.set_yticks(np.arange(len(shown)), [plain_text(variant.name) for variant in shown] if i == 0 else [""] * len(shown))
    return figure, sentence(credit)


def drawable(credit: Credit) -> list[Variant]:
    """The variants with figures that can be drawn: what diverged has none."""
    return [v for v in credit.variants if v.ports and all(np.isfinite((one.residual, one.effort)).all() for one in v.ports)]


def columns_of(credit: Credit) -> list[tuple[str, str, Callable[[Variant], float], bool]]:
    """Heading, unit, value of a variant, and whether on a log axis: residuals by port, the margin, efforts by port."""

    def at(port: str, name: str) -> Callable[[Variant], float]:
        return lambda variant: float(getattr(variant.at(port), name))

    ports = credit.whole.ports
    found = [(f"residual, {one.port}", one.motion_unit, at(one.port, "residual"), True) for one in ports]
    if np.isfinite(credit.whole.margin):
        found.append(("margin", "", lambda variant: variant.margin, False))
    pushed = [one for one in ports if any(variant.at(one.port).effort for variant in drawable(credit))]
    found = [column for column in found if not column[3] or any(column[2](variant) > 0 for variant in drawable(credit))]
    return [*found, *((f"effort, {one.port}", one.effort_unit, at(one.port, "effort"), False) for one in pushed)]


def draw_column(axes: Axes, shown: list[Variant], values: np.ndarray, unit: str, log: bool) -> None:
    """Dots of one figure of merit."""
    rows, ink = np.arange(len(shown)), colour(unit) if unit else CONSTRAINT
    axes.spines[["top", "right", "left"]].set_visible(False)
    axes.tick_params(axis="y", length=0)
    axes.set_ylim(len(shown) - 0.5, -0.5)
    axes.axvline(values[0], color=INK, lw=0.6, ls=(0, (1, 1.5)), zorder=1)
    if log:
        axes.set_xscale("log")
        positive = values[values > 0]
        axes.set_xlim(positive.min() / 1.6, positive.max() * 1.6)
        axes.xaxis.set_major_locator(LogLocator(numticks=5))
        axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: ten_to(round(np.log10(x)))))
        axes.xaxis.set_minor_formatter(NullFormatter())
    elif unit:
        axes.set_xlim(0, max(values.max(), 1e-300) * 1.08)
        axes.xaxis.set_major_locator(MaxNLocator(3))
        axes.xaxis.set_major_formatter(FuncFormatter(lambda x, _: plain_number(x)))
    else:
        least = max(LEAST_MARGIN, min(0.0, values.min() * 1.15))
        axes.set_xlim(least, max(values.max() * 1.15, 0.05))
        axes.axvspan(least, 0, facecolor="none", hatch="//////", ec=CONSTRAINT, lw=0, alpha=0.45, zorder=0)
        axes.xaxis.set_major_locator(MaxNLocator(3))
        axes.xaxis.set_major_formatter(PercentFormatter(1, decimals=0))
    low, high = axes.get_xlim()
    for row, variant, value in zip(rows, shown, values, strict=True):
        inks = UNCONTROLLED if variant.name.startswith("no control") else ink
        axes.axhline(float(row), color=FAINT, lw=0.3, alpha=0.6, zorder=0)
        if low <= value <= high:
            axes.plot([values[0], value], [row, row], color=inks, lw=1.4, solid_capstyle="butt", zorder=2)
            axes.plot([value], [row], marker="D" if row == 0 else "o", ms=3.6, color=inks, ls="none", zorder=3, clip_on=False)
        else:
            axes.annotate("◂", (low, row), (1, 0), textcoords="offset points", va="center", fontsize=7, color=inks)


def sentence(credit: Credit) -> str:
    """What the figure shows, in numbers."""
    whole, free = credit.whole, credit.get("no control")
    parts = [described(whole.at(one.port), free.at(one.port) if free and free.ports else None) for one in whole.ports]
    how = "Lines lead from the law as it is (dotted) to where it comes without a part."
    return f"RMS error of the last five trials: {'; '.join(parts)}. {how}"


def described(one: AtPort, free: AtPort | None) -> str:
    """The residual at a port, and that without control."""
    without = "" if free is None else f", {quantity(free.residual, one.motion_unit)} without control"
    return f"{one.port} {quantity(one.residual, one.motion_unit)}{without}"
