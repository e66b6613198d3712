"""An actuator of your own: it saturates softly. `step` is plain Python over scalars; dampen compiles this very function."""

import math
from dataclasses import dataclass

import dampen


def soft_step(command, state, parameters, new_state):
    return parameters[0] * math.tanh(command / parameters[0])


@dataclass(frozen=True)
class SoftSaturation(dampen.Stage):
    """B = limit tanh(u / limit)."""

    limit: float = 1.0
    step = staticmethod(soft_step)
    gain = 1.0

    def row(self, dt: float) -> tuple[float, ...]:
        return (self.limit,)
