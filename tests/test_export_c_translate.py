"""Scalar Python as C99: the same numbers to the bit, and a clear refusal of what cannot be written."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable
from pathlib import Path
from types import FunctionType
from typing import Any

import numpy as np
import pytest

from dampen.component import ArgumentError
from dampen.controllers.lqg import lqg_step
from dampen.export.c.numbers import literal
from dampen.export.c.source import ARRAYS, HELPERS
from dampen.export.c.translate import Translator
from dampen.plays import play_row, play_sum_step
from dampen.simulation import log_barrier, tan_barrier
from dampen.simulation.barrier import barrier_gradient, barrier_memo, fresh_memo
from dampen.simulation.compiled import bind
from dampen.simulation.digital import Sample
from tests.c_bench import COMPILERS, compile_c

pytestmark = pytest.mark.skipif(not COMPILERS, reason="no C compiler here")

HEAD = "#include <math.h>\ntypedef double real;\n#define DAMPEN_PORTS 2\n"
SAMPLE = f"struct sample {{ const real *{', *'.join(Sample._fields)}; }};\n"


def in_c(function: Callable[..., Any], folder: Path) -> Any:
    """A function of numbers that returns one, from C."""
    translator = Translator({"command": "DAMPEN_PORTS"}, ARRAYS)
    name = translator.add(function).name
    text = translator.text.replace("static ", "")
    helpers = [helper.replace("static ", "") for key, helper in HELPERS.items() if f"{key}(" in text]
    declared = [line + ";" for line in text.splitlines() if line.startswith(("real ", "void "))]
    file = folder / f"{name}.c"
    file.write_text("\n".join([HEAD, SAMPLE, *helpers, *declared, text, ""]))
    compile_c(COMPILERS[0], ("-O2", "-shared", "-fPIC"), [file], folder / f"{name}.so")
    found = getattr(ctypes.CDLL(str(folder / f"{name}.so")), name)
    found.restype = ctypes.c_double
    return found


def doubles(*values: float) -> list[ctypes.c_double]:
    return [ctypes.c_double(value) for value in values]


SHAPES = {"log": log_barrier, "tan": tan_barrier}


@pytest.mark.parametrize("shape", list(SHAPES))
@pytest.mark.parametrize("limits", [(-0.2, 0.2), (-0.3, 0.1)])
def test_both_barriers_are_the_same_to_the_bit_inside_and_beyond_their_edge(
    shape: str, limits: tuple[float, float], tmp_path: Path
) -> None:
    names = {name: getattr(SHAPES[shape], name) for name in ("carried", "fresh", "gradient", "potential")}
    gradient, memo = bind(barrier_gradient, **names), bind(fresh_memo, **names)
    carried = bind(barrier_memo, **names)
    gradient_c, memo_c, carried_c = (in_c(f, tmp_path) for f in (gradient, memo, carried))
    low, high = limits
    numbers = np.random.default_rng(1)
    places = [*numbers.uniform(1.2 * low, 1.2 * high, 300), 0.0, low, high, high * (1 - 1e-13), low * (1 - 1e-9)]
    for y, step in zip(places, numbers.choice([0.0, 1e-9, 1e-3, -0.1], len(places)), strict=True):
        y, y_new = float(y), float(y + step)
        kept = memo(y, low, high)
        assert memo_c(*doubles(y, low, high)) == kept
        assert gradient_c(*doubles(y, y_new, kept, low, high)) == gradient(y, y_new, kept, low, high)
        assert carried_c(*doubles(y_new, y, kept, low, high)) == carried(y_new, y, kept, low, high)


def test_arrays_and_whole_numbers_are_the_same_in_a_sum_of_plays(tmp_path: Path) -> None:
    step = in_c(play_sum_step, tmp_path)
    row, state = np.array(play_row(0.7, (0.2, 0.1), (0.1, 0.3))), np.array([0.05, -0.2])
    for command in np.linspace(-1, 1, 41):
        here, there = np.zeros(2), np.zeros(2)
        expected = play_sum_step(float(command), state, row, here)
        pointers = [a.ctypes.data_as(ctypes.c_void_p) for a in (state, row, there)]
        assert step(ctypes.c_double(command), *pointers) == expected
        np.testing.assert_array_equal(here, there)


def test_loops_over_a_packed_row_are_the_same_in_the_lqg_step(tmp_path: Path) -> None:
    step, n = in_c(lqg_step, tmp_path), 3
    step.restype = None
    numbers = np.random.default_rng(2)
    row = np.concatenate([[n], numbers.standard_normal(2 * n + 4 + 2 * n + 2 * n + n * n + 2 * n)])
    arrays = [numbers.standard_normal(2) for _ in Sample._fields]
    record = (ctypes.c_void_p * len(arrays))(*(a.ctypes.data for a in arrays))
    here, there = numbers.standard_normal(2 * n + 2), np.zeros(2 * n + 2)
    there[:] = here
    commands, found = np.zeros(2), np.zeros(2)
    for _ in range(3):
        lqg_step(Sample(*arrays), here, row, commands)
        step(record, *(a.ctypes.data_as(ctypes.c_void_p) for a in (there, row, found)))
        np.testing.assert_array_equal(found, commands)
        np.testing.assert_array_equal(there, here)


def rounding(a, b):  # type: ignore[no-untyped-def]
    """Where order of operations and kinds of numbers matter."""
    count = 0
    total = 1 / 3
    for i in range(2, 5):
        count += i
        total = total - (a - (b - i)) * (a / (b * i)) / count
        if i == 3 or not (a < b <= 2.0):
            continue
        total += a**2 if count > 2 else -(b - a)
    while total > 10.0:
        total /= 7
    return total * (1 / count) - ((a > 0.0) - (a < 0.0)) * math.pi


def test_order_of_operations_and_division_of_whole_numbers_are_pythons(tmp_path: Path) -> None:
    found = in_c(rounding, tmp_path)
    for a, b in np.random.default_rng(3).uniform(-3, 3, (500, 2)):
        assert found(*doubles(a, b)) == rounding(float(a), float(b))


def swaps(a, b):  # type: ignore[no-untyped-def]
    a, b = b, a
    return a - b


def picks(a):  # type: ignore[no-untyped-def]
    return sum([a, a])


def powers(a, b):  # type: ignore[no-untyped-def]
    return a**b


def tries(a):  # type: ignore[no-untyped-def]
    try:
        return 1 / a
    except ZeroDivisionError:
        return 0.0


def names(double):  # type: ignore[no-untyped-def]
    return 2.0 * double


@pytest.mark.parametrize("function", [swaps, picks, powers, tries, names])
def test_what_c_cannot_have_is_refused_with_the_functions_name(function: FunctionType) -> None:
    with pytest.raises(ArgumentError, match=f"test_export_c_translate.{function.__name__}` has .* cannot be written in C"):
        Translator().add(function)


def test_literals_are_read_back_as_the_same_number_and_an_edge_stays_below_its_limit() -> None:
    for value in (0.1, 1e-300, 1.0, -3.0, 1.7976931348623157e308, 1 / 3, 5e-324):
        assert float(literal(value)) == value
    assert np.float32(literal(0.1, single=True).rstrip("f")) == np.float32(0.1)
    assert np.float32(literal(1 - 1e-12, single=True).rstrip("f")) < 1
    assert literal(math.inf) == "INFINITY"
    assert literal(2.0, single=True) == "2.0f"
