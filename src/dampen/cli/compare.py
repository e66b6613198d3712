"""`dampen compare`: one experiment under several controllers."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from dampen.cli.studies import OutOption, ReportOption, SeedOption, WorkersOption
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

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dampen.simulation.scenario import Scenario
    from dampen.studies.compare.comparison import Comparison

HELP = (
    "Run one experiment under several controllers, each with gains tuned on the same budget; write a table, figures, every run "
    "and a report. The verdict says whom the experiment's own law loses to, whichever of the searches is taken."
    "\n\nExamples:\n\n  dampen compare he2017\n\n"
    "  dampen compare he2017 boundary-damping lqg he2017-tuned --budget 500 --objective peak\n\n"
    "  dampen compare he2017 he2017 --as-given he2017    # the law as published, beside the law tuned\n\n"
    'WITH is a kind of controller (see `dampen list controller`; "module:Class" for your own), whose gains are searched from the '
    "middle of the ranges that it says, or another scenario of the same experiment, of which the controller is taken, and its "
    "sampling; what `--set` changes of the experiment is changed for it too. Left out: all shipped kinds that can be run here."
    "\n\nExit status: 0 when all contenders are there; 2 for bad input; 3 when it was interrupted: the same command with the "
    "same --out goes on with it."
)


def compare(
    scenario: ScenarioArgument,
    with_: Annotated[list[str] | None, typer.Argument(metavar="[WITH]...", help="kinds of controllers, or scenarios")] = None,
    budget: Annotated[int, typer.Option("--budget", min=0, help="candidates for each controller; 0: as given")] = 300,
    searches: Annotated[
        int, typer.Option("--searches", min=1, help="searches for each, with seeds one after the other; the best counts")
    ] = 2,
    objective: Annotated[str, typer.Option("--objective", help="what is made small: any figure of merit")] = "residual",
    as_given: Annotated[list[str] | None, typer.Option("--as-given", metavar="NAME", help="do not tune this contender")] = None,
    seed: SeedOption = 0,
    set_: SetOption = None,
    folder: OutOption = None,
    workers: WorkersOption = None,
    report: ReportOption = True,
    hours: HoursOption = HOURS,
) -> None:
    """`dampen compare`."""
    from dampen.scenarios.read import read_scenario
    from dampen.simulation.cores import cores
    from dampen.simulation.cost import check_time
    from dampen.studies.compare.api import Plan
    from dampen.studies.engines import Cores

    case = read_scenario(scenario, set_ or ())
    try:
        with working("Trying the contenders"):
            contenders = [contender(name, set_ or ()) for name in with_ or ()]
            plan = Plan(case, contenders or None, budget, objective, seed, as_given or (), searches)
    except KeyboardInterrupt:
        err.print("Interrupted: nothing is written.", markup=False)
        raise typer.Exit(BROKE_OFF) from None
    check_time(case, plan.runs / (workers or cores()), hours)
    for name, why in plan.left_out.items():
        err.print(f"Left out: {name}: {why}", markup=False)
    folder = free_folder(folder, f"{case.name}-compare")
    with progress_line("Runs", plan.runs) as update:

        def progress(label: str, done: int, runs: int) -> None:
            update(description=label, completed=done)

        found = plan.run(folder, Cores(workers) if workers else None, progress)
    show(found, folder, report)
    if not found.complete:
        err.print(
            f"Interrupted: {len(found.contenders)} of {len(plan.entries)} contenders are done; the same command with "
            f"`--out {folder}` goes on.", markup=False,
        )  # fmt: skip
        raise typer.Exit(BROKE_OFF)


def contender(name: str, settings: Sequence[str]) -> str | Scenario:
    """A contender; one named by its scenario is set as the experiment is, but for what is its own: controller and sampling."""
    from dampen.scenarios.read import read_scenario, shipped

    if name not in shipped() and not name.endswith(".toml"):
        return name
    return read_scenario(name, [s for s in settings if not s.strip().startswith(("controller.", "sampling."))])


def show(found: Comparison, folder: Path, report: bool) -> None:
    """The table, the verdict, and where everything is."""
    from dampen.report.compare.tables import about, terminal_tables

    if not found.contenders:
        return
    for headings, rows in terminal_tables(found):
        show_table(headings, rows, [head for head in headings if head not in ("Contender", "Gains")], ("Contender",))
    out.print(about(found), style="dim", markup=False)
    for sentence in found.verdict:
        out.print(sentence, markup=False)
    if report:
        from dampen.report.compare.page import write_comparison

        with working("Drawing figures"):
            page = write_comparison(folder, found)
        out.print(f"Report: {page}", markup=False)
    else:
        out.print(f"Comparison: {folder}", markup=False)
