"""Sums of spectral lines: sinusoids, and noise made of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from dampen.component import ArgumentError, wrong

Array = np.ndarray
BLOCK = 2**20
EVEN = 1e-7  # of a step: what a grid's times may be off
FEWEST, PER_TRIAL = 32, 4  # lines of endless noise: at least, and for each that a trial can tell apart


@dataclass(frozen=True)
class Lines:
    """sum_k Re[c_k exp(2 pi i f_k t)], with frequencies f [Hz] and complex amplitudes c, (lines,) each."""

    frequency: Array
    amplitude: Array

    def at(self, t: Array) -> Array:
        """(times,) values; on an even grid by products of few exponentials, exp(i a (t + s)) = exp(i a t) exp(i a s)."""
        rate, block = 2j * np.pi * self.frequency, int(np.sqrt(len(t)))
        if not _even(t):
            parts = np.array_split(t, max(1, len(t) * len(rate) // BLOCK))
            return np.concatenate([(np.exp(np.multiply.outer(part, rate)) @ self.amplitude).real for part in parts])
        coarse = np.exp(np.outer(t[::block], rate)) * self.amplitude
        fine = np.exp(np.outer(t[:block] - t[0], rate))
        return np.asarray((coarse @ fine.T).real.ravel()[: len(t)])


def cosines(frequencies: Sequence[float], amplitudes: Sequence[float], phases: Sequence[float]) -> Lines:
    """sum_k A_k cos(2 pi f_k t + p_k); without phases, p_k = 0."""
    phase = np.array(phases or [0.0] * len(frequencies))
    return Lines(np.array(frequencies, float), np.array(amplitudes) * np.exp(1j * phase))


def noise(low: float, high: float, rms: float, duration: float, seed: Sequence[int], endless: bool = False) -> Lines:
    """Noise between two frequencies: lines of equal strength and random phase, whose mean square is rms^2.

    Lines lie at multiples of 1/duration, so that over a duration band and RMS hold exactly (without one in the band, a single
    line in its middle). `endless` noise must not repeat after a duration: its lines lie closer, and each by chance in its own
    part of the band, so that the RMS holds in the long run.
    """
    random = np.random.default_rng(list(seed))
    if endless:
        count = max(FEWEST, int(np.ceil(PER_TRIAL * (high - low) * duration)))
        frequency = low + (np.arange(count) + random.random(count)) * (high - low) / count
    else:
        first, last = max(1, np.ceil(low * duration - 1e-9)), np.floor(high * duration + 1e-9)
        frequency = np.arange(first, last + 1) / duration if last >= first else np.array([(low + high) / 2])
    phase = 2 * np.pi * random.random(len(frequency))
    return Lines(frequency, rms * np.sqrt(2 / len(frequency)) * np.exp(1j * phase))


def check_lines(frequencies: Sequence[float], phases: Sequence[float], amplitudes: dict[str, Sequence[float]]) -> None:
    """Raise ArgumentError unless there is one amplitude, and one phase or none, for each frequency."""
    count = f"{len(frequencies)} frequencies" if len(frequencies) != 1 else "one frequency"
    for name, given in amplitudes.items():
        if len(given) != len(frequencies):
            raise wrong(name, f"have one number for each of {count}", tuple(given))
    if phases and len(phases) != len(frequencies):
        raise wrong("phases", f"have one number for each of {count}, or none at all", tuple(phases))


def check_band(low: float, high: float) -> None:
    """Raise ArgumentError unless low < high."""
    if not low < high:
        raise ArgumentError(f"Argument `low` must be < `high`, {high:g} Hz, but is {low:g}.")


def _even(t: Array) -> bool:
    if len(t) < 3:
        return False
    step = (t[-1] - t[0]) / (len(t) - 1)
    return bool(step > 0 and np.max(np.abs(t - t[0] - step * np.arange(len(t)))) <= EVEN * step)
