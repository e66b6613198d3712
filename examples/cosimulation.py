"""Plant and controller as two units, run side by side as any master of co-simulation runs them, and held against the simulation.

pip install dampen fmpy
python examples/cosimulation.py
"""

from __future__ import annotations

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import fmpy
import numpy as np
from fmpy.fmi2 import FMU2Slave

import dampen


class Unit:
    """A unit that is ready to step; its variables by name."""

    def __init__(self, file: Path):
        about = fmpy.read_model_description(str(file))
        folder, identifier = fmpy.extract(str(file)), about.coSimulation.modelIdentifier
        self.slave = FMU2Slave(guid=about.guid, unzipDirectory=folder, modelIdentifier=identifier, instanceName=file.stem)
        self.reference = {v.name: v.valueReference for v in about.modelVariables}
        self.slave.instantiate()
        self.slave.setupExperiment(startTime=0.0)
        self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()

    def get(self, names: list[str]) -> list[float]:
        return list(self.slave.getReal([self.reference[name] for name in names]))

    def set(self, names: list[str], values: list[float]) -> None:
        self.slave.setReal([self.reference[name] for name in names], values)


def main(trials: int = 25) -> float:
    """The largest difference of a port's displacement from the simulation's [m, rad]."""
    scenario = dampen.read_scenario("he2017-sampled", [f"task.trials={trials}"])
    with TemporaryDirectory() as folder:
        plant, controller = (
            Unit(dampen.export_fmu(scenario, Path(folder) / f"{what}.fmu", what).file) for what in ("plant", "controller")
        )
    drives, seen = [f"drive.{port}" for port in scenario.ports], [f"displacement.{port}" for port in scenario.ports]
    readings = [f"{name}.{port}" for name in ("reading", "last_reading") for port in scenario.ports]
    step, path = scenario.sampling.period, []
    for k in range(trials * scenario.steps):
        drive, reading = controller.get(drives), plant.get(readings)  # what both put out at the end of the last step ...
        plant.set(drives, drive)  # ... is what the other one goes by in this one
        controller.set(readings, reading)
        plant.slave.doStep(k * step, step)
        controller.slave.doStep(k * step, step)
        path.append(plant.get(seen))
    run = np.concatenate(np.asarray(dampen.simulate(scenario)["y"])[:, 1:])
    worst = float(np.abs(np.array(path) - run).max())
    print(f"{len(path):,} communication steps; displacements within {worst:.1g} of the simulation's, of {np.abs(run).max():.2g}")
    return worst


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
