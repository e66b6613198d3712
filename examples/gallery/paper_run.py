"""
The paper's experiment
======================

A Timoshenko beam with a payload, 25 trials of 2 s, with and without the dual-loop adaptive iterative learning law. The
dashed lines are the output constraint.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import CONSTRAINT, DASHES, DISPLACEMENT, RC, UNCONTROLLED

scenario = dampen.read_scenario("he2017")
controlled, free = dampen.simulate(scenario), dampen.simulate(scenario.uncontrolled())

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(7.16, 2.4), layout="constrained")
for result, colour, label in ((free, UNCONTROLLED, "no control"), (controlled, DISPLACEMENT, "dual-loop ILC")):
    tip = result["y"][:, :-1, 0]
    axes.plot(np.arange(tip.size) * scenario.numerics.step, tip.ravel(), color=colour, lw=0.5, label=label)
for limit in (-0.2, 0.2):
    axes.axhline(limit, color=CONSTRAINT, ls=DASHES)
axes.set(xlabel="time [s]", ylabel="tip displacement w(L, t) [m]", xlim=(0, 50))
axes.legend(loc="upper right", ncols=2)

left = np.abs(controlled["y"][-5:, :, 0]).max()
without = np.abs(free["y"][-5:, :, 0]).max()
print(f"Largest |w(L)| of the last five trials: {1000 * left:.2f} mm with control, {without:.2f} m without.")
plt.show()
