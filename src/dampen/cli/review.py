"""`dampen audit`, `credit` and `limit`: what holds in a run, what does not, and what each part of it is worth."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

import typer

from dampen.cli.run import RUNS, OutOption, ReportOption, finish, perform
from dampen.cli.terminal import HOURS, HoursOption, ScenarioArgument, SetOption, err, out, progress_line, show_table, working

if TYPE_CHECKING:
    from dampen.analysis.limit.curve import Limit
    from dampen.analysis.limit.standing import Standing
    from dampen.simulation.bench import Bench
    from dampen.simulation.result import Result
    from dampen.simulation.scenario import Scenario
    from dampen.studies.record import Record

LONG = 10.0  # seconds: what takes longer is announced
EXIT = "Exit status: 0 when the run completed, whatever was found; 2 for bad input; 3 when it broke off, with what it has saved."
LIMIT_HELP = (
    "How far from the best possible? The least RMS of each field (or tracking error) that any forces at the same ports could "
    "reach, knowing the disturbance in advance, for each RMS of the forces; certified, and where the run lies against it.\n\n"
    "Examples:\n\n  dampen limit he2017\n\n  dampen limit flexible-arm-point-to-point --of tip_w\n\n"
    f"The full experiment of he2017 takes about a minute on two cores. {EXIT}"
)
AUDIT_HELP = (
    "Run a scenario and audit it: the energy account, how figures move with twice the modes and half the step, the assumptions "
    "of the law's proof as the run had them, every bound, the proof's energy and gain conditions; and what each part of the law "
    "is worth.\n\nExamples:\n\n  dampen audit he2017\n\n  dampen audit he2017 --set controller.compensate=false\n\n"
    f"Writes what `dampen run` writes, with a review in the report and every number in audit.json. {EXIT}"
)
CREDIT_HELP = (
    "Take the credit apart: run a scenario without control, with damping alone, and without one part of its law at a time (what "
    "it learned, observer, barrier, Sgn), with the disturbance's frequencies held and through an ideal actuator.\n\n"
    f"Example:\n\n  dampen credit he2017\n\n{EXIT}"
)


def audit(
    scenario: ScenarioArgument,
    set_: SetOption = None,
    folder: OutOption = None,
    with_credit: Annotated[bool, typer.Option("--credit/--no-credit", help="what each part of the law is worth")] = True,
    with_limit: Annotated[bool, typer.Option("--limit/--no-limit", help="how far from the best possible (takes long)")] = False,
    report: ReportOption = True,
    hours: HoursOption = HOURS,
) -> None:
    """`dampen audit`."""
    from dampen.analysis.limit.measure import check_measures
    from dampen.report.review.tables import audit_rows
    from dampen.report.review.words import sentence

    def reviewed(bench: Bench, result: Result) -> tuple[Record, bool]:
        return review(bench, result, refine=True, credit=with_credit, of=() if with_limit else None)

    def check(experiment: Scenario) -> None:
        if with_limit:
            check_measures(experiment, ())

    done = perform(scenario, set_, folder, report, purpose="audit", review=reviewed, check=check, hours=hours)
    if done.record.audit is not None:
        show_table(("", "Criterion", "Measured", "Verdict"), coloured(audit_rows(done.record.audit)))
        out.print(sentence(done.record.audit), markup=False)
    show_credit(done.record)
    show_limits(done.record)
    finish(done)


def limit(
    scenario: ScenarioArgument,
    set_: SetOption = None,
    of: Annotated[
        list[str] | None, typer.Option("--of", help="a field, or a port's tracking error (default: what matters)")
    ] = None,
    folder: OutOption = None,
    report: ReportOption = True,
    hours: HoursOption = HOURS,
) -> None:
    """`dampen limit`."""
    from dampen.analysis.limit.measure import check_measures

    def reviewed(bench: Bench, result: Result) -> tuple[Record, bool]:
        return review(bench, result, refine=None, of=of or ())

    check = partial(check_measures, names=of or ())
    done = perform(scenario, set_, folder, report, purpose="limit", review=reviewed, check=check, hours=hours)
    show_limits(done.record)
    finish(done)


def credit(
    scenario: ScenarioArgument,
    set_: SetOption = None,
    folder: OutOption = None,
    report: ReportOption = True,
    hours: HoursOption = HOURS,
) -> None:
    """`dampen credit`."""
    from dampen.analysis.credit import refuse_without_control

    def reviewed(bench: Bench, result: Result) -> tuple[Record, bool]:
        return review(bench, result, refine=None, credit=True)

    done = perform(scenario, set_, folder, report, purpose="credit", review=reviewed, check=refuse_without_control, hours=hours)
    show_credit(done.record)
    finish(done)


def review(
    bench: Bench, result: Result, refine: bool | None, credit: bool = False, of: Sequence[str] | None = None
) -> tuple[Record, bool]:
    """The parts of a review that are asked for, as far as they get before Ctrl-C, and whether they are all there.

    refine: None: no audit at all.   of: measures of the limit; empty: the usual ones, None: no limit.
    """
    from dampen.analysis.audit.audit import audit as audited
    from dampen.analysis.audit.audit import refined
    from dampen.analysis.credit import credit as credited
    from dampen.controllers.none import NoControl
    from dampen.studies.record import record

    found: dict[str, Any] = {}
    whole = True
    try:
        if refine is not None and result.trials:
            with working("Auditing"):
                found["audit"] = audited(result, refine=False, bench=bench)
                if refine:
                    found["audit"] = refined(found["audit"], result)
        if credit and not isinstance(result.scenario.controller, NoControl):
            with progress_line("Taking apart") as update:
                found["credit"] = credited(result.scenario, progress=partial(told, update))
        if of is not None and result.trials < result.scenario.task.trials:
            err.print("There is no limit to hold a run against that did not go to its end.", markup=False)
        elif of is not None:
            for one, at in limits_of(bench, result, of):
                found["limits"] = (*found.get("limits", ()), one)
                found["standings"] = (*found.get("standings", ()), at)
    except KeyboardInterrupt:
        err.print("The review was interrupted: it has what was finished.", markup=False)
        whole = False
    return record(result.scenario, **found), whole


def limits_of(bench: Bench, result: Result, of: Sequence[str]) -> Iterator[tuple[Limit, Standing]]:
    """The limits, one after the other, and where the run lies against them."""
    from dampen.analysis.limit.curve import limit as limited
    from dampen.analysis.limit.measure import measures
    from dampen.analysis.limit.standing import standing
    from dampen.simulation.cost import predicted_seconds

    seconds = RUNS["limit"] * predicted_seconds(result.scenario)
    if seconds > LONG:
        err.print(f"Finding the limit: this takes roughly {float(f'{seconds:.1g}'):g} s.", markup=False)
    for name in dict.fromkeys(of or measures(result.scenario)):
        with progress_line(f"Limit of {name}") as update:
            found = limited(result.scenario, name, bench=bench, progress=partial(told, update))
        yield found, standing(found, result)


def show_limits(record: Record) -> None:
    """Where the run lies against the limits."""
    from dampen.report.review.tables import LIMIT_COLUMNS, limit_rows
    from dampen.report.review.words import limited

    if record.limits:
        show_table(LIMIT_COLUMNS, limit_rows(record), LIMIT_COLUMNS[1:])
        for line in limited(record.limits, record.standings):
            out.print(line, markup=False)


def show_credit(record: Record) -> None:
    """The credit as a table and in words."""
    from dampen.report.review.tables import credit_columns, credit_rows
    from dampen.report.review.words import credited

    if record.credit is None:
        return
    columns = credit_columns(record.credit)
    show_table(("What it is worth", *columns[1:]), credit_rows(record.credit), columns[1:])
    for line in credited(record.credit, record.audit):
        out.print(line, markup=False)


def coloured(rows: list[tuple[str, str, str, str]]) -> list[tuple[Any, ...]]:
    """The rows with their verdicts in colour, a section's name where it begins."""
    from rich.text import Text

    colours = {"PASS": "green", "FAIL": "bold red", "note": "dim"}
    named, before = [], ""
    for section, *rest, verdict in rows:
        named.append((section if section != before else "", *rest, Text(verdict, colours.get(verdict, ""))))
        before = section
    return named


def told(update: Callable[..., None], done: int, total: int) -> None:
    """A progress line whose total is known with the first report."""
    update(completed=done, total=total)
