"""Bouc-Wen: smooth rate-independent hysteresis."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from annotated_types import Gt, Unit
from typing_extensions import Doc

from dampen.component import wrong
from dampen.stage import Array, Stage, Step

LEAST_LOSS = 1e-6  # beta / |gamma|: below, z would round to its limit value and stay there
NEGLIGIBLE = 1e-17


def bouc_wen_step(command: float, state: Array, parameters: Array, new_state: Array) -> float:
    """B = slope u + hysteresis z, z moved along the straight path from the last command to this one."""
    slope, hysteresis, rise, exponent = parameters[0], parameters[1], parameters[2], parameters[3]
    onward, back = parameters[4], parameters[5]
    way = command - state[1]
    sign = -1.0 if way < 0.0 else 1.0
    z = sign * moved(sign * state[0], abs(way), rise, onward, back, exponent)
    new_state[0], new_state[1] = z, command
    return slope * command + hysteresis * z


def moved(z: float, way: float, rise: float, onward: float, back: float, exponent: float) -> float:
    """z after a command that rose by `way`: dz/du = rise - onward z^n above zero, rise - back |z|^n below."""
    if z < 0.0:
        if exponent == 1.0:
            return released_1(z, way, rise, onward, back)
        return released_2(z, way, rise, onward, back)
    return loaded_1(z, way, rise, onward) if exponent == 1.0 else loaded_2(z, way, rise, onward)


def loaded_1(z: float, way: float, rise: float, onward: float) -> float:
    """dz/du = rise - onward z from z >= 0: an exponential towards rise / onward."""
    return z - (rise / onward - z) * math.expm1(-onward * way)


def loaded_2(z: float, way: float, rise: float, onward: float) -> float:
    """dz/du = rise - onward z^2 from z >= 0: a hyperbolic tangent towards sqrt(rise / onward)."""
    limit = math.sqrt(rise / onward)
    t, ratio = math.tanh(math.sqrt(rise * onward) * way), z / limit
    return z + limit * (1 - ratio) * (1 + ratio) * t / (1 + ratio * t)


def released_1(z: float, way: float, rise: float, onward: float, back: float) -> float:
    """dz/du = rise + back z from z < 0, an exponential; what is left of the way at z = 0 goes on above it."""
    if back == 0.0:
        to_zero = -z / rise
        return z + rise * way if way < to_zero else loaded_1(0.0, way - to_zero, rise, onward)
    to_zero = -math.log1p(back * z / rise) / back
    if way < to_zero:
        return min(z + (rise + back * z) * math.expm1(back * way) / back, 0.0)
    return loaded_1(0.0, way - to_zero, rise, onward)


def released_2(z: float, way: float, rise: float, onward: float, back: float) -> float:
    """dz/du = rise - back z^2 from z < 0, a hyperbolic tangent or a tangent; the rest of the way goes on above zero."""
    if back == 0.0:
        to_zero = -z / rise
        return z + rise * way if way < to_zero else loaded_2(0.0, way - to_zero, rise, onward)
    rate, scale = math.sqrt(rise * abs(back)), math.sqrt(rise / abs(back))
    ratio = -z / scale
    to_zero = (math.atanh(ratio) if back > 0.0 else math.atan(ratio)) / rate
    if way >= to_zero:
        return loaded_2(0.0, way - to_zero, rise, onward)
    if back > 0.0:
        t = math.tanh(rate * way)
        return min(z + scale * (1 - ratio) * (1 + ratio) * t / (1 - ratio * t), 0.0)
    t = math.tan(rate * way)
    return min(z + scale * (1 + ratio * ratio) * t / (1 + ratio * t), 0.0)


@dataclass(frozen=True)
class BoucWen(Stage):
    """Smooth rate-independent hysteresis, exact over every step.

        B = slope command + hysteresis z        dz/du = a - |z|^n (gamma + beta sgn(z du))        z = 0 before the first trial

    Over a step the command u moves monotonically from its last value to the new one, and the equation is solved in closed
    form, so that only the path counts and not in how many steps it is passed. With a > 0, beta > 0 and beta + gamma > 0, z
    stays within (a / (beta + gamma))^(1/n), which it reaches in the limit.

    Within that, dz/du takes every value from 0 (at the limit) to a max(1, 2 beta / (beta + gamma)): a at z = 0, the other at
    the limit just after the command has turned round. So the output never decreases with the command, `monotone`, if

        slope + hysteresis a max(1, 2 beta / (beta + gamma)) >= 0

    which only a negative `hysteresis` can break. Piezo actuators are often written B = d u - h with h of this form: slope = d,
    hysteresis = -1. Sources: Wen, J. Eng. Mech. Div. ASCE 102(2), 1976; Ikhouane and Rodellar, Systems with Hysteresis, 2007
    (bounds on z).
    """

    slope: Annotated[float, Gt(0), Doc("weight of the command itself")] = 1.0
    hysteresis: Annotated[float, Doc("weight of the hysteretic part z; may be negative")] = 0.5
    a: Annotated[float, Gt(0), Doc("slope of z against the command at z = 0")] = 1.0
    beta: Annotated[float, Gt(0), Unit("N^-n"), Doc("part of the bend that makes the loop")] = 1.5
    gamma: Annotated[float, Unit("N^-n"), Doc("part of the bend that comes and goes; > -beta")] = 0.5
    exponent: Annotated[Literal[1, 2], Doc("exponent n: the larger, the sharper the bend")] = 1

    kind: ClassVar[str] = "bouc-wen"
    states: ClassVar[int] = 2
    step: ClassVar[Step] = staticmethod(bouc_wen_step)

    def check(self) -> None:
        if self.gamma <= -self.beta:
            raise wrong("gamma", f"be > -beta = {-self.beta:g}, or z has no bound", self.gamma)
        if self.beta < LEAST_LOSS * self.gamma:
            raise wrong("beta", f"be >= {LEAST_LOSS:g} gamma = {LEAST_LOSS * self.gamma:g}", self.beta)

    def row(self, dt: float) -> tuple[float, ...]:
        onward, back = self.gamma + self.beta, self.gamma - self.beta
        if abs(back) <= NEGLIGIBLE * onward:
            back = 0.0
        return self.slope, self.hysteresis, self.a, float(self.exponent), onward, back

    @property
    def limit(self) -> float:
        """The bound on |z|, (a / (beta + gamma))^(1/n)."""
        return (self.a / (self.beta + self.gamma)) ** (1 / self.exponent)

    @property
    def gain(self) -> float:
        return self.slope

    @property
    def deviation(self) -> tuple[float, float]:
        return -abs(self.hysteresis) * self.limit, abs(self.hysteresis) * self.limit

    @property
    def monotone(self) -> bool:
        return self.slope + self.hysteresis * self.a * max(1.0, 2 * self.beta / (self.beta + self.gamma)) >= 0
