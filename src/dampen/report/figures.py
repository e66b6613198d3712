"""Draw the figures of a plan into files."""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from io import BytesIO
from pathlib import Path
from typing import Any, Generic, TypeVar

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from dampen.report.joined import uncontrolled
from dampen.report.plan import COMMANDED
from dampen.report.style import DPI, RC
from dampen.report.views.delivered import draw_delivered
from dampen.report.views.energy import draw_energy
from dampen.report.views.error import draw_error
from dampen.report.views.field import draw_field
from dampen.report.views.loop import draw_loop
from dampen.report.views.peaks import draw_peaks
from dampen.report.views.port import draw_port
from dampen.report.views.samples import draw_samples
from dampen.report.views.tracking import draw_tracking
from dampen.scenarios.figures import FigurePlan
from dampen.simulation.result import Result

View = Callable[[str, Result, Result | None], tuple[Figure, str]]
Draw = Callable[[], tuple[Figure, str]]
Progress = Callable[[int, int], None]
VIEWS: dict[str, View] = {
    "field": draw_field,
    "port": draw_port,
    "peaks": draw_peaks,
    "delivered": draw_delivered,
    "energy": draw_energy,
    "error": draw_error,
    "tracking": draw_tracking,
    "loop": draw_loop,
    "samples": draw_samples,
}
FORMATS = ("png", "svg")
AnyJob = TypeVar("AnyJob")


@dataclass(frozen=True)
class Job:
    """One figure to draw: the view `view` of the port or field `of` in `run`, with the `other` run beside it if there is one."""

    name: str
    caption: str
    view: str
    of: str
    run: Result
    other: Result | None


@dataclass(frozen=True)
class Drawn(Generic[AnyJob]):
    """A figure as drawn: the job, what it shows in this run, its size [in], and its files by format."""

    job: AnyJob
    sentence: str
    size: tuple[float, float]
    files: dict[str, Path]


def draw(
    plan: Sequence[FigurePlan], result: Result, baseline: Result | None, folder: Path, formats: Sequence[str] = FORMATS
) -> list[Drawn[Job]]:
    """Draw and save the figures of a plan; one that needs a run that is not at hand is left out."""
    return draw_jobs(jobs_of(plan, result, baseline), folder, formats)


def jobs_of(plan: Sequence[FigurePlan], result: Result, baseline: Result | None) -> list[Job]:
    """Which run each figure of the plan shows, and which one beside it.

    Where the result itself is without control, it is the run without control, and figures of a controlled run are left out.
    """
    free = uncontrolled(result)
    if free:
        twins = {(figure.view, figure.of) for figure in plan if not figure.controlled}
        plan = [f for f in plan if not f.controlled or ((f.view, f.of) not in twins and f.view not in COMMANDED)]
    jobs = []
    for figure in plan:
        run, other = (result, baseline) if figure.controlled or (free and baseline is None) else (baseline, result)
        other = other if other is not run and other is not None and other.trials else None
        if run is not None and run.trials:
            jobs.append(Job(figure.name, figure.caption, figure.view, figure.of, run, other))
    return jobs


def draw_jobs(
    jobs: Sequence[Job], folder: Path, formats: Sequence[str] = FORMATS, progress: Progress | None = None
) -> list[Drawn[Job]]:
    """Draw and save the figures of a run."""
    saved = save_all(
        [(job.name, partial(VIEWS[job.view], job.of, job.run, job.other)) for job in jobs], folder, formats, progress
    )
    return [Drawn(job, *of_it) for job, of_it in zip(jobs, saved, strict=True)]


def save_all(
    named: Sequence[tuple[str, Draw]], folder: Path, formats: Sequence[str] = FORMATS, progress: Progress | None = None
) -> list[tuple[str, tuple[float, float], dict[str, Path]]]:
    """Draw and save figure after figure; a second thread compresses the pixels of one while the next is drawn.

    Returns what each shows, its size [in], and its files by format.
    """
    folder.mkdir(parents=True, exist_ok=True)
    saved, waiting = [], []
    with matplotlib.rc_context(RC), ThreadPoolExecutor(1) as pool:
        for (_, draw_it), name in zip(named, file_names(name for name, _ in named), strict=True):
            figure, sentence = draw_it()
            width, height = map(float, figure.get_size_inches())
            files = {kind: folder / f"{name}.{kind}" for kind in formats}
            waiting += [save(figure, path, pool) for path in files.values()]
            saved.append((sentence, (width, height), files))
            if progress:
                progress(len(saved), len(named))
        for future in waiting:
            future.result()
    return saved


def save(figure: Figure, path: Path, pool: Executor) -> Future[Any]:
    """Write a figure: pixels are rendered here and compressed in the pool, everything else is written by matplotlib."""
    if path.suffix == ".png":
        figure.set_dpi(DPI)
        canvas: Any = FigureCanvasAgg(figure)
        canvas.draw()
        return pool.submit(write_png, np.asarray(canvas.buffer_rgba()), path)
    buffer = BytesIO()
    figure.savefig(buffer, format=path.suffix[1:], dpi=DPI, metadata={"Date": None, "Creator": None})
    return pool.submit(path.write_bytes, buffer.getvalue())


def write_png(pixels: np.ndarray, path: Path) -> None:
    """Compress and write; figures are opaque, so three channels do."""
    Image.fromarray(pixels).convert("RGB").save(path, compress_level=1, dpi=(DPI, DPI))


def file_names(names: Iterable[str]) -> list[str]:
    """The figures' names as different names of files: a user's port may be called anything."""
    taken: list[str] = []
    for name in names:
        plain = re.sub(r"[^\w.-]+", "_", name)
        taken.append(next(n for k in itertools.count(1) if (n := plain if k == 1 else f"{plain}-{k}") not in taken))
    return taken
