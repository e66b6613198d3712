"""
A backlash, traced
==================

What the actuator delivers against what it is commanded, in trial 0. With compensation the controller crosses the gap at
once; commanded directly, force is missing whenever the command turns round.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DISPLACEMENT, FAINT, LEARNED, RC

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(3.5, 3.0), layout="constrained")
axes.axline((0, 0), slope=0.3, color=FAINT, lw=0.6, label="no gap")
for compensate, colour, style in (("true", LEARNED, "-"), ("false", DISPLACEMENT, "--")):
    scenario = dampen.read_scenario("he2017", ["task.trials=1", "numerics.modes=40", f"controller.compensate={compensate}"])
    run = dampen.simulate(scenario)
    stage = scenario.chain(0)[0]
    command = run["command"][0, :, 0]
    label = "compensated" if compensate == "true" else "direct"
    axes.plot(command, run["delivered"][0, :, 0], style, color=colour, lw=0.6, label=label)
axes.set(xlabel="command u [N]", ylabel="delivered force B [N]")
axes.legend()

off = np.abs(run["delivered"][0, :, 0] - stage.slope * command).max()
print(f"Commanded directly, the force is off its line by up to {off:.3f} N: the slope times an end of the gap.")
plt.show()
