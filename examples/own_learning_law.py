"""A learning law of your own: learning from the rate, with momentum. Arrays in, arrays out; no compiler in sight."""

from dataclasses import dataclass

import numpy as np

import dampen


@dataclass(frozen=True)
class MomentumILC(dampen.Controller):
    """u_(j+1) = u_j + p_(j+1) with p_(j+1) = momentum p_j - learning v_j, beside some damping."""

    learning: float = 2.0
    momentum: float = 0.3
    damping: float = 2.0

    def begin(self, setting):
        return {"u": np.zeros((setting.steps, len(setting.ports))), "p": np.zeros((setting.steps, len(setting.ports)))}

    def law(self, memory, setting):
        return dampen.PortLaw(feedforward=memory["u"], damping=np.full(len(setting.ports), self.damping))

    def learn(self, memory, trial, setting):
        p = self.momentum * memory["p"] - self.learning * trial.v
        return {"u": memory["u"] + p, "p": p}
