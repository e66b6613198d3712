"""A merit along each axis of a sweep over three or more: the best and the median over all the others."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from dampen.report.axes import legend_row, sheet
from dampen.report.study.axes import (
    best_row,
    is_listed,
    merit_axis,
    merits_of,
    padded,
    parameter_axis,
    positions,
    rows_words,
    where_words,
)
from dampen.report.study.names import axis_names, is_low_better, merit_label, merit_value, merit_words, plain_name
from dampen.report.study.panels import panels_across, small_panels
from dampen.report.style import DASHES, DISPLACEMENT, DOUBLE, FAINT, INK
from dampen.studies.rows import Array, statuses
from dampen.studies.study import Study
from dampen.studies.variation import Axis


def draw_profile(study: Study, merit: str) -> tuple[Figure, str]:
    """For each axis the best value that held the constraint, whatever the others take, and the median over them."""
    scenario, varied = study.definition.scenario, study.definition.axes
    names = axis_names(scenario, varied)
    lines = {axis.name: _along(study, axis, merit) for axis in varied}
    everything = np.concatenate([np.concatenate([best, middle]) for _, best, middle in lines.values()])
    figure = sheet(DOUBLE, 2.0)
    handles = []
    for i, (axis, axes) in enumerate(zip(varied, small_panels(figure, len(varied)), strict=True)):
        points, best, middle = lines[axis.name]
        parameter_axis(axes, axis, scenario, "x", names[axis.name])
        axes.set_xlim(padded(axis))
        merit_axis(axes, merit_label(merit, scenario), everything)
        style: dict[str, Any] = {"lw": 0.0 if is_listed(axis) else 0.9, "zorder": 3}
        a = axes.plot(points, best, "o-", ms=3.2, color=DISPLACEMENT, label="best over the others", **style)
        b = axes.plot(
            points, middle, "s", ls=DASHES, ms=3, mfc="white", mew=0.7, color=FAINT, label="median over the others", **style
        )
        own = best_row(study, merit)
        if own is not None:
            at = positions(study, axis)[own]
            c = axes.plot(
                [at], [merits_of(study, merit)[own]], "o", ms=7, mfc="none", mec=INK, mew=1, label="best of all", ls="none"
            )
            handles = [*a, *b, *c]
        handles = handles or [*a, *b]
        if i % panels_across(len(varied)):
            axes.set_ylabel("")
    legend_row(figure, handles)
    return figure, _sentence(study, merit, lines, names)


def _along(study: Study, axis: Axis, merit: str) -> tuple[Array, Array, Array]:
    """Points of an axis, and at each the best and the median merit of the rows that held; nan where none did."""
    x, y = positions(study, axis), merits_of(study, merit)
    held = (statuses(study) == "complete") & np.isfinite(y)
    points = np.unique(x)
    groups = [y[held & (x == point)] for point in points]
    best = np.min if is_low_better(merit) else np.max
    return (
        points,
        np.array([best(g) if len(g) else np.nan for g in groups]),
        np.array([np.median(g) if len(g) else np.nan for g in groups]),
    )


def _sentence(study: Study, merit: str, lines: dict[str, tuple[Array, Array, Array]], names: dict[str, str]) -> str:
    best, scenario = best_row(study, merit), study.definition.scenario
    if best is None:
        return f"No run held the constraint{rows_words(study)}."
    value = merit_value(merit, merits_of(study, merit)[best], scenario)
    text = f"The {merit_words(merit)} is best, {value}, at {where_words(study, best, names)}"
    swing = {name: np.ptp(b[np.isfinite(b)]) for name, (_, b, _) in lines.items() if np.isfinite(b).any()}
    first = max(swing, key=swing.__getitem__)
    _, most, _ = lines[first]
    ends = [merit_value(merit, float(f(most[np.isfinite(most)])), scenario) for f in (np.min, np.max)]
    text += f"; {plain_name(names[first])} matters most: the best there is ranges from {ends[0]} to {ends[1]} along it"
    return f"{text}{rows_words(study)}."
