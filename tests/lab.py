"""A lab under test: a real `dampen lab` on loopback, and a page's half of the conversation."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import urlsplit

from websockets.sync.client import ClientConnection, connect

from dampen.lab.frames import unframed

PATIENCE = 300.0  # seconds: the first run of a kind compiles its kernel
END = ("complete", "left", "refused", "failed")


@contextmanager
def lab_process(*arguments: str, cwd: Any = None) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """A running lab: its address and its process, ended by Ctrl-C."""
    command = [sys.executable, "-m", "dampen.cli", "lab", "--no-browser", "--port", "0", *arguments]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=cwd, env={**os.environ, "PYTHONUNBUFFERED": "1"}
    )
    try:
        line = process.stdout.readline()
        assert line.startswith("Lab: http://127.0.0.1:"), line + process.stderr.read()
        yield line.split()[1].rstrip("/"), process
    finally:
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
        process.communicate(timeout=30)


@dataclass
class Answers:
    """What came back for one request, in order."""

    pictures: list[tuple[dict[str, Any], dict[str, Any]]] = field(default_factory=list)
    trials: dict[int, dict[str, Any]] = field(default_factory=dict)
    said: list[dict[str, Any]] = field(default_factory=list)

    def of(self, say: str) -> dict[str, Any]:
        return next(one for one in self.said if one["say"] == say)

    @property
    def end(self) -> str:
        return self.said[-1]["say"]

    @property
    def faults(self) -> list[dict[str, str]]:
        return self.of("refused")["faults"]


class Page:
    """The page's half: one WebSocket, and the requests beside it."""

    def __init__(self, address: str):
        self.address = address
        self.line = connect(
            f"ws://{urlsplit(address).netloc}/ws", origin=address, max_size=None, open_timeout=30, compression=None
        )
        self.socket: ClientConnection = self.line.__enter__()
        self.id = 0

    def send(self, **asked: Any) -> int:
        self.id += 1
        self.socket.send(json.dumps({"id": self.id, "trial": 0, **asked}))
        return self.id

    def exchange(self, message: str) -> str | bytes:
        """Any message, and what comes back first."""
        self.socket.send(message)
        return self.socket.recv(timeout=PATIENCE)

    def run(self, table: dict[str, Any], trial: int = 0) -> Answers:
        return self.answers(self.send(do="run", table=table, trial=trial))

    def answers(self, id: int) -> Answers:
        """Everything that is said to request `id`, to its end."""
        found = Answers()
        while True:
            message = self.socket.recv(timeout=PATIENCE)
            if isinstance(message, bytes):
                header, arrays = unframed(message)
                if header["id"] != id:
                    continue
                if header["say"] == "picture":
                    found.pictures.append((header, arrays))
                else:
                    found.trials[header["trial"]] = arrays
                continue
            said = json.loads(message)
            if said["id"] == id:
                found.said.append(said)
                if said["say"] in END:
                    return found

    def get(self, path: str) -> Any:
        with urllib.request.urlopen(f"{self.address}{path}", timeout=PATIENCE) as answer:
            return json.load(answer)

    def post(self, path: str, body: bytes, **headers: str) -> tuple[int, bytes, dict[str, str]]:
        """Status, body and headers of a POST as the page makes it; `headers` replace its own, None leaves one out."""
        own = {"Origin": self.address, "X-Dampen": "lab", "Content-Type": "application/octet-stream", **headers}
        request = urllib.request.Request(
            f"{self.address}{path}", body, {name: value for name, value in own.items() if value is not None}
        )
        try:
            with urllib.request.urlopen(request, timeout=PATIENCE) as answer:
                return answer.status, answer.read(), dict(answer.headers)
        except urllib.error.HTTPError as error:
            return error.code, error.read(), dict(error.headers)

    def close(self) -> None:
        self.line.__exit__(None, None, None)
