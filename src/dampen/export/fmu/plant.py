"""The plant as numbers for C: modes, the exact step, stages of the actuators, and what every trial brings."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from functools import cached_property

import numpy as np

from dampen.component import ArgumentError, own_name
from dampen.export.c.blueprint import compensation
from dampen.own import own
from dampen.simulation.bench import Bench
from dampen.simulation.scenario import Scenario
from dampen.stage import Stage

Array = np.ndarray
LARGEST = 2**30  # bytes of tables


@dataclass(frozen=True)
class Placed:
    """A stage of an actuator. adjustable: its parameters that stand as they are in the row its function reads, name and place."""

    port: int
    index: int
    stage: Stage
    row: tuple[float, ...]
    adjustable: tuple[tuple[str, int], ...]

    @property
    def name(self) -> str:
        return f"stage_{self.port}_{self.index}"


@dataclass(frozen=True)
class Plant:
    """All that stands between the commands and the readings.

    period: steps from reading to reading.   noisy: whether the sensors are.   reset: whether each trial starts anew.
    """

    scenario: Scenario
    bench: Bench

    @property
    def period(self) -> int:
        numerics, sampling = self.scenario.numerics, self.scenario.sampling
        return round(sampling.period / numerics.step) if self.scenario.sampled else 1

    @property
    def samples(self) -> int:
        return self.scenario.steps // self.period

    @property
    def reset(self) -> bool:
        return self.scenario.task.start == "reset"

    @property
    def noisy(self) -> bool:
        return bool(np.any(self.spread))

    @property
    def spread(self) -> Array:
        """(ports,) of the sensors' noise."""
        return self._by_port(self.scenario.sampling.noise)

    @property
    def quantum(self) -> Array:
        """(ports,) of the sensors' quantisers, 0: none."""
        return self._by_port(self.scenario.sampling.quantum)

    def _by_port(self, given: dict[str, float]) -> Array:
        return np.array([given.get(name, 0.0) if self.scenario.sampled else 0.0 for name in self.scenario.ports])

    @cached_property
    def stages(self) -> tuple[Placed, ...]:
        """The stages of all actuators."""
        return tuple(self._stages())

    def _stages(self) -> Iterator[Placed]:
        dt = self.scenario.numerics.step
        for p, port in enumerate(self.scenario.ports):
            for i, stage in enumerate(self.scenario.chain(p)[len(compensation(self.scenario, p)) :]):
                if own(type(stage)):
                    raise ArgumentError(
                        f"Argument `actuator.{port}` has {own_name(stage)}, Python of your own, which cannot be exported as C."
                    )
                yield Placed(p, i, stage, tuple(stage.row(dt)) or (0.0,), tuple(adjustable(stage, dt)))

    @cached_property
    def row_of_trial(self) -> tuple[int, ...]:
        """Which row of the tables shakes each trial."""
        firsts = [self.scenario.disturbance.same_as(j) for j in range(self.scenario.task.trials)]
        order = list(dict.fromkeys(firsts))
        return tuple(order.index(first) for first in firsts)

    @cached_property
    def shaking(self) -> tuple[tuple[Array, Array, Array], ...]:
        """For each row: forces at the ports (steps, ports), and the modal load as a product, (steps, rank) by (rank, modes)."""
        firsts = [self.row_of_trial.index(row) for row in range(max(self.row_of_trial) + 1)]
        scenario, found, numbers = self.scenario, [], 0
        trials, ports, modes = scenario.task.trials, len(scenario.ports), self.bench.modes.count
        kept = trials * ((self.samples + 1) * ports * self.noisy + modes * bool(scenario.task.reset_error))
        self._check_size(kept + len(firsts) * scenario.steps * ports)
        for trial in firsts:
            found.append(self._shaking(trial))
            numbers += sum(part.size for part in found[-1])
            self._check_size(kept + numbers)
        return tuple(found)

    def _shaking(self, trial: int) -> tuple[Array, Array, Array]:
        at_ports, in_time, in_modes = self.bench.factors(trial)
        if len(in_modes) < in_time.shape[1]:  # the base is shaken
            in_modes = np.vstack([in_modes, -self.translation])
        return at_ports, in_time, in_modes

    @cached_property
    def tables(self) -> dict[str, Array]:
        """What trials bring: at_ports (rows, steps, ports), in_time and in_modes as in `shaking` row after row, noise (trials,
        samples + 1, ports), misplaced (trials, modes); each empty where there is no such thing."""
        trials = range(self.scenario.task.trials)
        at_ports = np.array([ports for ports, _, _ in self.shaking])
        misplaced = np.array([self.bench.state(j)[0] - self.bench.start[0] for j in trials])
        nothing = np.zeros(0)
        return {
            "at_ports": at_ports if np.any(at_ports) else nothing,
            "in_time": np.concatenate([time.ravel() for _, time, _ in self.shaking]),
            "in_modes": np.concatenate([modes.ravel() for _, _, modes in self.shaking]),
            "noise": np.array([self.noise(j) for j in trials]) if self.noisy else nothing,
            "misplaced": misplaced if np.any(misplaced) else nothing,
        }

    @property
    def ranks(self) -> tuple[int, ...]:
        """How many shapes along the structure the load of each row is made of."""
        return tuple(time.shape[1] for _, time, _ in self.shaking)

    def noise(self, trial: int) -> Array:
        """(samples + 1, ports) as the sensors have it in a trial."""
        drawn = np.random.default_rng([self.scenario.sampling.seed, trial])
        return self.spread * drawn.standard_normal((self.samples + 1, len(self.scenario.ports)))

    def _check_size(self, numbers: int) -> None:
        if 8 * numbers > LARGEST:
            raise ArgumentError(
                f"Argument `task` must be shorter for an export of its plant: what shakes {self.scenario.task.trials} trials of "
                f"{self.scenario.steps} steps would be more than {LARGEST / 2**30:.2g} GiB of tables."
            )

    @property
    def translation(self) -> Array:
        """(modes,) inertia against a translation of the base."""
        found = self.bench.modes.translation
        return np.zeros(self.bench.modes.count) if found is None else found


def adjustable(stage: Stage, dt: float) -> Iterator[tuple[str, int]]:
    """The parameters that a stage's function reads as they are, and where: changed, they change that one number of the row."""
    row = tuple(stage.row(dt))
    for field in fields(stage):
        value = getattr(stage, field.name)
        if isinstance(value, bool) or not isinstance(value, float) or not math.isfinite(value):
            continue
        other = nudged(stage, field.name, value)
        after = tuple(other.row(dt)) if other is not None else row
        changed = [i for i, (a, b) in enumerate(zip(row, after, strict=True)) if a != b]
        if (
            other is not None
            and len(changed) == 1
            and (row[changed[0]], after[changed[0]]) == (value, getattr(other, field.name))
        ):
            yield field.name, changed[0]


def nudged(stage: Stage, name: str, value: float) -> Stage | None:
    """The stage with one parameter a little different, if that can be had."""
    for other in (value * 1.01, value * 0.99, value + 1e-3, value - 1e-3):
        if other != value:
            try:
                return replace(stage, **{name: other})
            except ArgumentError:
                continue
    return None
