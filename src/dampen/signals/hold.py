"""Stay where you are told."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

import numpy as np
from typing_extensions import Doc

from dampen.signals.base import Array, Signal


@dataclass(frozen=True)
class Hold(Signal):
    """A constant value.

    r(t) = r_0
    """

    kind: ClassVar[str] = "hold"

    value: Annotated[float, Doc("the value r_0")] = 0.0

    def sample(self, t: Array, trial: int) -> Array:
        return np.full(len(t), self.value)
