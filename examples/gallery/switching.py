"""
Sgn through samples: chatter or stick
=====================================

At 1 kHz a Sgn of the estimated rate flips with every sample. The implicit one solves for the command that brings the
tip to rest, and holds it.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DISPLACEMENT, RC, UNCONTROLLED

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(7.16, 2.4), layout="constrained")
variation = {}
for switching, colour in (("explicit", UNCONTROLLED), ("implicit", DISPLACEMENT)):
    few = ["task.trials=2", "numerics.modes=40", "sampling.noise={}", "sampling.quantum={}", f"sampling.switching={switching}"]
    run = dampen.simulate(dampen.read_scenario("he2017-sampled", few))
    command = run["command"][1, :, 0]
    variation[switching] = np.abs(np.diff(command)).sum()
    axes.plot(run.time[:300], command[:300], color=colour, lw=0.7, label=f"{switching}: variation {variation[switching]:.0f} N")
axes.set(xlabel="time in trial 1 [s]", ylabel="command u [N]")
axes.legend()

ratio = variation["implicit"] / variation["explicit"]
print(f"The implicit Sgn moves the command by {100 * ratio:.0f} % of what the explicit one does.")
plt.show()
