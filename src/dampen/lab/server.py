"""What the browser reaches: the page, what goes in and out, and a WebSocket for everything that moves."""

from __future__ import annotations

import asyncio
import json
import secrets
import shutil
import tempfile
import zipfile
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from starlette.applications import Starlette
from starlette.background import BackgroundTask
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import FileResponse, JSONResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.websockets import WebSocket, WebSocketDisconnect

from dampen.component import ArgumentError
from dampen.lab.guard import Guard, shown, take_in
from dampen.lab.lab import Lab, is_count
from dampen.lab.limits import ATTACHMENT, MESSAGE, STORED, UPLOAD
from dampen.lab.opening import shipped_table
from dampen.lab.tables import faults
from dampen.lab.workers import Customer, Said
from dampen.release import version
from dampen.report.style import PALETTES
from dampen.scenarios.read import shipped, table_of
from dampen.scenarios.schema import schema

PAGE = Path(__file__).parent / "page"
SLOW = 10.0  # seconds that a page may take to accept a message
TAKEN = ("toml", "netcdf", "figures", "report")


def page_of(request: Request | WebSocket) -> Lab:
    """The lab that a request has reached."""
    lab: Lab = request.app.state.lab
    return lab


def refused(error: ArgumentError) -> Response:
    """Bad input: one fault a line, each with the field it belongs to."""
    return JSONResponse({"faults": faults(error)}, 400)


async def describe(request: Request) -> Response:
    """GET /schema: all that a scenario can hold, and how it looks."""
    names = [{"name": name, "title": table_of(name).get("title", "")} for name in shipped()]
    return JSONResponse({"version": version(), "scenarios": names, "colours": PALETTES, **schema()})


async def start(request: Request) -> Response:
    """GET /start: what the lab was opened with."""
    lab = page_of(request)
    return JSONResponse({"name": lab.name, "table": lab.table, **({"token": lab.token} if lab.token else {})})


async def scenario(request: Request) -> Response:
    """GET /scenario/NAME: a shipped scenario."""
    name = request.path_params["name"]
    if name not in shipped():
        return JSONResponse({"faults": [{"at": "", "text": "There is no shipped scenario of this name."}]}, 404)
    return JSONResponse({"name": name, "table": shipped_table(name, page_of(request).attachments)})


async def read(request: Request) -> Response:
    """POST /read: a scenario file, a result, or an archive of one with its attachments."""
    lab, name = page_of(request), file_name(request)
    path = lab.folder / f"upload-{secrets.token_hex(8)}"
    try:
        async with lab.uploading:
            await take_in(request, path, UPLOAD)
            outcome = await lab.workers.errand({"do": "read", "path": str(path), "name": name})
        if "table" not in outcome:
            return JSONResponse({"faults": complaints(outcome)}, 400)
        opened = {"name": outcome["table"].get("name", name), "table": outcome["table"]}
        return JSONResponse({**opened, "token": lab.keep(path)} if outcome["result"] else opened)
    except ArgumentError as error:
        return refused(error)
    finally:
        if all(upload.path != path for upload in lab.uploads.values()):
            path.unlink(missing_ok=True)


async def attach(request: Request) -> Response:
    """POST /attach: a file that a scenario is to name."""
    lab = page_of(request)
    path = lab.folder / f"upload-{secrets.token_hex(8)}"
    try:
        async with lab.uploading:
            await take_in(request, path, ATTACHMENT)
            if sum(file.stat().st_size for file in lab.attachments.iterdir()) > STORED:
                raise ArgumentError(f"The lab keeps at most {shown(STORED)} of attachments: start it again.")
            outcome = await lab.workers.errand({"do": "attach", "path": str(path), "name": file_name(request)})
        kept = "attachment" in outcome
        return JSONResponse(outcome if kept else {"faults": complaints(outcome)}, 200 if kept else 400)
    except ArgumentError as error:
        return refused(error)
    finally:
        path.unlink(missing_ok=True)


async def take(request: Request) -> Response:
    """POST /download/WHAT: a scenario, its result, its figures or its report, as a file."""
    lab, what = page_of(request), request.path_params["what"]
    folder = Path(tempfile.mkdtemp(dir=lab.folder))
    gone = BackgroundTask(shutil.rmtree, folder, ignore_errors=True)
    try:
        await take_in(request, folder / "asked", MESSAGE)
        asked = decoded((folder / "asked").read_bytes().decode("utf-8", "replace"))
        if what not in TAKEN or not isinstance(asked, dict):
            raise ArgumentError(f"A download must be one of {', '.join(TAKEN)}, of a table.")
        stored = lab.uploads.get(asked["token"]) if what == "netcdf" and isinstance(asked.get("token"), str) else None
        if stored is not None:
            name = "result.zip" if zipfile.is_zipfile(stored.path) else "result.nc"
            return FileResponse(stored.path, media_type="application/octet-stream", filename=name, background=gone)
        outcome = await lab.workers.errand({"do": "take", "what": what, "table": asked.get("table"), "folder": str(folder)})
    except ArgumentError as error:
        await gone()
        return refused(error)
    if "path" not in outcome:
        await gone()
        return JSONResponse({"faults": complaints(outcome)}, 400)
    return FileResponse(outcome["path"], media_type="application/octet-stream", filename=outcome["name"], background=gone)


async def talk(socket: WebSocket) -> None:
    """WebSocket /ws: a page's wishes, and their answers."""
    lab = page_of(socket)
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


def complaints(outcome: dict[str, Any]) -> list[dict[str, str]]:
    """An errand's faults, or what it failed of."""
    found: list[dict[str, str]] = outcome.get("faults") or [{"at": "", "text": outcome.get("failed", "This could not be done.")}]
    return found


def file_name(request: Request) -> str:
    """The name of a file as its owner has it, for messages: its last part, printable and short."""
    name = Path(unquote(request.query_params.get("name", ""))).name
    return "".join(c for c in name if c.isprintable())[:80] or "file"


def application(lab: Lab, host: str) -> Starlette:
    """The lab as an ASGI application."""
    routes = [
        Route("/schema", describe),
        Route("/start", start),
        Route("/scenario/{name}", scenario),
        Route("/read", read, methods=["POST"]),
        Route("/attach", attach, methods=["POST"]),
        Route("/download/{what}", take, methods=["POST"]),
        WebSocketRoute("/ws", talk),
        Mount("/", StaticFiles(directory=PAGE, html=True)),
    ]
    app = Starlette(routes=routes, middleware=[Middleware(Guard, host=host)])
    app.state.lab = lab
    return app
