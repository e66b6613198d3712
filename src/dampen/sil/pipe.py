"""The line over a pipe: packets to a program's input, answers from its output."""

from __future__ import annotations

import os
import select
import time

from dampen.sil.line import GLANCE, Line, Lost
from dampen.sil.packets import Garbage, Request, check_head
from dampen.sil.program import GRACE, Program

ROOM = 65536


class Pipe(Line):
    """To a program that was started for it."""

    def __init__(self, program: Program, timeout: float):
        super().__init__(f"controller `{program.name}`", f"`{program.name}` over a pipe", program, timeout)
        assert program.child.stdin is not None
        assert program.child.stdout is not None
        self.into, self.out_of = program.child.stdin.fileno(), program.child.stdout.fileno()
        self.poll = select.poll()
        self.poll.register(self.out_of, select.POLLIN)

    def ask(self, request: Request) -> bytes:
        """One packet in, one out; bytes beyond it are no answer."""
        deadline, size, got = self.deadline(), request.answer_size, b""
        self.asked = 1
        try:
            os.write(self.into, request.data)
        except BrokenPipeError:
            raise self.gone("closed its input") from None
        while len(got) < size:
            left = deadline - time.perf_counter()
            if left <= 0:
                raise self.silent(got)
            if not self.poll.poll(1000 * min(left, GLANCE)):
                self.stop()
                continue
            more = os.read(self.out_of, ROOM)
            if not more:
                raise self.gone("closed its output")
            got += more
            check_head(got)
        if len(got) > size:
            raise Garbage(f"{len(got) - size} bytes more than the answer has")
        return got

    def gone(self, how: str) -> Lost:
        """The pipe is broken: because the program is, most likely."""
        return self.lost((self.program and self.program.ended(GRACE)) or how)
