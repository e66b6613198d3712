"""All evidence: `python docs/validation/evidence.py [FOLDER]` prints the numbers and draws the figures into a folder."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import learning
import motion
import samples
import structures
from kit import Evidence

PIECES: dict[str, Callable[[], Evidence]] = {
    piece.__name__: piece for room in (structures, motion, learning, samples) for piece in room.ALL
}


def show(name: str) -> None:
    """A piece on a page: its figure and its numbers."""
    from IPython.display import Markdown, display

    found = PIECES[name]()
    if found.missing:
        display(Markdown(f"*Not made in this build, for want of {found.missing}.*"))
        return
    if not found.holds:
        raise AssertionError(f"{name} does not hold:\n{found.table()}")
    if found.figure is not None:
        display(found.figure)
    display(Markdown(found.table()))


def main() -> int:
    """0 if all of it holds."""
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    if folder:
        folder.mkdir(parents=True, exist_ok=True)
    whole = True
    for name, piece in PIECES.items():
        found = piece()
        whole &= found.holds
        print(f"\n{name}: {(piece.__doc__ or '').strip()}")
        print("  not made, for want of " + found.missing if found.missing else found.table())
        if folder and found.figure is not None:
            found.figure.savefig(folder / f"{name}.png", dpi=200)
    return 0 if whole else 1


if __name__ == "__main__":
    sys.exit(main())
