"""Who may speak to the lab: its own page, from this machine unless the user has said otherwise."""

from __future__ import annotations

import ipaddress
from pathlib import Path
from urllib.parse import urlsplit

from starlette.datastructures import Headers, MutableHeaders
from starlette.requests import Request
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from dampen.component import ArgumentError

OWN_HEADER = "x-dampen"  # a page from elsewhere cannot send it without being asked first, and is then refused
LOOPBACK = ("127.0.0.1", "localhost", "::1")
EVERYWHERE = ("0.0.0.0", "::")
HEADERS = {
    "Content-Security-Policy": "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
    "connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; form-action 'none'; object-src 'none'",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cache-Control": "no-cache",
}


class Guard:
    """Refuses requests under a foreign name (DNS rebinding), and whatever a page from elsewhere sends."""

    def __init__(self, app: ASGIApp, host: str):
        self.app, self.host = app, host

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] not in ("http", "websocket"):
            await self.app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        reason = self.refusal(scope, headers)
        if reason and scope["type"] == "http":
            await PlainTextResponse(reason, 403)(scope, receive, send)
        elif reason:
            await receive()
            await send({"type": "websocket.close", "code": 4403, "reason": reason})
        else:
            await self.app(scope, receive, armoured(send))

    def refusal(self, scope: Scope, headers: Headers) -> str:
        """Why a request is refused; nothing for one that is let pass."""
        hosts = headers.getlist("host")
        if len(hosts) != 1 or not self.is_own(hostname(f"//{hosts[0]}")):
            return "The lab answers under its own address only."
        changes = scope["type"] == "websocket" or scope["method"] not in ("GET", "HEAD")
        if changes and headers.get("origin") not in (f"http://{hosts[0]}", f"https://{hosts[0]}"):
            return "The lab listens to its own page only."
        if changes and scope["type"] == "http" and OWN_HEADER not in headers:
            return "The lab listens to its own page only."
        return ""

    def is_own(self, name: str | None) -> bool:
        """Whether the lab is known by this name: bound to everywhere, by any address, but by no name that others hand out."""
        if name is None:
            return False
        return name in (*LOOPBACK, self.host) or (self.host in EVERYWHERE and is_address(name))


def hostname(url: str) -> str | None:
    """The host in a URL; None for what is none."""
    try:
        return urlsplit(url).hostname
    except ValueError:
        return None


def is_address(name: str) -> bool:
    """Whether a name is an IP address."""
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def armoured(send: Send) -> Send:
    """`send`, with headers that keep the page from being framed, sniffed or fed from elsewhere."""

    async def with_headers(message: Message) -> None:
        if message["type"] == "http.response.start":
            MutableHeaders(scope=message).update(HEADERS)
        await send(message)

    return with_headers


async def take_in(request: Request, path: Path, most: int) -> None:
    """Write the body of a request to a file as it comes. Raises ArgumentError as soon as it is larger than `most` bytes."""
    size = 0
    with path.open("wb") as file:
        async for part in request.stream():
            size += len(part)
            if size > most:
                raise ArgumentError(f"The request must be at most {shown(most)}.")
            file.write(part)


def shown(size: int) -> str:
    """A size in bytes, for reading."""
    return f"{size // 2**20} MiB" if size >= 2**20 else f"{size // 2**10} KiB"
