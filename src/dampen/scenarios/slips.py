"""Text that is not TOML: what line is at fault, and what it may have been meant to be."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Collection

from dampen.component import NUMBER, UNIT, cut

LONGEST = 300  # letters of a line that is looked into
END = r"(?=\s*(?:[,}\]#]|$))"
SLIPS = (
    (rf"([=\[,]\s*)(?!(?:true|false|inf|nan)\b)([A-Za-z][\w:. -]*?){END}", r'\1"\2"', "Text needs quotes."),
    (r"(\d),(\d)", r"\1.\2", "Numbers have a decimal point."),
)
MEASURED = re.compile(rf"=\s*{NUMBER} *{UNIT}?{END}")
HEADING = re.compile(r"\[[^\[\]]+\]")


def meant(text: str, shape: str = "`{}`") -> str:
    """What a line that is not TOML may have been meant to be, in the words that end a complaint about it.

    shape: how the line is to be shown.
    """
    if len(text) > LONGEST:
        return "."
    for slip, repair, advice in SLIPS:
        other = re.sub(slip, repair, text)
        if other != text and is_toml(other):
            return f"; did you mean {shape.format(cut(other))}? {advice}"
    return "; numbers stand without their unit." if MEASURED.search(text) else "."


def is_toml(text: str) -> bool:
    """Whether it can be read."""
    try:
        tomllib.loads(text)
    except (ValueError, RecursionError):
        return False
    return True


def fault(error: Exception, text: str, lists: Collection[str] = ()) -> str:
    """What TOML's reader says of a text, with the line that it stumbled over and what may have been meant there.

    lists: the keys of tables that come in lists.
    """
    place, lines = re.search(r"at line (\d+)", str(error)), text.rstrip().splitlines()
    if not lines:
        return f"{error}."
    line = (lines[int(place[1]) - 1] if place and int(place[1]) <= len(lines) else lines[-1]).strip()
    heading = HEADING.match(line)
    if heading and "twice" in str(error):
        name, last = cut(heading[0]), heading[0].strip("[] ").rpartition(".")[2].strip()
        advice = f"each of a list of tables is written `[{name}]`" if last in lists else f"merge the two `{name}` tables"
        return f"{error}, `{cut(line)}`; {advice}."
    return f"{error}, `{cut(line)}`{meant(line)}"
