"""Evidence about digital controllers: samples against continuous time, exported C and co-simulation units against runs."""

from __future__ import annotations

from pathlib import Path
from shutil import which
from tempfile import TemporaryDirectory

import numpy as np
from kit import Evidence, Number, about, at_most, canvas, slope, ticks

import dampen
from dampen.simulation.bench import Bench


def sampled_to_continuous() -> Evidence:
    """A smooth law through samples goes to the same law in continuous time, at first order in the period."""
    ports, step, coarsest = ("tip_w", "tip_phi"), 2.5e-4, 0.008
    start = dampen.BeamState(w=(0, 0.02), phi=(0, 0.02))

    def motion(period: float | None) -> np.ndarray:
        scenario = dampen.Scenario(
            plant=dampen.TimoshenkoBeam(damping=dampen.Damping(ratio=0.02, viscous=0.3), initial=start),
            controller=dampen.BoundaryDamping(damping=dict.fromkeys(ports, 0.5), stiffness={"tip_w": 5.0, "tip_phi": 3.0}),
            disturbance=dampen.NoDisturbance(),
            task=dampen.Task(trials=1, trial_duration=0.8),
            numerics=dampen.Numerics(modes=8, step=step, mode="sampled" if period else "continuous"),
            sampling=dampen.Sampling(period=period or step, filter_time=period or 0.0),
        )
        return dampen.simulate(scenario)["y"][0, :: round(coarsest / step)]

    periods, exact = step * np.array([32, 16, 8, 4]), motion(None)
    errors = np.array([np.abs(motion(float(period)) - exact).max() for period in periods])
    figure, (axes,) = canvas()
    axes.loglog(periods, errors, "o", ms=4, label="damping and stiffness")
    slope(axes, (periods[-1], periods[0]), errors[-1], 1, "first order")
    ticks(axes, periods)
    axes.set(xlabel="sample period [s]", ylabel="motion off by [m, rad]")
    axes.legend()
    return Evidence((about("order in the period", np.log2(errors[0] / errors[-1]) / 3, 1, 0.05),), figure)


def exported_c() -> Evidence:
    """The C controller, compiled, on the readings of a run: the commands of the simulation, bit for bit."""
    if not (which("gcc") or which("clang")):
        return Evidence((), missing="a C compiler")
    from dampen.export.c.recording import record
    from tests.c_bench import built

    scenario = dampen.read_scenario("he2017-sampled", ["task.trials=3", "numerics.modes=40"])
    bench = Bench(scenario)
    with TemporaryDirectory() as folder:
        bare = built(scenario, Path(folder), bench=bench)
        trials = list(record(scenario, bench))
        commands = np.concatenate([bare.trial(trial.readings)[1] for trial in trials])
    expected = np.concatenate([trial.commands for trial in trials])
    figure, (axes,) = canvas(1, width=7.16, height=2.0)
    time = np.arange(len(commands)) * scenario.sampling.period
    axes.plot(time, expected[:, 0], "k", lw=1.2, alpha=0.4, label="simulation")
    axes.plot(time, commands[:, 0], lw=0.5, label="C controller")
    axes.set(xlabel="time [s]", ylabel="command u [N]", xlim=(0, time[-1]))
    axes.legend()
    different = int(np.count_nonzero(commands != expected))
    return Evidence((Number(f"of {commands.size} commands, different", different, 0, 0),), figure)


def cosimulation_unit() -> Evidence:
    """The closed loop as a unit of FMI 2.0, stepped by FMPy, against the run."""
    from dampen.export.fmu.building import compiler

    try:
        import fmpy
        from fmpy.fmi2 import FMU2Slave
    except ImportError:
        return Evidence((), missing="FMPy")
    if compiler() is None:
        return Evidence((), missing="a C compiler")
    scenario = dampen.read_scenario("he2017-sampled", ["task.trials=2", "numerics.modes=24"])
    expected = np.concatenate(dampen.simulate(scenario)["y"][:, 1:])
    with TemporaryDirectory() as folder:
        file = str(dampen.export_fmu(scenario, Path(folder) / "loop.fmu").file)
        model = fmpy.read_model_description(file)
        slave = FMU2Slave(
            guid=model.guid, unzipDirectory=fmpy.extract(file, unzipdir=f"{folder}/unit"),
            modelIdentifier=model.coSimulation.modelIdentifier, instanceName="loop",
        )  # fmt: skip
        names = {variable.name: variable.valueReference for variable in model.modelVariables}
        wanted = [names[f"displacement.{port}"] for port in scenario.ports]
        slave.instantiate()
        slave.setupExperiment(startTime=0.0)
        slave.enterInitializationMode()
        slave.exitInitializationMode()
        seen, dt = [], scenario.numerics.step
        for k in range(len(expected)):
            slave.doStep(k * dt, dt)
            seen.append(slave.getReal(wanted))
        slave.freeInstance()
    off = np.abs(np.array(seen) - expected)
    figure, (above, below) = canvas(1, width=7.16, height=1.5, rows=2)
    time = dt * (1 + np.arange(len(expected)))
    above.plot(time, expected[:, 0], "k", lw=1.2, alpha=0.4, label="simulation")
    above.plot(time, np.array(seen)[:, 0], lw=0.6, label="unit")
    above.set(ylabel="w(L, t) [m]", xlim=(0, time[-1]))
    above.legend()
    below.semilogy(time, np.maximum(off[:, 0], 1e-20), lw=0.5)
    below.set(xlabel="time [s]", ylabel="apart by [m]", xlim=(0, time[-1]))
    return Evidence((at_most("displacements off by, relative", off.max() / np.abs(expected).max(), 1e-9),), figure)


ALL = (sampled_to_continuous, exported_c, cosimulation_unit)
