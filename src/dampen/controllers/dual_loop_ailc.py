"""The dual-loop adaptive iterative learning control law of He et al. 2017."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from dampen.controllers.base import Array, Assumption, Setting
from dampen.controllers.inner_loop import CHANNELS, InnerLoop, channel
from dampen.controllers.pointwise import PointwiseLearning, Relearn
from dampen.controllers.scales import span


def relearn(zeta: Any, d_hat: Any, error: Any, v: Any, command: Any, row: Any) -> tuple[Any, Any]:
    """xi = zeta - row[0] v, its dead-zone of width row[2]; and d_hat + row[1] |v|."""
    xi = zeta - row[0] * v
    return xi - np.minimum(np.maximum(xi, 0.0), row[2]), d_hat + row[1] * np.abs(v)


@dataclass(frozen=True)
class DualLoopAILC(PointwiseLearning, InnerLoop):
    """Dual-loop adaptive iterative learning control with a barrier.

        force   u = xi - [d_hat + 2 alpha_1 f_bar L + alpha_2 d_bar] sgn(v) - alpha_3 y/(C^2 - y^2) ln(C^2/(C^2 - y^2))
                xi = zeta(previous trial) - alpha_4 v          d_hat = d_hat(previous trial) + alpha_8 |v|
        torque  the same without the f_bar term, with alpha_5 for alpha_2 and alpha_6, 7, 9 for alpha_3, 4, 8

    y and v are the port's displacement and rate (with a reference, the error and its rate), zeta is the dead-zone of xi of
    width m (B_r - B_l), all memories are zero before trial 0, and sgn is set-valued at 0. Source: He et al. 2017, (15)-(18).
    Only alpha_9 = 0.1 is known of the paper's gains: the defaults are ours. Where the term alpha_8 |v| multiplies sgn(v) it
    acts as damping, and is solved as such.
    """

    kind: ClassVar[str] = "dual-loop-ailc"
    paper: ClassVar[str] = "He et al. 2017"
    memories: ClassVar[tuple[str, str]] = ("zeta", "d_hat")
    learned_terms: ClassVar[tuple[str, str]] = ("learned feedforward", "observer")
    relearn: ClassVar[Relearn] = staticmethod(relearn)

    @property
    def relies_on(self) -> tuple[Assumption, ...]:
        return ("alignment", "bounds", "moving ports")

    def search(self, setting: Setting) -> Mapping[str, str]:
        """The inner loop's gains, and the observers'; without learning these would be nothing but more damping."""
        found = dict(super().search(setting))
        for kind, names in CHANNELS.items():
            scale = channel(setting, kind)
            if scale is not None:
                found[names[3]] = span(scale.impedance, 2e-4, 2)
        return found

    def learning_row(self, setting: Setting) -> Array:
        learning, observing = setting.by_kind(self.alpha_4, self.alpha_7), setting.by_kind(self.alpha_8, self.alpha_9)
        widths = [self.assumed_at(port).width for port in setting.ports]
        return np.array([learning, observing, widths])
