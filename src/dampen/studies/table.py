"""A study's table on disk: Parquet parts that are only ever added, each whole or not there at all."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dampen.analysis.merits import columns
from dampen.component import ArgumentError
from dampen.studies.definition import Definition
from dampen.studies.evaluate import Row
from dampen.studies.variation import Axis
from dampen.toml import literal

if TYPE_CHECKING:
    import pandas

FINGERPRINT = b"dampen_study"
FAILED = ("refused", "crashed", "diverged")


class Table:
    """The rows of a study, in a folder or in memory. A row is added once, and never changed."""

    def __init__(self, definition: Definition, folder: Path | None = None):
        self.definition, self.folder = definition, folder
        self.by_member: dict[int, Row] = {}
        self.failed = 0
        for path in sorted(folder.glob("part-*.parquet")) if folder is not None else ():
            self._keep(self._read(path))

    def add(self, rows: Sequence[Row]) -> None:
        """Add rows; they are on disk when this returns. Raises ArgumentError where they cannot be written."""
        axes = {axis.name for axis in self.definition.axes}
        rows = [{name: as_kept(value) if name in axes else value for name, value in row.items()} for row in rows]
        if self.folder is not None and rows:
            self._write(rows, self.folder)
        self._keep(rows)

    @property
    def rows(self) -> Iterable[Row]:
        """All rows, in the order in which they came."""
        return self.by_member.values()

    def missing(self, members: Iterable[int]) -> list[int]:
        """Those members that have no row yet."""
        return [i for i in members if i not in self.by_member]

    def frame(self) -> pandas.DataFrame:
        """All rows, sorted by member, with the columns in one order."""
        import pandas

        names = [name for name, _ in fields(self.definition)]
        return pandas.DataFrame.from_records([self.by_member[i] for i in sorted(self.by_member)], columns=names)

    def _keep(self, rows: Sequence[Row]) -> None:
        self.by_member |= {int(row["member"]): row for row in rows}
        self.failed += sum(row["status"] in FAILED for row in rows)

    def _write(self, rows: Sequence[Row], folder: Path) -> None:
        """Under another name first: a part that bears its own is whole, whenever the process ends."""
        import pyarrow
        from pyarrow import parquet

        types = {"integer": pyarrow.int64(), "number": pyarrow.float64(), "text": pyarrow.string(), "truth": pyarrow.bool_()}
        types["numbers"] = pyarrow.list_(pyarrow.float64())
        schema = pyarrow.schema([(name, types[kind]) for name, kind in fields(self.definition)])
        texts = {name for name, kind in fields(self.definition) if kind == "text"}
        plain = [{name: str(value) if name in texts else value for name, value in row.items()} for row in rows]
        table = pyarrow.Table.from_pylist(plain, schema).replace_schema_metadata({FINGERPRINT: self.definition.fingerprint})
        members = [int(row["member"]) for row in rows]
        path = folder / f"part-{min(members):08d}-{max(members):08d}.parquet"
        hidden = folder / f".{path.name}.{os.getpid()}"
        try:
            folder.mkdir(exist_ok=True)
            with hidden.open("wb") as file:
                parquet.write_table(table, file)
                file.flush()
                os.fsync(file.fileno())
            hidden.replace(path)
        except OSError as error:
            hidden.unlink(missing_ok=True)
            kept = f"{len(self.by_member)} rows are kept, and `dampen resume` goes on from them"
            raise ArgumentError(f"Study folder `{folder.parent}` cannot be written: {error.strerror or error}; {kept}.") from None

    def _read(self, path: Path) -> list[Row]:
        from pyarrow import ArrowException, parquet

        try:
            table = parquet.read_table(path)
        except (ArrowException, OSError) as error:
            raise ArgumentError(f"Study part `{path}` cannot be read: {str(error).splitlines()[0]}") from None
        if (table.schema.metadata or {}).get(FINGERPRINT, b"").decode() != self.definition.fingerprint:
            raise ArgumentError(
                f"Study folder `{path.parent.parent}` has rows of another study: study.toml or scenario.toml was changed."
            )
        rows: list[Row] = table.to_pylist()
        return rows


def fields(definition: Definition) -> list[tuple[str, str]]:
    """Name and kind of every column."""
    generation = [("generation", "integer")] if definition.kind == "tune" else []
    axes = [(axis.name, _kind(axis)) for axis in definition.axes]
    found = [(name, "number") for name in columns(definition.scenario)]
    peaks = [(f"peaks.{port}", "numbers") for port in definition.scenario.ports]
    return [("member", "integer"), *generation, *axes, ("status", "text"), ("message", "text"), *found, *peaks]


def as_kept(value: Any) -> Any:
    """What a table can hold of what an axis takes: lists and tables as TOML writes them."""
    return literal(value) if isinstance(value, list | tuple | dict) else value


def _kind(axis: Axis) -> str:
    """What an axis takes; a list of several kinds is kept as text."""
    kinds: set[Any] = {type(value) for value in axis.values} or {int if axis.whole else float}
    if kinds == {int}:
        return "integer"
    return "truth" if kinds == {bool} else "number" if kinds <= {int, float} else "text"
