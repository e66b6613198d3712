"""Commands given beforehand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, ClassVar

from annotated_types import Unit
from typing_extensions import Doc

from dampen.controllers.base import Controller, Memory, PortLaw, Setting, named
from dampen.controllers.feedforward import feedforward
from dampen.signals.base import Signal


@dataclass(frozen=True)
class OpenLoop(Controller):
    """Commands given beforehand, the same in each trial, whatever the structure does: u = command(t)."""

    kind: ClassVar[str] = "open-loop"

    command: Annotated[dict[str, float | Signal], Unit("N, N m"), Doc("by port, command, a number or a signal")] = field(
        default_factory=dict
    )

    def ports_named(self) -> Mapping[str, str]:
        return named(command=self.command)

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        return PortLaw(feedforward(self.command, setting))
