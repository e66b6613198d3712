"""Everything that a comparison leaves for people to read: three figures and one self-contained page."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path

from dampen.report.compare.learning import draw_last, draw_learning
from dampen.report.compare.pareto import draw_pareto
from dampen.report.compare.tables import about, budget_words, found_table, table
from dampen.report.figures import FORMATS, Drawn, save_all
from dampen.report.page import embedded, smaller_format, template
from dampen.report.study.figures import StudyJob
from dampen.report.study.names import merit_words
from dampen.report.study.tables import Grid
from dampen.report.style import plain_number
from dampen.simulation.result import Result
from dampen.simulation.scenario import Scenario
from dampen.studies.compare.comparison import Comparison
from dampen.toml import to_toml


def write_comparison(folder: Path, found: Comparison) -> Path:
    """Write folder/figures/*.png and *.svg and folder/report.html; returns the path of the page. The comparison must have at
    least one contender, and its results."""
    folder, runs = Path(folder), found.results
    scenario = runs[found.contenders[0].label].scenario
    drawn = draw_comparison(found, runs, folder / "figures")
    kind = smaller_format(drawn)
    shown = [embedded(one, kind) for one in drawn]
    heads, rows = table(found)
    tables = [Grid("The contenders", about(found), heads, rows, 2), found_table(found)]
    text = template("compare/page.html.j2").render(
        title=f"{found.title or found.scenario}: {len(found.contenders)} controllers compared",
        status=status(found),
        verdict=" ".join(found.verdict[:2]),
        more=found.verdict[2:],
        facts=facts(found, scenario),
        key=shown[-1],
        tables=tables,
        figures=shown[:-1],
        left_out=found.left_out,
        toml=found.experiment or to_toml(scenario),
        version=found.version,
    )
    path = folder / "report.html"
    path.write_text(text, encoding="utf-8")
    return path


def draw_comparison(found: Comparison, runs: Mapping[str, Result], folder: Path) -> list[Drawn[StudyJob]]:
    """Draw and save the figures of a comparison."""
    scenario = runs[found.contenders[0].label].scenario
    words = merit_words(found.objective)
    jobs = [
        StudyJob("learning", "Largest error of each trial", partial(draw_learning, found, runs)),
        StudyJob("last-trial", "Error in the last trial", partial(draw_last, found, runs)),
        StudyJob("pareto", f"{words[0].upper()}{words[1:]} and what it costs", partial(draw_pareto, found, scenario)),
    ]
    saved = save_all([(job.name, job.draw) for job in jobs], folder, FORMATS)
    return [Drawn(job, *of_it) for job, of_it in zip(jobs, saved, strict=True)]


def status(found: Comparison) -> str:
    """What there is to warn of."""
    return "" if found.complete else f"Unfinished: this page is of the {len(found.contenders)} contenders that are done."


def facts(found: Comparison, scenario: Scenario) -> list[tuple[str, str]]:
    """What was compared, in a few words each."""
    numerics, task = scenario.numerics, scenario.task
    tuned = [c for c in found.contenders if c.tuned]
    minutes = sum(c.seconds for c in found.contenders) / 60
    return [
        ("Experiment", found.scenario),
        ("Contenders", f"{len(found.contenders)}, {len(tuned)} of them tuned"),
        ("Tuning", f"CMA-ES for the {merit_words(found.objective)}, {budget_words(found)}"),
        ("Trials", f"{task.trials} of {plain_number(task.trial_duration)} s, {task.start}"),
        ("Numerics", f"{numerics.discretisation}, {numerics.modes} modes, step {plain_number(1000 * numerics.step)} ms"),
        ("Time", f"{minutes:.1f} min"),
        ("Version", f"dampen {found.version}"),
    ]
