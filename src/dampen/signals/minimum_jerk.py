"""From here to there, gently."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar

from annotated_types import Ge, Gt, Unit
from typing_extensions import Doc

from dampen.signals.base import Array, Signal, smooth_step


@dataclass(frozen=True)
class MinimumJerk(Signal):
    """From rest to rest with the least mean square jerk.

        r(t) = r_0 + (r_1 - r_0) (10 s^3 - 15 s^4 + 6 s^5),    s = (t - t_0) / d in [0, 1]

    Held at r_0 before t_0 and at r_1 after t_0 + d. Source: Flash and Hogan, J. Neurosci. 5 (1985), 1688-1703.
    """

    kind: ClassVar[str] = "minimum-jerk"

    target: Annotated[float, Doc("value r_1 at the end")]
    duration: Annotated[float, Gt(0), Unit("s"), Doc("length d of the motion")]
    start: Annotated[float, Doc("value r_0 before it")] = 0.0
    begin: Annotated[float, Ge(0), Unit("s"), Doc("time t_0 in the trial at which it begins")] = 0.0

    def sample(self, t: Array, trial: int) -> Array:
        return self.start + (self.target - self.start) * smooth_step((t - self.begin) / self.duration)
