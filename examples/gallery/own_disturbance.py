"""
A disturbance of one's own
==========================

A gust that comes and goes, stronger from trial to trial: one method that returns an array. The law holds the tip
against it.
"""

from dataclasses import dataclass, replace

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DISPLACEMENT, LEARNED, RC, ROTATION


@dataclass(frozen=True)
class Gust(dampen.Disturbance):
    """d(t) = strength (1 + growth j) (1 - cos(2 pi t / length)) / 2 while t < length, at the tip alone."""

    strength: float = 0.4
    growth: float = 1.0
    length: float = 0.8

    def at_ports(self, trial, t, site):
        gust = np.where(t < self.length, (1 - np.cos(2 * np.pi * t / self.length)) / 2, 0.0)
        return np.outer(self.strength * (1 + self.growth * trial) * gust, [1.0, 0.0])


scenario = dampen.read_scenario("he2017", ["task.trials=4", "numerics.modes=24", "task.start=reset", "plant.initial={}"])
run = dampen.simulate(replace(scenario, disturbance=Gust()))

plt.rcParams.update(RC)
figure, (above, below) = plt.subplots(2, 1, figsize=(3.5, 3.4), sharex=True, layout="constrained")
for trial, colour in zip((0, 1, 3), (DISPLACEMENT, LEARNED, ROTATION), strict=True):
    above.plot(run.time[1:], run["disturbance"][trial, :, 0], color=colour, label=f"trial {trial}")
    below.plot(run.time, 1000 * run["y"][trial, :, 0], color=colour)
above.set_ylabel("gust [N]")
above.legend()
below.set(xlabel="time [s]", ylabel="tip displacement [mm]")

peak = 1000 * np.abs(run["y"][-1, :, 0]).max()
print(f"Largest displacement under the last gust: {peak:.2f} mm.")
plt.show()
