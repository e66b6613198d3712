"""What of a run depends on the time step: the same scenario at shorter steps, figure of merit by figure of merit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dampen.simulation.result import Result
from dampen.simulation.scenario import Scenario
from dampen.simulation.trials import simulate


@dataclass(frozen=True)
class Refined:
    """One figure of merit, with its unit, at the scenario's own step and at shorter ones."""

    name: str
    unit: str
    values: tuple[float, ...]

    @property
    def changes(self) -> tuple[float, ...]:
        """How far each value is from the last, relative to the last."""
        last = self.values[-1]
        return tuple(abs(value - last) / abs(last) if last else abs(value) for value in self.values[:-1])


def refine(scenario: Scenario, divisors: Sequence[int] = (1, 2, 4)) -> list[Refined]:
    """The figures of merit of `scenario` at its own time step divided by each of `divisors`.

    A sample period, a delay and the modes stay what they are: only the simulation's step changes.
    """
    rows = [figures_of_merit(run_at(scenario, divisor)) for divisor in divisors]
    return [Refined(name, unit, tuple(row[name, unit] for row in rows)) for name, unit in rows[0]]


def run_at(scenario: Scenario, divisor: int) -> Result:
    """The scenario, run with its step divided."""
    return simulate(finer(scenario, divisor))


def finer(scenario: Scenario, divisor: int = 1, modes: int | None = None) -> Scenario:
    """The scenario with its step divided, snapshots at the same times, and with another number of modes."""
    own, output = scenario.numerics, replace(scenario.output, every=scenario.output.every * divisor)
    return replace(scenario, numerics=replace(own, modes=modes or own.modes, step=own.step / divisor), output=output)


def figures_of_merit(result: Result) -> Mapping[tuple[str, str], float]:
    """By name and unit: at each port the largest error, the RMS of the last trial, effort and chatter; the last energy."""
    found: dict[tuple[str, str], float] = {}
    last = result.trials - 1
    for p, port in enumerate(result.scenario.plant.ports):
        error = [np.asarray(result["y"][j])[:, p] - result.scenario.reference(j)[:, p] for j in range(result.trials)]
        force = np.concatenate([np.asarray(result["delivered"][j])[:, p] for j in range(result.trials)])
        found[f"largest error at {port.name}", port.motion_unit] = float(np.max(np.abs(error)))
        found[f"RMS error of the last trial at {port.name}", port.motion_unit] = float(np.sqrt(np.mean(error[last] ** 2)))
        found[f"RMS force at {port.name}", port.effort_unit] = float(np.sqrt(np.mean(force**2)))
        found[f"variation of the force at {port.name}", port.effort_unit] = float(np.abs(np.diff(force)).sum())
    found["mean energy of the last trial", "J"] = float(np.mean(result["energy"][last]))
    return found
