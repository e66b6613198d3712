"""What a lab is opened with: a scenario or a result, named on the command line and therefore trusted."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from dampen.lab.tables import FREE_TEXT, texts
from dampen.scenarios.read import Builder, Table, folder_of, parse, shipped, table_of
from dampen.scenarios.results import load
from dampen.toml import to_toml


@dataclass(frozen=True)
class Opening:
    """name, table: the scenario.   beside: the folder that its files and classes lie in.   result: a stored result of it."""

    name: str
    table: Table
    beside: Path
    result: Path | None = None

    @property
    def own(self) -> frozenset[str]:
        """Code of the user's own that it names."""
        return frozenset(text for where, text in texts(self.table) if ":" in text and where not in FREE_TEXT)

    def table_in(self, attachments: Path) -> Table:
        """The table as the page has it: the files that it names are attachments. Raises ArgumentError if it cannot be run."""
        return with_attachments(self.table, self.beside, attachments)


def opening(source: str) -> Opening:
    """What `source` names: a shipped scenario, a scenario file, a result file. Raises ArgumentError if it is none."""
    if Path(source).suffix == ".nc":
        result = load(source)
        table = parse(to_toml(result.scenario), source)
        return Opening(result.scenario.name, table, Path(source).resolve().parent, Path(source).resolve())
    table = table_of(source)
    return Opening(str(table.get("name", "")), table, folder_of(source).resolve())


def shipped_table(name: str, attachments: Path) -> Table:
    """The table of a shipped scenario as the page has it."""
    return with_attachments(table_of(name), shipped()[name].parent, attachments)


def with_attachments(table: Table, folder: Path, attachments: Path) -> Table:
    """The table with each file that it names copied to the attachments, and named as it is there."""
    builder = NotingFiles(folder)
    builder.scenario(table)
    kept = {name: copied(Path(path), attachments) for name, path in builder.files.items()}
    return dict(renamed(table, kept)) if kept else table


class NotingFiles(Builder):
    """Builds a scenario and notes the files that it names."""

    def __init__(self, folder: Path):
        super().__init__(folder)
        self.files: dict[str, str] = {}

    def file(self, name: str, where: str) -> str:
        self.files[name] = super().file(name, where)
        return self.files[name]


def copied(path: Path, attachments: Path) -> str:
    """Copy a file to the attachments; its name there."""
    content = path.read_bytes()
    kept = attachments / attachment_name(path.name, content)
    kept.write_bytes(content)
    return kept.name


def attachment_name(name: str, content: bytes) -> str:
    """What a file is called among the attachments: its own stem, and a hash of its content unless it is there already."""
    mark = hashlib.sha256(content).hexdigest()[:8]
    stem = re.sub(r"[^A-Za-z0-9_-]+", "-", Path(name).stem).strip("-")[:40].removesuffix(f"-{mark}") or "file"
    return f"{stem}-{mark}{Path(name).suffix.lower()}"


def renamed(value: Any, names: Mapping[str, str]) -> Any:
    """The value with these strings replaced."""
    if isinstance(value, dict):
        return {key: renamed(inner, names) for key, inner in value.items()}
    if isinstance(value, list):
        return [renamed(inner, names) for inner in value]
    return names.get(value, value) if isinstance(value, str) else value
