"""The package's own text as Markdown: docstrings, units, tables."""

from __future__ import annotations

import inspect
import json
import re
import textwrap
from collections.abc import Iterable, Sequence
from typing import Any

from dampen.report.style import typeset

NAMES = r"[a-z_]\w*(?: [\w()\[\]]+){0,2}"
ENTRY = re.compile(rf"{NAMES}(?:, {NAMES})*: +\S")
ROLE = re.compile(r":(?:class|func|meth|mod):`~?\.?([\w.]+)`")


def docstring(thing: Any) -> str:
    """The docstring of `thing` as Markdown."""
    return "\n\n".join(map(_block, re.split(r"\n\s*\n", inspect.getdoc(thing) or "")))


def _block(text: str) -> str:
    """One paragraph: a formula or code if it is indented, a list if its lines are named, plain words otherwise."""
    lines = text.strip("\n").splitlines()
    if all(line.startswith("    ") for line in lines):
        return f"```text\n{textwrap.dedent(chr(10).join(lines))}\n```"
    if not lines or not ENTRY.match(lines[0]):
        return _mixed(lines)
    entries: list[str] = []
    for line in lines:
        if ENTRY.match(line) or not entries:
            entries.append(line)
        else:
            entries[-1] += " " + line.strip()
    return "\n".join(f"- **{name}**: {safe(rest.strip())}" for name, _, rest in (entry.partition(":") for entry in entries))


def _mixed(lines: Sequence[str]) -> str:
    """Words, and what is indented below them."""
    end = next((i for i, line in enumerate(lines) if i and line.startswith("    ")), len(lines))
    words = safe("\n".join(lines[:end]))
    return words if end == len(lines) else f"{words}\n\n{_block(chr(10).join(lines[end:]))}"


def safe(text: str) -> str:
    """Words in which nothing but backticks means anything to Markdown."""
    text = ROLE.sub(lambda match: f"`{match[1]}`", text)
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(part if part.startswith("`") else re.sub(r"([\\*_<>\[\]$#{}^~])", r"\\\1", part) for part in parts)


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A Markdown table; columns without any entry are left out."""
    rows = [list(row) for row in rows]
    used = [i for i, name in enumerate(head) if i == 0 or any(row[i] for row in rows)]
    lines = [[head[i] for i in used], ["---"] * len(used), *([row[i] for i in used] for row in rows)]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|").replace("\n", " ") for cell in line) + " |" for line in lines)


def about(text: str) -> str:
    """A parameter's meaning."""
    return safe(typeset(text))


def unit(text: str) -> str:
    """A unit, kept on one line."""
    return safe(typeset(text)).replace(" ", "\N{NO-BREAK SPACE}")


def code(value: Any) -> str:
    """A default as a scenario file or Python would have it."""
    text = value if isinstance(value, str) and value.startswith("[") else json.dumps(value, ensure_ascii=False, default=str)
    return f"`{text}`"
