"""A controller for `dampen sil` that goes wrong: sil_program.py FAULT AT [SIDE FILE], at the answer with the number AT."""

from __future__ import annotations

import json
import os
import signal
import struct
import sys
import time
from pathlib import Path

HEADER = struct.Struct("<4sHHIiIId")
HELLO, STEP, DRIVE, END, BYE = 1, 2, 3, 4, 5
PORTS, SAMPLES, PERIOD = 2, 200, 0.001
STATUS = {"stop": 5, "replaced": 1, "unheard-of": 17}


def main(fault: str, at: int, note: Path | None) -> None:
    """Answer everything, but not as it should be from `at` on."""
    asked = []
    if note:
        note.write_text(str(os.getpid()))
    if fault == "stubborn":
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
    sizes = dict.fromkeys((STEP, DRIVE, END), 8 * PORTS)
    while head := sys.stdin.buffer.read(HEADER.size):
        _, _, kind, number, status, ports, sample, seconds = HEADER.unpack(head)
        reading = struct.unpack(f"<{PORTS}d", sys.stdin.buffer.read(8 * PORTS)) if kind in sizes else ()
        asked.append([kind, number, status, ports, sample, seconds, *reading])
        numbers = [-0.5 * y for y in reading] if kind in (STEP, DRIVE) else []
        if note and fault == "slow" and number == at:
            note.with_suffix(".slow").touch()
        send(fault if number >= at else "none", kind, number, numbers)
        if kind == BYE:
            break
    if note and fault == "tell":
        note.write_text(json.dumps(asked))


def send(fault: str, kind: int, number: int, numbers: list[float]) -> None:
    """One answer, or what is none."""
    out = sys.stdout.buffer
    ports, samples, period = PORTS, SAMPLES, PERIOD
    head = {"magic": b"DSIL", "version": 1, "kind": kind, "number": number, "status": STATUS.get(fault, 0)}
    if fault == "exit":
        print("warming up", file=sys.stderr)
        sys.exit("sensor board not found")
    if fault == "killed":
        os.kill(os.getpid(), signal.SIGKILL)
    if fault == "slow":
        time.sleep(0.03)
    if fault in ("hang", "stubborn"):
        print("waiting for the bus", file=sys.stderr, flush=True)
        time.sleep(100)
    if fault == "closes":
        os.close(1)
        time.sleep(100)
    if fault == "text":
        out.write(b"temperature 20 C, all is well, going on with the next sample\n")
    if fault == "version":
        head["version"] = 2
    if fault == "kind":
        head["kind"] = BYE
    if fault == "number":
        head["number"] = number + 7
    if fault == "ports":
        ports = 3
    if fault == "samples":
        samples = 100
    if fault == "period":
        period = 0.002
    if fault == "nan":
        numbers = [numbers[0], float("nan")]
    if fault == "beyond":
        numbers = [-2.5, numbers[1]]
    if fault == "stop":
        numbers = [0.0] * len(numbers)
    packet = HEADER.pack(*head.values(), ports, samples, period) + struct.pack(f"<{len(numbers)}d", *numbers)
    if fault == "magic":
        packet = b"LISD" + packet[4:]
    if fault == "short":
        packet = packet[:-5]
    out.write(packet)
    if fault == "more":
        out.write(b"ok\n")
    out.flush()


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), Path(sys.argv[3]) if len(sys.argv) > 3 else None)
