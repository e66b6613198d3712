"""What every line to a controller is: something to ask, with a time limit, that ends what it has started."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field

from dampen.sil.packets import Request

GLANCE = 0.1  # s between looks at whether the program is alive, and whether someone wants to stop


class Lost(Exception):
    """The controller cannot be gone on with; the message begins with its name."""


def nothing() -> None:
    """No reason to stop."""


@dataclass
class Line(ABC):
    """name: of the controller, for messages.   timeout: [s] for an answer.   stop: asked while waiting; raises where the run
    is to end.   asked: how often the last request was sent."""

    name: str
    timeout: float
    stop: Callable[[], None] = field(default_factory=lambda: nothing, init=False)
    asked: int = field(default=0, init=False)

    @abstractmethod
    def ask(self, request: Request) -> bytes:
        """Send a request; what came back, to be checked. Raises Lost where nothing does, and Garbage for noise."""

    @abstractmethod
    def hang_up(self) -> None:
        """End the line, and the program where it was started here."""

    def silent(self, got: bytes) -> Lost:
        """No answer in time."""
        some = f" but {len(got)} bytes, {got[:24]!r}" if got else ""
        return Lost(f"{self.name} sent no answer{some} within {self.timeout:g} s.")

    def clock(self) -> float:
        """Until when an answer that is asked for now must be there."""
        return time.perf_counter() + self.timeout
