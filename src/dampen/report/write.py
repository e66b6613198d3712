"""The face of this room: everything that a run leaves for people to read."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from dampen.analysis.claims import Claim
from dampen.analysis.sampling_cost import sampling_cost
from dampen.report.figures import Job, Progress, draw_jobs, jobs_of
from dampen.report.page import embedded, smaller_format, write_page
from dampen.report.plan import completed, default_plan
from dampen.report.review.figures import draw_review
from dampen.report.review.parts import Parts, parts
from dampen.scenarios.claims import check_claims, figure_plan, note
from dampen.scenarios.figures import FigurePlan
from dampen.simulation.result import Result
from dampen.studies.experiment import Runs
from dampen.studies.record import Record


def report_of(runs: Runs, folder: Path, record: Record) -> Path:
    """The report of an experiment: against the claims of its scenario, in the figures that belong to them."""
    result, claims = runs.result, check_claims(runs.result, runs.baseline)
    plan, about = figure_plan(result), note(result)
    return write_report(folder, result, runs.baseline, claims, plan, about, continuous=runs.continuous, record=record)


def write_report(
    folder: Path,
    result: Result,
    baseline: Result | None,
    claims: list[Claim],
    plan: Sequence[FigurePlan] | None,
    note: str = "",
    progress: Progress | None = None,
    continuous: Result | None = None,
    record: Record | None = None,
) -> Path:
    """Write folder/figures/*.png and *.svg and folder/report.html; returns the path of the page.

    baseline: the same experiment without control, if it was run.
    plan:     the figures to draw; None or empty: those that `default_plan` chooses.
    note:     a sentence about the gains, printed below their table.
    progress: called with (figures drawn, figures in all) after each figure.
    continuous: of a sampled run, the same experiment under the continuous law, if it was run: then the page says what
              sampling costs.
    record:   the review of the run: then the page has it, with its figures.
    """
    folder, baseline = Path(folder), None if baseline is result else baseline
    jobs = jobs_of(completed(plan, result) if plan else default_plan(result), result, baseline)
    if result.trials:
        other = baseline if baseline is not None and baseline.trials else None
        jobs.append(Job("energy", "Energy of the structure and of the barrier", "energy", "", result, other))
    drawn = draw_jobs(jobs, folder / "figures", progress=progress)
    costs = [] if continuous is None else sampling_cost(result, continuous)
    review = None if record is None else reviewed(record, result, folder, smaller_format(drawn) if drawn else "svg")
    return write_page(folder / "report.html", result, baseline, claims, drawn, note, costs, review)


def reviewed(record: Record, result: Result, folder: Path, kind: str) -> Parts:
    """A review with its figures, drawn into folder/figures and embedded in this format."""
    drawn = draw_review(record, result, folder / "figures") if result.trials else []
    return parts(record, [embedded(one, kind) for one in drawn])
