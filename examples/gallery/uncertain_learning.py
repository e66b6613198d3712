"""
Learning under uncertainty
==========================

Learning curves of one law on thirty beams, whose payload and stiffness are drawn. Median, the middle 80 %, and the
extremes.
"""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import LEARNED, RC, tint

rng = np.random.default_rng(1)
base = dampen.read_scenario("he2017", ["task.trials=12", "numerics.modes=24"])
curves = []
for mass, stiffness in rng.uniform([0.05, 25.0], [0.15, 45.0], (30, 2)):
    drawn = replace(base, plant=replace(base.plant, tip_mass=mass, bending_stiffness=stiffness))
    curves.append(np.abs(dampen.simulate(drawn)["y"][..., 0]).max(axis=1))
low, tenth, middle, ninth, high = np.quantile(curves, [0, 0.1, 0.5, 0.9, 1], axis=0)

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(3.5, 2.6), layout="constrained")
trial = np.arange(12)
axes.fill_between(trial, low, high, color=tint(LEARNED, 0.2), label="all")
axes.fill_between(trial, tenth, ninth, color=tint(LEARNED, 0.5), label="middle 80 %")
axes.semilogy(trial, middle, color=LEARNED, label="median")
axes.set(xlabel="trial", ylabel="largest |w(L)| [m]", yscale="log")
axes.legend()

spread = ninth[-1] / tenth[-1]
print(f"In the last trial: median {1000 * middle[-1]:.2f} mm, 80 % between {1000 * tenth[-1]:.2f} and {1000 * ninth[-1]:.2f} mm.")
plt.show()
