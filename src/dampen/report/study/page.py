"""Everything that a study leaves for people to read: figures, and one self-contained page."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from dampen.component import listed
from dampen.report.page import embedded, smaller_format, template
from dampen.report.study.axes import best_row, where_words
from dampen.report.study.figures import draw_study, jobs_of_study
from dampen.report.study.names import axis_names, merit_value, merit_words, plain_name
from dampen.report.study.tables import (
    best_table,
    chosen_merit,
    command,
    index_table,
    message_table,
    quantile_table,
    study_facts,
    summary,
)
from dampen.report.study.views.pareto import front
from dampen.report.style import DASH, percent
from dampen.studies.best import at_ends, nearest_row
from dampen.studies.rows import JUDGED, column, counts, statuses
from dampen.studies.search import violation
from dampen.studies.statistics import Proportion, Robustness, robustness
from dampen.studies.study import Study
from dampen.toml import to_toml

EXPLAINS = 0.1
TITLES = {"sweep": "sweep over {}", "robust": "robustness over {}", "tune": "tuning of {}"}


def write_study_report(folder: Path, study: Study, nominal: Mapping[str, float] | None = None) -> Path:
    """Write folder/figures/*.png and *.svg and folder/report.html; returns the path of the page.

    nominal: figures of merit, by column, of the scenario with its own parameters, if they are known: marked in figures.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    found = robustness(study) if study.definition.kind == "robust" and len(study.table) else None
    drawn = draw_study(jobs_of_study(study, found, nominal), folder / "figures")
    kind = smaller_format(drawn) if drawn else "svg"
    shown = [embedded(one, kind) for one in drawn]
    tables = [quantile_table(study, found), index_table(study, found)] if found else [best_table(study)]
    text = template("study/page.html.j2").render(
        title=title(study),
        status=status(study),
        verdict=verdict(study, found),
        facts=study_facts(study),
        key=shown[0] if shown else None,
        tables=[table for table in (*tables, message_table(study)) if table],
        figures=shown[1:],
        toml=to_toml(study.definition.scenario),
        command=command(study),
        version=study.version,
    )
    path = folder / "report.html"
    path.write_text(text, encoding="utf-8")
    return path


def verdict_of(study: Study) -> str:
    """The outcome in one sentence."""
    return verdict(study, robustness(study) if study.definition.kind == "robust" and len(study.table) else None)


def summary_rows(study: Study) -> tuple[list[str], list[list[str]]]:
    """Headings and rows of the table that a terminal shows."""
    return summary(study)


def title(study: Study) -> str:
    """What was varied in which scenario."""
    scenario, axes = study.definition.scenario, study.definition.axes
    names = [plain_name(name) for name in axis_names(scenario, axes).values()]
    what = listed(names) if len(names) <= 3 else f"{len(names)} parameters"
    return f"{scenario.title or scenario.name}: {TITLES[study.definition.kind].format(what)}"


def status(study: Study) -> str:
    """What there is to warn of: a study that is not finished, and one of which nothing ran."""
    parts = []
    if study.done < study.members:
        parts.append(f"Unfinished: {study.done:,} of {study.members:,} runs are done, and this page is of these.")
    if study.done and not np.isin(statuses(study), JUDGED).any():
        first = next((text for text in study.table["message"] if text), "")
        parts.append(f"No run could be made. {first}".strip())
    unsettled = int((column(study, "unsettled") > 0).sum())
    if unsettled:
        parts.append(f"In {unsettled:,} runs forces at the ports did not settle in some steps: do not trust these.")
    return " ".join(parts)


def verdict(study: Study, found: Robustness | None) -> str:
    """The outcome in one sentence, by the kind of study."""
    if not study.done:
        return "No run is done yet."
    ran = int(np.isin(statuses(study), JUDGED).sum())
    if not ran:
        words = {"refused": "refused", "crashed": "crashed"}
        return f"All {study.done:,} runs failed: {listed([f'{n:,} {words[s]}' for s, n in counts(study).items()])}."
    return _robust(study, found) if found is not None else _searched(study, ran)


def _robust(study: Study, found: Robustness) -> str:
    """How often the constraint is lost, how large the peak is, what explains it."""
    if not found.lost.of:
        return "No independent sample has run yet."
    limited = bool(study.definition.scenario.task.constraint)
    text = f"In {found.lost.of:,} independent samples ({study.done:,} runs) "
    if found.lost.count:
        text += ("the constraint was lost in " if limited else "the motion diverged in ") + share_words(found.lost)
    else:
        never = "the constraint was never lost" if limited else "no motion diverged"
        text += f"{never} (95 % interval: 0{DASH}{_two(found.lost.high)} %)"
    text += f", {found.diverged:,} of them diverged" if limited and found.diverged else ""
    if "peak" in found.quantiles:
        q = found.quantiles["peak"]
        worst = "unbounded" if np.isinf(q.worst) else merit_value("peak", q.worst, study.definition.scenario)
        median = merit_value("peak", q.values[2], study.definition.scenario)
        text += f"; the peak error is {median} in the median and {worst} at worst"
    if "peak" in found.indices:
        names = axis_names(study.definition.scenario, study.definition.axes)
        first = found.indices["peak"].first
        i = int(np.argmax(first))
        if first[i] >= EXPLAINS:
            share = percent(min(float(first[i]), 1.0))
            text += f"; {plain_name(names[study.definition.axes[i].name])} explains {share} of its variance"
    return text + "."


def share_words(share: Proportion) -> str:
    """ "2.1 % (95 %: 1.3-3.1 %)"."""
    return f"{_two(share.estimate)} % (95 %: {_two(share.low)}{DASH}{_two(share.high)} %)"


def _two(ratio: float) -> str:
    """A ratio in percent with two significant digits, however small."""
    if not ratio > 0:
        return "0"
    return f"{100 * ratio:.{max(0, 1 - int(np.floor(np.log10(100 * ratio))))}f}"


def _searched(study: Study, ran: int) -> str:
    """What is best, where, and how many held the constraint."""
    name, scenario = chosen_merit(study), study.definition.scenario
    best, held = best_row(study, name), int((statuses(study) == "complete").sum())
    kept = "held the constraint" if scenario.task.constraint else "stayed bounded"
    if best is None:
        return f"None of {ran:,} runs {kept}{_nearest(study, name)}."
    names = axis_names(scenario, study.definition.axes)
    value = merit_value(name, float(column(study, name)[best]), scenario)
    value += f" in the worst of {study.definition.robust_samples} samples" if study.definition.robust_axes else ""
    where = where_words(study, best, names)
    if study.definition.kind == "sweep":
        return f"Of {ran:,} runs {held:,} {kept}; the {merit_words(name)} is best, {value}, at {where}."
    generations = int(study.table["generation"].max()) + 1
    after = f"{generations:,} {'generation' if generations == 1 else 'generations'}"
    text = f"After {after} the best {merit_words(name)} is {value}, at {where}"
    objectives = study.definition.objectives
    if len(objectives) > 1:
        on = len(front(study, objectives))
        text += f"; {on:,} {'member is' if on == 1 else 'members are'} on the front of {len(objectives)} objectives"
    ends = at_ends(study.definition, study.table.iloc[best])
    return f"{text}; {held:,} of {ran:,} members {kept}." + (f" {ends}." if ends else "")


def _nearest(study: Study, name: str) -> str:
    """Which run broke the constraint least, and by how much; "" where none ran to its end."""
    table = study.table
    row = nearest_row(table.to_dict("records"), name)
    if row is None or not violation(row) > 0:
        return ""
    where = where_words(
        study, list(table["member"]).index(row["member"]), axis_names(study.definition.scenario, study.definition.axes)
    )
    return f"; the nearest broke it by {percent(violation(row))}, at {where}"
