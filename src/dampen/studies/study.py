"""A study: what it is, and the rows that it has so far, in memory or in a folder that outlives every interruption."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dampen.arguments import PATH, takes
from dampen.component import ArgumentError
from dampen.release import version
from dampen.scenarios.read import build, parse
from dampen.simulation.bench import Bench
from dampen.simulation.interrupt import interrupt_noted
from dampen.studies.alone import alone
from dampen.studies.definition import Definition, read_definition
from dampen.studies.engines import Cores, Engine, Here
from dampen.studies.evaluate import Work
from dampen.studies.handing_out import hand_out
from dampen.studies.search import Search
from dampen.studies.table import Table
from dampen.toml import to_toml

if TYPE_CHECKING:
    import pandas
    import xarray

    from dampen.simulation.scenario import Scenario

Progress = Callable[[int, int, int], None]


class Study:
    """Many runs of one scenario. `study.table` is a pandas DataFrame with a row a member, `study.dataset` an xarray Dataset.

    A study with a folder is written as it goes: study.toml and scenario.toml say what it is, rows/ holds what is done.
    """

    def __init__(self, definition: Definition, folder: Path | None = None):
        self.definition, self.folder = definition, folder
        self.rows = Table(definition, None if folder is None else folder / "rows")
        self.version = version()

    @property
    def members(self) -> int:
        """How many rows there are in the end."""
        return self.definition.members

    @property
    def done(self) -> int:
        """How many there are."""
        return len(self.rows.by_member)

    @property
    def complete(self) -> bool:
        return self.done >= self.members

    @property
    def table(self) -> pandas.DataFrame:
        """All rows, sorted by member."""
        return self.rows.frame()

    @property
    def dataset(self) -> xarray.Dataset:
        """The numbers of the table as an xarray Dataset: along `member`, or, of a finished grid, along its axes."""
        from dampen.studies.dataset import dataset_of

        return dataset_of(self.definition, self.table)

    def run(self, engine: Engine | None = None, progress: Progress | None = None) -> Study:
        """Run what is missing. progress: called with (rows done, rows in all, rows that failed) after each piece of work.

        A first Ctrl-C lets what is under way finish and ends the run; the study then is not `complete`, and a further `run`
        goes on with it. Raises ArgumentError where rows cannot be written.
        """
        Bench(self.definition.scenario)  # refuses what cannot be resolved
        source = self._source()
        chosen = engine or (Cores() if isinstance(source, tuple) else Here())
        if not isinstance(source, tuple) and not isinstance(chosen, Here):
            raise ArgumentError(
                "Argument `scenario` has classes or functions that no other process can make: use the engine `Here`."
            )
        with running_alone(self.folder), interrupt_noted() as stopped, chosen as ready:
            for members, values, more in self._rounds():
                table = dict(zip(members, values, strict=True))
                for rows in hand_out(self.rows.missing(members), lambda piece: self._work(source, piece, table), ready, stopped):  # noqa: B023
                    self.rows.add([{**row, **more} for row in rows])
                    if progress:
                        progress(self.done, self.members, self.rows.failed)
                if stopped():
                    break
        return self

    def discard(self) -> None:
        """Take the study's folder away again, if no row was ever written."""
        if self.folder is not None and not self.done:
            for name in ("study.toml", "scenario.toml", "rows/.lock"):
                (self.folder / name).unlink(missing_ok=True)
            for folder in (self.folder / "rows", self.folder):
                if folder.exists() and not any(folder.iterdir()):
                    folder.rmdir()

    def _rounds(self) -> Any:
        """Members, what their axes take, and what else stands in their rows: all at once, or generation by generation."""
        if self.definition.kind != "tune":
            order = self._order()
            yield order, [self.definition.design[i] for i in order], {}
            return
        search = Search(self.definition)
        for number, members in enumerate(self.definition.generations()):
            values = search.ask(number, len(members))
            yield members, values, {"generation": number}
            search.tell([self.rows.by_member[i] for i in members])

    def _order(self) -> list[int]:
        """All members; of a Saltelli design base row by base row, so that indices can be had before the end."""
        base = self.definition.base or self.members
        return sorted(range(self.members), key=lambda i: i % base)

    def _work(self, source: tuple[str, str] | Scenario, piece: Sequence[int], values: dict[int, Any]) -> Work:
        definition = self.definition
        taken = tuple(values[i] for i in piece)
        return Work(source, definition.axes, tuple(piece), taken, definition.robust_axes, tuple(definition.robust_design))

    def _source(self) -> tuple[str, str] | Scenario:
        """The scenario as text that any process can make it from; itself where it cannot be made from text."""
        scenario, home = self.definition.scenario, self.definition.home
        try:
            text = to_toml(scenario)
            if "__main__:" not in text and build(parse(text, "scenario"), home) == scenario:
                return text, str(home.resolve())
        except ArgumentError:
            pass
        return scenario


@contextmanager
def running_alone(folder: Path | None) -> Iterator[None]:
    """Keep other processes from running the study of a folder."""
    if folder is not None:
        (folder / "rows").mkdir(exist_ok=True)
    with alone(folder and folder / "rows" / ".lock", f"Study folder `{folder}` is being run by another process."):
        yield


def new_study(definition: Definition, folder: Path | None = None) -> Study:
    """A study that has no rows yet. Raises ArgumentError for a folder that has anything in it."""
    if folder is not None:
        if (folder / "study.toml").exists():
            there = open_study(folder)
            if there.definition.fingerprint != definition.fingerprint:
                raise ArgumentError(f"Study folder `{folder}` must be another one: it holds a study of something else.")
            raise ArgumentError(
                f"Study folder `{folder}` holds this study already, {there.done} of {there.members} rows: "
                f"`dampen resume {folder}` goes on with it."
            )
        try:
            folder.mkdir(parents=True, exist_ok=True)
            if any(folder.iterdir()):
                raise ArgumentError(f"Study folder `{folder}` must be empty or new, but has files in it.")
            (folder / "rows").mkdir()
            (folder / "scenario.toml").write_text(to_toml(definition.scenario), encoding="utf-8")
            (folder / "study.toml").write_text(definition.to_toml(), encoding="utf-8")
        except OSError as error:
            raise ArgumentError(f"Study folder `{folder}` cannot be written: {error.strerror or error}.") from None
    return Study(definition, folder)


@takes(folder=PATH)
def open_study(folder: str | Path) -> Study:
    """The study that a folder holds, with all rows that are done. Raises ArgumentError for any other folder."""
    folder = Path(folder)
    return Study(read_definition(folder), folder)
