"""What is handed in and what is taken away: one request each, beside the line."""

from __future__ import annotations

import secrets
import shutil
import tempfile
import zipfile
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from starlette.background import BackgroundTask
from starlette.requests import Request
from starlette.responses import FileResponse, JSONResponse, Response

from dampen.component import ArgumentError
from dampen.lab.guard import shown, take_in
from dampen.lab.lab import Lab
from dampen.lab.limits import ATTACHMENT, MESSAGE, STORED, UPLOAD
from dampen.lab.line import decoded
from dampen.lab.tables import faults

TAKEN = ("toml", "netcdf", "figures", "report")
DATA = "application/octet-stream"


async def read(request: Request) -> Response:
    """POST /read: a scenario file, a result, or an archive of one with its attachments."""
    lab, name = lab_of(request), file_name(request)
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
    lab = lab_of(request)
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
    folder = Path(tempfile.mkdtemp(dir=lab_of(request).folder))
    answer: Response | None = None
    try:
        answer = await taken(request, folder)
    except ArgumentError as error:
        return refused(error)
    finally:
        if isinstance(answer, FileResponse):
            answer.background = BackgroundTask(shutil.rmtree, folder, ignore_errors=True)
        else:
            shutil.rmtree(folder, ignore_errors=True)
    return answer


async def taken(request: Request, folder: Path) -> Response:
    """The file that is asked for, made in an empty folder. Raises ArgumentError."""
    lab, what = lab_of(request), request.path_params["what"]
    await take_in(request, folder / "asked", MESSAGE)
    asked = decoded((folder / "asked").read_bytes().decode("utf-8", "replace"))
    if what not in TAKEN or not isinstance(asked, dict):
        raise ArgumentError(f"A download must be one of {', '.join(TAKEN)}, of a table.")
    stored = lab.uploads.get(asked["token"]) if what == "netcdf" and isinstance(asked.get("token"), str) else None
    if stored is not None:
        name = "result.zip" if zipfile.is_zipfile(stored.path) else "result.nc"
        return FileResponse(stored.path, media_type=DATA, filename=name)
    outcome = await lab.workers.errand({"do": "take", "what": what, "table": asked.get("table"), "folder": str(folder)})
    if "path" not in outcome:
        return JSONResponse({"faults": complaints(outcome)}, 400)
    return FileResponse(outcome["path"], media_type=DATA, filename=outcome["name"])


def lab_of(request: Request) -> Lab:
    """The lab that a request has reached."""
    lab: Lab = request.app.state.lab
    return lab


def refused(error: ArgumentError) -> Response:
    """Bad input: one fault a line, each with the field it belongs to."""
    return JSONResponse({"faults": faults(error)}, 400)


def complaints(outcome: dict[str, Any]) -> list[dict[str, str]]:
    """An errand's faults, or what it failed of."""
    found: list[dict[str, str]] = outcome.get("faults") or [{"at": "", "text": outcome.get("failed", "This could not be done.")}]
    return found


def file_name(request: Request) -> str:
    """The name of a file as its owner has it, for messages: its last part, printable and short."""
    name = Path(unquote(request.query_params.get("name", ""))).name
    return "".join(c for c in name if c.isprintable())[:80] or "file"
