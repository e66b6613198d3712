"""What is measured: a field over the structure, or the tracking error of a port, over exactly what a result keeps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from hashlib import sha256

import numpy as np

from dampen.actuators.absent import Absent
from dampen.analysis.metrics import tracking_error
from dampen.component import ArgumentError, shown, suggestion
from dampen.simulation.bench import Bench
from dampen.simulation.result import Result
from dampen.simulation.sampling import Sampling
from dampen.simulation.scenario import Scenario
from dampen.stage import Stage
from dampen.toml import to_toml

Array = np.ndarray


@dataclass(frozen=True)
class Measure:
    """e = outputs q - reference, at every `every`-th time of each trial, both ends included.

    of: a field or a port.   unit: m or rad.   outputs: (outputs, modes).   reference: (trials, times, 1), or None for zero.
    """

    of: str
    unit: str
    every: int
    outputs: Array
    reference: Array | None


def measures(scenario: Scenario) -> tuple[str, ...]:
    """What is measured by default: ports that have something to follow; else all fields; without any, all ports."""
    followed = tuple(port for port in scenario.ports if port in scenario.task.reference)
    return followed or tuple(name for name, _ in scenario.plant.fields) or scenario.ports


def measure(scenario: Scenario, of: str, bench: Bench) -> Measure:
    """The measure named `of`. Raises ArgumentError for what is neither a field nor a port of the plant."""
    fields = dict(scenario.plant.fields)
    check_measures(scenario, [of])
    if of in fields:
        return Measure(of, fields[of], scenario.output.every, bench.shapes[of], None)
    p, trials = scenario.ports.index(of), range(scenario.task.trials)
    follows = of in scenario.task.reference
    reference = np.stack([scenario.reference(j)[:, p, None] for j in trials]) if follows else None
    return Measure(of, scenario.plant.ports[p].motion_unit, 1, bench.modes.b[p : p + 1], reference)


def check_measures(scenario: Scenario, names: Sequence[str]) -> None:
    """Raise ArgumentError for what is neither a field nor a port of the plant, and where no port has an actuator."""
    known = [*(name for name, _ in scenario.plant.fields), *scenario.ports]
    for of in names:
        if of not in known:
            raise ArgumentError(
                f"Argument `of` must be a field or a port of this plant, but is {shown(of)}{suggestion(of, known)}"
            )
    usable(scenario)


def measured(result: Result, of: str) -> tuple[float, float]:
    """Root mean square and peak of what a result keeps of it: a field at all snapshots and points, or a port's error."""
    squares, largest, is_field = [], 0.0, of in dict(result.scenario.plant.fields)
    for j in range(result.trials):
        values = np.asarray(result[of][j], float) if is_field else tracking_error(result, of, j)
        squares.append(float(np.mean(np.square(values))))
        largest = max(largest, float(np.max(np.abs(values))))
    return float(np.sqrt(np.mean(squares))), largest


def scales(scenario: Scenario) -> Array:
    """(ports,) what one newton of effort is at each port: 1 N of force, span times 1 N of torque [m]."""
    return np.array([1.0 if port.kind == "force" else scenario.plant.span for port in scenario.plant.ports])


def effort(result: Result) -> float:
    """Root mean square of the delivered forces of all ports together over the run [N], torques divided by the span."""
    forces = [np.square(np.asarray(result["delivered"][j]) / scales(result.scenario)) for j in range(result.trials)]
    return float(np.sqrt(np.mean([np.mean(np.sum(f, axis=1)) for f in forces])))


def usable(scenario: Scenario) -> list[int]:
    """The ports that have an actuator. Raises ArgumentError where there is none."""
    gains = [np.prod([stage.gain for stage in scenario.actuators.get(port, ())]) for port in scenario.ports]
    found = [p for p, gain in enumerate(gains) if gain != 0]
    if not found:
        raise ArgumentError("Argument `scenario` must have an actuator at some port for there to be a limit, but has none.")
    return found


def experiment(scenario: Scenario) -> str:
    """A digest of what a controller cannot change: plant, disturbance, task, numerics, output, ports with an actuator."""
    absent: dict[str, tuple[Stage, ...]] = {
        port: (Absent(),) for p, port in enumerate(scenario.ports) if p not in usable(scenario)
    }
    bare = replace(
        scenario.uncontrolled(),
        task=replace(scenario.task, constraint={}),
        sampling=Sampling(),
        actuators=absent,
        bounds={},
        name="experiment",
        title="",
        claims=None,
    )
    return sha256(to_toml(bare).encode()).hexdigest()[:16]
