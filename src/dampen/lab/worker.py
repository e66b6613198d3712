"""A worker: `python -m dampen.lab.worker` takes jobs from its standard input and answers on its standard output.

Both are chains of records: a length (uint32, little-endian), then that many bytes. A job is JSON. An answer begins with a letter:
"t" a message (JSON) for the page, "b" a frame for it, "c" that a kernel is being compiled, "." the end of a job, with what the
server itself is to know (JSON).
{"leave": n} among the jobs says that job n need not be finished; {"trust": ...}, the first, what may be named beside a table.
"""

from __future__ import annotations

import json
import os
import queue
import struct
import sys
import threading
import traceback
from collections.abc import Mapping
from pathlib import Path
from typing import Any, BinaryIO

from dampen.component import ArgumentError
from dampen.lab.desk import Desk, Left
from dampen.lab.handed_in import attach, contents, result_in, table_in
from dampen.lab.tables import Trust, faults, scenario_of
from dampen.lab.takeaway import take
from dampen.recording import is_netcdf
from dampen.scenarios.results import load
from dampen.simulation.result import Result

LENGTH = struct.Struct("<I")
ROOM = 4 * 2**30  # bytes of data that a worker may have


class Worker:
    """Jobs in, answers out."""

    def __init__(self, jobs: BinaryIO, answers: BinaryIO):
        self.jobs, self.answers, self.trust = jobs, answers, Trust(Path())
        self.waiting: queue.SimpleQueue[dict[str, Any] | None] = queue.SimpleQueue()
        self.left, self.closed, self.serial = -1, False, 0
        self.desk = Desk(self.say, lambda: self.closed or self.left >= self.serial)

    def listen(self) -> None:
        """Take jobs in while one is being done; in a thread of its own."""
        while (record := received(self.jobs)) is not None:
            job = json.loads(record)
            if "leave" in job:
                self.left = max(self.left, job["leave"])
            elif "trust" in job:
                self.trust = trusted(job["trust"])
            else:
                self.waiting.put(job)
        self.closed = True
        self.waiting.put(None)

    def work(self) -> None:
        """Do jobs until there are no more."""
        threading.Thread(target=self.listen, daemon=True).start()
        while (job := self.waiting.get()) is not None:
            self.serial = job["serial"]
            try:
                outcome = self.do(job)
            except Left:
                self.say({"say": "left", "id": job.get("id", 0)})
                outcome = {}
            except ArgumentError as error:
                outcome = {"faults": self.readable(faults(error))}
            except MemoryError:
                outcome = {"failed": "This needs more memory than the lab gives one run."}
            except Exception as error:  # a fault of the lab's: the next job finds a worker all the same
                traceback.print_exc()
                outcome = {"failed": f"This could not be computed: {type(error).__name__}: {error}"}
            self.answer(b".", json.dumps(outcome).encode())

    def do(self, job: dict[str, Any]) -> dict[str, Any]:
        """One job; what the server is to know of it."""
        what = job["do"]
        if what == "run":
            self.desk.run(job["id"], job["table"], job["trial"], self.trust)
        elif what == "open":
            self.desk.open(job["id"], self.stored(job), job["trial"])
        elif what == "read":
            content, kept = contents(Path(job["path"]).read_bytes(), self.trust)
            if is_netcdf(content):
                return {"table": result_in(content, self.trust, kept)[1], "result": True}
            return {"table": table_in(content, job["name"], self.trust, kept), "result": False}
        elif what == "attach":
            return {"attachment": attach(Path(job["path"]).read_bytes(), job["name"], self.trust)}
        elif what == "take":
            path, name = take(job["what"], scenario_of(job["table"], self.trust), self.trust, Path(job["folder"]))
            return {"path": str(path), "name": name}
        return {}

    def stored(self, job: dict[str, Any]) -> Result:
        """A stored result: the command's own, or one that a browser has handed in."""
        if job["trusted"]:
            return load(job["path"])
        content, kept = contents(Path(job["path"]).read_bytes(), self.trust)
        return result_in(content, self.trust, kept)[0]

    def say(self, said: bytes | Mapping[str, Any]) -> None:
        """Send a message or a frame to the page."""
        if isinstance(said, bytes):
            self.answer(b"b", said)
            return
        if said["say"] == "note":
            self.answer(b"c", b"")
        if "faults" in said:
            said = {**said, "faults": self.readable(said["faults"])}
        self.answer(b"t", json.dumps(said).encode())

    def answer(self, letter: bytes, content: bytes) -> None:
        """One record."""
        self.answers.write(LENGTH.pack(len(content) + 1) + letter)
        self.answers.write(content)
        self.answers.flush()

    def readable(self, found: list[dict[str, str]]) -> list[dict[str, str]]:
        """Faults without the folder that attachments happen to lie in."""
        return [{**fault, "text": fault["text"].replace(f"{self.trust.attachments}/", "")} for fault in found]


def received(stream: BinaryIO) -> bytes | None:
    """The next record; None at the end of the stream."""
    head = stream.read(LENGTH.size)
    return stream.read(*LENGTH.unpack(head)) if len(head) == LENGTH.size else None


def trusted(told: dict[str, Any]) -> Trust:
    """What the server says of what may be named."""
    return Trust(Path(told["attachments"]), frozenset(told["own"]), Path(told["beside"]))


def confine() -> None:
    """Let a run that goes out of hand fail by itself, where the system can see to it."""
    try:
        import resource
    except ImportError:
        return
    _, hard = resource.getrlimit(resource.RLIMIT_DATA)
    if hard == resource.RLIM_INFINITY or hard > ROOM:
        resource.setrlimit(resource.RLIMIT_DATA, (ROOM, hard))


def main() -> None:
    """A worker's life."""
    import scipy.linalg  # noqa: F401  (loaded first, so that the limit below reaches its BLAS too)
    from threadpoolctl import threadpool_limits

    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what is printed by others must not come between the answers
    confine()
    with threadpool_limits(1):
        Worker(sys.stdin.buffer, answers).work()


if __name__ == "__main__":
    main()
