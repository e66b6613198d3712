"""The line over loopback UDP: a datagram for a packet, asked again with the same number where one is lost."""

from __future__ import annotations

import select
import socket
import time

from dampen.component import ArgumentError
from dampen.sil.line import GLANCE, Line
from dampen.sil.packets import ROUND, Request, number_of
from dampen.sil.program import Program

HERE = "127.0.0.1"  # no other address, ever
AGAIN, SELDOM = 0.05, 1.0  # s without an answer, after which a request is sent again: twice as long every time
ROOM = 65536


class Udp(Line):
    """To a port of this machine, where a program listens; `program`: the one that was started for it."""

    def __init__(self, port: int, program: Program | None, timeout: float):
        there = f"the controller at UDP port {port}"
        name, described = (f"controller `{program.name}`", f"`{program.name}` over UDP") if program else (there, there)
        super().__init__(name, described, program, timeout)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setblocking(False)
        self.socket.connect((HERE, port))  # from then on nobody else's datagrams are seen
        self.poll = select.poll()
        self.poll.register(self.socket, select.POLLIN)

    def ask(self, request: Request) -> bytes:
        """The datagram that answers; late answers to earlier requests are passed over."""
        deadline, data, pause, self.asked = self.deadline(), request.data, AGAIN, 0
        while True:
            self.send(data)
            again, pause = min(time.perf_counter() + pause, deadline), min(2 * pause, SELDOM)
            while (left := again - time.perf_counter()) > 0:
                got = self.receive(min(left, GLANCE))
                if got is not None and not late(number_of(got), request.number):
                    return got
            self.stop()
            ended = self.program.ended() if self.program else None
            if ended:
                raise self.lost(ended)
            if again >= deadline:
                raise self.silent()

    def send(self, data: bytes) -> None:
        """One datagram; while nobody listens yet, it is as if it were lost."""
        self.asked += 1
        try:
            self.socket.send(data)
        except OSError:
            time.sleep(AGAIN / 10)

    def receive(self, wait: float) -> bytes | None:
        """A datagram, if one comes within `wait` [s]."""
        if not self.poll.poll(1000 * wait):
            return None
        try:
            return self.socket.recv(ROOM)
        except OSError:  # nobody listens yet, or any more
            time.sleep(AGAIN / 10)
            return None

    def hang_up(self) -> None:
        """Close the socket, too."""
        self.socket.close()
        super().hang_up()


def late(number: int, now: int) -> bool:
    """Whether a number belongs to an earlier request; numbers go around."""
    return 0 < (now - number) % ROUND < ROUND // 2


def free_port() -> int:
    """A port of this machine that nobody uses."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
        one.bind((HERE, 0))
        return int(one.getsockname()[1])


def check_port(port: int) -> int:
    """A port's number. Raises ArgumentError."""
    if not 1 <= port <= 65535:
        raise ArgumentError(f"Option `--port` must be from 1 to 65535, but is {port}.")
    return port
