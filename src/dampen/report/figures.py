"""Draw the figures of a plan into files."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from dampen.report.joined import uncontrolled
from dampen.report.style import DPI, RC
from dampen.report.views.delivered import draw_delivered
from dampen.report.views.energy import draw_energy
from dampen.report.views.field import draw_field
from dampen.report.views.peaks import draw_peaks
from dampen.report.views.port import draw_port
from dampen.scenarios.figures import FigurePlan
from dampen.simulation.result import Result

View = Callable[[str, Result, Result | None], tuple[Figure, str]]
Progress = Callable[[int, int], None]
VIEWS: dict[str, View] = {
    "field": draw_field,
    "port": draw_port,
    "peaks": draw_peaks,
    "delivered": draw_delivered,
    "energy": draw_energy,
}
FORMATS = ("png", "svg")


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
class Drawn:
    """A figure as drawn: the job, what it shows in this run, its size [in], and its files by format."""

    job: Job
    sentence: str
    size: tuple[float, float]
    files: dict[str, Path]


def default_plan(result: Result) -> tuple[FigurePlan, ...]:
    """The figures of a scenario that has no plan of its own: every field, every port, peaks, delivered forces."""
    ports = [port.name for port in result.scenario.plant.ports]
    fields = [name for name, _ in result.scenario.plant.fields]
    plan = [FigurePlan(f"field_{name}", "field", name, f"{name}(x, t) over all trials") for name in fields]
    plan += [FigurePlan(f"port_{name}", "port", name, f"Motion at {name}") for name in ports]
    plan += [FigurePlan(f"peaks_{name}", "peaks", name, f"Largest |{name}| of each trial") for name in fields]
    if not uncontrolled(result):
        plan += [FigurePlan(f"delivered_{name}", "delivered", name, f"What the actuator delivers at {name}") for name in ports]
    return tuple(plan)


def draw(
    plan: Sequence[FigurePlan], result: Result, baseline: Result | None, folder: Path, formats: Sequence[str] = FORMATS
) -> list[Drawn]:
    """Draw and save the figures of a plan; one that needs a run that is not at hand is left out."""
    return draw_jobs(jobs_of(plan, result, baseline), folder, formats)


def jobs_of(plan: Sequence[FigurePlan], result: Result, baseline: Result | None) -> list[Job]:
    """Which run each figure of the plan shows, and which one beside it.

    Where the result itself is without control, it is the run without control, and figures of a controlled run are left out.
    """
    free = uncontrolled(result)
    if free:
        twins = {(figure.view, figure.of) for figure in plan if not figure.controlled}
        plan = [f for f in plan if not f.controlled or ((f.view, f.of) not in twins and f.view != "delivered")]
    jobs = []
    for figure in plan:
        run, other = (result, baseline) if figure.controlled or (free and baseline is None) else (baseline, result)
        other = other if other is not run and other is not None and other.trials else None
        if run is not None and run.trials:
            jobs.append(Job(figure.name, figure.caption, figure.view, figure.of, run, other))
    return jobs


def draw_jobs(
    jobs: Sequence[Job], folder: Path, formats: Sequence[str] = FORMATS, progress: Progress | None = None
) -> list[Drawn]:
    """Draw and save figure after figure; a second thread compresses the pixels of one while the next is drawn."""
    folder.mkdir(parents=True, exist_ok=True)
    drawn, waiting = [], []
    with matplotlib.rc_context(RC), ThreadPoolExecutor(1) as pool:
        for job in jobs:
            figure, sentence = VIEWS[job.view](job.of, job.run, job.other)
            width, height = map(float, figure.get_size_inches())
            files = {kind: folder / f"{job.name}.{kind}" for kind in formats}
            waiting += [save(figure, path, pool) for path in files.values()]
            drawn.append(Drawn(job, sentence, (width, height), files))
            if progress:
                progress(len(drawn), len(jobs))
        for future in waiting:
            future.result()
    return drawn


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
