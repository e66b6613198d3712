"""What the lab takes on, and what it refuses before it begins."""

from __future__ import annotations

from dampen.component import ArgumentError
from dampen.simulation.scenario import Scenario

MESSAGE = 256 * 2**10  # bytes of a request: scenarios are a few thousand
ATTACHMENT = 16 * 2**20
UPLOAD = 256 * 2**20
STORED = 512 * 2**20  # bytes of all uploads together
UNPACKED = 64 * 2**20  # what an attachment may unfold to
DEEPEST = 16

SECONDS = 10.0  # a run that would take longer belongs to `dampen run`
MEMORY = 512 * 2**20
PATIENCE = 30.0  # seconds after which a worker that has not answered is ended

STEP, MODE = 4e-7, 1.2e-8  # seconds a step takes, and each mode in it: measured, loads and account included
EIGENVALUES = 3e-10  # seconds, times the cube of the unknowns
SIGNALS = 10  # doubles that a result keeps for each port and step
KEPT = 128 * 2**20  # loads that a bench keeps


def predicted_seconds(scenario: Scenario) -> float:
    """About how long a run takes, with setting it up."""
    numerics = scenario.numerics
    stepping = scenario.task.trials * scenario.steps * (STEP + MODE * numerics.modes)
    unknowns = 2 * numerics.points if numerics.discretisation == "finite-difference" else 2 * numerics.modes
    return stepping + EIGENVALUES * unknowns**3


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
