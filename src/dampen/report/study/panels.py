"""Rows of small panels for figures that have one for each parameter."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure

LEFT, RIGHT, TOP, BOTTOM, GAP = 0.62, 0.12, 0.32, 0.44, 0.42
HEIGHT = 1.35  # in, of a panel


def panels_across(count: int) -> int:
    """Four where three would leave one alone in the last row."""
    return min(count, 4 if count % 3 == 1 else 3)


def small_panels(figure: Figure, count: int, panel_height: float = HEIGHT) -> list[Axes]:
    """`count` panels, three or four across, on a sheet that is made high enough for them."""
    width = float(figure.get_size_inches()[0])
    across = panels_across(count)
    rows = -(-count // across)
    height = TOP + rows * (panel_height + BOTTOM) + (rows - 1) * 0.12
    figure.set_size_inches(width, height)
    each = (width - LEFT - RIGHT - (across - 1) * GAP) / across
    found = []
    for i in range(count):
        row, place = divmod(i, across)
        left = LEFT + place * (each + GAP)
        bottom = height - TOP - (row + 1) * panel_height - row * (BOTTOM + 0.12)
        axes = figure.add_axes((left / width, bottom / height, each / width, panel_height / height))
        axes.spines[["top", "right"]].set_visible(False)
        found.append(axes)
    return found
