"""Barriers against their definitions: inside, across zero between uneven limits, and beyond the edge, where a line goes on."""

from __future__ import annotations

import math
from decimal import Decimal
from typing import Any

import pytest

from dampen.simulation import barrier, log_barrier, tan_barrier
from dampen.simulation.compiled import bind

EDGE, HIGH, LOW = 1 - 1e-12, 0.2, -0.05
PAIRS = [
    (0.5, 1.1),
    (1.1, 0.5),
    (1.1, 1.3),
    (1.3, 1.3),
    (0.999, 1.0),
    (0.3, 0.3),
    (0.3, 0.31),
    (0.3, 0.3003),
    (0.9, 0.95),
    (0.0, 0.6),
]
SIDES = [(1, 1), (-1, -1), (1, -1), (-1, 1)]


def log_v(y: float, limit: float) -> Decimal:
    edge, c = Decimal(EDGE * limit), Decimal(limit)
    inside = min(Decimal(abs(y)), edge)
    logarithm = -(1 - (inside / c) ** 2).ln()
    slope = edge * -(1 - (edge / c) ** 2).ln() / (c * c - edge * edge)
    return logarithm**2 / 4 + slope * (Decimal(abs(y)) - inside)


def tan_v(y: float, limit: float) -> Decimal:
    edge, c = Decimal(EDGE * limit), Decimal(limit)
    inside = min(Decimal(abs(y)), edge)

    def away(x: Decimal) -> float:  # pi / 2 - a, from the distance to the limit
        return math.pi / 2 * float(1 - (x / c) ** 2)

    if inside < edge:
        return Decimal(math.tan(math.pi / 2 * float((inside / c) ** 2)) / math.pi)
    slope = float(edge / (c * c)) / math.sin(away(edge)) ** 2
    return Decimal(1 / math.tan(away(edge)) / math.pi + slope * float(Decimal(abs(y)) - inside))


SHAPES: dict[str, tuple[Any, Any]] = {"log": (log_barrier, log_v), "tan": (tan_barrier, tan_v)}


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("sides", SIDES)
@pytest.mark.parametrize("pair", PAIRS)
def test_the_discrete_gradient_is_the_quotient_of_the_potential(
    pair: tuple[float, float], sides: tuple[int, int], shape: str
) -> None:
    module, v = SHAPES[shape]
    shaped = {name: getattr(module, name) for name in ("gradient", "carried", "fresh", "potential")}
    gradient = bind(barrier.barrier_gradient, **shaped)
    y, y_new = (share * (HIGH if side > 0 else -LOW) * side for share, side in zip(pair, sides, strict=True))
    limits = [HIGH if x >= 0 else -LOW for x in (y, y_new)]
    memo = bind(barrier.fresh_memo, **shaped)(y, LOW, HIGH)
    digits = 0.0  # what a difference of two equal heights has lost
    if y == y_new:
        step = 1e-6 * abs(y)
        expected = float(v(y + step, limits[0]) - v(y - step, limits[0])) / (2 * step)
    else:
        expected = float(v(y_new, limits[1]) - v(y, limits[0])) / (y_new - y)
        digits = 1e-15 * float(v(y, limits[0]) + v(y_new, limits[1])) / abs(y_new - y)
    assert gradient(y, y_new, memo, LOW, HIGH) == pytest.approx(expected, rel=1e-9, abs=digits)
    for x, limit in zip((y, y_new), limits, strict=True):
        assert module.potential(x, limit) == pytest.approx(float(v(x, limit)), rel=1e-10)


@pytest.mark.parametrize("sides", SIDES)
@pytest.mark.parametrize("pair", PAIRS)
def test_what_is_carried_from_step_to_step_is_the_logarithm(pair: tuple[float, float], sides: tuple[int, int]) -> None:
    """Where it is used: within the edge."""
    y, y_new = (share * (HIGH if side > 0 else -LOW) * side for share, side in zip(pair, sides, strict=True))
    memo = barrier.barrier_memo(y_new, y, barrier.fresh_memo(y, LOW, HIGH), LOW, HIGH)
    if pair[1] < 1:
        limit = HIGH if y_new >= 0 else -LOW
        assert memo == pytest.approx(2 * math.sqrt(log_v(y_new, limit)), rel=1e-13, abs=1e-15)


def test_from_zero_a_step_to_either_side_begins_with_that_side_s_limit() -> None:
    for y_new, limit in ((0.1, HIGH), (-0.03, -LOW)):
        assert barrier.barrier_memo(y_new, 0.0, 0.0, LOW, HIGH) == pytest.approx(2 * math.sqrt(log_v(y_new, limit)), rel=1e-13)
        assert barrier.barrier_gradient(0.0, y_new, 0.0, LOW, HIGH) == pytest.approx(
            float(log_v(y_new, limit)) / y_new, rel=1e-12
        )
        assert barrier.barrier_gradient(y_new, 0.0, barrier.fresh_memo(y_new, LOW, HIGH), LOW, HIGH) == pytest.approx(
            float(log_v(y_new, limit)) / y_new, rel=1e-12
        )


def test_a_step_to_zero_leaves_nothing_of_the_other_side_s_logarithm() -> None:
    for y in (0.1, -0.03, 1e-4, -1e-5):
        assert barrier.barrier_memo(0.0, y, barrier.fresh_memo(y, LOW, HIGH), LOW, HIGH) == 0.0


def test_the_series_of_small_steps_is_atanh_to_the_last_digits() -> None:
    for z in (1e-9, 3e-4, 9.99e-4):
        assert log_barrier.atanh_ratio(z * z) == pytest.approx(math.atanh(z) / z, rel=5e-16, abs=0.0)


@pytest.mark.parametrize("d", [9.9e-4, -9.9e-4, 3e-4, 1e-9])
def test_the_series_of_small_steps_of_the_tan_barrier_is_the_sine_to_the_last_digits(d: float) -> None:
    y = 0.5
    y_new = math.sqrt(y * y + d / (math.pi / 2))
    d = math.pi / 2 * (y_new - y) * (y_new + y)
    found = tan_barrier.gradient(y, y_new, 0.0, 1.0)
    ratio = found * 2 * tan_barrier.cosine_of(y, 1.0) * tan_barrier.cosine_of(y_new, 1.0) / (y + y_new)
    assert ratio == pytest.approx(math.sin(d) / d, rel=1e-15, abs=0.0)
