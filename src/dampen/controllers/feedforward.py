"""Feedforward as controllers are given it: by port, a number or a signal."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from dampen.controllers.base import Array, Setting
from dampen.signals.base import Signal


def feedforward(given: Mapping[str, float | Signal], setting: Setting) -> Array:
    """(steps, ports) feedforward [N, N m], the same in every trial; zero where none is given."""
    columns = []
    for port in setting.ports:
        value = given.get(port.name, 0.0)
        columns.append(value.sample(setting.times, 0) if isinstance(value, Signal) else np.full(setting.steps, float(value)))
    return np.column_stack(columns)
