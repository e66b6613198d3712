"""What a policy's numbers mean: commands in [-1, 1], observations in units of what there is room for, and the reward."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from dampen.component import ArgumentError, wrong
from dampen.controllers.base import Array, Setting
from dampen.controllers.scales import first_period, scales
from dampen.simulation.scenario import Scenario

FARTHEST = 100.0  # observations end here, in their own units: finite bounds, which no controlled motion comes near
EFFORT = 0.01


@dataclass(frozen=True)
class Scaling:
    """By port, (ports,): command [N, N m], error [m, rad] and rate [m/s, rad/s] that count as 1; the weight of effort."""

    command: Array
    error: Array
    rate: Array
    effort: float

    def cost(self, square: Array, effort: Array) -> Array:
        """(...,) sum over ports of  mean (e/scale)^2 + weight mean (u/limit)^2,  of means of squares (..., ports)."""
        return np.asarray((square / self.error**2 + self.effort * effort / self.command**2).sum(axis=-1))

    @property
    def worst(self) -> float:
        """The cost of errors and commands that stay at their limits."""
        return len(self.command) * (1 + self.effort)


def scaling_of(
    scenario: Scenario, setting: Setting, command_limit: float | Mapping[str, float] | None, effort_weight: float
) -> Scaling:
    """The scales of a scenario.

    command: `command_limit`, else the scenario's `sampling.command_limit`, else the static force that takes the structure to
             its constraint.
    error:   the least distance from the reference to the constraint, else what that command bends statically.
    rate:    that error at the lowest frequency.
    """
    if not (np.isfinite(effort_weight) and effort_weight >= 0):
        raise wrong("effort_weight", "be >= 0", effort_weight)
    given = _limits(scenario, command_limit)
    own = {s.port.name: s for s in scales(setting)}
    command, error = [], []
    for port in scenario.ports:
        limit, scale = given.get(port), own.get(port)
        room = float(np.minimum(setting.high, -setting.low)[:, scenario.ports.index(port)].min())
        if scale is None:  # nothing acts there
            command.append(1.0 if limit is None else limit)
            error.append(room if np.isfinite(room) else 1.0)
            continue
        if limit is None and not np.isfinite(room):
            raise ArgumentError(f"Argument `command_limit` must be given for {port}: the scenario has no limit or constraint there.")
        command.append(scale.stiffness * room if limit is None else limit)
        error.append(room if np.isfinite(room) else command[-1] / scale.stiffness)
    rate = 2 * np.pi / first_period(setting)
    return Scaling(np.array(command), np.array(error), rate * np.array(error), float(effort_weight))


def _limits(scenario: Scenario, command_limit: float | Mapping[str, float] | None) -> Mapping[str, float]:
    """The limits that are given, by port."""
    if command_limit is None:
        return scenario.sampling.command_limit
    given = command_limit if isinstance(command_limit, Mapping) else dict.fromkeys(scenario.ports, float(command_limit))
    for port, limit in given.items():
        if port not in scenario.ports:
            known = ", ".join(scenario.ports)
            raise ArgumentError(f"Argument `command_limit.{port}` is not a port of this plant; known here: {known}.")
        if not (np.isfinite(limit) and limit > 0):
            raise wrong(f"command_limit.{port}", "be > 0", limit)
    return {**scenario.sampling.command_limit, **given}
