"""The forces that are best for one weight: an exact factorisation by the Riccati recursion, and two sweeps through it.

With the gains K and the matrices S of the recursion, and L: u -> u + K z(u) for the motion z(u) that u excites from rest,

    P* P + weight 1 = L* S L,

so that two sweeps of the closed loop solve for all steps at once, L* backwards and L forwards: the innovations form (Anderson &
Moore, Optimal Control: Linear Quadratic Methods, 1990; Kailath, Sayed & Hassibi, Linear Estimation, 2000).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from dampen.analysis.limit.lifted import Lifted
from dampen.analysis.limit.recursions import BLOCKS, factorise, sweep_back, sweep_forward
from dampen.simulation.compiled import compiled

Array = np.ndarray
KEPT = 160 * 2**20  # bytes of gains that are kept for one weight: beyond it those of each trial are found twice
CARRIED = ("m11", "m12", "m21", "m22")
Gains = tuple[Array, Array]


def solve(lifted: Lifted, weight: float, slopes: Array, keep: int = KEPT) -> Array:
    """(P* P + weight 1)^-1 slopes, (trials, steps, usable ports).

    weight: > 0, what the mean square of the effort is multiplied with [unit^2/N^2].   slopes: as what is returned.
    """
    recursion, roomy = Recursion(lifted, weight), gains_size(lifted) <= keep
    found, slopes, modal, ports = np.empty_like(slopes), slopes.copy(), lifted.modal(), lifted.ports()
    own = range(lifted.trials) if lifted.chained else [0] * lifted.trials  # whose gains a trial has
    kept: dict[int, Gains] = {}
    begun: dict[int, Array] = {}
    for j in lifted.backwards:
        lifted.begin(modal)
        if own[j] not in kept:
            begun[j] = recursion.state()
            kept = {**(kept if roomy else {}), own[j]: recursion.trial()}
        compiled(sweep_back)(modal, ports, *kept[own[j]], slopes[j], found[j])
    modal = lifted.modal()
    for j in range(lifted.trials):
        lifted.begin(modal)
        if own[j] not in kept:
            recursion.go_back_to(begun[j])
            kept = {j: recursion.trial()}
        compiled(sweep_forward)(modal, ports, kept[own[j]][0], found[j])
    return found


def gains_size(lifted: Lifted) -> int:
    """Bytes that the gains of one weight take, if all are kept."""
    different, count = lifted.trials if lifted.chained else 1, len(lifted.usable)
    return 8 * different * lifted.steps * count * (2 * lifted.bench.modes.count + count)


class Recursion:
    """The Riccati recursion for one weight, trial after trial in reverse; it begins with nothing to come after the last."""

    def __init__(self, lifted: Lifted, weight: float):
        self.lifted, self.weight = lifted, weight
        self.modal, self.ports = lifted.modal(), lifted.ports()
        self.blocks: Any = np.zeros(lifted.bench.modes.count, BLOCKS).view(np.recarray)
        self.weighting = lifted.share * lifted.outputs.T @ lifted.outputs

    def trial(self) -> Gains:
        """Gains (steps, ports, 2, modes) and inverses of S, (steps, ports, ports), of the trial before."""
        n, count, steps, every = len(self.blocks), len(self.ports), self.lifted.steps, self.lifted.measure.every
        gains, inverses = np.empty((steps, count, 2, n)), np.empty((steps, count, count))
        scratch = np.empty((count, count))
        compiled(factorise)(self.modal, self.ports, self.blocks, self.weighting, every, self.weight, gains, inverses, scratch)
        return gains, inverses

    def state(self) -> Array:
        """Where the recursion is: P, (4, modes, modes), its lower half."""
        return np.stack([self.blocks[name][:, : len(self.blocks)] for name in CARRIED])

    def go_back_to(self, state: Array) -> None:
        """Be where `state` was taken."""
        for name, values in zip(CARRIED, state, strict=True):
            self.blocks[name][:, : len(self.blocks)] = values
