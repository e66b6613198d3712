"""The page of the command line, from the commands themselves."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import typer
from words import safe, table

from dampen.cli import app


def command_page() -> str:
    """The page."""
    root = typer.main.get_command(app)
    parts = ["# Command line", helped(root.help), options(root), "Wherever there is `--help`, there is `-h`."]
    parts += [part for name, command in root.commands.items() for part in described(f"dampen {name}", command, 2)]
    return "\n\n".join(part for part in parts if part)


def described(name: str, command: Any, level: int) -> Iterator[str]:
    """One command, or a group and its commands."""
    yield f"{'#' * level} {name}"
    inner = getattr(command, "commands", None)
    if inner is None:
        arguments = [p.name.upper() if p.required else f"[{p.name.upper()}]" for p in command.params if is_argument(p)]
        many = ["..." if p.nargs == -1 else "" for p in command.params if is_argument(p)]
        usage = " ".join([name, "[OPTIONS]", *map("".join, zip(arguments, many, strict=True))])
        yield f"```text\n{usage}\n```"
    yield helped(command.help)
    if inner is None:
        rows = [(f"`{p.name.upper()}`", "", safe(p.help or "")) for p in command.params if is_argument(p)]
        yield table(("argument", "", "meaning"), rows) if rows else ""
        yield options(command)
    for key, one in (inner or {}).items():
        yield from described(f"{name} {key}", one, level + 1)


def is_argument(parameter: Any) -> bool:
    """Whether a parameter is given by its place."""
    return parameter.param_type_name == "argument"


def options(command: Any) -> str:
    """The options of a command as a table."""
    rows = []
    for p in command.params:
        if is_argument(p) or p.hidden:
            continue
        names = ", ".join(f"`{name}`" for name in (*p.opts, *p.secondary_opts))
        value = f" `{p.metavar}`" if p.metavar else "" if p.is_flag else f" `{p.type_descriptor.annotation.__name__.upper()}`"
        shown = p.default is not None and not callable(p.default) and not p.is_flag and p.default not in ((), [])
        often = "; more than once, if need be" if p.multiple else ""
        rows.append((names + value, f"`{p.default}`" if shown else "", safe(p.help or "") + often))
    return table(("option", "default", "meaning"), rows) if rows else ""


def helped(text: str | None) -> str:
    """Help as Markdown: indented lines are commands."""
    parts = []
    for block in re.split(r"\n\s*\n", text or ""):
        parts.append(f"```text\n{block.strip()}\n```" if block.startswith("  ") else safe(block.strip()))
    return "\n\n".join(parts).replace("\n```\n\n```text\n", "\n")
