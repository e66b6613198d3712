"""What the lab takes on, and what it refuses before it begins."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dampen.component import ArgumentError

if TYPE_CHECKING:
    from dampen.simulation.scenario import Scenario

MESSAGE = 256 * 2**10  # bytes of a request: scenarios are a few thousand
ATTACHMENT = 16 * 2**20
UPLOAD = 256 * 2**20
STORED = 512 * 2**20  # bytes of all uploads together
UNPACKED = 32 * 2**20  # what an attachment may unfold to: matrices of 2,000 degrees of freedom
DEEPEST = 16

SECONDS = 10.0  # a run that would take longer belongs to `dampen run`
MEMORY = 512 * 2**20
PATIENCE = 30.0  # seconds after which a worker that has not answered is ended
LONG_PATIENCE = 300.0  # the same for one that compiles a kernel, or makes a report

# Seconds, as measured on one core: a trial, a step with its signals, and each mode in it; a step of a load along the structure,
# which is projected by a rule that is as fine as the modes or the grid, and of a load at a moving point; finding the modes.
TRIAL, STEP, MODE = 4e-4, 6e-7, 2.5e-9
POINT = 4e-8
LOAD, LOAD_MODES, LOAD_GRID = 4e-6, 2e-10, 1e-6
SPECTRAL, GRID = 1.4e-8, 4e-10

SIGNALS = 10  # doubles that a result keeps for each port and step
KEPT = 128 * 2**20  # loads that a bench keeps


def predicted_seconds(scenario: Scenario) -> float:
    """About how long a run takes, with setting it up."""
    numerics, trials, modes = scenario.numerics, scenario.task.trials, scenario.numerics.modes
    on_grid = numerics.discretisation == "finite-difference"
    found = GRID * (2 * numerics.points) ** 3 if on_grid else SPECTRAL * modes**3
    along = LOAD + (LOAD_GRID * numerics.points if on_grid else LOAD_MODES * modes**2)
    loads = [part.load_field is not None for part in scenario.disturbance.parts]
    points = [part.point_field is not None for part in scenario.disturbance.parts]
    shaken = len({scenario.disturbance.same_as(j) for j in range(trials)}) if any(loads) or any(points) else 0
    load = shaken * scenario.steps * (sum(loads) * along + sum(points) * POINT * modes)
    design = scenario.controller.design_time(trials, scenario.law_grid[0], len(scenario.ports))
    return trials * (TRIAL + scenario.steps * (STEP + MODE * modes)) + load + found + design


def predicted_bytes(scenario: Scenario) -> float:
    """About how much memory its result and its loads take."""
    numerics, output = scenario.numerics, scenario.output
    step = 8 * (SIGNALS * len(scenario.ports) + 6)
    snapshot = 4 * len(scenario.plant.fields) * output.points / output.every
    loads = 8 * scenario.steps * numerics.modes
    return scenario.task.trials * scenario.steps * (step + snapshot) + max(loads, min(KEPT, scenario.task.trials * loads))


def check_cost(scenario: Scenario) -> None:
    """Raise ArgumentError, before anything is computed, for a run that is too long or too large for the lab."""
    for figure, unit, scale, most, name in (
        (predicted_seconds(scenario), "s", 1.0, SECONDS, "numerics.step"),
        (predicted_bytes(scenario), "MiB", 2.0**20, MEMORY, "task.trials"),
    ):
        if figure > most:
            what = "take about" if unit == "s" else "need about"
            raise ArgumentError(
                f"Argument `{name}` must make a smaller run for the lab: this one would {what} {figure / scale:.3g} {unit}, "
                f"more than {most / scale:.0f} {unit}. `dampen run` has no such limit."
            )
