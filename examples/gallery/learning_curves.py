"""
Three laws learn
================

The same beam and backlash under a disturbance that repeats: the paper's law, P-type and PD-type learning, each beside
some damping. The backlash is in nobody's model: P-type learning gets worse again.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DISPLACEMENT, LEARNED, RC, ROTATION

PORTS = ("tip_w", "tip_phi")


def each(value):
    return dict.fromkeys(PORTS, value)


base = dampen.read_scenario("he2017", ["task.trials=15", "numerics.modes=40", "disturbance.frozen_at=2"])
laws = {
    "dual-loop ILC": (base.controller, DISPLACEMENT, "o-"),
    "P-type": (dampen.PTypeILC(learning=each(2.0), damping=each(3.0), stiffness=each(5.0)), ROTATION, "s--"),
    "PD-type": (
        dampen.PDTypeILC(learning=each(2.0), rate_learning=each(1.0), damping=each(3.0), stiffness=each(5.0)),
        LEARNED,
        "^:",
    ),
}

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(3.5, 2.6), layout="constrained")
last = {}
for name, (law, colour, style) in laws.items():
    error = np.sqrt(np.mean(dampen.simulate(base.with_controller(law))["y"][..., 0] ** 2, axis=1))
    axes.semilogy(error, style, color=colour, ms=3, label=name)
    last[name] = error[-1]
axes.set(xlabel="trial", ylabel="RMS tip displacement [m]")
axes.legend()

ratio = last["P-type"] / last["PD-type"]
print({name: f"{1000 * error:.3f} mm" for name, error in last.items()})
plt.show()
