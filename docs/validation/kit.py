"""A piece of evidence: what is claimed, the numbers that say so, what they may be, and a picture."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from dampen.report.style import CONSTRAINT, DISPLACEMENT, FAINT, INK, LEARNED, RC, ROTATION

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT))  # the tests' own bench, where it is the thing that measures


@dataclass(frozen=True)
class Number:
    """A measured value, and where it has to lie."""

    what: str
    value: float
    low: float
    high: float

    @property
    def holds(self) -> bool:
        return self.low <= self.value <= self.high

    @property
    def allowed(self) -> str:
        """Where it has to lie, in words."""
        if self.low == self.high:
            return f"{self.low:g}"
        if self.high == float("inf"):
            return f"at least {self.low:.3g}"
        return f"at most {self.high:.3g}" if self.low == -float("inf") else f"{self.low:.4g} to {self.high:.4g}"


@dataclass(frozen=True)
class Evidence:
    """What a page shows; `missing` says what was not there to make it."""

    numbers: tuple[Number, ...]
    figure: Figure | None = None
    missing: str = ""

    @property
    def holds(self) -> bool:
        return all(number.holds for number in self.numbers)

    def table(self) -> str:
        """The numbers as a Markdown table."""
        rows = [f"| {n.what} | {n.value:.4g} | {n.allowed} | {'holds' if n.holds else 'FAILS'} |" for n in self.numbers]
        return "\n".join(["| | measured | allowed | |", "|---|---|---|---|", *rows])


def at_most(what: str, value: float, high: float) -> Number:
    """A number that has to be small."""
    return Number(what, float(value), -float("inf"), high)


def about(what: str, value: float, wanted: float, off: float) -> Number:
    """A number that has to be near another one."""
    return Number(what, float(value), wanted - off, wanted + off)


def canvas(columns: int = 1, width: float = 3.5, height: float = 2.5, rows: int = 1) -> tuple[Figure, list[Axes]]:
    """A figure in the style of the reports, and its axes."""
    matplotlib.rcParams.update(RC)
    figure = Figure(dpi=200, figsize=(width * columns, height * rows), layout="constrained")
    axes = list(figure.subplots(rows, columns, squeeze=False).ravel())
    for one in axes:
        one.set_prop_cycle(color=[DISPLACEMENT, ROTATION, LEARNED, CONSTRAINT])
    return figure, axes


def ticks(axes: Axes, values: Sequence[float]) -> None:
    """Few ticks on a logarithmic axis that is short."""
    axes.set_xticks(values, [f"{value:g}" for value in values])
    axes.xaxis.set_minor_formatter(NullFormatter())


def slope(axes: Axes, x: tuple[float, float], y: float, order: int, label: str) -> None:
    """A faint line of the order that is declared."""
    axes.loglog(x, (y, y * (x[1] / x[0]) ** order), color=FAINT, lw=0.7, ls="--")
    axes.annotate(label, (x[1], y * (x[1] / x[0]) ** order), color=INK, fontsize=7, va="bottom", ha="right")
