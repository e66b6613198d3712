"""What every line to a controller is: something to ask, with a time limit, that ends what it has started."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Callable

from dampen.sil.packets import Request, shown
from dampen.sil.program import Program

GLANCE = 0.1  # s between looks at whether the program is alive, and whether someone wants to stop


class Lost(Exception):
    """The controller cannot be gone on with; the message begins with its name."""


def nothing() -> None:
    """No reason to stop."""


class Line(ABC):
    """To a controller.

    name: of the controller, within a sentence.   described: the same, and the way there.   program: where it was started here.
    timeout: [s] for an answer.   stop: asked while waiting; raises where the run is to end.   asked: how often the last request
    was sent.
    """

    def __init__(self, name: str, described: str, program: Program | None, timeout: float):
        self.name, self.described, self.program, self.timeout = name, described, program, timeout
        self.stop: Callable[[], None] = nothing
        self.asked = 0

    @abstractmethod
    def ask(self, request: Request) -> bytes:
        """Send a request; what came back, to be checked. Raises Lost where nothing does, and Garbage for noise."""

    def hang_up(self) -> None:
        """End the line, and the program where it was started here."""
        if self.program:
            self.program.end()

    def deadline(self) -> float:
        """Until when an answer that is asked for now must be there."""
        return time.perf_counter() + self.timeout

    def silent(self, got: bytes = b"") -> Lost:
        """No answer in time."""
        some = f" but {len(got)} bytes, {shown(got)}," if got else ""
        return self.lost(f"sent no answer{some} within {self.timeout:g} s")

    def lost(self, what: str) -> Lost:
        """What happened, and what the program may have had to say about it."""
        return Lost(f"{self.name} {what}.{self.program.last_words() if self.program else ''}")
