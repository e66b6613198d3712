"""The task: how many trials, from which start, along which reference, within which constraint."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Annotated, Any, Literal

import numpy as np
from annotated_types import Ge, Gt, Le, Unit
from typing_extensions import Doc

from dampen.component import ArgumentError, Component, wrong
from dampen.signals.base import Signal, sampled

Array = np.ndarray


@dataclass(frozen=True)
class Constraint(Component):
    """Limits low < z < high of a port, where z is its displacement, or its tracking error; each may move with time."""

    high: Annotated[float | Signal, Unit("m, rad"), Doc("upper limit, a number or a signal")]
    low: Annotated[float | Signal | None, Unit("m, rad"), Doc("lower limit; left out: -high")] = None
    on: Annotated[
        Literal["output", "error"], Doc("what is limited: the displacement itself, or its distance from the reference")
    ] = "output"

    def limits(self, t: Array, trial: int, reference: Array) -> tuple[Array, Array]:
        """(times,) lower and upper limits of the displacement."""
        high = sampled(self.high, t, trial)
        low = -high if self.low is None else sampled(self.low, t, trial)
        return (low, high) if self.on == "output" else (reference + low, reference + high)


@dataclass(frozen=True)
class Task(Component):
    """What is to be done: how many trials of what length, from where, along which reference and within which constraint."""

    trials: Annotated[int, Ge(1), Le(100_000), Doc("number of trials")] = 25
    trial_duration: Annotated[float, Gt(0), Unit("s"), Doc("duration T_b of a trial")] = 2.0
    start: Annotated[
        Literal["chained", "reset"],
        Doc("chained: a trial starts where the last one ended (repetitive control); reset: from the plant's initial state"),
    ] = "chained"
    reset_error: Annotated[
        dict[str, float],
        Ge(0),
        Unit("m, rad"),
        Doc("by port, standard deviation of where a reset puts it; the structure bends to it"),
    ] = field(default_factory=dict)
    seed: Annotated[int, Ge(0), Doc("seed of the reset's errors")] = 0
    reference: Annotated[dict[str, Signal], Doc("by port, what it is to follow; left out: zero")] = field(default_factory=dict)
    constraint: Annotated[
        dict[str, float | tuple[float, float] | Constraint],
        Unit("m, rad"),
        Doc("by port, a number C for |y| < C, [low, high], or a table with high, low, on"),
    ] = field(default_factory=dict)

    def check(self) -> None:
        for port, given in self.constraint.items():
            if isinstance(given, int | float) and not given > 0:
                raise wrong(f"constraint.{port}", "be > 0", given)
            if isinstance(given, tuple) and not given[0] < given[1]:
                raise wrong(f"constraint.{port}", "be [low, high] with low < high", given)
        if self.reset_error and self.start != "reset":
            raise wrong("reset_error", 'be left out unless `start` is "reset"', dict(self.reset_error))

    @property
    def steady(self) -> bool:
        """Whether every trial has the same reference, none, and the same constraint."""
        moving = any(
            isinstance(c, Constraint) and isinstance(c.high, Signal) | isinstance(c.low, Signal) for c in self.constraint.values()
        )
        return not self.reference and not moving

    def references(self, ports: tuple[str, ...], t: Array, trial: int) -> Array:
        """(times, ports) references."""
        return np.column_stack([sampled(self.reference.get(name, 0.0), t, trial) for name in ports])

    def limits(self, ports: tuple[str, ...], t: Array, trial: int) -> tuple[Array, Array]:
        """(times, ports) lower and upper limits of the displacement, infinite where there is none.

        Raises ArgumentError where they leave no room for the reference.
        """
        reference = self.references(ports, t, trial)
        low, high = np.full_like(reference, -np.inf), np.full_like(reference, np.inf)
        for p, name in enumerate(ports):
            if name in self.constraint:
                low[:, p], high[:, p] = _constraint(self.constraint[name]).limits(t, trial, reference[:, p])
                outside = np.flatnonzero(~((low[:, p] < reference[:, p]) & (reference[:, p] < high[:, p])))
                if len(outside):
                    k = outside[0]
                    raise ArgumentError(
                        f"Argument `task.constraint.{name}` must leave room for the reference, but at t = {t[k]:.4g} s it is "
                        f"({low[k, p]:.4g}, {high[k, p]:.4g}) around {reference[k, p]:.4g}."
                    )
        return low, high


def _constraint(given: Any) -> Constraint:
    """The long form of a constraint."""
    if isinstance(given, Constraint):
        return given
    return Constraint(high=given[1], low=given[0]) if isinstance(given, tuple) else Constraint(high=float(given))
