"""A force that travels along the structure."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Unit
from typing_extensions import Doc

from dampen.disturbances.base import Array, Content
from dampen.disturbances.clock import Clocked, Trials
from dampen.port import Site

CROSSINGS = 4


@dataclass(frozen=True)
class MovingLoad(Clocked):
    """A concentrated force that travels along the structure at constant speed.

        f(x, t) = F delta(x - x_0 - v t)    while it is on the structure, 0 <= x_0 + v t <= L

    Its place can be before the structure at first; with a negative speed it comes from the far end. It has no mass of its own.
    The highest frequency is taken to be 4 v/L: a delta has no shortest wave, but the shapes of the lowest modes, which it
    excites most, are passed that fast. Source: Fryba, Vibration of Solids and Structures under Moving Loads, 1999, ch. 1.
    """

    kind: ClassVar[str] = "moving-load"

    force: Annotated[float, Unit("N"), Doc("force F")]
    speed: Annotated[float, Unit("m/s"), Doc("speed v")]
    start: Annotated[float, Unit("m"), Doc("place x_0 at time 0")] = 0.0
    field: Annotated[str, Doc("field that it acts on")] = "w"
    trials: Trials = "repeat"

    @property
    def point_field(self) -> str | None:
        return self.field

    def point_load(self, trial: int, t: Array, site: Site) -> tuple[Array, Array]:
        x = self.start + self.speed * self.clock(trial, t, site)
        return np.clip(x, 0, site.span), np.where((x >= 0) & (x <= site.span), self.force, 0.0)

    def content(self, trial: int, site: Site) -> Content:
        return Content(load_frequency=CROSSINGS * abs(self.speed) / site.span)
