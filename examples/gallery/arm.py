"""
A flexible arm learns its motion
================================

A motor turns a light link by 30 degrees; at the tip there is a sensor alone. Norm-optimal learning finds the hub's
torque from the tip's error through the link's own impulse response.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DASHES, DISPLACEMENT, LEARNED, RC, REFERENCE, UNCONTROLLED

scenario = dampen.read_scenario("flexible-arm-point-to-point")
run = dampen.simulate(scenario)
midway = (run.time[1:] + run.time[:-1]) / 2
hub, tip = (scenario.ports.index(port) for port in ("hub", "tip_w"))

plt.rcParams.update(RC)
figure, (left, right) = plt.subplots(1, 2, figsize=(7.16, 2.5), layout="constrained")
left.plot(run.time, scenario.reference()[:, tip], color=REFERENCE, ls=DASHES, label="reference")
left.plot(run.time, run["y"][0, :, tip], color=UNCONTROLLED, label="trial 0")
left.plot(run.time, run["y"][-1, :, tip], color=DISPLACEMENT, label="trial 11")
left.set(xlabel="time [s]", ylabel="tip displacement [m]")
left.legend()
right.plot(midway, run["delivered"][0, :, hub], color=UNCONTROLLED, label="trial 0")
right.plot(midway, run["delivered"][-1, :, hub], color=LEARNED, label="trial 11")
right.set(xlabel="time [s]", ylabel="torque of the hub [N m]")

error = np.sqrt(np.mean((run["y"][..., tip] - scenario.reference()[:, tip]) ** 2, axis=1))
gained = error[0] / error[-1]
print(f"RMS error of the tip: {1000 * error[0]:.1f} mm in trial 0, {1000 * error[-1]:.2f} mm in trial 11.")
plt.show()
