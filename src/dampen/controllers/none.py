"""No control."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from dampen.controllers.base import Controller, Memory, PortLaw, Setting


@dataclass(frozen=True)
class NoControl(Controller):
    """Commands nothing: the structure as it vibrates by itself."""

    kind: ClassVar[str] = "none"

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        return PortLaw(np.zeros((setting.steps, len(setting.ports))))
