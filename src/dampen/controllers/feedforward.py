"""Feedforward as controllers are given it: by port, a number or a signal."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from dampen.controllers.base import Array, Setting
from dampen.signals.base import Signal, sampled


def feedforward(given: Mapping[str, float | Signal], setting: Setting) -> Array:
    """(steps, ports) feedforward [N, N m], the same in every trial; zero where none is given."""
    return np.column_stack([sampled(given.get(port.name, 0.0), setting.times, 0) for port in setting.ports])
