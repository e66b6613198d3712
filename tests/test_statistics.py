"""Statistics of robustness studies, against exact indices, against SciPy, and by counting."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pandas as pd
import pytest
from scipy import stats

from dampen.component import ArgumentError
from dampen.studies.samples import saltelli
from dampen.studies.statistics import Indices, proportion, robustness, sobol_indices
from tests.synthetic import StandIn, robust_study

A, B = 7.0, 0.1


def ishigami(x: np.ndarray) -> np.ndarray:
    """Of (rows, 3) points between -pi and pi."""
    return np.sin(x[:, 0]) + A * np.sin(x[:, 1]) ** 2 + B * x[:, 2] ** 4 * np.sin(x[:, 0])


def exact() -> tuple[np.ndarray, np.ndarray]:
    """First-order and total indices of the Ishigami function (Ishigami and Homma 1990)."""
    one, two = 0.5 * (1 + B * np.pi**4 / 5) ** 2, A**2 / 8
    both = B**2 * np.pi**8 * (1 / 18 - 1 / 50)
    return np.array([one, two, 0.0]) / (one + two + both), np.array([one + both, two, both]) / (one + two + both)


def indices(f: Callable[[np.ndarray], np.ndarray], base: int, d: int, sampler: str = "sobol", seed: int = 1) -> Indices:
    values = f(saltelli(base, d, sampler, seed))
    return sobol_indices(values[:base], values[base : 2 * base], values[2 * base :].reshape(d, base), seed)


def on_pi(u: np.ndarray) -> np.ndarray:
    return ishigami(np.pi * (2 * u - 1))


def test_the_indices_of_the_ishigami_function_are_the_exact_ones() -> None:
    found, (first, total) = indices(on_pi, 2**14, 3), exact()
    np.testing.assert_allclose(found.first[:2], first[:2], rtol=0.02)
    np.testing.assert_allclose(found.first[2], 0, atol=0.02)
    np.testing.assert_allclose(found.total, total, rtol=0.02)
    for interval, value in ((found.first_interval, first), (found.total_interval, total)):
        assert np.all((interval[0] < value) & (value < interval[1]))
        assert np.all(np.diff(interval, axis=0) < 0.1)


def test_the_indices_of_a_full_design_are_scipys() -> None:
    base = 256
    values = on_pi(saltelli(base, 3, "sobol", 5)) + 100.0  # a mean far from zero: both must centre
    given = {"f_A": values[None, :base], "f_B": values[None, base : 2 * base], "f_AB": values[2 * base :].reshape(3, 1, base)}
    theirs = stats.sobol_indices(func=given, n=base)
    ours = sobol_indices(given["f_A"][0], given["f_B"][0], given["f_AB"][:, 0], 5)
    np.testing.assert_allclose(ours.first, np.ravel(theirs.first_order), rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(ours.total, np.ravel(theirs.total_order), rtol=1e-9)


def test_rows_with_a_nan_are_left_out_and_counted() -> None:
    base = 512
    a, b, *mixed = np.split(on_pi(saltelli(base, 3, "latin", 2)), 5)
    ab = np.array(mixed)
    keep = np.ones(base, dtype=bool)
    keep[[3, 70, 71, 200]] = False
    want = sobol_indices(a[keep], b[keep], ab[:, keep], 9)
    a[3], b[70], ab[1, 71], ab[0, 200], ab[2, 200] = np.nan, np.nan, np.inf, np.nan, np.nan
    found = sobol_indices(a, b, ab, 9)
    assert (found.rows, found.left_out) == (base - 4, 4)
    for name in ("first", "total", "first_interval", "total_interval"):
        np.testing.assert_array_equal(getattr(found, name), getattr(want, name))


def test_without_variance_or_rows_all_indices_are_zero() -> None:
    for found in (indices(lambda u: np.full(len(u), 0.3), 16, 2), indices(lambda u: np.full(len(u), np.nan), 16, 2)):
        assert not found.first.any()
        assert not found.total.any()
        assert not found.total_interval.any()


@pytest.mark.parametrize("sampler", ["sobol", "latin"])
@pytest.mark.parametrize("d", [1, 20])
def test_the_design_is_a_then_b_then_a_with_one_column_of_b(sampler: str, d: int) -> None:
    base = 64 if sampler == "sobol" else 50
    points = saltelli(base, d, sampler, 4)
    assert points.shape == (base * (d + 2), d)
    assert points.min() >= 0
    assert points.max() < 1
    a, b = points[:base], points[base : 2 * base]
    assert not np.any(a == b)
    for i in range(d):
        mixed = points[(2 + i) * base : (3 + i) * base]
        np.testing.assert_array_equal(mixed[:, i], b[:, i])
        np.testing.assert_array_equal(np.delete(mixed, i, axis=1), np.delete(a, i, axis=1))
    np.testing.assert_array_equal(points, saltelli(base, d, sampler, 4))
    assert np.any(points != saltelli(base, d, sampler, 5))


def test_the_design_says_what_it_cannot_be() -> None:
    with pytest.raises(ArgumentError, match="`base` must be a power of two for Sobol points, but is 100"):
        saltelli(100, 2, "sobol", 0)
    with pytest.raises(ArgumentError, match="`sampler` must be 'sobol' or 'latin', but is 'grid'"):
        saltelli(64, 2, "grid", 0)


def test_a_proportion_is_exact_at_its_ends() -> None:
    none = proportion(0, 1000)
    assert (none.estimate, none.low) == (0, 0)
    assert none.high == pytest.approx(1 - 0.025 ** (1 / 1000))
    assert proportion(10, 10).low == pytest.approx(0.025**0.1)
    assert np.isnan(proportion(0, 0).estimate)


@pytest.mark.parametrize("p", [0.002, 0.05, 0.4])
def test_the_interval_covers_the_true_share_at_least_as_often_as_it_says(p: float) -> None:
    of = 200
    found = [proportion(k, of) for k in range(of + 1)]
    covered = sum(stats.binom.pmf(one.count, of, p) for one in found if one.low <= p <= one.high)
    assert 0.95 <= covered <= 1.0


def test_robustness_counts_only_the_independent_rows() -> None:
    study = robust_study(base=128)
    found, table = robustness(study), study.table
    ab = table[table.member < 256]
    lost = int(ab.status.isin(["constraint_lost", "diverged"]).sum())
    judged = int(ab.status.isin(["complete", "constraint_lost", "diverged"]).sum())
    assert lost > 0
    assert (found.lost.count, found.lost.of) == (lost, judged)
    assert found.left_out == int(ab.status.isin(["refused", "crashed"]).sum()) > 0
    assert found.diverged == int((ab.status == "diverged").sum()) > 0
    assert sum(found.statuses.values()) == len(table)
    counted = ab[ab.status.isin(["complete", "constraint_lost", "diverged"])]
    values = np.sort(np.where(counted.status == "diverged", np.inf, counted["peak"]))
    assert found.quantiles["peak"].values[2] == values[(judged + 1) // 2 - 1]
    assert found.quantiles["peak"].worst == np.inf
    assert found.quantiles["margin"].worst == -np.inf
    assert found.quantiles["margin"].values[0] > found.quantiles["margin"].values[4]
    assert set(found.indices) == {"peak", "residual", "effort", "margin"}
    assert found.indices["peak"].left_out > 0
    assert np.argmax(found.indices["peak"].total) == 0


def test_an_unfinished_study_has_indices_of_its_complete_base_rows() -> None:
    study = robust_study(base=128)
    some = study.table[(study.table.member % 128 < 40) | (study.table.member == 100)]
    found = robustness(StandIn(study.definition, study.members, some))
    assert found.indices["peak"].rows + found.indices["peak"].left_out == 128
    assert 20 < found.indices["peak"].rows <= 40
    only_a = robustness(StandIn(study.definition, study.members, study.table[study.table.member < 100]))
    assert only_a.indices == {}
    assert only_a.lost.of > 0


def test_a_study_that_was_refused_throughout_knows_nothing() -> None:
    study = robust_study(base=8)
    rows = {"member": range(8), "status": ["refused"] * 8, "message": ["no"] * 8}
    found = robustness(StandIn(study.definition, study.members, pd.DataFrame(rows)))
    assert found.lost.of == 0
    assert found.left_out == 8
    assert found.quantiles == {}
    assert found.indices == {}
