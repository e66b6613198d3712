"""How contenders are told apart in figures: by colour, line and mark, eight of each before they come again."""

from __future__ import annotations

from typing import Any

from matplotlib.lines import Line2D

from dampen.report.style import UNCONTROLLED
from dampen.studies.compare.comparison import Comparison

# Okabe-Ito, but for its yellow, which white swallows: brown and black instead
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#222222", "#8C5A2B")
LINES = ("-", (0, (5, 1.5)), (0, (1.2, 1.2)), (0, (6, 1.5, 1.2, 1.5)), (0, (3, 1.2)), "-", (0, (2, 2)), (0, (8, 2)))
MARKS = ("o", "s", "^", "D", "v", "P", "X", "*")


def looks(found: Comparison) -> dict[str, dict[str, Any]]:
    """By label, colour, line style and mark; the experiment's own law is the first, thicker than the others; no control is
    grey."""
    styles: dict[str, dict[str, Any]] = {}
    for i, one in enumerate(found.contenders):
        k = len(styles) - sum(c.kind == "none" for c in found.contenders[:i])
        colour = UNCONTROLLED if one.kind == "none" else COLOURS[k % len(COLOURS)]
        line = LINES[(k + k // len(COLOURS)) % len(LINES)] if one.kind != "none" else "-"
        mark = MARKS[(k + k // len(COLOURS)) % len(MARKS)] if one.kind != "none" else "x"
        styles[one.label] = {"color": colour, "ls": line, "marker": mark, "lw": 1.6 if i == 0 else 1.0}
    return styles


def handle(label: str, look: dict[str, Any], marked: bool = True) -> Line2D:
    """What a legend shows of a contender."""
    style = {**look, "marker": look["marker"] if marked else ""}
    return Line2D([], [], label=label, ms=4, mew=0.9 if look["marker"] == "x" else 0.0, **style)
