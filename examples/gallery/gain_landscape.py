"""
A landscape of gains
====================

The paper's experiment for 100 pairs of damping gains. Much damping is not much better: a tip that is held stiffly
reflects.
"""

import matplotlib.pyplot as plt

import dampen
from dampen.report.style import CONSTRAINT, RC

scenario = dampen.read_scenario("he2017", ["task.trials=8", "numerics.modes=24"])
grid = {"controller.alpha_4": "0.1:10:log:10", "controller.alpha_7": "0.1:10:log:10"}
table = dampen.sweep(scenario, grid, engine=1).table
residual = table.pivot(index="controller.alpha_7", columns="controller.alpha_4", values="residual")

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(3.5, 2.8), layout="constrained")
picture = axes.pcolormesh(residual.columns, residual.index, 100 * residual, cmap="cividis_r", shading="nearest")
axes.plot(1, 1, "+", color=CONSTRAINT, ms=9, mew=1.5)
axes.set(
    xscale="log", yscale="log", xlabel="damping of the force, alpha_4 [N s/m]", ylabel="damping of the torque, alpha_7 [N m s]"
)
figure.colorbar(picture, label="residual [% of the constraint]")

best = table.loc[table["residual"].idxmin()]
least = float(best["residual"])
print(f"Least residual: {100 * least:.2f} % at gains of {best['controller.alpha_4']:.3g} and {best['controller.alpha_7']:.3g}.")
plt.show()
