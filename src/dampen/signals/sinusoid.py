"""To and fro."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Ge, Unit
from typing_extensions import Doc

from dampen.signals.base import Array, Signal, smooth_step


@dataclass(frozen=True)
class Sinusoid(Signal):
    """A sinusoid about an offset, faded in so that it starts at rest.

        r(t) = r_0 + A h(t) sin(2 pi f t + theta),    h = 10 s^3 - 15 s^4 + 6 s^5,  s = t / ramp, and 1 from then on

    Without a ramp, h = 1.
    """

    kind: ClassVar[str] = "sinusoid"

    amplitude: Annotated[float, Doc("amplitude A")]
    frequency: Annotated[float, Ge(0), Unit("Hz"), Doc("frequency f")]
    offset: Annotated[float, Doc("mean value r_0")] = 0.0
    phase: Annotated[float, Unit("rad"), Doc("phase theta at the start of a trial")] = 0.0
    ramp: Annotated[float, Ge(0), Unit("s"), Doc("time in which the amplitude grows from 0")] = 0.0

    def sample(self, t: Array, trial: int) -> Array:
        grown = smooth_step(t / self.ramp) if self.ramp else 1.0
        return self.offset + self.amplitude * grown * np.sin(2 * np.pi * self.frequency * t + self.phase)
