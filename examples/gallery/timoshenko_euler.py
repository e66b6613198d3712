"""
When is a beam slender?
=======================

Frequencies of a Timoshenko cantilever of square section against those by Euler and Bernoulli, as the beam gets longer.
High modes bend in short waves, so that they feel shear and rotary inertia first.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DISPLACEMENT, LEARNED, RC, ROTATION

SIDE, YOUNG, SHEAR, DENSITY = 0.02, 70e9, 5 / 6 * 26e9, 2700.0  # m, Pa, Pa with the section's factor, kg/m^3
area, inertia = SIDE**2, SIDE**4 / 12
slenderness = np.geomspace(5, 100, 12)
ratios = []
for length in slenderness * SIDE:
    same = {
        "mass_per_length": DENSITY * area,
        "length": length,
        "tip_mass": 0.0,
        "bending_stiffness": YOUNG * inertia,
        "tip_inertia": 0.0,
    }
    thick = dampen.TimoshenkoBeam(rotary_inertia=DENSITY * inertia, shear_stiffness=SHEAR * area, **same)
    ratios.append(thick.modes(3).omega / dampen.EulerBernoulliBeam(**same).modes(3).omega)
ratios = np.array(ratios)

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(3.5, 2.6), layout="constrained")
for mode, (colour, mark) in enumerate(((DISPLACEMENT, "o-"), (ROTATION, "s--"), (LEARNED, "^:"))):
    axes.semilogx(slenderness, ratios[:, mode], mark, color=colour, ms=3, label=f"mode {mode + 1}")
axes.set(xlabel="length / side of the section", ylabel="frequency, Timoshenko / Euler-Bernoulli")
axes.legend()

third = ratios[0, 2]
print(f"The third frequency is {100 * (1 - third):.0f} % lower at a slenderness of 5, {100 * (1 - ratios[-1, 2]):.2f} % at 100.")
plt.show()
