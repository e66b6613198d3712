"""Fifty pages at once, each moving a slider ten times a second for half a minute: `python benchmarks/lab_load.py`.

Starts a lab of its own, and says how long changes took to be answered (by the first picture of that change or of a later one of
the same page), what went wrong, and what the lab's processes held in memory before, during and after. Linux, for /proc.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import random
import signal
import subprocess
import sys
import time
import urllib.request
from dataclasses import dataclass, field
from pathlib import Path
from statistics import median, quantiles

from websockets.asyncio.client import connect

PAGE = 4096  # bytes of a page of memory


@dataclass
class Client:
    """One page: when it asked for what, and how long each change took."""

    sent: dict[int, float] = field(default_factory=dict)
    took: list[float] = field(default_factory=list)
    pictures: int = 0
    errors: list[str] = field(default_factory=list)

    async def talk(self, address: str, table: dict, seconds: float, rate: float) -> None:
        """Send changes at `rate`, listening meanwhile, until the last has been answered."""
        line = connect(f"{address.replace('http', 'ws')}/ws", origin=address, max_size=None, compression=None, open_timeout=60)
        async with line as socket:
            listening = asyncio.create_task(self.listen(socket))
            own, end, id = json.loads(json.dumps(table)), time.monotonic() + seconds, 0
            await asyncio.sleep(random.random() / rate)
            while time.monotonic() < end:
                id += 1
                own["controller"]["alpha_4"] = round(10 ** random.uniform(-1, 1), 4)
                self.sent[id] = time.monotonic()
                await socket.send(json.dumps({"do": "run", "id": id, "trial": 0, "table": own}))
                await asyncio.sleep(1 / rate)
            async with asyncio.timeout(30):
                while self.sent:
                    await asyncio.sleep(0.05)
            listening.cancel()

    async def listen(self, socket) -> None:
        """Tick off what has been answered; only the head of a frame is read."""
        async for message in socket:
            if isinstance(message, bytes):
                if b'"say": "picture"' in message[:40]:
                    self.pictures += 1
                    length = int.from_bytes(message[:4], "little")
                    self.answered(json.loads(message[4 : 4 + length])["id"])
            elif (said := json.loads(message))["say"] in ("refused", "failed"):
                self.errors.append(message)
                self.answered(said["id"])

    def answered(self, id: int) -> None:
        """Everything up to `id` has its answer."""
        now = time.monotonic()
        for one in [one for one in self.sent if one <= id]:
            self.took.append(now - self.sent.pop(one))


def memory(root: int) -> tuple[float, int]:
    """Resident MiB of a process and all below it, and how many they are."""
    found, held = [root], 0
    for pid in found:
        try:
            found += map(int, Path(f"/proc/{pid}/task/{pid}/children").read_text().split())
            held += int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * PAGE
        except OSError:
            continue
    return held / 2**20, len(found)


async def measure(address: str, process: int, clients: int, seconds: float, rate: float) -> None:
    """The whole experiment, twice: the first time is the warm-up that fills caches."""
    with urllib.request.urlopen(f"{address}/start") as answer:
        table = json.load(answer)["table"]
    for name, count, length in (("warm-up", min(clients, 4), 5.0), ("load", clients, seconds)):
        before = memory(process)
        all_of_them = [Client() for _ in range(count)]
        work = asyncio.gather(*(client.talk(address, table, length, rate) for client in all_of_them))
        most = before
        while not work.done():
            await asyncio.wait([work], timeout=1.0)
            most = max(most, memory(process))
        await work
        took = [t for client in all_of_them for t in client.took]
        errors = [error for client in all_of_them for error in client.errors]
        pictures = sum(client.pictures for client in all_of_them)
        print(f"{name}: {count} pages, {len(took)} changes, {pictures} pictures ({pictures / length:.0f} a second)")
        late = quantiles(took, n=20)[-1]
        print(f"  answered within {median(took):.2f} s (median), {late:.2f} s (95 %), {max(took):.2f} s (all)")
        print(f"  errors: {len(errors)} {errors[:1] or ''}")
        print(f"  memory: {before[0]:.0f} MiB in {before[1]} processes before, at most {most[0]:.0f} MiB in {most[1]}")
    print("  afterwards:")
    for wait in (1, 10, 45):
        await asyncio.sleep(wait)
        held = memory(process)
        print(f"    {held[0]:.0f} MiB in {held[1]} processes, {wait} s later")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--clients", type=int, default=50)
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--rate", type=float, default=10.0, help="changes a second and page")
    given = parser.parse_args()
    command = [sys.executable, "-m", "dampen.cli", "lab", "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            address = process.stdout.readline().split()[1].rstrip("/")
            asyncio.run(measure(address, process.pid, given.clients, given.seconds, given.rate))
        finally:
            process.send_signal(signal.SIGINT)


if __name__ == "__main__":
    main()
