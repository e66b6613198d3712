"""The lab's state: its workers, its private folder, what has been handed in."""

from __future__ import annotations

import asyncio
import secrets
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dampen.component import ArgumentError
from dampen.lab.limits import STORED
from dampen.lab.workers import Customer, Workers, nowhere

if TYPE_CHECKING:
    from dampen.lab.opening import Opening
    from dampen.scenarios.read import Table

WISHES = ("run", "open")
UPLOADS = 2  # at a time: each may be large


@dataclass
class Upload:
    """A stored result that a page may ask for by its token; `trusted`: it came with the command."""

    path: Path
    trusted: bool = False


class Lab:
    """The server's state: its workers, its private folder, and what has been handed in.

    Made before it is known what it is opened with, so that the first worker starts meanwhile.
    """

    def __init__(self, folder: Path):
        self.folder, self.attachments = folder, folder / "attachments"
        self.attachments.mkdir()
        self.workers = Workers(self.trust)
        self.workers.open()
        self.uploads: dict[str, Upload] = {}
        self.uploading = asyncio.Semaphore(UPLOADS)
        self.name, self.token = "", ""
        self.table: Table = {}
        self.own: list[str] = []
        self.beside = Path()

    def open(self, opening: Opening) -> None:
        """Open a scenario or a result, and have the first picture's work done before a page asks for it. Raises ArgumentError."""
        self.name, self.own, self.beside = opening.name, sorted(opening.own), opening.beside
        self.table = opening.table_in(self.attachments)
        self.token = "" if opening.result is None else self.keep(opening.result, trusted=True)
        first = {"do": "open", "token": self.token} if self.token else {"do": "run", "table": self.table}
        self.workers.benches[0].wish(Customer(nowhere), self.job({**first, "id": 0}))

    def trust(self) -> dict[str, Any]:
        """What workers may take from outside a table."""
        return {"attachments": str(self.attachments), "own": self.own, "beside": str(self.beside)}

    def keep(self, path: Path, trusted: bool = False) -> str:
        """Keep a result under a new token; the oldest uploads go when there are too many bytes of them."""
        token = secrets.token_urlsafe(12)
        self.uploads[token] = Upload(path, trusted)
        own = [t for t, upload in self.uploads.items() if not upload.trusted]
        while sum(self.uploads[t].path.stat().st_size for t in own) > STORED:
            self.uploads.pop(own.pop(0)).path.unlink()
        return token

    def job(self, asked: Any) -> dict[str, Any]:
        """The job behind a page's message. Raises ArgumentError."""
        if not isinstance(asked, dict) or asked.get("do") not in WISHES:
            raise ArgumentError('A message must ask to "run" or to "open".')
        id, trial = asked.get("id"), asked.get("trial", 0)
        if not is_count(id) or not is_count(trial):
            raise ArgumentError("A message must have an `id` and a `trial`, whole numbers >= 0.")
        if asked["do"] == "run":
            return {"do": "run", "id": id, "trial": trial, "table": asked.get("table")}
        token = asked.get("token")
        upload = self.uploads.get(token) if isinstance(token, str) else None
        if upload is None:
            raise ArgumentError("This result is no longer here: open its file again.")
        return {"do": "open", "id": id, "trial": trial, "path": str(upload.path), "trusted": upload.trusted}


def is_count(value: object) -> bool:
    """Whether a value of a message is a whole number that can be one."""
    return isinstance(value, int) and not isinstance(value, bool) and 0 <= value < 2**53
