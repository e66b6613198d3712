"""Where the samples of a study lie: points of the unit cube, and what axes make of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dampen.component import wrong
from dampen.studies.variation import Axis

Array = np.ndarray


def saltelli(base: int, dimensions: int, sampler: str, seed: int) -> Array:
    """(base * (d + 2), d) points in [0, 1): `base` rows of A, as many of B, then for each i those of A with column i of B.

    A and B are the halves of one design in 2 d dimensions, as Saltelli et al. (2010), section 5, advise.
    sampler: "sobol", scrambled, whose base must be a power of two, or "latin".
    """
    from scipy.stats import qmc

    if sampler not in ("sobol", "latin"):
        raise wrong("sampler", "be 'sobol' or 'latin'", sampler)
    if base < 1 or (sampler == "sobol" and base & (base - 1)):
        raise wrong("base", "be a power of two for Sobol points" if sampler == "sobol" else "be >= 1", base)
    # a generator, not a number: SciPy has renamed the argument, and under either name means the same by a generator
    rng = np.random.default_rng(seed)
    if sampler == "sobol":
        points = qmc.Sobol(2 * dimensions, scramble=True, seed=rng).random(base)
    else:
        points = qmc.LatinHypercube(2 * dimensions, seed=rng).random(base)
    a, b = points[:, :dimensions], points[:, dimensions:]
    mixed = np.repeat(a[None], dimensions, axis=0)
    for i in range(dimensions):
        mixed[i, :, i] = b[:, i]
    return np.concatenate([a, b, mixed.reshape(-1, dimensions)])


def latin(count: int, dimensions: int, seed: int) -> Array:
    """(count, d) points of a Latin hypercube."""
    from scipy.stats import qmc

    return np.asarray(qmc.LatinHypercube(dimensions, seed=np.random.default_rng([seed, 1])).random(count))


def sampled(axes: Sequence[Axis], points: np.ndarray) -> list[dict[str, Any]]:
    """Points of the unit cube, (members, axes), as what the axes take."""
    taken = [axis.at(points[:, i]) for i, axis in enumerate(axes)]
    return [{axis.name: column[i].item() for axis, column in zip(axes, taken, strict=True)} for i in range(len(points))]
