"""How a tuning gets on: every member's objective, and the best so far, generation by generation."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from dampen.report.axes import legend_row, panel, sheet
from dampen.report.study.axes import BEST, best_row, merit_axis, merits_of, rows_words, scatter
from dampen.report.study.names import is_low_better, merit_label, merit_value, merit_words
from dampen.report.style import DISPLACEMENT
from dampen.studies.rows import Array, statuses
from dampen.studies.study import Study


def draw_convergence(study: Study, objective: str) -> tuple[Figure, str]:
    """Members as dots, those that lost the constraint marked; the best of those that held so far as a line."""
    scenario, y = study.definition.scenario, merits_of(study, objective)
    generation = np.asarray(study.table["generation"], dtype=float)
    figure = sheet()
    axes = panel(figure, left=0.68, top=0.3)
    last = int(generation.max()) if len(generation) else 0
    axes.set_xlim(-0.5, last + 0.5)
    axes.set_xlabel("generation")
    axes.xaxis.set_major_locator(MaxNLocator(6, integer=True, steps=[1, 2, 5, 10]))
    merit_axis(axes, merit_label(objective, scenario), y)
    handles = scatter(axes, study, generation, y, DISPLACEMENT, ms=2.2, alpha=0.5)
    best = best_so_far(study, objective)
    handles += axes.plot(np.arange(last + 1), best, color=BEST, lw=1.4, drawstyle="steps-post", label="best so far", zorder=5)
    legend_row(figure, handles)
    return figure, _sentence(study, objective, best)


def best_so_far(study: Study, objective: str) -> Array:
    """(generations,) the best value of a member that held the constraint, up to each; nan before there is one."""
    sign = 1.0 if is_low_better(objective) else -1.0
    y, generation = sign * merits_of(study, objective), np.asarray(study.table["generation"], dtype=int)
    held = (statuses(study) == "complete") & np.isfinite(y)
    each = np.full(int(generation.max(initial=0)) + 1, np.inf)
    np.minimum.at(each, generation[held], y[held])
    best = np.minimum.accumulate(each)
    return np.where(np.isfinite(best), sign * best, np.nan)


def _sentence(study: Study, objective: str, best: Array) -> str:
    if best_row(study, objective) is None:
        return f"No member held the constraint{rows_words(study)}."
    scenario, known = study.definition.scenario, np.flatnonzero(np.isfinite(best))
    first, last = int(known[0]), len(best) - 1
    values = [merit_value(objective, float(best[j]), scenario) for j in (first, last)]
    text = f"The best {merit_words(objective)} goes from {values[0]} in generation {first} to {values[1]} in generation {last}"
    found = int(np.flatnonzero(best == best[last])[0])
    text += f", found in generation {found}"
    near = int(np.flatnonzero(np.abs(best - best[last]) <= 0.01 * abs(best[last]))[0])
    text += f" and within 1 % of it from generation {near} on" if near < found else ""
    return f"{text}{rows_words(study)}."
