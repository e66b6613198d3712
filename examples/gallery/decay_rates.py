"""
Decay rates, mode by mode
=========================

Boundary damping at the tip of the paper's beam. The payload's inertia shields high modes: the higher a mode, the slower
it decays, and the continuum has no uniform rate.
"""

import matplotlib.pyplot as plt

import dampen
from dampen.report.style import DISPLACEMENT, LEARNED, RC, ROTATION

PORTS = ("tip_w", "tip_phi")
base = dampen.read_scenario("he2017", ["numerics.modes=40"])

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(3.5, 2.6), layout="constrained")
slowest = {}
for damping, colour, mark in ((0.3, DISPLACEMENT, "o"), (3.0, ROTATION, "s"), (30.0, LEARNED, "^")):
    law = dampen.BoundaryDamping(damping=dict.fromkeys(PORTS, damping))
    loop = dampen.rates(base.with_controller(law))
    axes.loglog(
        [m.frequency for m in loop.modes], [m.rate for m in loop.modes], mark, color=colour, ms=3, label=f"{damping:g} N s/m"
    )
    slowest[damping] = loop.rate
axes.set(xlabel="frequency [Hz]", ylabel="decay rate [1/s]")
axes.legend(title="damping")

best = max(slowest, key=slowest.get)
slow = slowest[best]
print(f"The slowest of 40 modes decays at {slow:.4f} 1/s at best, with a damping of {best:g} N s/m.")
plt.show()
