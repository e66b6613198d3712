"""
A policy in Gymnasium
=====================

A policy takes the place of the law: here a linear one, at four strengths side by side, in one compiled call a step.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
import dampen.gym
from dampen.report.style import RC, tint

STRENGTHS = np.array([0.0, 0.1, 0.3, 1.0])
short = ["task.trials=1", "numerics.modes=24", "numerics.step=0.002", "controller.kind=none", "task.constraint={}"]
env = dampen.gym.BeamVectorEnv(4, "he2017", overrides=short, period=0.004, command_limit=3.0, error_scale=0.2)
seen, _ = env.reset()
tip, over = [], np.array([False])
while not over.any():
    seen, _, _, over, about = env.step(-STRENGTHS[:, None] * (0.3 * seen[:, :2] + seen[:, 2:4]))
    tip.append(about["displacement"][:, 0])
tip = np.array(tip)

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(7.16, 2.4), layout="constrained")
for k, strength in enumerate(STRENGTHS):
    axes.plot(0.004 * np.arange(1, len(tip) + 1), tip[:, k], color=tint("#0072B2", 0.25 + 0.25 * k), label=f"{strength:g}")
axes.set(xlabel="time [s]", ylabel="tip displacement [m]")
axes.legend(title="strength", ncols=4, loc="upper center")

ratio = float(np.sqrt(np.mean(tip[:, -1] ** 2) / np.mean(tip[:, 0] ** 2)))
print(f"RMS of the tip at full strength: {100 * ratio:.0f} % of that without a policy.")
plt.show()
