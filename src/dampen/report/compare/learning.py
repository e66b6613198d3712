"""How the largest error falls from trial to trial, and what is left of it in the last trial: all contenders in one figure."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from dampen.analysis.metrics import tracking_error
from dampen.report.axes import BOTTOM, log_axis, sheet, value_axis
from dampen.report.compare.looks import handle, looks
from dampen.report.joined import pick_extremes
from dampen.report.names import port_names
from dampen.report.style import DOUBLE, INK, SMALL, number, quantity
from dampen.simulation.result import Result
from dampen.studies.compare.comparison import Comparison, Contender

BINS = 300
FAR = 4.0  # times what is shown, beyond which a curve would only cross it
LEGEND, HEAD, GAP, LEFT = 1.45, 0.26, 0.66, 0.62  # in


def draw_learning(found: Comparison, runs: Mapping[str, Result]) -> tuple[Figure, str]:
    """The largest |error| of each trial, a panel for each counted port, and the threshold of having settled."""
    figure, panels = panels_of(found, runs, 2.6)
    styles = looks(found)
    for axes, port in zip(panels, found.counted, strict=True):
        names = port_names(next(iter(runs.values())), port)
        shown = [np.array(one.peaks[port]) for one in found.contenders if one.trials]
        trials = max(map(len, shown))
        for one in reversed(found.contenders):
            peaks, look = np.array(one.peaks[port]), styles[one.label]
            few: dict[str, Any] = {"ms": 2.8, "markevery": max(1, trials // 12), "mew": 0.8 if look["marker"] == "x" else 0}
            axes.plot(np.where(peaks > 0, peaks, np.nan), **few, **look, zorder=3 + (one is found.contenders[0]))
        axes.axhline(found.thresholds[port], color=INK, lw=0.6, ls=(0, (1, 2)), zorder=1)
        axes.annotate("settled", (1, found.thresholds[port]), (0, 2), axes.get_yaxis_transform(), "offset points", ha="right",
                      fontsize=6, color="#555555")  # fmt: skip
        everything = np.concatenate([*shown, [found.thresholds[port]]])
        everything = everything[np.isfinite(everything) & (everything > 0)]
        log_axis(axes, f"largest error, {names.short} [{names.motion}]", everything.min() / 1.6, everything.max() * 1.6)
        axes.set_xlabel("trial")
        axes.xaxis.set_major_locator(MaxNLocator(6, integer=True, steps=[1, 2, 5, 10]))
        axes.set_xlim(-0.5, max(trials - 0.5, 1))
    legend(figure, found)
    return figure, learning_sentence(found)


def learning_sentence(found: Comparison) -> str:
    """Who has settled, from when on."""
    settled = sorted((c for c in found.contenders if c.settling is not None), key=lambda c: c.settling or 0)
    parts = [f"{c.label} from trial {c.settling}" for c in settled]
    room = "the room there is" if any("margin" in c.merits for c in found.contenders) else "the largest error of all"
    text = f"Within 5 % of {room}: {'; '.join(parts)}" if parts else f"No contender stays within 5 % of {room}"
    never = [c.label for c in found.contenders if c.settling is None]
    return f"{text}; never: {', '.join(never)}." if never and parts else f"{text}."


def draw_last(found: Comparison, runs: Mapping[str, Result]) -> tuple[Figure, str]:
    """The error in the last trial, a panel for each counted port, as far as those go that hold the constraint; who is far
    beyond is not drawn, but told."""
    figure, panels = panels_of(found, runs, 2.6)
    styles, beyond, drawn = looks(found), list[str](), set[str]()
    for axes, port in zip(panels, found.counted, strict=True):
        names = port_names(next(iter(runs.values())), port)
        ran = sorted((c for c in found.contenders if c.trials), key=lambda c: -c.peaks[port][-1])
        reach = 1.15 * max([c.peaks[port][-1] for c in ran if c.held] or [ran[0].peaks[port][-1]]) or 1.0
        axes.set_ylim(-reach, reach)
        for one in ran:
            if one.peaks[port][-1] > FAR * reach:
                beyond.append(f"{one.label} goes to {quantity(one.peaks[port][-1], names.motion)} at {names.text}")
                continue
            error = tracking_error(runs[one.label], port, one.trials - 1)
            picked = pick_extremes(error[None], BINS)[0]
            look = {**styles[one.label], "marker": "", "lw": 1.2 if one is found.contenders[0] else 0.8}
            axes.plot(runs[one.label].time[picked], error[picked], **look)
            drawn.add(one.label)
        axes.set_xlim(0, float(next(iter(runs.values())).time[-1]))
        axes.set_xlabel("time in the last trial [s]")
        value_axis(axes, f"error, {names.short}", names.motion)
    legend(figure, found, drawn)
    return figure, last_sentence(found, beyond)


def last_sentence(found: Comparison, beyond: list[str]) -> str:
    """The largest error of the last trial, least first, at each counted port."""
    parts = []
    for port in found.counted:
        order = sorted((c for c in found.contenders if c.held), key=lambda c: c.peaks[port][-1])
        values = [f"{c.label} {number(c.peaks[port][-1], 2)}" for c in order]
        unit = found.ports[port][0]
        parts.append(f"largest |error| of {port.replace('_', ' ')} [{unit}]: {', '.join(values)}" if values else "")
    text = "; ".join(part for part in parts if part)
    text = text[:1].upper() + text[1:]
    return f"{text}." + (f" Not drawn: {'; '.join(beyond)}." if beyond else "")


def panels_of(found: Comparison, runs: Mapping[str, Result], height: float) -> tuple[Figure, list[Axes]]:
    """A wide sheet with a panel for each counted port and room for a legend on the right; further ports below."""
    count, across = len(found.counted), min(2, len(found.counted))
    rows = -(-count // across)
    figure = sheet(DOUBLE, height * rows)
    each = (DOUBLE - LEFT - LEGEND - (across - 1) * GAP) / across
    tall = height - BOTTOM - HEAD
    panels = []
    for i in range(count):
        row, place = divmod(i, across)
        bottom = (rows - 1 - row) * height + BOTTOM
        box = (LEFT + place * (each + GAP)) / DOUBLE, bottom / (rows * height), each / DOUBLE, tall / (rows * height)
        axes = figure.add_axes(box)
        axes.spines[["top", "right"]].set_visible(False)
        panels.append(axes)
    return figure, panels


def legend(figure: Figure, found: Comparison, lines: Collection[str] | None = None) -> None:
    """All contenders in a column on the right, in the order of the table. lines: those that are drawn, as lines without marks."""
    styles = looks(found)
    handles: list[Any] = [
        handle(told(one), styles[one.label], lines is None) for one in found.contenders if lines is None or one.label in lines
    ]
    width, height = figure.get_size_inches()
    figure.legend(
        handles=handles, loc="upper left", bbox_to_anchor=(1 - (LEGEND - 0.06) / width, 1 - (HEAD - 0.06) / height),
        frameon=False, borderpad=0, borderaxespad=0, fontsize=SMALL, handlelength=2.6, handletextpad=0.5, labelspacing=0.55,
    )  # fmt: skip


def told(one: Contender) -> str:
    """A label that says when the constraint is lost."""
    return one.label if one.held else f"{one.label}\n({'diverged' if one.status == 'diverged' else 'constraint lost'})"
