"""
A trolley on a rope
===================

A force travels along a hanging rope, slower than its waves. Damping at the tip, matched to the rope's impedance,
swallows the waves that it sends.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DIVERGING, RC

changes = ["task.trials=1", "task.start=reset", "task.constraint={}", "controller.barrier=none", "controller.barrier_gain={}"]
scenario = dampen.read_scenario(
    "string-tip-mass", [*changes, "disturbance.kind=moving-load", "disturbance.force=15.0", "disturbance.speed=5.0"]
)
runs = {"free end": dampen.simulate(scenario.uncontrolled()), "matched damping": dampen.simulate(scenario)}
largest = max(np.abs(run["w"]).max() for run in runs.values())

plt.rcParams.update(RC)
figure, both = plt.subplots(1, 2, figsize=(7.16, 2.6), sharey=True, layout="constrained")
for axes, (name, run) in zip(both, runs.items(), strict=True):
    limits = {"cmap": DIVERGING, "vmin": -largest, "vmax": largest}
    picture = axes.imshow(run["w"][0].T, origin="lower", aspect="auto", extent=(0, 4, 0, 20), **limits)
    axes.plot([0, 4], [0, 20], color="k", lw=0.6, ls="--")
    axes.set(xlabel="time [s]", title=name)
both[0].set_ylabel("place along the rope [m]")
figure.colorbar(picture, ax=both, label="deflection w(x, t) [m]")

end = {name: run["energy"][0, -1] for name, run in runs.items()}
kept = end["matched damping"] / end["free end"]
print(f"Energy after 4 s: {end['free end']:.3f} J with a free end, {end['matched damping']:.3f} J with matched damping.")
plt.show()
