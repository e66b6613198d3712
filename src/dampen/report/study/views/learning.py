"""How the error falls from trial to trial over all samples of a robustness study."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from dampen.report.axes import legend_row, log_axis, panel, sheet
from dampen.report.study.axes import log_ticks
from dampen.report.study.names import port_words
from dampen.report.study.views.distribution import limit_of
from dampen.report.style import CONSTRAINT, DASHES, colour, quantity, tint, typeset
from dampen.studies.rows import JUDGED, Array, statuses
from dampen.studies.study import Study

LEVELS = (5, 25, 50, 75, 95)


def draw_learning(study: Study, port: str) -> tuple[Figure, str]:
    """Median, quartiles and the band from 5 to 95 % of the largest |error| of each trial.

    A run that diverged counts as infinite from the trial on that it did not finish, so bands do not narrow by losing the worst.
    """
    scenario = study.definition.scenario
    unit = next(p.motion_unit for p in scenario.plant.ports if p.name == port)
    curves, ink = _curves(study, port), colour(unit)
    figure = sheet()
    axes = panel(figure, top=0.3)
    trials = np.arange(curves.shape[1])
    bands = np.quantile(curves, [level / 100 for level in LEVELS], axis=0, method="inverted_cdf")
    shown = bands[np.isfinite(bands) & (bands > 0)]
    low, high = (0.6 * shown.min(), 1.6 * shown.max()) if len(shown) else (0.1, 1.0)
    log_axis(axes, f"largest |error|, {typeset(port_words(port))} [{unit}]", low, high)
    log_ticks(axes.yaxis, low, high, 5)
    kept = np.clip(bands, low, 1e3 * high)
    wide = axes.fill_between(trials, kept[0], kept[4], color=tint(ink, 0.18), lw=0, label="5\N{EN DASH}95 %")
    inner = axes.fill_between(trials, kept[1], kept[3], color=tint(ink, 0.42), lw=0, label="25\N{EN DASH}75 %")
    (middle,) = axes.plot(trials, kept[2], color=ink, lw=1.2, label="median")
    handles = [middle, inner, wide]
    limit = limit_of(study, port)
    if limit is not None and low < limit < high:
        handles.append(axes.axhline(limit, color=CONSTRAINT, lw=0.9, ls=DASHES, label="constraint"))
    axes.set_xlabel("trial")
    axes.set_xlim(0, max(len(trials) - 1, 1))
    axes.xaxis.set_major_locator(MaxNLocator(6, integer=True, steps=[1, 2, 5, 10]))
    legend_row(figure, handles)
    return figure, _sentence(port, unit, curves, bands)


def _curves(study: Study, port: str) -> Array:
    """(runs, trials) largest |error| of each independent sample that ran, infinite after it diverged; the trials that all had."""
    independent = np.asarray(study.table["member"], dtype=int) < 2 * study.definition.base
    rows = np.flatnonzero(independent & np.isin(statuses(study), JUDGED))
    peaks = study.table[f"peaks.{port}"].iloc[rows]
    ended = [len(v) for v, status in zip(peaks, statuses(study)[rows], strict=True) if status != "diverged"]
    trials = min(ended, default=study.definition.scenario.task.trials)
    curves = np.full((len(rows), trials), np.inf)
    for i, values in enumerate(peaks):
        curves[i, : len(values[:trials])] = values[:trials]
    return np.where(np.isnan(curves), np.inf, curves)


def _sentence(port: str, unit: str, curves: Array, bands: Array) -> str:
    first, last = bands[:, 0], bands[:, -1]
    text = f"Of {len(curves):,} independent samples the largest |error| at {port_words(port)} goes from "
    text += f"{quantity(first[2], unit)} in trial 0 to {quantity(last[2], unit)} in trial {curves.shape[1] - 1} in the median"
    if np.isfinite(last[4]):
        text += f"; nine of ten end between {quantity(last[0], unit)} and {quantity(last[4], unit)}"
    else:
        text += f"; {np.mean(~np.isfinite(curves[:, -1])):.0%} did not finish"
    return text + "."
