"""`dampen run`: a scenario with and without control, its claims and its report."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

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
from dampen.component import ArgumentError, listed
from dampen.studies.alone import alone

if TYPE_CHECKING:
    from dampen.analysis.claims import Claim
    from dampen.simulation.bench import Bench
    from dampen.simulation.result import Result
    from dampen.simulation.scenario import Scenario
    from dampen.studies.experiment import Runs
    from dampen.studies.record import Record

HELP = (
    "Run a scenario with and without control; write results, figures and a report.\n\n"
    "Examples:\n\n  dampen run he2017\n\n  dampen run he2017 --set controller.alpha_8=0.5 --set task.trials=50\n\n"
    "  dampen run he2017 --set controller.compensate=false --out direct\n\n"
    "Exit status: 0 when the run completed, whatever the claims say; 2 for bad input; 3 when the run broke off, with what it "
    "has saved."
)


OutOption = Annotated[Path | None, typer.Option("--out", metavar="DIR", help="where to write (default: a new folder in runs/)")]
ReportOption = Annotated[bool, typer.Option("--report/--no-report", help="figures and report.html")]
RUNS = {"": 1.0, "audit": 16.0, "credit": 12.0, "limit": 200.0}  # runs that a review is worth in time: rough, not measured
LEFT = (  # by an earlier run
    "report.html", "audit.json", "continuous.nc", "uncontrolled.nc", "exchanges.parquet", "figures/exchanges.png",
    "figures/exchanges.svg", "result.nc",
)  # fmt: skip
WITHOUT = "The scenario has no [controller]: nothing is controlled."
COMPILING = "Compiling the simulation kernel: once for this combination of pieces, about ten seconds."
Review = Callable[["Bench", "Result"], tuple["Record", bool]]


@dataclass(frozen=True)
class Done:
    """What a command has run and written; whole: nothing of it broke off."""

    folder: Path
    result: Result
    baseline: Result | None
    continuous: Result | None
    frequencies: tuple[float, ...]
    claims: list[Claim]
    record: Record
    page: Path | None
    whole: bool


def run(
    scenario: ScenarioArgument,
    set_: SetOption = None,
    folder: OutOption = None,
    report: ReportOption = True,
    hours: HoursOption = HOURS,
) -> None:
    """`dampen run`."""
    done = perform(scenario, set_, folder, report, hours=hours)
    show_outcome(done)
    finish(done)


def perform(
    scenario: str,
    set_: list[str] | None,
    folder: Path | None,
    report: bool,
    purpose: str = "",
    review: Review | None = None,
    check: Callable[[Scenario], None] = lambda experiment: None,
    hours: float = HOURS,
) -> Done:
    """Run a scenario with and without control, review it, and write everything.

    purpose: what a new folder is called after, beside the scenario.   review: makes the record; without it, the audit that needs
    no further run.   check: raises ArgumentError, before anything is run, for a scenario that cannot be reviewed so.   hours:
    what is predicted to take longer is refused.
    """
    import scipy.linalg  # noqa: F401  (loaded first, so that the limit below reaches its BLAS too)
    from threadpoolctl import threadpool_limits

    from dampen.scenarios.claims import check_claims
    from dampen.scenarios.read import build, folder_of, override, table_of
    from dampen.simulation.bench import Bench
    from dampen.simulation.cost import check_time
    from dampen.simulation.memory import begun
    from dampen.simulation.setting import setting_of
    from dampen.studies.experiment import beside, own_review
    from dampen.studies.record import write_record

    table = override(table_of(scenario), set_ or ())
    experiment = build(table, folder_of(scenario))
    check(experiment)
    check_time(experiment, RUNS[purpose] + len(beside(experiment)), hours)
    with ExitStack() as kept, threadpool_limits(1):
        bench = Bench(experiment)  # refuses what cannot be resolved, before anything is written
        begun(experiment, setting_of(experiment, bench=bench))  # as this does what its law cannot begin with
        folder = kept.enter_context(output_folder(folder, f"{experiment.name}-{purpose}" if purpose else experiment.name))
        runs = run_shown(bench, folder)
        for line in [*([] if "controller" in table else [WITHOUT]), *runs.result.warnings]:
            err.print(f"Note: {line}", markup=False)
        if review is None or runs.interrupted:  # after Ctrl-C nothing more is run
            record, whole = own_review(bench, runs.result), True
        else:
            record, whole = review(bench, runs.result)
        write_record(folder, record)
        page = None
        if report and runs.result.trials:
            from dampen.report.write import report_of

            with working("Drawing figures"):
                page = report_of(runs, folder, record)
    whole &= not (runs.result.broke_off or (runs.baseline is not None and runs.baseline.broke_off))
    claims, frequencies = check_claims(runs.result, runs.baseline), tuple(bench.modes.omega / math.tau)
    return Done(folder, runs.result, runs.baseline, runs.continuous, frequencies, claims, record, page, whole)


def finish(done: Done) -> None:
    """Where everything is, and the exit status of a run that broke off."""
    out.print(f"Report: {done.page}" if done.page else f"Results: {done.folder / 'result.nc'}", markup=False)
    if not done.whole:
        raise typer.Exit(BROKE_OFF)


@contextmanager
def output_folder(folder: Path | None, name: str) -> Iterator[Path]:
    """The output folder, made ready and kept from other processes meanwhile: what an earlier run has left there goes. Nothing
    is left of a run that fails before it has a result."""
    folder = free_folder(folder, name)
    mark, result, other = folder / "scenario.toml", folder / "result.nc", f"Output folder `{folder}` must be another one"
    with ExitStack() as held:
        try:
            begun = mark.exists() and mark.stat().st_size == 0
            earlier = mark.exists() and result.exists()
            foreign = [part for part in (mark.name, *LEFT, "figures") if (folder / part).exists()]
            if foreign and not (begun or earlier):
                raise ArgumentError(f"{other}: it holds {listed(foreign)}, and no run that could be replaced.")
            folder.mkdir(parents=True, exist_ok=True)
            held.enter_context(alone(mark, f"{other}: another process is writing there."))
            if earlier:
                err.print(f"Note: the earlier run in `{folder}` is replaced.", markup=False)
            mark.write_text("", encoding="utf-8")
            for old in LEFT:
                (folder / old).unlink(missing_ok=True)
        except (OSError, ValueError) as error:
            if isinstance(error, ArgumentError):
                raise
            reason = getattr(error, "strerror", None) or error
            raise ArgumentError(f"Output folder `{folder}` cannot be written: {reason}.") from None
        try:
            yield folder
        finally:
            if not result.exists():
                for part in (mark.name, *LEFT):
                    (folder / part).unlink(missing_ok=True)
                with suppress(OSError):  # others' files are in it
                    folder.rmdir()


def run_shown(bench: Bench, folder: Path) -> Runs:
    """All runs of an experiment, with their progress shown."""
    from dampen.studies.experiment import beside, run_all

    compile_ahead(bench.scenario, bench)
    with progress_line("Trials", bench.scenario.task.trials * (1 + len(beside(bench.scenario)))) as update:
        return run_all(bench, folder, lambda: update(advance=1))


def compile_ahead(scenario: Scenario, bench: Bench) -> None:
    """Say so before the wait: the first run of a combination of pieces on a machine compiles the kernel."""
    from dampen.simulation.compose import is_ready

    kernel, _ = bench.kernel(scenario)
    if not is_ready(kernel):
        err.print(COMPILING)


def show_outcome(done: Done) -> None:
    """The claims with their verdict, or what became of the ports; one sentence of the audit; what sampling costs."""
    from rich.text import Text

    from dampen.analysis.claims import verdict_sentence
    from dampen.report.motion import in_words
    from dampen.report.review.words import sentence
    from dampen.scenarios.claims import legend, note

    result = done.result
    if result.broke_off:
        err.print(
            f"The run broke off ({result.status}) after {result.trials} of {result.scenario.task.trials} trials.", markup=False
        )
    if done.claims:
        colours = {"PASS": "green", "FAIL": "bold red", "n/a": "dim"}
        rows = [(c.id, c.statement, c.measured, Text(c.verdict, colours[c.verdict])) for c in done.claims]
        show_table(("", "Claim", "Measured", "Verdict"), rows)
        out.print(legend(result), style="dim", markup=False)
        out.print(verdict_sentence(done.claims), markup=False)
    elif result.trials:
        for line in in_words(result, done.baseline, done.frequencies):
            out.print(line, markup=False)
    if done.record.audit is not None:
        out.print(sentence(done.record.audit), markup=False)
    if note(result):
        out.print(note(result), style="dim", markup=False)
    if done.continuous is not None:
        show_costs(result, done.continuous)


def show_costs(result: Result, continuous: Result) -> None:
    """What sampling costs, as a small table."""
    from dampen.analysis.sampling_cost import sampling_cost
    from dampen.report.facts import cost_row

    headings = ("What sampling costs", "at", "continuous", "sampled", "ratio")
    show_table(headings, [cost_row(cost) for cost in sampling_cost(result, continuous)], headings[2:])
