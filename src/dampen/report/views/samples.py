"""A sampled run under the magnifying glass: the commands of some sample periods, what is delivered, what is read."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from dampen.analysis.sampling_cost import chatter
from dampen.report.axes import label_axis, legend_row, panel, sheet, value_axis, value_range
from dampen.report.names import PortNames, port_names
from dampen.report.style import DOTS, INK, SINGLE, colour, plain_number, quantity, tint
from dampen.simulation.result import Result

HEIGHT, LOWER = 3.4, 1.5
PERIODS = 30


def draw_samples(of: str, run: Result, other: Result | None) -> tuple[Figure, str]:
    """Command and delivered force at the port `of` in the 30 sample periods of the last trial in which the command varies most,
    and below them the displacement and its readings."""
    port, last = port_names(run, of), run.trials - 1
    ink, period = colour(port.effort), run.scenario.sampling.period
    issued, reading = (np.asarray(run[name][last])[:, port.index] for name in ("issued", "reading"))
    first, end = liveliest(issued, PERIODS)
    steps = round(period / run.scenario.numerics.step)
    inside, clock = slice(first * steps, end * steps), run.time
    figure = sheet(SINGLE, HEIGHT)
    axes = panel(figure, bottom=LOWER + 0.3, top=0.28)
    below = panel(figure, top=HEIGHT - LOWER - 0.12)
    command, delivered = (np.asarray(run[name][last])[inside, port.index] for name in ("command", "delivered"))
    t, at = clock[first * steps : end * steps + 1], clock[first * steps : end * steps : steps]
    handles = axes.plot(*_stairs(t, command), color=INK, lw=0.8, drawstyle="steps-post", label="command", zorder=3)
    handles += axes.plot(
        *_stairs(t, delivered), color=tint(ink, 0.55), lw=2.2, drawstyle="steps-post", label="delivered", zorder=2
    )
    _limits(axes, command, delivered)
    value_axis(axes, "force" if port.effort == "N" else "torque", port.effort)
    axes.tick_params(labelbottom=False)
    y = np.asarray(run["y"][last])[first * steps : end * steps + 1, port.index]
    held = _stairs(np.append(at, t[-1]), reading[first:end])
    below.plot(*held, color=INK, lw=0.5, ls=DOTS, drawstyle="steps-post", zorder=2)
    handles += below.plot(at, reading[first:end], color=INK, marker="o", ms=1.8, ls="none", label="reading", zorder=4)
    handles += below.plot(t, y, color=colour(port.motion), lw=1.0, label="true", zorder=3)
    _limits(below, y, reading[first:end])
    value_axis(below, port.short, port.motion)
    for each in (axes, below):
        each.set_xlim(float(t[0]), float(t[-1]))
        each.xaxis.set_major_locator(MaxNLocator(5))
    label_axis(below.xaxis, f"time in trial {last}", "s")
    legend_row(figure, handles)
    return figure, _sentence(port, run, of, (float(t[0]), float(t[-1])), reading - _true(run, port, steps))


def liveliest(values: np.ndarray, count: int) -> tuple[int, int]:
    """First and one past the last of `count` neighbouring values among which the total variation is largest."""
    count = min(count, len(values))
    travelled = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(values)))])
    first = int(np.argmax(travelled[count - 1 :] - travelled[: len(values) - count + 1]))
    return first, first + count


def _stairs(t: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Times and values to be drawn as stairs, the last value held to the end."""
    return t, np.append(values, values[-1])


def _limits(axes: Axes, *contents: np.ndarray) -> None:
    low, high, _ = value_range(contents, (), False)
    axes.set_ylim(low - 0.08 * (high - low), high + 0.08 * (high - low))


def _true(run: Result, port: PortNames, steps: int) -> np.ndarray:
    """(samples,) displacements at the sample instants of the last trial."""
    return np.asarray(run["y"][run.trials - 1])[:-1:steps, port.index]


def _sentence(port: PortNames, run: Result, of: str, span: tuple[float, float], error: np.ndarray) -> str:
    last, period = run.trials - 1, run.scenario.sampling.period
    alone = np.asarray(run["command"][last])[:, port.index]
    travelled = float(np.sum(np.abs(np.diff(alone))))
    when = f"between t = {span[0]:.4g} s and {span[1]:.4g} s of trial {last}"
    whole = quantity(chatter(run, of), port.effort)
    text = f"Samples of {plain_number(1000 * period)} ms {when}, where the command varies most. Its total variation is"
    text += f" {quantity(travelled, port.effort)} in this trial and {whole} over the run"
    worst = float(np.abs(error).max())
    return text + (f"; a reading is up to {quantity(worst, port.motion)} off." if worst > 1e-15 else "; readings are exact.")
