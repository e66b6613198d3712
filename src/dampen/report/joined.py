"""What the views read of a result: signals over all trials, joined in time and decimated so that no peak is lost."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from dampen.report.style import COLUMNS
from dampen.simulation.result import Result

Array = np.ndarray
BLOCK = 2**22


def uncontrolled(run: Result) -> bool:
    """Whether nothing was commanded in this run."""
    return run.scenario.controller.kind == "none"


def duration(run: Result) -> float:
    """Duration of a trial [s]."""
    return float(run.scenario.task.trial_duration)


def blocks(run: Result, name: str, at: Any = (), trials: int | None = None) -> Iterator[tuple[int, Array]]:
    """(first trial, values of some trials), block by block: memory does not grow with the number of trials."""
    shape = run.layout.shape(run.layout.variables[name])
    size = max(1, BLOCK // max(1, int(np.prod(shape))))
    end = run.trials if trials is None else trials
    for first in range(0, end, size):
        values = run[name][first : min(first + size, end)]
        yield first, np.asarray(values)[..., at] if at != () else np.asarray(values)


def trial_peaks(run: Result, name: str, at: Any = ()) -> Array:
    """(trials,) largest modulus of a signal in each trial."""
    parts = [np.abs(values).reshape(len(values), -1).max(axis=1) for _, values in blocks(run, name, at)]
    return np.concatenate(parts)


def extremes(run: Result, name: str, at: Any = ()) -> tuple[Array, Array]:
    """Times [s] and values of a signal over all trials, joined; per bin of time the least and the greatest value.

    Both are kept at their own instants, in the order of time. Bins never straddle two trials while there are fewer trials
    than columns to draw in.
    """
    kind = run.layout.variables[name].dims[0]
    return joined(run, blocks(run, name, at), run.layout.coordinates[kind][1])


def joined(run: Result, parts: Iterable[tuple[int, Array]], clock: Array) -> tuple[Array, Array]:
    """`extremes` of signals given as (first trial, values of some trials), block by block, on this clock of a trial."""
    times, values = [], []
    for first, part in parts:
        t = clock + duration(run) * np.arange(first, first + len(part))[:, None]
        picked = pick_extremes(part, max(1, -(-COLUMNS // run.trials)))
        times.append(np.take_along_axis(t, picked, axis=1).ravel())
        values.append(np.take_along_axis(part, picked, axis=1).ravel())
    t, y = np.concatenate(times), np.concatenate(values)
    if len(y) > 4 * COLUMNS:
        keep = pick_extremes(y[None], COLUMNS)[0]
        t, y = t[keep], y[keep]
    return t, y


def gapped(run: Result, t: Array, y: Array) -> tuple[Array, Array]:
    """A joined signal, parted where it jumps between the end of a trial and the start of the next: no line to draw there."""
    jumps = np.flatnonzero((np.diff(t) <= 1e-9 * duration(run)) & (np.diff(y) != 0)) + 1
    return np.insert(t, jumps, t[jumps]), np.insert(y, jumps, np.nan)


def pick_extremes(values: Array, bins: int) -> Array:
    """(rows, kept) indices of the least and greatest value in each of `bins` parts of every row, and of the row's ends."""
    rows, n = values.shape
    width = -(-n // bins)
    if width <= 2:
        return np.broadcast_to(np.arange(n), (rows, n))
    pad = -n % width
    padded = np.concatenate([values, np.broadcast_to(values[:, -1:], (rows, pad))], axis=1).reshape(rows, -1, width)
    start = np.arange(padded.shape[1]) * width
    pair = np.sort(np.stack([padded.argmin(axis=2) + start, padded.argmax(axis=2) + start], axis=2), axis=2)
    inner = np.minimum(pair.reshape(rows, -1), n - 1)
    return np.concatenate([np.zeros((rows, 1), int), inner, np.full((rows, 1), n - 1)], axis=1)


def field_columns(run: Result, name: str, trials: int) -> Array:
    """(columns, x) of a field over the first trials, joined in time: per column and place the value of largest modulus."""
    parts = []
    for _, values in blocks(run, name, trials=trials):
        parts.append(strongest(values[:, :-1], max(1, COLUMNS // trials)).reshape(-1, values.shape[2]))
    columns = np.concatenate(parts)
    if len(columns) > 2 * COLUMNS:
        columns = strongest(columns[None], COLUMNS)[0]
    return columns


def strongest(values: Array, bins: int) -> Array:
    """(trials, bins, x): per bin of time the signed value of largest modulus. Uneven bins overlap by one snapshot at most."""
    n = values.shape[1]
    bins = min(bins, n)
    width = -(-n // bins)
    start = np.linspace(0, n - width, bins).round().astype(int)
    grouped = values[:, start[:, None] + np.arange(width)]
    high, low = grouped.max(axis=2), grouped.min(axis=2)
    signed: Array = np.where(high >= -low, high, low)
    return signed


def largest(run: Result, name: str) -> tuple[float, int, float, float]:
    """Largest modulus of a field's snapshots, its trial, its time in the joined run [s] and its place [m]."""
    best = (-1.0, 0, 0.0, 0.0)
    for first, values in blocks(run, name):
        flat = int(np.abs(values).argmax())
        j, k, i = np.unravel_index(flat, values.shape)
        value = float(abs(values[j, k, i]))
        if value > best[0]:
            trial = first + int(j)
            best = (value, trial, trial * duration(run) + float(run.time_out[k]), float(run.x[i]))
    return best
