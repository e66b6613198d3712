"""Ports and sites: what plants, disturbances and controllers have in common."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Port:
    """A place where a force (or torque) acts and the matching displacement (or angle) is seen.

    `kind` is "force" or "torque": a law may treat the two differently, as the paper's does.
    """

    name: str
    field: str
    x: float
    kind: Literal["force", "torque"] = "force"

    @property
    def motion_unit(self) -> str:
        return "m" if self.kind == "force" else "rad"

    @property
    def effort_unit(self) -> str:
        return "N" if self.kind == "force" else "N m"


@dataclass(frozen=True)
class Site:
    """Where a disturbance acts, and for how long: the ports, the structure's length [m], the duration of a trial [s]."""

    ports: tuple[Port, ...]
    span: float
    duration: float
