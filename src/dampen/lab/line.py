"""The line to a page: its wishes come in, their answers go out."""

from __future__ import annotations

import asyncio
import json
from contextlib import suppress
from typing import Any

from starlette.websockets import WebSocket, WebSocketDisconnect

from dampen.component import ArgumentError
from dampen.lab.guard import shown
from dampen.lab.lab import Lab, is_count
from dampen.lab.limits import MESSAGE
from dampen.lab.tables import faults
from dampen.lab.workers import Customer, Said

SLOW = 10.0  # seconds that a page may take to accept a message


async def talk(socket: WebSocket) -> None:
    """WebSocket /ws: a page's wishes, and their answers."""
    lab: Lab = socket.app.state.lab
    await socket.accept()

    async def deliver(said: Said) -> None:
        """To the page; one that does not take its messages is let go."""
        try:
            async with asyncio.timeout(SLOW):
                await (socket.send_bytes(said) if isinstance(said, bytes) else socket.send_text(said))
        except (TimeoutError, RuntimeError, WebSocketDisconnect, OSError):
            worker.forget(customer)
            with suppress(TimeoutError, RuntimeError, OSError):
                async with asyncio.timeout(1):
                    await socket.close(1013)

    customer = Customer(deliver)
    worker = lab.workers.join(customer)
    endings: set[asyncio.Task[None]] = set()
    try:
        while True:
            message = await socket.receive()
            if message["type"] == "websocket.disconnect" or customer not in worker.customers:
                return
            try:
                asked = decoded(message.get("text") or "")
                wish = worker.wish(customer, lab.job(asked))
            except ArgumentError as error:
                id = asked["id"] if isinstance(asked := seen(message), dict) and is_count(asked.get("id")) else 0
                await deliver(json.dumps({"say": "refused", "id": id, "faults": faults(error)}))
                continue
            ending = asyncio.create_task(last_word(wish.outcome, wish.job["id"], deliver))
            endings.add(ending)
            ending.add_done_callback(endings.discard)
    finally:
        worker.forget(customer)
        for ending in endings:
            ending.cancel()


async def last_word(outcome: asyncio.Future[dict[str, Any]], id: int, deliver: Any) -> None:
    """What a page must still hear once its job has ended."""
    with suppress(asyncio.CancelledError):
        found = await outcome
        if "faults" in found:
            await deliver(json.dumps({"say": "refused", "id": id, "faults": found["faults"]}))
        elif "failed" in found:
            await deliver(json.dumps({"say": "failed", "id": id, "text": found["failed"]}))


def decoded(text: str) -> Any:
    """JSON from a browser. Raises ArgumentError."""
    if len(text) > MESSAGE:
        raise ArgumentError(f"A message must be at most {shown(MESSAGE)}.")
    try:
        return json.loads(text)
    except (ValueError, RecursionError):
        raise ArgumentError("A message must be JSON.") from None


def seen(message: Any) -> Any:
    """What can be told of a message that was refused."""
    with suppress(ArgumentError):
        return decoded(message.get("text") or "")
    return None
