"""What a run will take, before it begins: seconds, memory and disk, as measured; and what is refused for it."""

from __future__ import annotations

import os
import shutil
from pathlib import Path
from typing import TYPE_CHECKING

from dampen.component import ArgumentError

if TYPE_CHECKING:
    from dampen.simulation.result import Layout
    from dampen.simulation.scenario import Scenario

# Seconds, as measured on one core: a trial, a step with its signals, and each mode in it; a step of a load along the structure,
# which is projected by a rule that is as fine as the modes or the grid, and of a load at a moving point; finding the modes.
TRIAL, STEP, MODE = 4e-4, 6e-7, 2.5e-9
POINT = 4e-8
LOAD, LOAD_MODES, LOAD_GRID = 4e-6, 2e-10, 1e-6
SPECTRAL, GRID = 1.4e-8, 4e-10

SIGNALS = 10  # doubles that a result keeps for each port and step
KEPT = 128 * 2**20  # loads that a bench keeps
WORKING = 8  # arrays of a step's signals that a trial is worked out in


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


def check_time(scenario: Scenario, runs: float, hours: float) -> None:
    """Raise ArgumentError for what is to take more than `hours`, which is `runs` runs of the scenario, one after the other."""
    if not hours > 0:
        raise ArgumentError(f"Option `--hours` must be > 0, but is {hours:g}.")
    wanted = runs * predicted_seconds(scenario) / 3600
    if wanted > hours:
        raise ArgumentError(
            f"Argument `task.trials` must be smaller, `numerics.step` larger, or `--hours` at least {wanted:.2g}: this is "
            f"predicted to take {wanted:.3g} hours, and more than {hours:g} are refused."
        )


def check_memory_of_trial(scenario: Scenario) -> None:
    """Raise ArgumentError for a trial that does not fit into the memory that is free."""
    per_step = 8 * (WORKING * (SIGNALS * len(scenario.ports) + 6) + 3 * scenario.numerics.modes)
    refuse(scenario.steps * per_step, memory_free(), "numerics.step", "be larger", "memory")


def check_memory(layout: Layout) -> None:
    """Raise ArgumentError for a result in memory that does not fit into what is free."""
    refuse(size_of(layout, "if"), memory_free(), "task.trials", "be smaller, or the result go to a file", "memory")


def check_disk(layout: Layout, path: Path) -> None:
    """Raise ArgumentError for a result whose signals, which no compression makes smaller, do not fit onto the disk."""
    free = shutil.disk_usage(path.absolute().parent).free
    refuse(size_of(layout, "8"), free, "task.trials", "be smaller", f"disk in `{path.absolute().parent}`")


def size_of(layout: Layout, kinds: str) -> float:
    """Bytes of the variables of all trials whose kind has one of these letters in it."""
    size = 0.0
    for variable in layout.variables.values():
        count = 1.0
        for n in layout.shape(variable):
            count *= n
        size += count * int(variable.kind[1:]) * any(letter in variable.kind for letter in kinds)
    return size * layout.scenario.task.trials


def refuse(needed: float, free: float, argument: str, must: str, of: str) -> None:
    """Raise ArgumentError where more is needed than is free."""
    if needed > free:
        sizes = f"{needed / 2**30:.3g} GiB of {of}, where {free / 2**30:.3g} are free"
        raise ArgumentError(f"Argument `{argument}` must {must}: this would need about {sizes}.")


def memory_free() -> float:
    """Bytes of memory that a program can still have, as far as the system tells."""
    try:
        lines = Path("/proc/meminfo").read_text(encoding="ascii").splitlines()
        return 1024.0 * next(int(line.split()[1]) for line in lines if line.startswith("MemAvailable"))
    except (OSError, StopIteration):
        pass
    try:
        return float(os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"))
    except (AttributeError, ValueError, OSError):
        return float("inf")
