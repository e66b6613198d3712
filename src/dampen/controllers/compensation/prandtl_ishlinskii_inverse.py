"""The inverse of a Prandtl-Ishlinskii hysteresis."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate, pairwise
from typing import Annotated, ClassVar

from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.plays import PLAYS_AT_MOST, check_plays, play_row, play_sum_step
from dampen.stage import Stage, Step


@dataclass(frozen=True)
class PrandtlIshlinskiiInverse(Stage):
    """Undoes the hysteresis that it assumes: the inverse of a sum of plays is a sum of plays again, in closed form.

        u = v / W_0 + sum_i c_i p_i(v)        c_i = 1 / W_i - 1 / W_(i-1) <= 0        W_i = linear + weights_1 + .. + weights_i
        radius of play i:  linear radii_i + sum_(j<i) weights_j (radii_i - radii_j)

    so that its initial loading curve is the inverse of the other's. With exact estimates the actuator behind it delivers v,
    from the start on (all plays zero before the first trial). Source: Krejci and Kuhnen, IEE Proc. Control Theory Appl.
    148(3), 2001; Kuhnen, European Journal of Control 9(4), 2003.
    """

    linear: Annotated[float, Gt(0), Doc("assumed weight w_0 of the command itself")] = 1.0
    weights: Annotated[tuple[float, ...], Ge(0), Doc("assumed weight w_i of each play")] = (0.2, 0.1)
    radii: Annotated[
        tuple[float, ...], Gt(0), Unit("N"), Doc("assumed radius r_i of each play, increasing (N m at a torque port)")
    ] = (0.1, 0.3)

    kind: ClassVar[str] = "prandtl-ishlinskii-inverse"
    states: ClassVar[int] = PLAYS_AT_MOST
    step: ClassVar[Step] = staticmethod(play_sum_step)

    def check(self) -> None:
        check_plays(self.weights, self.radii)

    def row(self, dt: float) -> tuple[float, ...]:
        return play_row(1 / self.linear, *self._plays())

    def _plays(self) -> tuple[list[float], list[float]]:
        """Weights c_i and radii of the inverse's own plays."""
        slopes = list(accumulate(self.weights, initial=self.linear))
        weights = [-w / (before * after) for w, (before, after) in zip(self.weights, pairwise(slopes), strict=True)]
        steps = [b - a for a, b in pairwise((0.0, *self.radii))]
        radii = list(accumulate(slope * step for slope, step in zip(slopes, steps, strict=False)))
        return weights, radii

    @property
    def gain(self) -> float:
        return 1 / (self.linear + sum(self.weights))

    @property
    def deviation(self) -> tuple[float, float]:
        """Every play is within its radius of the command."""
        most = sum(abs(c) * r for c, r in zip(*self._plays(), strict=True))
        return -most, most
