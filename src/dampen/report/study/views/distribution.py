"""How the peak error of a port is distributed over the samples of a robustness study."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MaxNLocator

from dampen.report.axes import legend_row, panel, sheet
from dampen.report.study.axes import linear_ticks, log_ticks
from dampen.report.study.names import merit_label, merit_value, port_words
from dampen.report.style import CONSTRAINT, DASHES, DOTS, INK, SMALL, colour, tint
from dampen.studies.rows import JUDGED, Array, column, statuses
from dampen.studies.study import Study

BINS = 40
QUANTILES = (0.05, 0.5, 0.95)


def draw_distribution(study: Study, port: str, own: Mapping[str, float] | None = None) -> tuple[Figure, str]:
    """Histogram and cumulative share of the peak error, with its 5, 50 and 95 % quantiles; diverged runs are beyond all bins.

    own: the merits of the scenario itself, marked if given.
    """
    name, scenario = f"peak.{port}", study.definition.scenario
    unit = next(p.motion_unit for p in scenario.plant.ports if p.name == port)
    values, diverged = _samples(study, name)
    figure = sheet()
    axes = panel(figure, right=0.5, top=0.42)
    log = len(values) > 0 and values.min() > 0 and values.max() > 8 * values.min()
    low, high = (float(values.min()), float(values.max())) if len(values) else (0.0, 1.0)
    high = high if high > low else low + max(abs(low), 1e-12)
    bins = np.geomspace(low, high, BINS + 1) if log else np.linspace(low, high, BINS + 1)
    ink = colour(unit)
    axes.hist(values, bins=list(bins), color=tint(ink, 0.45), ec="white", lw=0.3, zorder=2)
    axes.set_ylabel("runs")
    axes.yaxis.set_major_locator(MaxNLocator(5, integer=True))
    beside = axes.twinx()
    beside.spines["top"].set_visible(False)
    shares = np.arange(1, len(values) + 1) / max(len(values) + diverged, 1)
    handles = beside.plot(np.sort(values), shares, color=ink, lw=1.1, drawstyle="steps-post", label="share of runs below")
    beside.set_ylim(0, 1.02)
    beside.yaxis.set_major_formatter(FuncFormatter(lambda v, _: f"{100 * v:.0f} %"))
    if log:
        axes.set_xscale("log")
        log_ticks(axes.xaxis, low, high, 6)
    else:
        linear_ticks(axes.xaxis, 6)
    axes.set_xlabel(merit_label(name, scenario))
    for q in QUANTILES:
        at = _quantile(values, diverged, q)
        if np.isfinite(at):
            axes.axvline(at, color=INK, lw=0.7, ls=DOTS, zorder=3)
            axes.annotate(
                f"{100 * q:.0f} %", (at, 1), (0, 2), axes.get_xaxis_transform(), "offset points", ha="center", fontsize=SMALL - 1
            )
    limit = limit_of(study, port)
    if limit is not None and low <= limit <= 1.3 * high:
        handles.append(axes.axvline(limit, color=CONSTRAINT, lw=1.0, ls=DASHES, label="constraint", zorder=3))
    if own and np.isfinite(own.get(name, np.nan)):
        handles.append(axes.axvline(own[name], color="#009E73", lw=1.2, label="scenario's own", zorder=4))
    legend_row(figure, handles, right=0.12)
    return figure, _sentence(study, port, values, diverged, own)


def _samples(study: Study, name: str) -> tuple[Array, int]:
    """The independent samples' values, and how many diverged and so have none."""
    found = statuses(study)
    independent = (np.asarray(study.table["member"], dtype=int) < 2 * study.definition.base) & np.isin(found, JUDGED)
    values = column(study, name)[independent]
    return values[np.isfinite(values)], int((found[independent] == "diverged").sum())


def _quantile(values: Array, diverged: int, share: float) -> float:
    """Of all samples, the diverged ones among them as infinite."""
    everything = np.concatenate([values, np.full(diverged, np.inf)])
    return float(np.quantile(everything, share, method="inverted_cdf")) if len(everything) else np.nan


def limit_of(study: Study, port: str) -> float | None:
    """Half the width of the constraint as a trial begins."""
    scenario = study.definition.scenario
    if port not in scenario.task.constraint:
        return None
    low, high = (limit[0, scenario.ports.index(port)] for limit in scenario.limits(0))
    return float((high - low) / 2)


def _sentence(study: Study, port: str, values: Array, diverged: int, own: Mapping[str, float] | None) -> str:
    name, scenario = f"peak.{port}", study.definition.scenario
    if not len(values):
        return f"No sample has a peak error at {port_words(port)}."
    at = [merit_value(name, _quantile(values, diverged, q), scenario) for q in QUANTILES]
    text = f"Over {len(values) + diverged:,} independent samples the peak error at {port_words(port)} is {at[1]} in the median, "
    text += f"between {at[0]} and {at[2]} in nine of ten runs"
    text += f"; {diverged:,} diverged" if diverged else f", {merit_value(name, float(values.max()), scenario)} at worst"
    if own and np.isfinite(own.get(name, np.nan)):
        text += f". The scenario's own parameters give {merit_value(name, own[name], scenario)}"
    return text + "."
