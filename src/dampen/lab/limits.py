"""What the lab takes on, and what it refuses before it begins."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dampen.component import ArgumentError
from dampen.simulation.cost import predicted_bytes, predicted_seconds

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
