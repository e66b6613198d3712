"""
A shaken base
=============

A slender boom on a base that shakes at its first frequency: what builds up without control, and what damping at the tip
leaves of it.
"""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DISPLACEMENT, RC, UNCONTROLLED

boom = dampen.read_scenario(
    "euler-bernoulli-payload", ["task.trials=1", "task.constraint={}", "plant.initial={}", "controller.kind=none"]
)
first = boom.plant.modes(1).omega[0] / (2 * np.pi)
shaken = replace(boom, disturbance=dampen.BaseShaking(frequencies=(first,), amplitudes=(0.2,)))
damped = shaken.with_controller(dampen.BoundaryDamping(damping={"tip_w": 0.3}))

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(7.16, 2.4), layout="constrained")
peaks = []
for scenario, colour, label in ((shaken, UNCONTROLLED, "no control"), (damped, DISPLACEMENT, "damping at the tip")):
    run = dampen.simulate(scenario)
    axes.plot(run.time, 1000 * run["y"][0, :, 0], color=colour, label=label)
    peaks.append(1000 * np.abs(run["y"][0, :, 0]).max())
axes.set(xlabel="time [s]", ylabel="tip against base [mm]")
axes.legend(loc="upper left")

ratio = peaks[1] / peaks[0]
print(f"Shaken at {first:.2f} Hz: up to {peaks[0]:.1f} mm without control, {peaks[1]:.1f} mm with it.")
plt.show()
