"""The dual-loop adaptive iterative learning control law of He et al. 2017."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from dampen.controllers.base import Memory, Setting, Trial
from dampen.controllers.inner_loop import InnerLoop


@dataclass(frozen=True)
class DualLoopAILC(InnerLoop):
    """Dual-loop adaptive iterative learning control with a barrier.

        force   u = xi - [d_hat + 2 alpha_1 f_bar L + alpha_2 d_bar] sgn(v) - alpha_3 y/(C^2 - y^2) ln(C^2/(C^2 - y^2))
                xi = zeta(previous trial) - alpha_4 v          d_hat = d_hat(previous trial) + alpha_8 |v|
        torque  the same without the f_bar term, with alpha_5 for alpha_2 and alpha_6, 7, 9 for alpha_3, 4, 8

    y and v are the port's displacement and rate (with a reference, the error and its rate), zeta is the dead-zone of xi of
    width m (B_r - B_l), all memories are zero before trial 0, and sgn is set-valued at 0. Source: He et al. 2017, (15)-(18).
    Only alpha_9 = 0.1 is known of the paper's gains: the defaults are ours. Where the term alpha_8 |v| multiplies sgn(v) it
    acts as damping, and is solved as such.
    """

    kind: ClassVar[str] = "dual-loop-ailc"

    def begin(self, setting: Setting) -> Memory:
        nothing = np.zeros((setting.steps, len(setting.ports)))
        return {"zeta": nothing, "d_hat": nothing}

    def learn(self, memory: Memory, trial: Trial, setting: Setting) -> Memory:
        xi = memory["zeta"] - setting.by_kind(self.alpha_4, self.alpha_7) * trial.v
        zeta = np.where(xi <= 0, xi, np.maximum(xi - self.assumed_backlash.width, 0.0))
        observed = setting.by_kind(self.alpha_8, self.alpha_9) * np.abs(trial.v)
        return {"zeta": zeta, "d_hat": memory["d_hat"] + observed}
