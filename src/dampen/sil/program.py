"""A controller's program as a child process: started, watched, and never left behind."""

from __future__ import annotations

import os
import shlex
import signal
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from dampen.component import ArgumentError

GRACE = 1.0  # s from one way of ending a program to the next, firmer one
LAST = 3, 400  # lines of its error output that are shown, and letters of each


class Program:
    """A running controller; what it writes to its error output is kept, the last lines for messages.

    Raises ArgumentError where it cannot be started.
    """

    def __init__(self, command: str | Sequence[str], more: Sequence[str] = (), pipe: bool = True):
        words = words_of(command)
        self.name = shlex.join(words)
        self.errors = tempfile.TemporaryFile()  # noqa: SIM115  (closed in `end`)
        streams = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE}
        if not pipe:
            streams = {"stdin": subprocess.DEVNULL, "stdout": self.errors}  # type: ignore[dict-item]
        try:  # in a process group of its own, so that Ctrl-C in a terminal is for this side alone
            self.child = subprocess.Popen([*words, *more], stderr=self.errors, bufsize=0, process_group=0, **streams)  # type: ignore[call-overload]
        except (OSError, ValueError) as error:
            self.errors.close()
            why = getattr(error, "strerror", None) or error
            raise ArgumentError(
                f"Option `--controller` must be a program that can be started, but `{words[0]}`: {why}."
            ) from None

    def ended(self, wait: float = 0.0) -> str | None:
        """How it ended; None: it has not, within `wait` [s]."""
        try:
            status = self.child.wait(wait) if wait else self.child.poll()
        except subprocess.TimeoutExpired:
            return None
        if status is None:
            return None
        if status < 0:
            try:
                return f"was ended by {signal.Signals(-status).name}"
            except ValueError:
                return f"was ended by signal {-status}"
        return f"ended with exit status {status}"

    def last_words(self) -> str:
        """The end of its error output, to be put behind a message."""
        self.errors.seek(0, 2)
        self.errors.seek(max(0, self.errors.tell() - 10_000))
        lines = [line for line in self.errors.read().decode(errors="replace").splitlines() if line.strip()]
        count, letters = LAST
        shown = " / ".join("".join(c if c.isprintable() else " " for c in line)[:letters] for line in lines[-count:])
        return f" Its last words: {shown}" if shown else ""

    def end(self) -> None:
        """Let it end by itself now that nobody asks any more, then end it, then kill it; no zombie is left."""
        for stream in (self.child.stdin, self.child.stdout):
            if stream is not None:
                stream.close()
        for firmer in (signal.SIGTERM, signal.SIGKILL):
            if self.ended(GRACE) is not None:
                break
            os.killpg(self.child.pid, firmer)  # with what it may have started: the group is its own
        self.child.wait()
        self.errors.close()


def words_of(command: str | Sequence[str]) -> list[str]:
    """A command line in words; a string that is the path of a file is one word."""
    try:
        words = list(command) if not isinstance(command, str) else [command] if Path(command).is_file() else shlex.split(command)
    except (ValueError, OSError) as error:
        raise ArgumentError(f"Option `--controller` must be a command line, but {command!r} is none: {error}.") from None
    if not words or not all(isinstance(word, str) for word in words):
        raise ArgumentError(f"Option `--controller` must be a command line, but is {command!r}.")
    return words
