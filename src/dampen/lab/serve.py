"""The life of a lab: a worker first, the server beside it, until Ctrl-C."""

from __future__ import annotations

import shutil
import signal
import socket
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from dampen.component import ArgumentError
from dampen.lab.lab import Lab
from dampen.lab.limits import MESSAGE

if TYPE_CHECKING:
    from uvicorn import Server

PORT = 8017  # if it is free


def listening(host: str, port: int | None) -> socket.socket:
    """A socket bound to `port`, or, where none is asked for, to the lab's own or any free one. Raises ArgumentError."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    for wanted in (PORT, 0) if port is None else (port,):
        own = socket.socket(family, socket.SOCK_STREAM)
        try:
            own.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            own.bind((host, wanted))
            own.listen()
        except (OSError, OverflowError) as error:
            own.close()
            if wanted == PORT and port is None:
                continue
            reason = getattr(error, "strerror", None) or error
            raise ArgumentError(
                f"Argument `--port` must be a port that is free on {host}, but {wanted} is not ({reason})."
            ) from None
        return own
    raise ArgumentError(f"Option `--host` must be an address of this machine, but is {host!r}.")


async def serve(source: str, own: socket.socket, host: str, ready: Callable[[], None]) -> None:
    """Serve the lab on a bound socket until it is interrupted; `ready` is called when a page can be asked for.

    Raises ArgumentError for a scenario that cannot be run.
    """
    folder = Path(tempfile.mkdtemp(prefix="dampen-lab-"))
    lab = Lab(folder)
    try:
        await lab.workers.benches[0].start()  # before this process, too, loads what it needs
        from dampen.lab.opening import opening

        lab.open(opening(source))
        await server(lab, host, ready).serve([own])
    finally:
        try:
            await lab.workers.close()
        finally:
            shutil.rmtree(folder, ignore_errors=True)


def server(lab: Lab, host: str, ready: Callable[[], None]) -> Server:
    """The HTTP server of a lab."""
    import uvicorn

    from dampen.lab.server import application

    class LabServer(uvicorn.Server):
        @contextmanager
        def capture_signals(self) -> Iterator[None]:
            """A signal ends the lab in good order; it is not raised again after that."""
            before = {number: signal.signal(number, self.handle_exit) for number in (signal.SIGINT, signal.SIGTERM)}
            try:
                yield
            finally:
                for number, handler in before.items():
                    signal.signal(number, handler)

        async def startup(self, sockets: list[socket.socket] | None = None) -> None:
            await super().startup(sockets)
            ready()

    config = uvicorn.Config(
        application(lab, host), lifespan="off", log_level="warning", access_log=False, server_header=False, proxy_headers=False,
        ws_max_size=MESSAGE, ws_max_queue=4, ws_per_message_deflate=False, timeout_graceful_shutdown=1,
    )  # fmt: skip
    return LabServer(config)
