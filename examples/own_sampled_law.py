"""A digital controller of your own: PI on the displacement, damping on its estimated rate, all ports alike."""

from dataclasses import dataclass

import numpy as np

import dampen


def pid_step(sample, state, parameters, command):
    for p in range(len(command)):
        state[p] += parameters[2] * sample.error[p]
        command[p] = -parameters[0] * sample.error[p] - parameters[1] * sample.rate[p] - state[p]


@dataclass(frozen=True)
class DigitalPID(dampen.SampledFeedback):
    """u = -k_p e - k_d e' - k_i sum e T."""

    gains: tuple[float, ...] = (10.0, 1.0, 20.0)
    step = staticmethod(pid_step)

    def states(self, setting):
        return len(setting.ports)

    def row(self, setting):
        return np.array([self.gains[0], self.gains[1], self.gains[2] * setting.dt])
