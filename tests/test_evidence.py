"""The evidence on the documentation's page of validation holds, piece by piece."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

VALIDATION = Path(__file__).parents[1] / "docs" / "validation"
NAMES = (
    "frequencies", "timoshenko_to_euler_bernoulli", "decay_rates", "energy", "order_in_the_step", "other_units", "sticking",
    "play", "p_type_recursion", "batches", "limit", "sampled_to_continuous", "exported_c", "cosimulation_unit",
)  # fmt: skip


@pytest.fixture(scope="module")
def pieces() -> Iterator[Any]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "path", [str(VALIDATION), *sys.path])
        from evidence import PIECES

        yield PIECES


def test_no_piece_is_left_out_here_or_on_the_page(pieces: Any) -> None:
    page = (VALIDATION / "index.md").read_text(encoding="utf-8")
    assert tuple(pieces) == NAMES
    assert all(f'show("{name}")' in page for name in NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_a_piece_of_evidence_holds(name: str, pieces: Any) -> None:
    found = pieces[name]()
    assert found.missing or found.numbers
    assert found.holds, found.table()
