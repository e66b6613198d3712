"""Which figures a study has, and drawing them into files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations
from pathlib import Path

import numpy as np

from dampen.report.figures import FORMATS, Draw, Drawn, save_all
from dampen.report.study.names import merit_words
from dampen.report.study.views.convergence import draw_convergence
from dampen.report.study.views.distribution import draw_distribution
from dampen.report.study.views.heat_map import draw_heat_map
from dampen.report.study.views.learning import draw_learning
from dampen.report.study.views.line import draw_line
from dampen.report.study.views.pareto import draw_pareto
from dampen.report.study.views.profile import draw_profile
from dampen.report.study.views.scatter import draw_scatter, most_important
from dampen.report.study.views.sensitivity import draw_sensitivity
from dampen.report.study.views.slices import draw_slices
from dampen.studies.rows import JUDGED, column, statuses
from dampen.studies.statistics import Robustness
from dampen.studies.study import Study

MAIN = ("peak", "effort", "margin")


@dataclass(frozen=True)
class StudyJob:
    """One figure of a study that is to be drawn."""

    name: str
    caption: str
    draw: Draw


def jobs_of_study(study: Study, found: Robustness | None, own: Mapping[str, float] | None = None) -> list[StudyJob]:
    """The figures that its kind asks for and its rows allow; none where no row ran."""
    if not np.isin(statuses(study), JUDGED).any():
        return []
    kind = study.definition.kind
    if kind == "sweep":
        return _sweep(study)
    return _tune(study) if kind == "tune" or found is None else _robust(study, found, own)


def _sweep(study: Study) -> list[StudyJob]:
    draw = {1: draw_line, 2: draw_heat_map}.get(len(study.definition.axes), draw_profile)
    return [StudyJob(f"sweep-{name}", _title(name), partial(draw, study, name)) for name in _known(study, MAIN)]


def _robust(study: Study, found: Robustness, own: Mapping[str, float] | None) -> list[StudyJob]:
    jobs, ports = [], study.definition.scenario.ports
    for port in ports:
        if _known(study, (f"peak.{port}",)):
            caption = f"{_title(f'peak.{port}')} over the samples"
            jobs.append(StudyJob(f"peak-{port}", caption, partial(draw_distribution, study, port, own)))
    for port in ports:
        if f"peaks.{port}" in study.table.columns and (np.asarray(study.table["member"]) < 2 * study.definition.base).any():
            caption = f"Error at {port.replace('_', ' ')} from trial to trial"
            jobs.append(StudyJob(f"learning-{port}", caption, partial(draw_learning, study, port)))
    for name, one in found.indices.items():
        caption = f"What the {merit_words(name)} depends on"
        jobs.append(StudyJob(f"sobol-{name}", caption, partial(draw_sensitivity, study, name, one)))
    for name in _known(study, ("peak",)):
        shown = most_important(study, found.indices.get(name))
        jobs.append(StudyJob(f"scatter-{name}", f"{_title(name)} by parameter", partial(draw_scatter, study, name, shown)))
    return jobs


def _tune(study: Study) -> list[StudyJob]:
    objectives = _known(study, study.definition.objectives)
    jobs = [StudyJob(f"front-{a}-{b}", f"{_title(a)} and {merit_words(b)}", partial(draw_pareto, study, a, b))
            for a, b in combinations(objectives, 2)]  # fmt: skip
    for name in objectives:
        jobs.append(StudyJob(f"convergence-{name}", f"{_title(name)} by generation", partial(draw_convergence, study, name)))
    for name in objectives:
        jobs.append(StudyJob(f"slices-{name}", f"{_title(name)} by parameter", partial(draw_slices, study, name)))
    return jobs


def _known(study: Study, names: Sequence[str]) -> list[str]:
    return [name for name in names if np.isfinite(column(study, name)).any()]


def _title(name: str) -> str:
    words = merit_words(name)
    return words[0].upper() + words[1:]


def draw_study(jobs: Sequence[StudyJob], folder: Path, formats: Sequence[str] = FORMATS) -> list[Drawn[StudyJob]]:
    """Draw and save the figures of a study."""
    saved = save_all([(job.name, job.draw) for job in jobs], folder, formats)
    return [Drawn(job, *of_it) for job, of_it in zip(jobs, saved, strict=True)]
