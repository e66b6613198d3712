"""
A barrier at work
=================

The tip starts at 0.16 m, moving outwards, and may not pass 0.17 m. Damping alone lets it; with a barrier, the force
grows as the wall comes near, and the barrier's energy is given back on the way home.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import CONSTRAINT, DASHES, DISPLACEMENT, RC, UNCONTROLLED

WALL = 0.17
short = ["task.trials=1", "task.trial_duration=0.5", "numerics.modes=40", f"task.constraint.tip_w={WALL}"]
scenario = dampen.read_scenario("he2017", [*short, "plant.initial.w_rate=[0.3, 0.2]"])

plt.rcParams.update(RC)
figure, (above, below) = plt.subplots(2, 1, figsize=(3.5, 3.4), sharex=True, layout="constrained")
peaks = {}
for gain, colour, label in ((0.0, UNCONTROLLED, "no barrier"), (0.05, DISPLACEMENT, "log barrier")):
    law = dampen.BoundaryDamping(damping={"tip_w": 0.3}, barrier="log", barrier_gain={"tip_w": gain})
    run = dampen.simulate(scenario.with_controller(law))
    above.plot(run.time, run["y"][0, :, 0], color=colour, label=label)
    below.plot(run.time, run["barrier_energy"][0], color=colour)
    peaks[label] = np.abs(run["y"][0, :, 0]).max()
above.axhline(WALL, color=CONSTRAINT, ls=DASHES)
above.set_ylabel("tip displacement [m]")
above.legend()
below.set(xlabel="time [s]", ylabel="barrier energy [J]")

room = WALL - peaks["log barrier"]
print(f"Largest displacement: {peaks['no barrier']:.4f} m without barrier, {peaks['log barrier']:.4f} m with it.")
plt.show()
