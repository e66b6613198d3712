"""
A cloud of payloads
===================

The tuned law over payloads that are up to 30 % off, in mass and inertia: every point is one experiment.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import CONSTRAINT, DASHES, RC

scenario = dampen.read_scenario("he2017-tuned", ["task.trials=10", "numerics.modes=24"])
study = dampen.robust(scenario, {"plant.tip_mass": "+-30%", "plant.tip_inertia": "+-30%"}, samples=64, sampler="latin", engine=1)
table = study.table

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(3.5, 2.8), layout="constrained")
places = (table["plant.tip_mass"], table["plant.tip_inertia"])
points = axes.scatter(*places, c=1000 * table["residual.tip_w"], cmap="cividis", s=14)
axes.plot(0.1, 0.1, "+", color=CONSTRAINT, ms=9, mew=1.5)
axes.axvline(0.1, color=CONSTRAINT, ls=DASHES, lw=0.5)
axes.set(xlabel="payload mass [kg]", ylabel="payload inertia [kg m²]")
figure.colorbar(points, label="residual of w(L) [mm]")

middle = float(np.median(table["residual.tip_w"]))
print(f"{len(table)} runs, {(table['status'] == 'complete').sum()} keep the constraint; median residual {1000 * middle:.3f} mm.")
plt.show()
