"""The tables of a study's page: what was varied, quantiles, indices, the best rows, what was refused."""

from __future__ import annotations

import shlex
from collections import Counter
from dataclasses import dataclass

import numpy as np

from dampen.analysis.merits import merit_unit
from dampen.report.facts import described
from dampen.report.study.axes import best_row, is_log, value_text
from dampen.report.study.names import (
    axis_names,
    axis_unit,
    is_low_better,
    math_unit,
    merit_value,
    merit_words,
    plain_name,
)
from dampen.report.style import DASH, plain_number
from dampen.simulation.scenario import Scenario
from dampen.studies.rows import JUDGED, column, counts, statuses
from dampen.studies.statistics import FRACTIONS, Robustness, main_merits
from dampen.studies.study import Study
from dampen.studies.variation import Axis

KINDS = {"sweep": "grid", "robust": "samples of what is uncertain", "tune": "search for the best parameters"}
OPTIONS = {"sweep": "--vary", "robust": "--uncertain", "tune": "--search"}
STATUS_WORDS = {
    "complete": "held",
    "constraint_lost": "lost the constraint",
    "diverged": "diverged",
    "refused": "refused",
    "crashed": "crashed",
}
BEST_ROWS = 10
OF = " of the constraint"  # said once, above the table
MESSAGES = 8


@dataclass(frozen=True)
class Grid:
    """A table of the page. words: how many of its first columns are text, the rest being numbers."""

    title: str
    about: str
    heads: tuple[str, ...]
    rows: list[tuple[str, ...]]
    words: int = 1


def study_facts(study: Study) -> list[tuple[str, str]]:
    """What was studied, in a few words each."""
    definition = study.definition
    scenario = definition.scenario
    design = {"sobol": "scrambled Sobol points", "latin": "Latin hypercube"}.get(definition.sampler, definition.sampler)
    method = "CMA-ES" if len(definition.objectives) == 1 else "NSGA-II"
    names = axis_names(scenario, definition.axes)
    rows = [
        ("Study", f"{definition.kind}: {KINDS[definition.kind]}"),
        ("Scenario", scenario.name),
        ("Plant", described(scenario.plant)),
        ("Controller", described(scenario.controller)),
        ("Design", f"{design}, Saltelli design of {definition.base:,} base rows" if definition.kind == "robust" else ""),
        ("Objectives", ", ".join(map(merit_words, definition.objectives)) if definition.kind == "tune" else ""),
        ("Method", f"{method}, generations of {definition.population}" if definition.kind == "tune" else ""),
        *((plain_name(names[axis.name]), range_words(study, axis)) for axis in definition.axes),
        *((f"held over {plain_name(name)}", range_words(study, axis)) for axis, name in _held_over(study)),
        ("Samples each", str(definition.robust_samples) if definition.robust_axes else ""),
        ("Runs", f"{study.done:,} of {study.members:,}"),
        *((f"{DASH} {STATUS_WORDS[status]}", f"{n:,}") for status, n in counts(study).items()),
        ("Seed", str(definition.seed) if definition.kind != "sweep" else ""),
        ("Version", f"dampen {study.version}"),
    ]
    return [(name, text) for name, text in rows if text]


def _held_over(study: Study) -> list[tuple[Axis, str]]:
    axes = study.definition.robust_axes
    names = axis_names(study.definition.scenario, axes)
    return [(axis, names[axis.name]) for axis in axes]


def range_words(study: Study, axis: Axis) -> str:
    """An axis's range, unit, and how it is spread: "0.05 to 0.15 kg, normal"."""
    unit = math_unit(axis_unit(study.definition.scenario, axis))
    if axis.values and not axis.low < axis.high:
        return f"{', '.join(value_text(v) for v in axis.values)} {unit}".strip()
    text = f"{value_text(axis.low)} to {value_text(axis.high)} {unit}".strip()
    extras = [f"{len(axis.values)} points" if axis.values else "", "logarithmic" if is_log(axis) else ""]
    extras += ["normal, cut at three deviations" if axis.normal else "", "whole numbers" if axis.whole else ""]
    return ", ".join([text, *(extra for extra in extras if extra)])


def quantile_table(study: Study, found: Robustness) -> Grid | None:
    """From good to bad; a diverged run is worse than any value."""
    if not found.quantiles:
        return None
    scenario = study.definition.scenario
    rows = []
    for name, q in found.quantiles.items():
        values = [merit_value(name, v, scenario).removesuffix(OF) for v in (*q.values, q.worst)]
        rows.append((_sentence_case(merit_words(name)), *values))
    about = f"Of {found.lost.of:,} independent samples, from the best to the worst; the peak and rms error of all ports "
    about += "together are shares of the constraint. A run that diverged counts as worse than any value."
    heads = ("Figure of merit", *("median" if f == 0.5 else f"{100 * f:.0f} %" for f in FRACTIONS), "worst")
    return Grid("Quantiles", about, heads, rows)


def index_table(study: Study, found: Robustness) -> Grid | None:
    """First-order and total index of each parameter, with the interval in brackets, merit by merit."""
    if not found.indices:
        return None
    names = axis_names(study.definition.scenario, study.definition.axes)
    rows: list[tuple[str, ...]] = [
        (
            _sentence_case(merit_words(name)) if i == 0 else "",
            plain_name(names[axis.name]),
            _with_interval(one.first[i], one.first_interval[:, i]),
            _with_interval(one.total[i], one.total_interval[:, i]),
        )
        for name, one in found.indices.items()
        for i, axis in enumerate(study.definition.axes)
    ]
    used = next(iter(found.indices.values()))
    about = "Sobol indices: the share of a merit's variance that goes with the parameter alone (first order) and with all its "
    about += f"interactions (total), with 95 % bootstrap intervals, from {used.rows:,} complete base rows"
    why = "since a run of theirs diverged, was refused or is not done"
    about += f"; {used.left_out:,} were left out {why}." if used.left_out else "."
    heads = ("Figure of merit", "Parameter", "Alone", "With interactions")
    return Grid("What the figures of merit depend on", about, heads, rows, 2)


def _with_interval(value: float, ends: np.ndarray) -> str:
    return f"{_two(value)} ({_two(float(ends[0]))} to {_two(float(ends[1]))})"


def _two(value: float) -> str:
    text = f"{value:.2f}"
    return plain_number(0) if float(text) == 0 else text.replace("-", "\N{MINUS SIGN}")


def chosen_merit(study: Study) -> str:
    """What rows are ranked by: the tuning's first objective, else the peak."""
    return (*study.definition.objectives, "peak")[0]


def best_table(study: Study) -> Grid | None:
    """The ten best rows that held the constraint."""
    name, scenario = chosen_merit(study), study.definition.scenario
    y = column(study, name) * (1 if is_low_better(name) else -1)
    held = np.flatnonzero((statuses(study) == "complete") & np.isfinite(y))
    rows = held[np.argsort(y[held], kind="stable")][:BEST_ROWS]
    if not len(rows):
        return None
    names = axis_names(scenario, study.definition.axes)
    merits = list(dict.fromkeys([name, *study.definition.objectives, "peak", "effort", "margin"]))
    merits = [m for m in merits if np.isfinite(column(study, m)).any()]
    heads = ["Member"]
    for axis in study.definition.axes:
        unit = math_unit(axis_unit(scenario, axis))
        heads.append(plain_name(names[axis.name]) + (f" [{unit}]" if unit else ""))
    cells = [
        (
            str(int(study.table["member"].iloc[row])),
            *(value_text(study.table[axis.name].iloc[row]) for axis in study.definition.axes),
            *(merit_value(m, float(column(study, m)[row]), scenario).removesuffix(OF) for m in merits),
        )
        for row in rows
    ]
    about = f"By the {merit_words(name)}, among the runs that held the constraint, of which the errors and the margin are shares."
    heads += [_sentence_case(merit_words(m)) for m in merits]
    return Grid(f"The {len(rows)} best runs" if len(rows) > 1 else "The best run", about, tuple(heads), cells, 0)


def message_table(study: Study) -> Grid | None:
    """Why runs were refused or crashed, the commonest reason first."""
    found = statuses(study)
    failed = np.flatnonzero(~np.isin(found, JUDGED))
    reasons = Counter((str(found[i]), str(study.table["message"].iloc[i]) or "no reason was given") for i in failed)
    if not reasons:
        return None
    rows: list[tuple[str, ...]] = [(status, message, f"{n:,}") for (status, message), n in reasons.most_common(MESSAGES)]
    more = len(reasons) - len(rows)
    about = "These runs have no result and count in no figure." + (f" {more:,} further reasons are in the table." if more else "")
    return Grid("Runs that could not be made", about, ("Status", "Reason", "Runs"), rows, 2)


def summary(study: Study) -> tuple[list[str], list[list[str]]]:
    """For the terminal: best, median and worst of each main merit among runs that did not diverge; of a tuning, before them,
    what its winner has."""
    scenario, rows = study.definition.scenario, []
    winner = best_row(study, chosen_merit(study)) if study.definition.kind == "tune" else None
    for name in main_merits(study):
        every = column(study, name)
        y = np.sort(every[np.isfinite(every) & (statuses(study) != "diverged")])
        if len(y):
            at = y if is_low_better(name) else y[::-1]
            shown = [*([] if winner is None else [every[winner]]), at[0], np.median(y), at[-1]]
            values = [merit_value(name, float(v), scenario).removesuffix(OF) for v in shown]
            rows.append([_as_objective(name, scenario), *values])
    several = f" in {chosen_merit(study)}" if len(study.definition.objectives) > 1 else ""
    return ["Figure of merit", *([] if winner is None else [f"Winner{several}"]), "Best", "Median", "Worst"], rows


def _as_objective(name: str, scenario: Scenario) -> str:
    """A merit in words, and in brackets its name as an objective, where that is another, and the units that it has in one."""
    unit = merit_unit(name, scenario)
    extras = [*([] if name == merit_words(name) else [name]), *([f"{unit} together"] if ", " in unit else [])]
    return merit_words(name) + (f" ({'; '.join(extras)})" if extras else "")


def command(study: Study) -> str:
    """The command that repeats the study, with the scenario as a file."""
    d = study.definition
    parts = ["dampen", d.kind, "scenario.toml"]
    for axis in d.axes:
        parts += [OPTIONS[d.kind], axis.text]
    if d.kind == "robust":
        parts += ["--samples", str(study.members), "--sampler", d.sampler]
    if d.kind == "tune":
        parts += [part for name in d.objectives for part in ("--objective", name)]
        parts += ["--budget", str(study.members), "--population", str(d.population)]
        parts += [part for axis in d.robust_axes for part in ("--robust-over", axis.text)]
        parts += ["--robust-samples", str(d.robust_samples)] if d.robust_axes else []
    parts += ["--seed", str(d.seed)] if d.kind != "sweep" else []
    return shlex.join(parts)


def _sentence_case(text: str) -> str:
    return text[0].upper() + text[1:]
