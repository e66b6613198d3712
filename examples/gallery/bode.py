"""
The plant as a state-space model
================================

Receptance at the tip of the paper's beam: six modes alone are too stiff far below their frequencies; with the static
compliance of the modes left out they are right.
"""

import matplotlib.pyplot as plt
import numpy as np

import dampen
from dampen.report.style import DISPLACEMENT, RC, ROTATION, UNCONTROLLED

scenario = dampen.read_scenario("he2017", ["plant.damping.ratio=0.01"])
models = {
    "80 modes": (dampen.state_space(scenario), UNCONTROLLED, "-"),
    "6 modes": (dampen.state_space(scenario, modes=6), ROTATION, "--"),
    "6 modes and residual": (dampen.state_space(scenario, modes=6, residual=True), DISPLACEMENT, ":"),
}
hertz = np.geomspace(0.1, 6, 600)

plt.rcParams.update(RC)
figure, axes = plt.subplots(figsize=(7.16, 2.6), layout="constrained")
response = {}
for name, (model, colour, style) in models.items():
    response[name] = np.array([model(2j * np.pi * f)[0, 0] for f in hertz])
    axes.loglog(hertz, np.abs(response[name]), style, color=colour, label=name)
axes.set(xlabel="frequency [Hz]", ylabel="w(L) / force [m/N]")
axes.legend()

few, better = (abs(response[name][0] / response["80 modes"][0] - 1) for name in ("6 modes", "6 modes and residual"))
print(f"At 0.1 Hz six modes are off by {100 * few:.1f} %, with the residual by {better:.1e}.")
plt.show()
