"""Sums of plays: the one step function that a Prandtl-Ishlinskii actuator and its inverse share."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from dampen.component import ArgumentError, wrong

PLAYS_AT_MOST = 15


def play_sum_step(command: float, state: np.ndarray, parameters: np.ndarray, new_state: np.ndarray) -> float:
    """B = w_0 u + sum w_i p_i with the plays p_i = min(max(p_i, u - r_i), u + r_i); parameters are those of `play_row`."""
    output = parameters[1] * command
    for i in range(int(parameters[0])):
        radius = parameters[3 + 2 * i]
        play = min(max(state[i], command - radius), command + radius)
        new_state[i] = play
        output += parameters[2 + 2 * i] * play
    return output


def play_row(linear: float, weights: Sequence[float], radii: Sequence[float]) -> tuple[float, ...]:
    """(number of plays, w_0, w_1, r_1, w_2, r_2, ...)."""
    return float(len(weights)), linear, *(number for pair in zip(weights, radii, strict=True) for number in pair)


def check_plays(weights: Sequence[float], radii: Sequence[float]) -> None:
    """Raise ArgumentError unless there is one radius for each weight, and the radii increase."""
    if len(weights) != len(radii):
        raise ArgumentError(
            f"Argument `radii` must have as many members as `weights`, but has {len(radii)} where `weights` has {len(weights)}."
        )
    if len(weights) > PLAYS_AT_MOST:
        raise ArgumentError(f"Argument `weights` must have at most {PLAYS_AT_MOST} members, but has {len(weights)}.")
    if any(a >= b for a, b in pairwise(radii)):
        raise wrong("radii", "increase", tuple(radii))
