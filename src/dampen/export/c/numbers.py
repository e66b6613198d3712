"""Numbers as C99 has them: the shortest decimal that is read back as the same number."""

from __future__ import annotations

import math

import numpy as np

from dampen.component import ArgumentError


def literal(value: float, single: bool = False) -> str:
    """A literal of type double, or float. What is below 1 stays below 1: an edge must not become the limit itself.

    Raises ArgumentError for what a float cannot hold.
    """
    if math.isinf(value):
        return "INFINITY" if value > 0 else "-INFINITY"
    if not single:
        return repr(float(value))
    if abs(value) > np.finfo(np.float32).max:
        raise ArgumentError(
            f"Option `--float` must be left out: the controller has the number {value:g}, which no float can hold."
        )
    number = np.float32(value)
    if abs(value) < 1 <= abs(number):
        number = np.nextafter(number, np.float32(0))
    text = str(number)
    return f"{text}f" if any(mark in text for mark in ".e") else f"{text}.0f"


def rows(table: np.ndarray, single: bool = False) -> list[str]:
    """A two-dimensional table, row by row in braces."""
    return ["{" + ", ".join(literal(value, single) for value in row) + "}" for row in np.asarray(table, float)]
