"""Stay where you are told."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Unit
from typing_extensions import Doc

from dampen.references.base import Array, Reference


@dataclass(frozen=True)
class Hold(Reference):
    """A constant value.

    r(t) = r_0
    """

    kind: ClassVar[str] = "hold"

    value: Annotated[float, Unit("m, rad"), Doc("the value r_0")] = 0.0

    def sample(self, t: Array, trial: int) -> Array:
        return np.full(len(t), self.value)
