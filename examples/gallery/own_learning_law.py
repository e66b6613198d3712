"""
A learning law of one's own
===========================

Learning from the rate, with momentum: a class with three methods on arrays, and no compiler in sight.
"""

from dataclasses import dataclass, replace

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DISPLACEMENT, LEARNED, RC


@dataclass(frozen=True)
class Momentum(dampen.Controller):
    """u_(j+1) = u_j + p_(j+1), p_(j+1) = momentum p_j - learning v_j, beside some damping."""

    learning: float = 0.3
    momentum: float = 0.0

    def begin(self, setting):
        return {"u": np.zeros((setting.steps, 2)), "p": np.zeros((setting.steps, 2))}

    def law(self, memory, setting):
        return dampen.PortLaw(feedforward=memory["u"], damping=np.full(2, 3.0))

    def learn(self, memory, trial, setting):
        p = self.momentum * memory["p"] - self.learning * trial.v
        return {"u": memory["u"] + p, "p": p}


base = dampen.read_scenario("he2017", ["task.trials=20", "numerics.modes=24", "disturbance.frozen_at=2"])
base = replace(base, actuators={})

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(3.5, 2.6), layout="constrained")
last = []
for momentum, colour, style in ((0.0, DISPLACEMENT, "o-"), (0.5, LEARNED, "s--")):
    error = np.sqrt(np.mean(dampen.simulate(base.with_controller(Momentum(momentum=momentum)))["v"][..., 0] ** 2, axis=1))
    axes.semilogy(error, style, color=colour, ms=3, label=f"momentum {momentum:g}")
    last.append(error[-1])
axes.set(xticks=range(0, 20, 4), xlabel="trial", ylabel="RMS tip velocity [m/s]")
axes.legend()

ratio = last[1] / last[0]
print(f"Momentum leaves {100 * ratio:.0f} % of what learning without it leaves.")
plt.show()
