"""What the browser reaches: the page, what describes a scenario, errands, and the line for everything that moves."""

from __future__ import annotations

from pathlib import Path

from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles

from dampen.lab.errands import attach, lab_of, read, take
from dampen.lab.guard import Guard
from dampen.lab.lab import Lab
from dampen.lab.line import talk
from dampen.lab.opening import shipped_table
from dampen.release import version
from dampen.report.style import PALETTES
from dampen.scenarios.read import shipped, table_of
from dampen.scenarios.schema import schema

PAGE = Path(__file__).parent / "page"


async def describe(request: Request) -> Response:
    """GET /schema: all that a scenario can hold, and how it looks."""
    names = [{"name": name, "title": table_of(name).get("title", "")} for name in shipped()]
    return JSONResponse({"version": version(), "scenarios": names, "colours": PALETTES, **schema()})


async def start(request: Request) -> Response:
    """GET /start: what the lab was opened with."""
    lab = lab_of(request)
    return JSONResponse({"name": lab.name, "table": lab.table, **({"token": lab.token} if lab.token else {})})


async def scenario(request: Request) -> Response:
    """GET /scenario/NAME: a shipped scenario."""
    name = request.path_params["name"]
    if name not in shipped():
        return JSONResponse({"faults": [{"at": "", "text": "There is no shipped scenario of this name."}]}, 404)
    return JSONResponse({"name": name, "table": shipped_table(name, lab_of(request).attachments)})


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
