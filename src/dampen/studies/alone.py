"""One process at a time in a folder: the system lets go of the lock however a process ends."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from dampen.component import ArgumentError


@contextmanager
def alone(lock: Path | None, refusal: str) -> Iterator[None]:
    """Hold the file `lock`. Raises ArgumentError with the words `refusal` where another process holds it."""
    try:
        import fcntl
    except ImportError:  # not on Windows
        lock = None
    if lock is None:
        yield
        return
    with lock.open("a") as held:
        try:
            fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise ArgumentError(refusal) from None
        except OSError:  # a file system without locks
            pass
        yield
