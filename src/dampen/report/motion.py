"""What became of a run in sentences: the motion of its ports, and what it took."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dampen.analysis.at_limit import share_at_limit, share_of_command
from dampen.analysis.audit.sticking import driven
from dampen.analysis.metrics import error_peaks, first_beyond, fraction_of_limit
from dampen.analysis.sampling_cost import effort
from dampen.report.joined import trial_peaks
from dampen.report.limits import limits_of
from dampen.report.names import course, port_names, tracked
from dampen.report.style import MINUS, number, percent, quantity, ranges
from dampen.simulation.result import Result


def in_words(run: Result, baseline: Result | None, frequencies: Sequence[float]) -> list[str]:
    """What the structure is [Hz], how its ports moved, and with what forces: a line each."""
    lines = [f"Lowest frequencies: {', '.join(number(f) for f in frequencies[:3])} Hz."]
    lines += [port_in_words(run, of, baseline) for of in run.scenario.ports]
    for index in driven(run):
        of = run.scenario.ports[index]
        port, largest = port_names(run, of), float(trial_peaks(run, "delivered", index).max())
        if largest == 0:
            continue
        spent = f"{quantity(effort(run, of), port.effort)} RMS, {quantity(largest, port.effort)} at most"
        lines.append(f"{port.effort_words.capitalize()} at {of}: {spent}{limited(run, of)}.")
    return lines


def limited(run: Result, of: str) -> str:
    """How often the actuator at a port, or the command of a sampled law, stood at its limit; "" where there is none."""
    text = ""
    for share, whose in ((share_at_limit(run, of), ""), (share_of_command(run, of), "its command ")):
        if share is not None:
            text += f", {whose}at its limit in {percent(share)} of the steps" if share else f", {whose}never at its limit"
    return text


def port_in_words(run: Result, of: str, behind: Result | None = None) -> str:
    """The largest motion or error at the port `of` along the trials, its constraint, and the same in the run without control."""
    port, limits, follows = port_names(run, of), limits_of(run.scenario, of), tracked(run, of)
    peaks = error_peaks(run, of) if follows else trial_peaks(run, "y", port.index)
    text = f"The largest error |{port.text} {MINUS} reference|" if follows else f"The largest |{port.text}|"
    if run.trials == 1:
        text += f" is {quantity(peaks[0], port.motion)} in the only trial"
    else:
        text += course(peaks, port.motion, " of a trial")
    if limits is not None:
        text += f"; {limits.words} {against(run, of)}"
    if behind is not None:
        grey = error_peaks(behind, of) if follows else trial_peaks(behind, "y", port.index)
        text += f". Without control it is {quantity(grey[-1], port.motion)} in trial {behind.trials - 1}"
        text += f", and {quantity(grey.max(), port.motion)} at its largest"
    return text + "."


def against(run: Result, of: str) -> str:
    """What became of the constraint: kept with what margin, or broken when and by how much."""
    shares, beyond = fraction_of_limit(run, of), first_beyond(run, of)
    if beyond is None:
        return f"is never reached, the margin is {percent(1 - shares.max())}"
    broken = np.flatnonzero(shares >= 1)
    when = f"trial {broken[0]}" if len(broken) == 1 else f"{len(broken)} of {len(shares)} trials"
    which = f" ({ranges(broken.tolist())})" if 1 < len(broken) < len(shares) else ""
    trial, t = beyond
    at = f"first at t = {t + trial * float(run.scenario.task.trial_duration):.4g} s"
    return f"is broken in {when}{which}, {at}, by {percent(shares.max() - 1)} at most"
