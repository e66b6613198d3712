"""Statistics of a robustness study: how often the constraint is lost, what the outcome depends on.

Sobol indices are estimated here and not by scipy.stats.sobol_indices, since that refuses a design with rows missing, and a
member may diverge, be refused or not be done yet. On a full design both agree, which a test holds.

Source: A. Saltelli, P. Annoni, I. Azzini, F. Campolongo, M. Ratto, S. Tarantola, "Variance based sensitivity analysis of
model output. Design and estimator for the total sensitivity index", Comput. Phys. Commun. 181 (2010) 259-270.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dampen.arguments import STUDY, takes
from dampen.component import wrong
from dampen.studies.rows import JUDGED, LOST, Array, by_member, column, counts, statuses

if TYPE_CHECKING:
    from dampen.studies.study import Study

RESAMPLES, AT_ONCE = 1000, 100
LEVEL = 0.95
FEWEST = 32  # base rows below which indices would be noise
FRACTIONS = (0.05, 0.25, 0.5, 0.75, 0.95)
EXPLAINED = ("peak", "residual", "effort", "margin")


@dataclass(frozen=True)
class Proportion:
    """A share of all cases, and its confidence interval; nan where there was no case."""

    count: int
    of: int
    estimate: float
    low: float
    high: float


@dataclass(frozen=True)
class Indices:
    """Sobol indices of one output. first, total: (d,).   first_interval, total_interval: (2, d) 95 % intervals.

    rows: base rows that were used.   left_out: those of which a value is missing.
    """

    first: Array
    total: Array
    first_interval: Array
    total_interval: Array
    rows: int
    left_out: int


@dataclass(frozen=True)
class Quantiles:
    """Values of a merit by FRACTIONS, and the worst; infinite where a motion diverged, which is worse than any number."""

    values: tuple[float, ...]
    worst: float


@dataclass(frozen=True)
class Robustness:
    """What a robustness study has found so far.

    statuses:  rows of each status, of the whole design.
    lost:      share of the independent samples that lost the constraint or diverged.   diverged: how many of those diverged.
    left_out:  independent samples that were refused or crashed: they count nowhere else.
    quantiles: by merit, of the independent samples.   indices: by merit; empty while no base row is complete.
    """

    statuses: dict[str, int]
    lost: Proportion
    diverged: int
    left_out: int
    quantiles: dict[str, Quantiles]
    indices: dict[str, Indices]


def sobol_indices(values_A: Array, values_B: Array, values_AB: Array, seed: int) -> Indices:
    """First-order and total indices of one output, with intervals by bootstrap over the base rows.

    With f_A, f_B (N,) and f_AB^i, (d, N), all less their mean over A and B, and V = var(f_A, f_B):

        S_i  = 1/N sum_j f_B,j (f_AB^i,j - f_A,j) / V       (2010, Table 2 b)
        ST_i = 1/(2 N) sum_j (f_A,j - f_AB^i,j)^2 / V       (2010, Table 2 f; Jansen 1999)

    Rows with a nan in any of them are left out. Without variance, or with less than two rows, all are zero.
    """
    whole = np.isfinite(values_A) & np.isfinite(values_B) & np.isfinite(values_AB).all(axis=0)
    a, b, mixed = values_A[whole], values_B[whole], values_AB[:, whole].T
    rows, d = mixed.shape
    spread = float(np.var([a, b])) if rows else 0.0
    if rows < 2 or spread <= 1e-24 * float(np.mean([a**2, b**2])):
        zeros = np.zeros(d)
        return Indices(zeros, zeros, np.zeros((2, d)), np.zeros((2, d)), rows, len(whole) - rows)
    middle = float(np.mean([a, b]))
    terms = _terms(a - middle, b - middle, mixed - middle)
    first, total = _estimate(terms.mean(axis=0)[None], d)
    again = [_estimate(weights @ terms / rows, d) for weights in _resamples(rows, seed)]
    tails = ((1 - LEVEL) / 2, (1 + LEVEL) / 2)
    firsts, totals = (np.nanquantile(np.concatenate([pair[k] for pair in again]), tails, axis=0) for k in (0, 1))
    return Indices(first[0], total[0], firsts, totals, rows, len(whole) - rows)


def _terms(a: Array, b: Array, mixed: Array) -> Array:
    """(rows, 3 d + 2) what both estimators are means of, row by row, so that a bootstrap is one matrix product."""
    moved = mixed - a[:, None]
    return np.column_stack([b[:, None] * moved, moved, moved**2, (a + b) / 2, (a**2 + b**2) / 2])


def _estimate(means: Array, d: int) -> tuple[Array, Array]:
    """(samples, d) both indices from means of the terms, centred anew about each sample's own mean."""
    product, moved, square = means[:, :d], means[:, d : 2 * d], means[:, 2 * d : 3 * d]
    middle = means[:, -2, None]
    variance = means[:, -1, None] - middle**2
    with np.errstate(divide="ignore", invalid="ignore"):
        variance = np.where(variance > 0, variance, np.nan)
        return (product - middle * moved) / variance, square / 2 / variance


def _resamples(rows: int, seed: int) -> Iterator[Array]:
    """(AT_ONCE, rows) how often each row occurs in resamples with replacement; in parts, since N x 1000 may be large."""
    rng = np.random.default_rng(seed)
    for _ in range(RESAMPLES // AT_ONCE):
        drawn = rng.integers(rows, size=(AT_ONCE, rows))
        yield np.stack([np.bincount(one, minlength=rows) for one in drawn]).astype(float)


def proportion(count: int, of: int, level: float = LEVEL) -> Proportion:
    """The share count / of with its exact interval (Clopper and Pearson 1934).

    It holds for independent samples. Sobol points and Latin hypercubes are spread more evenly than these, for which it is as a
    rule wider than it need be, though nothing guarantees that for a share.
    """
    from scipy.stats import binomtest

    if not of:
        return Proportion(0, 0, np.nan, 0.0, 1.0)
    interval = binomtest(count, of).proportion_ci(level, method="exact")
    return Proportion(count, of, count / of, float(interval.low), float(interval.high))


@takes(study=STUDY)
def robustness(study: Study) -> Robustness:
    """How often the constraint is lost, how large the merits are, and which parameters they depend on, as far as is known.

    Shares and quantiles are of the rows of A and B only: these are independent samples of the uncertain parameters, while
    each row of an AB repeats all values but one of a row of A, and would count it again.
    """
    if study.definition.kind != "robust":
        raise wrong("study", "be one of `robust`", study.definition.kind)
    base, members = study.definition.base, np.asarray(study.table["member"], dtype=int)
    found = statuses(study)
    independent = members < 2 * base
    judged = independent & np.isin(found, JUDGED)
    lost = judged & np.isin(found, LOST)
    return Robustness(
        statuses=counts(study),
        lost=proportion(int(lost.sum()), int(judged.sum())),
        diverged=int((judged & (found == "diverged")).sum()),
        left_out=int((independent & ~judged).sum()),
        quantiles={name: _quantiles(study, name, judged) for name in main_merits(study)} if judged.any() else {},
        indices={name: one for name in EXPLAINED if (one := merit_indices(study, name)) is not None},
    )


def main_merits(study: Study) -> list[str]:
    """The columns that are worth a row in a table: peak, residual, margin, effort, of all ports and of each; and energy."""
    from dampen.analysis.merits import columns

    names = [n for n in columns(study.definition.scenario) if n.partition(".")[0] in (*EXPLAINED, "energy")]
    names.sort(key=lambda name: "." in name)
    return [name for name in names if np.isfinite(column(study, name)).any()]


def _quantiles(study: Study, name: str, rows: Array) -> Quantiles:
    """Fractions from good to bad; of real members' values, not between two of them, since a value may be infinite."""
    from dampen.analysis.merits import merit

    sign = float(merit(name).sign)
    diverged = statuses(study) == "diverged"
    values = sign * np.where(diverged, sign * np.inf, column(study, name))[rows]
    values = values[~np.isnan(values)]
    found = np.quantile(values, [*FRACTIONS, 1.0], method="inverted_cdf") if len(values) else np.full(len(FRACTIONS) + 1, np.nan)
    return Quantiles(tuple(float(sign * v) for v in found[:-1]), float(sign * found[-1]))


def merit_indices(study: Study, name: str) -> Indices | None:
    """Sobol indices of a merit from the base rows that are complete; None if there is none, or no such design or column."""
    base, d = study.definition.base, len(study.definition.axes)
    if name not in study.table.columns or base < 1 or study.members < base * (d + 2):
        return None
    ran = np.isin(statuses(study), ("complete", "constraint_lost"))  # a diverged motion's margin is a number without meaning
    values = by_member(study, np.where(ran, column(study, name), np.nan))[: base * (d + 2)]
    found = sobol_indices(values[:base], values[base : 2 * base], values[2 * base :].reshape(d, base), study.definition.seed)
    return found if found.rows >= FEWEST else None
