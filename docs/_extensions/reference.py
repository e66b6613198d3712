"""Writes reference/generated from the code, when the build begins."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from api_pages import api_pages
from command_page import command_page
from scenario_pages import scenario_pages


def pages() -> Iterator[tuple[str, str]]:
    """(name, text) of every page that is made from the code."""
    yield from api_pages()
    yield "commands", command_page()
    yield from scenario_pages()


def write(folder: Path) -> None:
    """All of them into `folder`, touched only where they change."""
    folder.mkdir(exist_ok=True)
    made = {f"{name}.md": f"{text}\n" for name, text in pages()}
    for old in folder.iterdir():
        if old.name not in made:
            old.unlink()
    for name, text in made.items():
        file = folder / name
        if not file.exists() or file.read_text(encoding="utf-8") != text:
            file.write_text(text, encoding="utf-8")


def setup(app: Any) -> dict[str, Any]:
    """Join the build."""
    app.connect("builder-inited", lambda app: write(Path(app.srcdir) / "reference" / "generated"))
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
