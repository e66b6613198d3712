"""What plants that are discretised have in common: their modes, and how they are put on the functions of another."""

from __future__ import annotations

from abc import abstractmethod
from typing import Any

from dampen.plants.base import Array, Modes, Plant
from dampen.plants.deflection import Deflection
from dampen.plants.discretisation import Discretisation


class DiscretisedPlant(Plant):
    """A plant that knows its energies in shape functions. Needs `ports`, `space` and `in_space`; modes follow."""

    @abstractmethod
    def space(self, count: int, grid: int | None) -> Any:
        """Shape functions that resolve `count` modes, or those of a grid; with `kin` and `shared` as a Space has them."""

    @abstractmethod
    def in_space(self, space: Any) -> Discretisation:
        """The structure in these shape functions."""

    def discretise(self, count: int, grid: int | None = None, like: Discretisation | None = None) -> Discretisation | None:
        space = self.space(count, grid)
        if like is None:
            return self.in_space(space)
        same = like.ports == self.ports and [(f.name, f.unit) for f in like.fields] == list(self.fields)
        return self.in_space(like.space.shared) if same and space.kin(like.space) else None

    def modes(self, count: int, grid: int | None = None) -> Modes:
        """The lowest `count` modes, rigid ones first. Raises ArgumentError if the discretisation has fewer."""
        discretisation = self.discretise(count, grid)
        assert discretisation is not None, "a plant has shape functions of its own"
        return discretisation.modes(count)


class DeflectedPlant(DiscretisedPlant):
    """One whose only motion is w(x, t), and which starts from a deflection."""

    initial: Deflection

    def initial_ports(self) -> tuple[float, ...]:
        return self.initial.at_ports(self.ports)

    def initial_state(self, modes: Modes) -> tuple[Array, Array]:
        return self.initial.in_modes(modes)
