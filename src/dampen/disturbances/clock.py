"""Whether a disturbance starts afresh with every trial, or runs on from one to the next: said once, for all that has a choice."""

from __future__ import annotations

from typing import Annotated, Literal

from typing_extensions import Doc

from dampen.disturbances.base import Array, Disturbance
from dampen.port import Site

_REPEAT = '"repeat": the same in every trial; "continue": the clock runs on from trial to trial'
Trials = Annotated[Literal["repeat", "continue"], Doc(_REPEAT)]
NoiseTrials = Annotated[Literal["repeat", "continue", "random"], Doc(f'{_REPEAT}; "random": fresh noise in every trial')]


class Clocked(Disturbance):
    """A disturbance with a parameter `trials`, declared as :data:`Trials` or :data:`NoiseTrials`."""

    trials: str

    def clock(self, trial: int, t: Array, site: Site) -> Array:
        """The disturbance's own time at times `t` of a trial: t, or t + trial * duration where it runs on."""
        return t + trial * site.duration if self.trials == "continue" else t

    def same_as(self, trial: int) -> int:
        return 0 if self.trials == "repeat" else trial
