"""The worker processes from the server's side: who is served next, and what is left for something newer."""

from __future__ import annotations

import asyncio
import json
import os
import struct
import sys
import time
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from typing import Any

from dampen.lab.limits import LONG_PATIENCE, PATIENCE

LENGTH = struct.Struct("<I")
GRACE = 0.25  # seconds that a run may go on although its own page wants a newer one: most are done by then
IDLE = 30.0  # seconds after which a worker that nobody uses is ended
MOST = 4
FRAME = 4 * 2**20  # bytes that are read ahead of a process: more than a picture has

Said = bytes | str
Deliver = Callable[[Said], Awaitable[None]]


class Broken(Exception):
    """The worker ended, or did not answer in time."""


async def nowhere(said: Said) -> None:
    """Where answers go that no page waits for."""


@dataclass(eq=False)
class Customer:
    """One page, or one request for a download: where its answers go."""

    deliver: Deliver


@dataclass
class Wish:
    """A job, whose it is, and what becomes of it."""

    customer: Customer
    job: dict[str, Any]
    outcome: asyncio.Future[dict[str, Any]] = field(default_factory=lambda: asyncio.get_running_loop().create_future())


class Worker:
    """One process. Each customer has at most one wish waiting, its newest; they are served in turn.

    trust: what the process may take from outside a table; asked for when the process gets its first job.
    """

    def __init__(self, trust: Callable[[], dict[str, Any]]):
        self.trust = trust
        self.customers: set[Customer] = set()
        self.waiting: dict[Customer, Wish] = {}
        self.something = asyncio.Event()
        self.process: asyncio.subprocess.Process | None = None
        self.current: Wish | None = None
        self.serial, self.began, self.shown, self.told, self.introduced = 0, 0.0, False, False, False
        self.last_used = time.monotonic()
        self.starting = asyncio.Lock()
        self.turns = asyncio.create_task(self.serve())

    async def start(self) -> asyncio.subprocess.Process:
        """The process, started if there is none."""
        async with self.starting:
            if self.process is None or self.process.returncode is not None:
                self.introduced = False
                self.process = await asyncio.create_subprocess_exec(
                    sys.executable, "-P", "-m", "dampen.lab.worker",  # -P: nothing is taken from the folder it happens to be in
                    stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE,
                    limit=FRAME,
                    start_new_session=True,  # Ctrl-C is the server's to hear
                    env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
                )  # fmt: skip
            return self.process

    def wish(self, customer: Customer, job: dict[str, Any]) -> Wish:
        """Ask for a job: it takes the place of what the customer was waiting for."""
        wish = Wish(customer, job)
        older = self.waiting.get(customer)
        self.waiting[customer] = wish
        if older is not None:
            older.outcome.cancel()
        self.something.set()
        self.leave_if_better()
        asyncio.get_running_loop().call_later(GRACE, self.leave_if_better)
        return wish

    def forget(self, customer: Customer) -> None:
        """A customer has gone."""
        self.customers.discard(customer)
        older = self.waiting.pop(customer, None)
        if older is not None:
            older.outcome.cancel()
        if self.current is not None and self.current.customer is customer:
            self.leave()

    def leave_if_better(self) -> None:
        """Have the current job left where it only completes a picture that has been shown, or where its own page has waited long
        for a newer one."""
        if self.current is None or not self.waiting:
            return
        superseded = self.current.customer in self.waiting and time.monotonic() - self.began > GRACE
        if self.shown or superseded:
            self.leave()

    def leave(self) -> None:
        """Tell the process that the current job need not be finished."""
        if self.process is not None and self.process.stdin is not None and not self.told:
            self.told = True
            self.send({"leave": self.serial})

    def send(self, job: dict[str, Any]) -> None:
        """One record to the process."""
        assert self.process is not None
        assert self.process.stdin is not None
        content = json.dumps(job).encode()
        self.process.stdin.write(LENGTH.pack(len(content)) + content)

    async def serve(self) -> None:
        """Wish after wish."""
        await self.start()
        while True:
            await self.something.wait()
            self.something.clear()
            while self.waiting:
                customer = next(iter(self.waiting))
                wish = self.waiting.pop(customer)
                outcome = await self.fulfil(wish)
                if not wish.outcome.done():
                    wish.outcome.set_result(outcome)
                self.last_used = time.monotonic()

    async def fulfil(self, wish: Wish) -> dict[str, Any]:
        """Have one job done, and pass its answers on; once more where the process has gone before it said anything."""
        patience = LONG_PATIENCE if wish.job["do"] == "take" else PATIENCE
        for last in (False, True):
            self.serial += 1
            self.current, self.began, self.shown, self.told = wish, time.monotonic(), False, False
            try:
                async with asyncio.timeout(patience) as deadline:
                    await self.start()
                    if not self.introduced:
                        self.introduced = True
                        self.send({"trust": self.trust()})
                    self.send({**wish.job, "serial": self.serial})
                    return await self.relay(wish, deadline)
            except TimeoutError:
                await self.end()
                return {"failed": "The computation took too long and was ended."}
            except (Broken, OSError, ValueError):
                await self.end()
                if last or self.shown:
                    break
            finally:
                self.current = None
        return {"failed": "The computation broke down and was ended."}

    async def relay(self, wish: Wish, deadline: asyncio.Timeout) -> dict[str, Any]:
        """Pass on what the process answers, until the job has ended; one that compiles a kernel first gets more time."""
        assert self.process is not None
        assert self.process.stdout is not None
        while True:
            try:
                (length,) = LENGTH.unpack(await self.process.stdout.readexactly(LENGTH.size))
                record = await self.process.stdout.readexactly(length)
            except asyncio.IncompleteReadError:
                raise Broken from None
            letter, content = record[:1], record[1:]
            if letter == b".":
                outcome: dict[str, Any] = json.loads(content)
                return outcome
            if letter == b"c":
                deadline.reschedule(asyncio.get_running_loop().time() + LONG_PATIENCE)
                continue
            self.shown |= letter == b"b"
            await wish.customer.deliver(content if letter == b"b" else content.decode())
            self.leave_if_better()

    def kill(self) -> None:
        """End the process."""
        if self.process is not None and self.process.returncode is None:
            self.process.kill()

    async def end(self) -> None:
        """End the process, and see it ended; the next wish starts another."""
        self.kill()
        if self.process is not None:
            await self.process.wait()

    async def close(self) -> None:
        """End for good."""
        self.turns.cancel()
        await self.end()


class Workers:
    """Workers for pages, one to begin with and more as pages come; and for errands beside them, while they are needed: quick ones
    do not wait for slow ones."""

    def __init__(self, trust: Callable[[], dict[str, Any]], most: int = 0):
        self.trust = trust
        self.most = most or max(1, min(MOST, os.cpu_count() or 1))
        self.benches: list[Worker] = []
        self.clerks: dict[str, Worker] = {}
        self.watch: asyncio.Task[None] | None = None

    def open(self) -> None:
        """Start the first."""
        self.benches.append(Worker(self.trust))
        self.watch = asyncio.create_task(self.end_idle())

    def join(self, customer: Customer) -> Worker:
        """The worker that is to serve a new page: the one with the fewest."""
        least = min(self.benches, key=lambda worker: len(worker.customers))
        if least.customers and len(self.benches) < self.most:
            least = Worker(self.trust)
            self.benches.append(least)
        least.customers.add(customer)
        return least

    async def errand(self, job: dict[str, Any]) -> dict[str, Any]:
        """A job beside the pages."""
        kind = "slow" if job["do"] == "take" else "quick"
        if kind not in self.clerks:
            self.clerks[kind] = Worker(self.trust)
        clerk = self.clerks[kind]
        customer = Customer(nowhere)
        clerk.customers.add(customer)
        try:
            return await clerk.wish(customer, job).outcome
        finally:
            clerk.forget(customer)

    async def end_idle(self) -> None:
        """Give back what nobody uses."""
        while True:
            await asyncio.sleep(IDLE / 3)
            old = time.monotonic() - IDLE
            for worker in [w for w in self.benches[1:] if not w.customers and w.last_used < old]:
                self.benches.remove(worker)
                await worker.close()
            for kind, clerk in list(self.clerks.items()):
                if not clerk.customers and clerk.last_used < old:
                    del self.clerks[kind]
                    await clerk.close()

    async def close(self) -> None:
        """End all."""
        if self.watch is not None:
            self.watch.cancel()
        workers = [*self.benches, *self.clerks.values()]
        for worker in workers:
            worker.kill()
        for worker in workers:
            await worker.close()
