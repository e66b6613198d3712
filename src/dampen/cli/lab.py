"""`dampen lab`: the page where the structure moves under one's hand."""

from __future__ import annotations

from typing import Annotated

import typer

from dampen.cli.terminal import err, out

HELP = (
    "Open the lab: a page in your browser where the structure moves and every parameter has its slider; at every change all "
    "trials are run again.\n\nExamples:\n\n  dampen lab\n\n  dampen lab mine.toml\n\n  dampen lab runs/he2017/result.nc\n\n"
    "Runs on this machine and is reached from it only. Ctrl-C ends it."
)


def lab(
    source: Annotated[
        str, typer.Argument(metavar="[SCENARIO|RESULT.nc]", help="a shipped scenario, a TOML file or a result file")
    ] = "he2017",
    port: Annotated[int | None, typer.Option("--port", metavar="N", help="the port (default: 8017 if it is free)")] = None,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="open the page in the browser")] = True,
    host: Annotated[
        str,
        typer.Option("--host", metavar="ADDRESS", help="where to listen; any but 127.0.0.1 lets other machines in"),
    ] = "127.0.0.1",
) -> None:
    """`dampen lab`."""
    import asyncio
    import webbrowser

    from dampen.lab.serve import listening, serve

    own = listening(host, port)
    place = f"[{host}]" if ":" in host else host
    address = f"http://{place}:{own.getsockname()[1]}/"
    if host not in ("127.0.0.1", "localhost", "::1"):
        err.print(f"Note: whoever reaches {host} can use this lab; there is no password.", markup=False)

    def ready() -> None:
        out.print(f"Lab: {address}   (Ctrl-C ends it)", markup=False)
        if browser:
            webbrowser.open(address)

    asyncio.run(serve(source, own, host, ready))
