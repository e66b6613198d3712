"""What a policy's numbers mean: commands in [-1, 1], observations in units of what there is room for, and the reward."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from dampen.component import ArgumentError, is_number, wrong
from dampen.controllers.base import Array, Setting
from dampen.controllers.scales import first_period, scales
from dampen.simulation.scenario import Scenario

FARTHEST = 100.0  # observations end here, in their own units: finite bounds, which no controlled motion comes near
EFFORT = 0.01
ByPort = float | Mapping[str, float]


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
    scenario: Scenario, setting: Setting, command_limit: ByPort | None, error_scale: ByPort | None, effort_weight: float
) -> Scaling:
    """The scales of a scenario.

    error:   `error_scale`, else the least distance from the reference to the constraint, else the reference's largest
             excursion, else what the command limit bends statically.
    command: `command_limit`, else the scenario's `sampling.command_limit`, else the static force that bends the structure by
             the error's scale; 1 where no force reaches the structure.
    rate:    the error's scale at the lowest frequency.

    Raises ArgumentError where nothing of all that is known.
    """
    if not (is_number(effort_weight) and effort_weight >= 0):
        raise wrong("effort_weight", "be a number >= 0", effort_weight)
    limits = {**scenario.sampling.command_limit, **by_port(scenario, "command_limit", command_limit)}
    errors = by_port(scenario, "error_scale", error_scale)
    stiffness = {s.port.name: s.stiffness for s in scales(setting)}
    command, error = np.ones((2, len(scenario.ports)))
    for p, port in enumerate(scenario.ports):
        far, limit = errors.get(port, excursion(setting, p)), limits.get(port)
        if port not in stiffness:
            error[p], command[p] = far or 1.0, limit or 1.0
        elif far is not None:
            error[p], command[p] = far, limit or stiffness[port] * far
        elif limit is not None:
            error[p], command[p] = limit / stiffness[port], limit
        else:
            raise ArgumentError(
                f"Argument `command_limit.{port}` must be given: the scenario has no limit, constraint or reference there."
            )
    return Scaling(command, error, 2 * np.pi / first_period(setting) * error, float(effort_weight))


def excursion(setting: Setting, p: int) -> float | None:
    """The least distance from the reference to the constraint at a port, else how far its reference goes; None: neither."""
    room = float(np.minimum(setting.high[:, p], -setting.low[:, p]).min())
    if np.isfinite(room):
        return room
    return float(np.abs(setting.reference[:, p]).max()) or None


def by_port(scenario: Scenario, name: str, given: ByPort | None) -> Mapping[str, float]:
    """Numbers by port, checked; one number is for all ports."""
    if given is None:
        return {}
    table = given if isinstance(given, Mapping) else dict.fromkeys(scenario.ports, given)
    for port, number in table.items():
        if port not in scenario.ports:
            known = ", ".join(scenario.ports)
            raise ArgumentError(f"Argument `{name}.{port}` is not a port of this plant; known here: {known}.")
        if not (is_number(number) and number > 0):
            raise wrong(f"{name}.{port}", "be a number > 0", number)
    return table
