"""`dampen sweep`, `robust`, `tune`, `resume` and `plot`: studies of many runs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Annotated, Any

import typer

from dampen.cli.terminal import (
    BROKE_OFF,
    HOURS,
    HoursOption,
    ScenarioArgument,
    SetOption,
    err,
    free_folder,
    out,
    progress_line,
    show_table,
    working,
)
from dampen.component import ArgumentError

if TYPE_CHECKING:
    from dampen.studies.definition import Definition
    from dampen.studies.study import Study

PATHS = (
    "A PATH names a value as --set does: controller.alpha_4, plant.tip_mass, actuator.all.chain.0.right, task.constraint.tip_w. "
    "Several with a comma between them take the same value or, with +-30%, the same factor."
)
STATUS = "Exit status: 0 when the study is complete; 2 for bad input; 3 when it was interrupted: `dampen resume` goes on with it."
SWEEP_HELP = (
    "Run a scenario over a grid; write a table, figures and a report.\n\nExamples:\n\n"
    "  dampen sweep he2017 --vary controller.alpha_4=0.1:10:log:20 --vary controller.alpha_7=0.1:10:log:20\n\n"
    f"  dampen sweep he2017 --vary controller.barrier=log,tan --vary plant.tip_mass=0.05:0.2:4\n\n{PATHS}\n\n{STATUS}"
)
ROBUST_HELP = (
    "Run a scenario over what is uncertain: how likely is the constraint lost, what are the figures of merit, and which "
    "parameter matters (Sobol indices).\n\nExample:\n\n  dampen robust he2017-tuned "
    "--uncertain plant.tip_mass,plant.tip_inertia=+-30% "
    "--uncertain actuator.all.chain.0.right,actuator.all.chain.0.left=+-50% --samples 10000\n\n"
    f"A range is +-30%, 0.1+-30%, 0.1+-0.02 (any with :normal), LOW:HIGH or LOW:HIGH:log. {PATHS}\n\n{STATUS}"
)
TUNE_HELP = (
    "Search for better gains: by CMA-ES for one objective, by NSGA-II for several; the task's constraint is kept. The best are "
    "written as scenario files.\n\nExamples:\n\n"
    "  dampen tune he2017 --search controller.alpha_4=0.01:100:log --search controller.alpha_7=0.01:100:log --budget 500\n\n"
    "  dampen tune he2017 --search controller.alpha_4=0.01:100:log --objective residual --objective effort\n\n"
    "  dampen tune he2017 --search controller.alpha_4=0.01:100:log --robust-over plant.tip_mass=+-30%\n\n"
    "Objectives are figures of merit: peak, residual, effort, chatter, energy, margin, or one of a port, such as "
    f"peak.tip_w. {PATHS}\n\n{STATUS}"
)
RESUME_HELP = f"Go on with a study that was interrupted or killed: no finished row is computed again.\n\n{STATUS}"
PLOT_HELP = "Draw the figures and the report of a study or a comparison again, from what it has."

OutOption = Annotated[Path | None, typer.Option("--out", metavar="DIR", help="study folder (default: a new one in runs/)")]
WorkersOption = Annotated[int | None, typer.Option("--workers", min=1, help="processes (default: one for each core)")]
SchedulerOption = Annotated[
    str | None, typer.Option("--scheduler", metavar="ADDRESS", help="run on a dask.distributed cluster, e.g. tcp://host:8786")
]
SeedOption = Annotated[int, typer.Option("--seed", min=0, help="seed of samples and search")]
FolderArgument = Annotated[Path, typer.Argument(metavar="DIR", help="a study folder")]
ReportOption = Annotated[bool, typer.Option("--report/--no-report", help="figures and report.html")]


def sweep(
    scenario: ScenarioArgument,
    vary: Annotated[list[str] | None, typer.Option("--vary", metavar="PATH=RANGE", help="an axis of the grid")] = None,
    set_: SetOption = None,
    folder: OutOption = None,
    workers: WorkersOption = None,
    scheduler: SchedulerOption = None,
    report: ReportOption = True,
    hours: HoursOption = HOURS,
) -> None:
    """`dampen sweep`."""
    from dampen.studies.definition import sweep_of

    case, home = _scenario(scenario, set_)
    _start(sweep_of(case, vary or (), home), folder, workers, scheduler, report, hours)


def robust(
    scenario: ScenarioArgument,
    uncertain: Annotated[list[str] | None, typer.Option("--uncertain", metavar="PATH=RANGE", help="what is uncertain")] = None,
    samples: Annotated[int, typer.Option("--samples", help="runs, at least")] = 1000,
    sampler: Annotated[str, typer.Option("--sampler", help="sobol or latin (hypercube)")] = "sobol",
    seed: SeedOption = 0,
    set_: SetOption = None,
    folder: OutOption = None,
    workers: WorkersOption = None,
    scheduler: SchedulerOption = None,
    report: ReportOption = True,
    hours: HoursOption = HOURS,
) -> None:
    """`dampen robust`."""
    from dampen.studies.definition import robust_of

    case, home = _scenario(scenario, set_)
    _start(robust_of(case, uncertain or (), samples, sampler, seed, home), folder, workers, scheduler, report, hours)


def tune(
    scenario: ScenarioArgument,
    search: Annotated[list[str] | None, typer.Option("--search", metavar="PATH=RANGE", help="what is searched")] = None,
    objective: Annotated[list[str] | None, typer.Option("--objective", help="what is made small (default: peak)")] = None,
    budget: Annotated[int, typer.Option("--budget", help="candidates at most")] = 2000,
    population: Annotated[int | None, typer.Option("--population", help="candidates in a generation")] = None,
    robust_over: Annotated[
        list[str] | None, typer.Option("--robust-over", metavar="PATH=RANGE", help="what each candidate has to hold over")
    ] = None,
    robust_samples: Annotated[int, typer.Option("--robust-samples", help="samples of it; the worst counts")] = 16,
    seed: SeedOption = 0,
    set_: SetOption = None,
    folder: OutOption = None,
    workers: WorkersOption = None,
    scheduler: SchedulerOption = None,
    report: ReportOption = True,
    hours: HoursOption = HOURS,
) -> None:
    """`dampen tune`."""
    from dampen.studies.definition import tune_of
    from dampen.studies.search import clipped

    case, home = _scenario(scenario, set_)
    definition = tune_of(
        case, search or (), objective or ("peak",), budget, population, seed, robust_over or (), robust_samples, home
    )
    for line in clipped(definition):
        err.print(f"Note: {line}.", markup=False)
    _start(definition, folder, workers, scheduler, report, hours)


def resume(
    folder: FolderArgument, workers: WorkersOption = None, scheduler: SchedulerOption = None, report: ReportOption = True
) -> None:
    """`dampen resume`."""
    from dampen.studies.study import open_study

    _go_on(open_study(folder), workers, scheduler, report)


def plot(folder: FolderArgument) -> None:
    """`dampen plot`."""
    from dampen.studies.compare.api import DEFINITION
    from dampen.studies.study import open_study

    if (folder / DEFINITION).exists():
        from dampen.report.compare.page import write_comparison
        from dampen.studies.compare.api import open_comparison

        out.print(f"Report: {write_comparison(folder, open_comparison(folder))}", markup=False)
        return
    _report(open_study(folder))


def _scenario(source: str, settings: list[str] | None) -> tuple[Any, Path]:
    from dampen.scenarios.read import folder_of, read_scenario

    return read_scenario(source, settings or ()), folder_of(source).resolve()


def _start(
    definition: Definition, folder: Path | None, workers: int | None, scheduler: str | None, report: bool, hours: float
) -> None:
    from dampen.simulation.bench import Bench
    from dampen.simulation.cores import cores
    from dampen.simulation.cost import check_time
    from dampen.studies.study import new_study

    if scheduler is None:  # how many work on a cluster is not known here
        runs = definition.members * max(1, definition.robust_samples)
        check_time(definition.scenario, runs / (workers or cores()), hours)
    Bench(definition.scenario)  # refuses what cannot be resolved, before anything is written
    name = f"{definition.scenario.name}-{definition.kind}"
    study = new_study(definition, free_folder(folder, name))
    try:
        _go_on(study, workers, scheduler, report)
    except ArgumentError:
        study.discard()  # a folder without a row is of no use
        raise


def _go_on(study: Study, workers: int | None, scheduler: str | None, report: bool) -> None:
    from dampen.studies.best import NEAREST, outcome, write_best
    from dampen.studies.engines import Cluster, Cores

    with study_bar(study) as progress:
        study.run(Cluster(scheduler) if scheduler else Cores(workers) if workers else None, progress)
    written = write_best(study)
    if report:
        _report(study)
    for path in written:
        out.print(f"{'Nearest' if path.name == NEAREST else 'Best'}: {path}", markup=False)
    if not report:
        out.print(f"Study: {study.folder}", markup=False)
        if told := outcome(study):
            out.print(told, markup=False)
    if not study.complete:
        err.print(f"{study.done} of {study.members} rows are done: `dampen resume {study.folder}` goes on.", markup=False)
        raise typer.Exit(BROKE_OFF)


def _report(study: Study) -> None:
    from dampen.report.study.page import summary_rows, verdict_of, write_study_report
    from dampen.studies.best import nominal_merits

    assert study.folder is not None, "a study of the command line has a folder"
    with working("Drawing figures"):
        nominal = nominal_merits(study) if study.definition.kind == "robust" else None
        page = write_study_report(study.folder, study, nominal)
    headings, rows = summary_rows(study)
    show_table(headings, rows, headings[1:])
    out.print(verdict_of(study), markup=False)
    out.print(f"Report: {page}", markup=False)


@contextmanager
def study_bar(study: Study) -> Iterator[Callable[[int, int, int], None]]:
    """A progress line with rate, time left and failures; quiet in a pipe."""
    with progress_line("Runs", study.members, study.done, aside=" ") as update:
        begun, before = monotonic(), study.done

        def show(done: int, total: int, failed: int) -> None:
            rate = (done - before) / max(monotonic() - begun, 1e-3)
            update(completed=done, aside=f"{rate:.3g}/s" + (f", {failed} failed" if failed else ""))

        yield show
