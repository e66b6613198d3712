"""Prandtl-Ishlinskii: hysteresis as a weighted sum of plays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.component import wrong
from dampen.plays import PLAYS_AT_MOST, check_plays, play_row, play_sum_step
from dampen.stage import Stage, Step


@dataclass(frozen=True)
class PrandtlIshlinskii(Stage):
    """Rate-independent hysteresis: a linear part and a weighted sum of plays of growing radius.

        B = linear command + sum_i weights_i p_i        p_i_new = min(max(p_i, command - radii_i), command + radii_i)

    All plays are zero before the first trial. With one play of weight m and radius r and no linear part it is a backlash of
    slope m between -r and r. At most 15 plays. Source: Krejci and Kuhnen, IEE Proc. Control Theory Appl. 148(3), 2001;
    Kuhnen, European Journal of Control 9(4), 2003.
    """

    linear: Annotated[float, Ge(0), Doc("weight w_0 of the command itself")] = 1.0
    weights: Annotated[tuple[float, ...], Ge(0), Doc("weight w_i of each play")] = (0.2, 0.1)
    radii: Annotated[tuple[float, ...], Gt(0), Unit("N"), Doc("radius r_i of each play, increasing (N m at a torque port)")] = (
        0.1,
        0.3,
    )

    kind: ClassVar[str] = "prandtl-ishlinskii"
    states: ClassVar[int] = PLAYS_AT_MOST
    step: ClassVar[Step] = staticmethod(play_sum_step)

    def check(self) -> None:
        check_plays(self.weights, self.radii)
        if self.gain <= 0:
            raise wrong("linear", "be > 0 where no weight is", self.linear)

    def row(self, dt: float) -> tuple[float, ...]:
        return play_row(self.linear, self.weights, self.radii)

    @property
    def gain(self) -> float:
        return self.linear + sum(self.weights)

    @property
    def deviation(self) -> tuple[float, float]:
        """Every play is within its radius of the command."""
        most = sum(w * r for w, r in zip(self.weights, self.radii, strict=True))
        return -most, most
