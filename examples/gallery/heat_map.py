"""
The whole beam over time
========================

The deflection w(x, t) without control and with it, on one scale: what runs along the beam is swallowed at its tip.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DIVERGING, RC

scenario = dampen.read_scenario("he2017", ["task.trials=3", "numerics.modes=40"])
runs = {"no control": dampen.simulate(scenario.uncontrolled()), "dual-loop ILC": dampen.simulate(scenario)}
fields = {name: np.concatenate(run["w"][:, :-1]) for name, run in runs.items()}
largest = max(np.abs(w).max() for w in fields.values())

plt.rcParams.update(RC)
figure, both = plt.subplots(2, 1, figsize=(7.16, 3.4), sharex=True, layout="constrained")
for axes, (name, w) in zip(both, fields.items(), strict=True):
    picture = axes.imshow(w.T, origin="lower", aspect="auto", extent=(0, 6, 0, 1), cmap=DIVERGING, vmin=-largest, vmax=largest)
    axes.set_ylabel(f"{name}\nplace x [m]")
both[-1].set_xlabel("time [s]")
figure.colorbar(picture, ax=both, label="deflection w(x, t) [m]")

ratio = np.sqrt(np.mean(fields["dual-loop ILC"] ** 2) / np.mean(fields["no control"] ** 2))
print(f"RMS of w over beam and time: {100 * ratio:.1f} % of that without control.")
plt.show()
