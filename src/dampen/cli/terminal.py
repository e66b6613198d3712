"""What commands share of the terminal: two consoles, help that lists kinds, tables, and a line while something takes a while."""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console
from typer.core import TyperCommand

COMPLETED, BAD_INPUT, BROKE_OFF = 0, 2, 3


class Terminal(Console):
    """A console that lets `main` see to a reader that has gone."""

    def on_broken_pipe(self) -> None:
        raise BrokenPipeError


out, err = Terminal(soft_wrap=True, highlight=False), Terminal(stderr=True, soft_wrap=True, highlight=False)


class WithListing(TyperCommand):
    """A command whose help ends with every kind and its parameters."""

    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        from dampen.listing import listing

        formatter.write(f"\n{listing()}\n")


class WithOverview(TyperCommand):
    """A command whose help ends with the names of all kinds."""

    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        from dampen.listing import overview

        formatter.write(f"\n{overview()}\n")


ScenarioArgument = Annotated[str, typer.Argument(help="a shipped scenario (see `dampen list`) or the path of a TOML file")]
SetOption = Annotated[
    list[str] | None, typer.Option("--set", metavar="KEY=VALUE", help="change a value, e.g. plant.tip_mass=0.2")
]


HOURS = 24.0
HoursOption = Annotated[float, typer.Option("--hours", help="refuse what is predicted to take longer")]


def complain(lines: list[str]) -> int:
    """One line for every fault."""
    for line in lines:
        err.print(line, markup=False)
    return BAD_INPUT


def free_folder(folder: Path | None, name: str) -> Path:
    """The folder asked for, or the first of runs/NAME, runs/NAME-2, ... that does not exist yet."""
    if folder is not None:
        return folder
    candidates = (Path("runs") / (name if number == 1 else f"{name}-{number}") for number in itertools.count(1))
    return next(path for path in candidates if not path.exists())


@contextmanager
def progress_line(what: str, total: int | None = None, done: int = 0, aside: str = "") -> Iterator[Callable[..., None]]:
    """A progress line; quiet in a pipe. Yields what updates it: `advance`, or `completed`, `total`, `description` and `aside`, a
    word behind the count, where there is one from the beginning."""
    if not err.is_terminal:  # before 15, rich ends even a disabled line with an empty one
        yield lambda **news: None
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    named, count = TextColumn("{task.description}"), (BarColumn(), MofNCompleteColumn())
    columns = (named, *count, *([TextColumn("{task.fields[aside]}")] if aside else []), TimeRemainingColumn())
    with Progress(*columns, console=err, transient=True) as bar:
        task = bar.add_task(what, total=total, completed=done, aside=aside)
        yield lambda **news: bar.update(task, **news)


@contextmanager
def working(what: str) -> Iterator[None]:
    """A line while something takes a while; quiet in a pipe."""
    if err.is_terminal:
        with err.status(f"{what} ..."):
            yield
    else:
        yield


def show_table(
    headings: Sequence[str], rows: Sequence[Sequence[Any]], numbers: Sequence[str] = (), kept: Sequence[str] = ()
) -> None:
    """A table; columns in `numbers` are set to the right, those in `kept` are not broken over lines. In a pipe it is 140 wide,
    or what COLUMNS says."""
    from rich import box
    from rich.table import Table

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    for heading in headings:
        whole = heading in kept
        table.add_column(heading, justify="right" if heading in numbers else "left", overflow="fold", no_wrap=whole)
    for row in rows:
        table.add_row(*row)
    Terminal(highlight=False, width=None if out.is_terminal or "COLUMNS" in os.environ else 140).print(table)
