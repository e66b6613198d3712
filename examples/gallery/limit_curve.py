"""
How far from the best possible?
===============================

The least RMS of the tip's displacement that any forces of a given effort could reach, whatever they know of the
disturbance, and where two laws lie.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DISPLACEMENT, LEARNED, RC, REFERENCE

PORTS = ("tip_w", "tip_phi")
scenario = dampen.read_scenario("he2017", ["task.trials=4", "numerics.modes=16", "numerics.step=0.002"])
curve = dampen.limit(scenario, "w", weights=np.geomspace(1e-6, 1, 9))
damping = dampen.BoundaryDamping(damping=dict.fromkeys(PORTS, 3.0))

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(3.5, 2.6), layout="constrained")
effort = np.geomspace(0.02, 3, 60)
bound = np.array([curve.bound(value) for value in effort])
axes.loglog(effort, bound, color=REFERENCE, label="no forces get below")
axes.fill_between(effort, bound.min() / 2, bound, color=REFERENCE, alpha=0.08, lw=0)
ratios = {}
for law, colour, mark in ((scenario.controller, DISPLACEMENT, "o"), (damping, LEARNED, "s")):
    at = dampen.standing(curve, dampen.simulate(scenario.with_controller(law)))
    axes.loglog(at.effort, at.rms, mark, color=colour, label=law.kind)
    ratios[law.kind] = at.rms / curve.bound(at.effort)
axes.set(xlabel="effort, RMS [N]", ylabel="RMS of w over beam and run [m]", ylim=(bound.min() / 1.5, None))
axes.legend()

ratio = ratios["dual-loop-ailc"]
print({kind: f"{value:.2f} times the least" for kind, value in ratios.items()})
plt.show()
