"""What every controller hands on: for each trial the law at the ports, and what it learns from the trial."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from dampen.component import Component
from dampen.port import Port
from dampen.stage import Stage

Array = np.ndarray
Memory = Mapping[str, Array]


@dataclass(frozen=True)
class Setting:
    """What a controller may know of its task: ports, steps, constraint (ports,), and bounds on what shakes the structure.

    bounds: by port name [N, N m], and "f" for the distributed load [N/m]; as stated in the scenario, true or not.
    """

    ports: Sequence[Port]
    steps: int
    dt: float
    length: float
    constraint: Array
    bounds: Mapping[str, float]


@dataclass(frozen=True)
class PortLaw:
    """The monotone law at the ports for one trial,

        u in feedforward - damping v - coulomb Sgn(v) - barrier dV/dy,     V(y) = 1/4 ln^2(C^2 / (C^2 - y^2))

    feedforward, coulomb: (steps, ports).   damping, barrier: (ports,).   All but feedforward must be >= 0.
    """

    feedforward: Array
    coulomb: Array
    damping: Array
    barrier: Array


@dataclass(frozen=True)
class Trial:
    """What a controller gets to see of a finished trial: y (steps + 1, ports); v, command (steps, ports)."""

    index: int
    y: Array
    v: Array
    command: Array


class Controller(Component):
    """A law at the ports (inner loop) and what it learns between trials (outer loop). Memories are (steps, ports) arrays."""

    @property
    def uses_barrier(self) -> bool:
        """Whether the law needs the tip to start inside the constraint."""
        return False

    def compensation(self, port: Port) -> tuple[Stage, ...]:
        """Stages between the law's value and the actuator's input: the controller's own idea of the actuator."""
        return ()

    def begin(self, setting: Setting) -> Memory:
        """The memories before trial 0."""
        return {}

    @abstractmethod
    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        """The law of the coming trial."""

    def learn(self, memory: Memory, trial: Trial, setting: Setting) -> Memory:
        """The memories after a trial."""
        return memory
