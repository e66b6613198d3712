"""Looks through built pages: `python docs/check_pages.py build/docs`.

Every link inside has to lead somewhere, nothing may be loaded from the net, and nothing may tell of the machine that built them.
"""

from __future__ import annotations

import sys
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

LOADS = {("link", "href"), ("script", "src"), ("img", "src"), ("iframe", "src"), ("source", "src"), ("object", "data")}
ROOT = Path(__file__).parents[1]
PLACES = [place for place in (str(ROOT), str(Path.home()), "/tmp/") if len(place) > 1]


class Page(HTMLParser):
    """What a page points to, and what in it can be pointed to."""

    def __init__(self, text: str):
        super().__init__()
        self.ids: set[str] = set()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Note the ends of links and what is loaded."""
        given = {name: value or "" for name, value in attrs}
        self.ids |= {given[name] for name in ("id", "name") if name in given}
        loaded = [given[name] for name in ("href", "src", "data") if (tag, name) in LOADS and name in given]
        self.loads += loaded
        self.links += [given["href"]] if tag == "a" and "href" in given else loaded


@cache
def page(file: Path) -> Page:
    """A page, read once."""
    return Page(file.read_text(encoding="utf-8"))


def faults(file: Path) -> list[str]:
    """What is wrong with one page."""
    found = [f"loads {load}" for load in page(file).loads if urlsplit(load).scheme in ("http", "https") or load.startswith("//")]
    text = file.read_text(encoding="utf-8")
    found += [f"tells of {place}" for place in PLACES if place in text]
    for link in page(file).links:
        parts = urlsplit(link)
        if parts.scheme or parts.netloc:
            continue
        target = (file.parent / unquote(parts.path)).resolve() if parts.path else file
        if not target.is_file():
            found.append(f"{link} leads nowhere")
        elif parts.fragment and target.suffix == ".html" and unquote(parts.fragment) not in page(target).ids:
            found.append(f"{link} names no place there")
    return found


def main() -> int:
    """0 if nothing is wrong."""
    built = Path(sys.argv[1])
    files = sorted(built.rglob("*.html"))
    lines = [f"{file.relative_to(built)}: {fault}" for file in files for fault in sorted(set(faults(file)))]
    lines += [
        f"{sheet.relative_to(built)}: loads from the net"
        for sheet in built.rglob("*.css")
        if any(mark in sheet.read_text(encoding="utf-8") for mark in ("url(http", "url('http", 'url("http', "@import"))
    ]
    print("\n".join(lines) or f"{len(files)} pages: all links lead somewhere, nothing is loaded from the net.")
    return 1 if lines or not files else 0


if __name__ == "__main__":
    sys.exit(main())
