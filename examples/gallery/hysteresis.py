"""
Hysteresis and its inverse
==========================

A piezoelectric actuator as a sum of plays, driven by a decaying sinusoid. The inverse of a sum of plays is one again,
in closed form: with exact estimates nothing is left, with estimates a tenth off a thin loop.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DISPLACEMENT, FAINT, LEARNED, RC, UNCONTROLLED


def driven(stages, command):
    states, out = [np.array(stage.start()) for stage in stages], []
    for u in command:
        for i, stage in enumerate(stages):
            new = states[i].copy()
            u = stage.step(u, states[i], np.array(stage.row(0.001)), new)
            states[i] = new
        out.append(u)
    return np.array(out)


piezo = dampen.PrandtlIshlinskii(linear=0.5, weights=(0.2, 0.15, 0.1), radii=(0.05, 0.15, 0.3))
exact = dampen.PrandtlIshlinskiiInverse(linear=0.5, weights=(0.2, 0.15, 0.1), radii=(0.05, 0.15, 0.3))
wrong = dampen.PrandtlIshlinskiiInverse(linear=0.55, weights=(0.18, 0.165, 0.09), radii=(0.05, 0.15, 0.3))
wanted = np.sin(np.linspace(0, 8 * np.pi, 2000)) * np.linspace(1, 0.2, 2000)

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(3.5, 3.0), layout="constrained")
axes.axline((0, 0), slope=1, color=FAINT, lw=0.6)
for chain, colour, label in (
    ([piezo], UNCONTROLLED, "no inverse"),
    ([wrong, piezo], DISPLACEMENT, "a tenth off"),
    ([exact, piezo], LEARNED, "exact"),
):
    delivered = driven(chain, wanted)
    axes.plot(wanted, delivered, color=colour, lw=0.8, label=label)
    print(f"{label:>12}: off by up to {np.abs(delivered - wanted).max():.3f} N")
axes.set(xlabel="wanted force [N]", ylabel="delivered force [N]")
axes.legend()

off = np.abs(driven([wrong, piezo], wanted) - wanted).max()
plt.show()
