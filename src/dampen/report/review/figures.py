"""Which figures belong to a review."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from dampen.analysis.audit.sticking import sticking
from dampen.report.figures import Draw, Drawn, save_all
from dampen.report.review.credit import columns_of as credit_columns
from dampen.report.review.credit import draw_credit
from dampen.report.review.limit import draw_limit
from dampen.report.review.sticking import draw_sticking
from dampen.simulation.result import Result
from dampen.studies.record import Record


@dataclass(frozen=True)
class Sketch:
    """A figure of a review: its name among the files, and its caption."""

    name: str
    caption: str


def draw_review(record: Record, result: Result, folder: Path) -> list[Drawn[Sketch]]:
    """Draw and save the figures of a review's parts."""
    sketches = list(sketched(record, result))
    saved = save_all([(sketch.name, draw) for sketch, draw in sketches], folder)
    return [Drawn(sketch, *of_it) for (sketch, _), of_it in zip(sketches, saved, strict=True)]


def sketched(record: Record, result: Result) -> Iterator[tuple[Sketch, Draw]]:
    """Each figure, and how it is drawn."""
    if record.audit is not None:
        found = sticking(result)
        if found is not None and any(found.share) and np.max([np.max(result["energy"][j]) for j in range(result.trials)]) > 0:
            yield Sketch("sticking", "Energy, and when the ports stick"), partial(draw_sticking, result, found)
    if record.credit is not None and credit_columns(record.credit):
        yield Sketch("credit", "What each part is worth"), partial(draw_credit, record.credit)
    name = result.scenario.controller.kind or type(result.scenario.controller).__name__
    for limit, at in zip(record.limits, record.standings, strict=True):
        yield Sketch(f"limit_{limit.of}", f"The limit of {limit.of}"), partial(draw_limit, limit, [(name, at)])
