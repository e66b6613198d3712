"""Shapes of a field: functions of x, a column for every degree of freedom, which modes combine."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

Array = np.ndarray
Functions = Callable[[Array], Array]


class Shapes(ABC):
    """x (points,) -> (points, dof), the field's value per unit of each degree of freedom."""

    @abstractmethod
    def __call__(self, x: Array) -> Array:
        """(points, dof) values at x."""

    @abstractmethod
    def on(self, vectors: Array) -> Shapes:
        """The shapes of the columns of `vectors` (dof, columns), as combinations of these."""


@dataclass(frozen=True)
class Combined(Shapes):
    """functions(x) @ vectors, with functions (points, size) and vectors (size, dof)."""

    functions: Functions
    vectors: Array

    def __call__(self, x: Array) -> Array:
        return self.functions(x) @ self.vectors

    def on(self, vectors: Array) -> Combined:
        return Combined(self.functions, self.vectors @ vectors)


@dataclass(frozen=True)
class Part(Shapes):
    """Functions (points, size) of the degrees of freedom in `rows`, of `dof` in all; no other moves the field."""

    functions: Functions
    rows: slice
    dof: int

    def __call__(self, x: Array) -> Array:
        shapes = np.zeros((len(x), self.dof))
        shapes[:, self.rows] = self.functions(x)
        return shapes

    def on(self, vectors: Array) -> Combined:
        return Combined(self.functions, vectors[self.rows])


@dataclass(frozen=True)
class Interpolated(Shapes):
    """Straight lines through `values` (places, dof) at `places`, level beyond their ends."""

    places: Array
    values: Array

    def __call__(self, x: Array) -> Array:
        left = np.clip(np.searchsorted(self.places, x) - 1, 0, len(self.places) - 2)
        part = np.clip((x - self.places[left]) / (self.places[left + 1] - self.places[left]), 0.0, 1.0)[:, None]
        return (1 - part) * self.values[left] + part * self.values[left + 1]

    def on(self, vectors: Array) -> Interpolated:
        return Interpolated(self.places, self.values @ vectors)
