"""A limit that tightens."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Gt, Unit
from typing_extensions import Doc

from dampen.signals.base import Array, Signal


@dataclass(frozen=True)
class Decay(Signal):
    """An exponential from one value towards another: the funnel of prescribed performance, as a limit of the error.

        r(t) = final + (start - final) e^(-t / time_constant)

    Source: Bechlioulis and Rovithakis, IEEE Trans. Automatic Control 53, 2008.
    """

    kind: ClassVar[str] = "decay"

    start: Annotated[float, Doc("value at the start of a trial")]
    final: Annotated[float, Doc("value it tends to")]
    time_constant: Annotated[float, Gt(0), Unit("s"), Doc("time constant")] = 0.5

    def sample(self, t: Array, trial: int) -> Array:
        return np.asarray(self.final + (self.start - self.final) * np.exp(-t / self.time_constant))
