"""What commands share of the terminal: two consoles, help that lists kinds, tables, and a line while something takes a while."""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any, Literal

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


COLUMN_EDGE = 3  # letters between two columns of a table
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
    """A table; columns in `numbers` are set to the right, those in `kept` are not broken over lines, others between words alone.
    Columns that do not fit beside one another come below, behind the first column again. In a pipe the width is 140, or what
    COLUMNS says."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    console = Terminal(highlight=False, width=None if out.is_terminal or "COLUMNS" in os.environ else 140)
    columns = list(zip(headings, *rows, strict=True))
    least = [
        max(len(part) for cell in column for part in ([str(cell)] if column[0] in kept else str(cell).split()) or [""])
        for column in columns
    ]
    natural = [max(len(str(cell)) for cell in column) for column in columns]
    for shown in side_by_side(least, console.width):
        widths = shrunk([natural[i] for i in shown], [least[i] for i in shown], console.width - COLUMN_EDGE * len(shown))
        table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
        for i, width in zip(shown, widths, strict=True):
            side: Literal["left", "right"] = "right" if headings[i] in numbers else "left"
            table.add_column(Text(headings[i]), justify=side, overflow="fold", width=width)
        for row in rows:
            cells = [row[i] for i in shown]
            table.add_row(*(Text(cell) if isinstance(cell, str) else cell for cell in cells))  # brackets in text are no markup
        console.print(table)


def shrunk(natural: Sequence[int], least: Sequence[int], room: int) -> list[int | None]:
    """Widths of columns that fill no more than `room`: the widest give way first, none below its least; None where even that
    is too much."""
    if sum(least) > room:
        return [None] * len(least)
    widths = list(natural)
    while sum(widths) > room:
        widths[max((i for i in range(len(widths)) if widths[i] > least[i]), key=lambda i: widths[i])] -= 1
    return list(widths)


def side_by_side(least: Sequence[int], width: int) -> list[list[int]]:
    """Which columns stand beside one another, for what each needs at least; the first one begins every part."""
    parts: list[list[int]] = [[0]]
    for i in range(1, len(least)):
        if len(parts[-1]) > 1 and sum(least[k] + COLUMN_EDGE for k in (*parts[-1], i)) > width:
            parts.append([0])
        parts[-1].append(i)
    return parts
