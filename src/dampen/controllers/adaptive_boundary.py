"""The paper's inner loop alone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from dampen.controllers.inner_loop import InnerLoop


@dataclass(frozen=True)
class AdaptiveBoundary(InnerLoop):
    """The dual-loop law without its outer loop: nothing is carried from trial to trial.

        force   u = -alpha_4 v - [alpha_8 |v| + 2 alpha_1 f_bar L + alpha_2 d_bar] sgn(v) - alpha_3 dV/dy
        torque  u = -alpha_7 v - [alpha_9 |v| + alpha_5 d_bar] sgn(v) - alpha_6 dV/dy

    What the learning adds is the difference to `dual-loop-ailc` with the same gains. Source: He et al. 2017, (15)-(18) with
    zeta = d_hat = 0 of the previous trial.
    """

    kind: ClassVar[str] = "adaptive-boundary"
