"""The packets between plant and controller: fixed sizes, little-endian, one answer to every request.

A header of 32 bytes, then, as the kind has it, numbers in double precision, one for each port:

    offset  type    name      in requests                                        in answers
    0       4 char  magic     "DSIL"                                             the same
    4       uint16  version   1                                                  1
    6       uint16  kind      HELLO, STEP, DRIVE, END or BYE                     the same
    8       uint32  number    one more from request to request                   that of the request
    12      int32   status    END: 1 where the structure goes back to its start  the controller's, see STATUSES
    16      uint32  ports     how many                                           the controller's
    20      uint32  sample    of the trial; HELLO: samples in a trial            HELLO: the controller's; else any
    24      double  seconds   in the trial; HELLO: the sample period             HELLO: the controller's; else any
"""

from __future__ import annotations

import struct
from dataclasses import dataclass

import numpy as np

Array = np.ndarray
MAGIC, VERSION = b"DSIL", 1
HEADER = struct.Struct("<4sHHIiIId")
HELLO, STEP, DRIVE, END, BYE = 1, 2, 3, 4, 5
KINDS = {HELLO: "hello", STEP: "step", DRIVE: "drive", END: "end", BYE: "bye"}
NUMBERS = {HELLO: (0, 0), STEP: (1, 1), DRIVE: (1, 2), END: (1, 0), BYE: (0, 0)}  # for each port, in request and answer
STATUSES = {
    0: "ok",
    1: "a reading was replaced by its prediction",
    2: "the trial's samples are done",
    3: "the trial was cut",
    4: "the sensor is not believed any more",
    5: "a port has crossed its constraint",
    6: "the law made no number",
}
STOPPED = (4, 5, 6)  # latched, and the commands are 0
ROUND = 2**32


class Garbage(Exception):
    """What came is not the answer; the message continues "the controller sent ..."."""


@dataclass(frozen=True)
class Request:
    """What the plant asks. numbers: (ports,) readings, where the kind has them."""

    kind: int
    number: int
    ports: int
    status: int = 0
    sample: int = 0
    seconds: float = 0.0
    numbers: Array | None = None

    @property
    def data(self) -> bytes:
        """The packet."""
        head = HEADER.pack(MAGIC, VERSION, self.kind, self.number, self.status, self.ports, self.sample, self.seconds)
        return head if self.numbers is None else head + np.asarray(self.numbers, "<f8").tobytes()

    @property
    def answer_size(self) -> int:
        """Bytes that the answer must have."""
        return HEADER.size + 8 * NUMBERS[self.kind][1] * self.ports


@dataclass(frozen=True)
class Answer:
    """What came back. numbers: (ports,) commands, after a DRIVE (2 ports,) commands and drives."""

    number: int
    status: int
    ports: int
    sample: int
    seconds: float
    numbers: Array


def check_head(data: bytes) -> None:
    """Raise Garbage for what does not even begin as a packet does; `data` may be its first bytes only."""
    if data[: len(MAGIC)] != MAGIC[: len(data)]:
        raise Garbage(f"{shown(data)} where a packet must begin with {MAGIC.decode()}")


def number_of(data: bytes) -> int:
    """The number of a packet that begins as one does."""
    check_head(data)
    if len(data) < HEADER.size:
        raise Garbage(f"a packet of {len(data)} bytes, which is shorter than a header")
    return int(HEADER.unpack_from(data)[3])


def answer_to(request: Request, data: bytes) -> Answer:
    """The answer, checked against its request. Raises Garbage."""
    number_of(data)
    _, version, kind, number, status, ports, sample, seconds = HEADER.unpack_from(data)
    if version != VERSION:
        raise Garbage(f"packets of version {version}, where this is version {VERSION}")
    if kind != request.kind:
        raise Garbage(f"a packet of kind {kind} as the answer to one of kind {request.kind} ({KINDS[request.kind]})")
    if number != request.number:
        raise Garbage(f"a packet with the number {number} as the answer to number {request.number}")
    if request.kind != HELLO and ports != request.ports:
        raise Garbage(f"a packet for {ports} ports, where there are {request.ports}")
    if len(data) != request.answer_size:
        raise Garbage(f"{len(data)} bytes where the answer ({KINDS[request.kind]}) has {request.answer_size}")
    return Answer(number, status, ports, sample, seconds, np.frombuffer(data, "<f8", offset=HEADER.size).astype(float))


def shown(data: bytes, most: int = 24) -> str:
    """Some bytes for a message."""
    return repr(data[:most])[1:] + (" ..." if len(data) > most else "")


def status_text(status: int) -> str:
    """What a controller's status says."""
    return f"status {status}, {STATUSES[status]}" if status in STATUSES else f"status {status}"
