"""Handing members out to an engine, in pieces of about a second, and again where a worker died with them.

When a worker dies, all pieces that were out are suspect: their members are tried again one by one, with nothing else out, so
that one which takes its worker down is found. It is tried three times in all, and then is a row that says so.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, wait

import numpy as np

from dampen.component import ArgumentError
from dampen.studies.engines import Engine
from dampen.studies.evaluate import Row, Work, gathered, nominal_of

PIECE = 1.0  # s, what a piece should take
LARGEST = 64  # members in a piece
ATTEMPTS = 3
Out = dict[Future[list[Row]], tuple[list[int], float]]


def hand_out(
    members: list[int], work: Callable[[list[int]], Work], engine: Engine, stopped: Callable[[], bool]
) -> Iterator[list[Row]]:
    """Rows of all members, piece by piece as they are done; once `stopped()`, only of those that were out.

    work: makes the work of some members.
    """
    queue, out = Queue(members), Out()
    while True:
        while not stopped() and len(out) < (1 if queue.suspects else engine.workers + 1) and queue:
            piece = queue.take(engine.workers)
            out[engine.submit(work(piece))] = piece, time.monotonic()
        if not out:
            return
        done, _ = wait(out, timeout=0.2, return_when=FIRST_COMPLETED)
        errors = {future: error_of(future) for future in done}
        for future in done:
            if errors[future] is None:
                piece, begun = out.pop(future)
                queue.took(len(piece), time.monotonic() - begun)
                yield future.result()
        failed = [error for error in errors.values() if error is not None]
        for error in failed:
            if not engine.lost(error):
                raise error
        if failed:
            yield from suspect(out, queue, work)
            engine.renew()


def error_of(future: Future[list[Row]]) -> BaseException | None:
    """What a finished piece failed with."""
    try:
        return future.exception()
    except CancelledError as error:
        return error


def suspect(out: Out, queue: Queue, work: Callable[[list[int]], Work]) -> Iterator[list[Row]]:
    """Take back all that was out when a worker died, but what is done; give up a member that was out alone too often."""
    pieces = [(future, piece) for future, (piece, _) in out.items()]
    out.clear()
    for future, piece in pieces:
        if future.done() and error_of(future) is None:
            yield future.result()
        elif queue.suspected(piece, alone=len(pieces) == 1 and len(piece) == 1) >= ATTEMPTS:
            yield [lost_row(work(piece))]
        else:
            future.cancel()
            queue.suspects += piece


def lost_row(work: Work) -> Row:
    """The row of a member that takes its worker down."""
    nothing = gathered(nominal_of(work), [ArgumentError(f"Its worker died, in {ATTEMPTS} attempts.")])
    return {"member": work.members[0], **work.values[0], **nothing, "status": "crashed"}


class Queue:
    """Members that wait, handed out in pieces whose size follows the time that pieces take; suspects one by one."""

    def __init__(self, members: list[int]):
        self.members, self.suspects = list(reversed(members)), list[int]()
        self.size, self.attempts = 4.0, dict[int, int]()

    def __bool__(self) -> bool:
        return bool(self.members or self.suspects)

    def take(self, workers: int) -> list[int]:
        """The next piece: not so large that a worker would be idle in the end."""
        if self.suspects:
            return [self.suspects.pop()]
        count = max(1, min(int(self.size), -(-len(self.members) // workers)))
        return [self.members.pop() for _ in range(min(count, len(self.members)))]

    def took(self, count: int, seconds: float) -> None:
        """Grow at most twofold, so that the compiler's first seconds do not count for long."""
        self.size = float(np.clip(count * PIECE / max(seconds, 1e-3), 1, min(2 * self.size, LARGEST)))

    def suspected(self, piece: list[int], alone: bool) -> int:
        """How often a piece was out when a worker died: once in company, and each time alone."""
        for i in piece:
            self.attempts[i] = self.attempts.get(i, 0) + 1 if alone else 1
        return self.attempts[piece[0]]
