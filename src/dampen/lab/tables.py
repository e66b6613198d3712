"""Tables from a browser turned into scenarios: nothing in them reaches code or files but attachments."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from dampen.component import ArgumentError, Component, InFile, split_hint
from dampen.lab.limits import DEEPEST, check_cost
from dampen.own import own_function
from dampen.scenarios.kinds import find_kind
from dampen.scenarios.read import Builder
from dampen.simulation.scenario import Scenario

LINE = re.compile(r"^(?:Argument|Option) `([^`]+)` (.*)$", re.DOTALL)
FREE_TEXT = ("name", "title")


@dataclass(frozen=True)
class Trust:
    """What a table may name outside itself.

    attachments: folder of the files that have been handed in, under names that the lab gave them.
    own:         code of the user's own that the command line's scenario names, as "module:Class", looked for in `beside`.
    """

    attachments: Path
    own: frozenset[str] = field(default_factory=frozenset)
    beside: Path = field(default_factory=Path)

    def file(self, name: str) -> Path | None:
        """The attachment of this name; a path is none, nor what leads to one."""
        known = {path.name: path for path in self.attachments.iterdir() if path.is_file()}
        return known.get(Path(name).name)


def scenario_of(table: object, trust: Trust) -> Scenario:
    """The scenario that a table from a browser describes. Raises ArgumentError, also for one that is too large for the lab."""
    if not isinstance(table, dict):
        raise ArgumentError("A scenario must be a table.")
    check_shape(table)
    scenario = GuardedBuilder(trust).scenario(table)
    check_cost(scenario)
    return scenario


class GuardedBuilder(Builder):
    """Builds what a browser asks for."""

    def __init__(self, trust: Trust):
        super().__init__(trust.attachments)
        self.trust = trust

    def kind(self, table: str, kind: object, where: str) -> type[Component]:
        own = self.checked(kind, f"{where}.kind")
        return find_kind(table, kind, where, self.trust.beside if own else self.folder)

    def file(self, name: str, where: str) -> str:
        path = self.trust.file(name)
        if path is None:
            raise ArgumentError(f"Argument `{where}` must name an attachment, but {Path(name).name!r} is none: attach the file.")
        return str(path)

    def function(self, name: str, where: str) -> Callable[..., Any]:
        self.checked(name, where)
        return own_function(name, where, self.trust.beside)

    def value(self, hint: Any, value: Any, where: str) -> Any:
        """What is no plain text could be taken for the name of a class or a function further on."""
        base, extras = split_hint(hint)
        if isinstance(value, str) and (base is not str or any(isinstance(extra, InFile) for extra in extras)):
            self.checked(value, where)
        return super().value(hint, value, where)

    def checked(self, text: object, where: str) -> bool:
        """Whether it names code that the lab's start has named; raises ArgumentError where it names any other."""
        if not isinstance(text, str) or ":" not in text:
            return False
        if text not in self.trust.own:
            raise ArgumentError(f"Argument `{where}` must not name code of your own: the lab takes it from its own start only.")
        return True


def check_shape(value: object, depth: int = 0) -> None:
    """Raise ArgumentError for tables in tables without end."""
    if depth > DEEPEST:
        raise ArgumentError(f"A scenario must not be deeper than {DEEPEST} tables.")
    for inner in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        check_shape(inner, depth + 1)


def texts(value: object, where: str = "") -> Iterator[tuple[str, str]]:
    """(path, text) of every string in a table."""
    if isinstance(value, str):
        yield where, value
    elif isinstance(value, Mapping):
        for key, inner in value.items():
            yield from texts(inner, f"{where}.{key}" if where else str(key))
    elif isinstance(value, list):
        for i, inner in enumerate(value):
            yield from texts(inner, f"{where}[{i}]")


def faults(error: ArgumentError) -> list[dict[str, str]]:
    """Each complaint, and the field that it belongs to."""
    found = []
    for line in error.lines:
        match = LINE.match(line)
        found.append({"at": match[1], "text": match[2]} if match else {"at": "", "text": line})
    return found
