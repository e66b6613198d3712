"""What the C controller costs: bytes of memory, and operations of a step, counted by running its Python on numbers that count."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, ClassVar

import numpy as np

from dampen.controllers.p_type_ilc import PDTypeILC, PTypeILC
from dampen.controllers.pointwise import PointwiseLearning
from dampen.export.c.expressions import MATH
from dampen.export.c.source import Source
from dampen.simulation.compiled import bind
from dampen.simulation.digital import Sample, follow, limited

KINDS = {"+": "additions", "*": "multiplications", "/": "divisions", "<": "comparisons", "math": "calls of math.h"}


@dataclass(frozen=True)
class Footprint:
    """memory: of the record, in RAM; tables: constants, in flash [bytes]; step: operations by kind; end: those of
    `dampen_end_trial` in words."""

    memory: int
    tables: int
    step: dict[str, int]
    end: str


class Counting(float):
    """A number that counts what is done with it; `tally` is the count of the moment."""

    tally: ClassVar[Counter[str]] = Counter()


def _operator(name: str, kind: str) -> None:
    plain = getattr(float, name)

    def counted(self: Counting, *others: Any) -> Any:
        Counting.tally[kind] += 1
        value = plain(self, *(float(other) for other in others))
        return Counting(value) if kind != "<" else value

    setattr(Counting, name, counted)


for _kind, _names in {"+": "add radd sub rsub", "*": "mul rmul pow", "/": "truediv rtruediv", "<": "lt le gt ge eq ne"}.items():
    for _name in _names.split():
        _operator(f"__{_name}__", _kind)
setattr(Counting, "__neg__", lambda self: Counting(-float(self)))  # noqa: B010  (signs are free)
setattr(Counting, "__abs__", lambda self: Counting(math.fabs(self)))  # noqa: B010


def counted(function: Callable[..., Any], *arguments: Any) -> Counter[str]:
    """The operations of one call."""

    def call(name: str) -> Callable[..., Counting]:
        def called(*given: float) -> Counting:
            Counting.tally["math"] += 1
            return Counting(getattr(math, name)(*map(float, given)))

        return called

    shim = SimpleNamespace(pi=math.pi, minimum=min, maximum=max, abs=abs, **{name: call(name) for name in MATH})
    Counting.tally = Counter()
    bind(function, math=shim, np=shim)(*arguments)
    return Counting.tally


def footprint(source: Source) -> Footprint:
    """Memory and operations; of a step the most that was found in a few samples."""
    blue, size = source.blue, 4 if source.blue.single else 8
    reals = 3 * blue.ports + len(blue.sampler.state)
    sizes = {"double": 8, "dampen_real": size}
    memory = 4 * (4 + blue.ports) + size * reals + sum(sizes[slot.type] * slot.numbers for slot in source.slots)
    tables = size * np.size(blue.sampler.parameters) + sum((8 if t.wide else size) * t.values.size for t in source.tables)
    align = max(size, *(sizes[slot.type] for slot in source.slots)) if source.slots else size
    return Footprint(-(-memory // align) * align, tables, step_operations(source), end_in_words(source))


def step_operations(source: Source) -> dict[str, int]:
    """Of a step that reads well: estimator, law, limit, learning sample by sample, and the guards' comparisons."""
    blue = source.blue
    ports, found = blue.ports, Counter[str]()
    for share in (0.0, 0.3, -0.6, 0.9):
        total = law_operations(source, share)
        for name in KINDS:
            found[name] = max(found[name], total[name])
    number, cells = Counting(0.1), [Counting(0.1)] * ports
    found += times(counted(follow, 0, number, number, number, number, list(cells), list(cells)), ports)
    found += times(counted(limited, number, Counting(1.0)), ports)
    if isinstance(blue.controller, PointwiseLearning):
        row = [Counting(v) for v in blue.controller.learning_row(blue.setting)[:, 0]]
        found += times(counted(type(blue.controller).relearn, number, number, number, number, number, row), ports)
        found["+"] += 2 * ports
    elif isinstance(blue.controller, PTypeILC):
        rate = isinstance(blue.controller, PDTypeILC)
        found += Counter({"+": (1 + 2 * rate) * ports, "*": (2 + rate) * ports, "/": rate * ports})
    found += Counter({"+": ports, "<": (4 + 2 * blue.guards.stop_at_constraint) * ports})
    return {KINDS[name]: found[name] for name in KINDS}


def law_operations(source: Source, share: float) -> Counter[str]:
    """Of the law, with errors at a share of the constraint."""
    blue, sampler = source.blue, source.blue.sampler
    room = np.where(np.isfinite(sampler.high[0]), sampler.high[0], 1.0)
    known: dict[str, Any] = {name: [Counting(0.1)] * blue.ports for name in Sample._fields}
    known["error"] = [Counting(v) for v in share * room]
    known["low"], known["high"] = ([Counting(v) for v in table[0]] for table in (sampler.low, sampler.high))
    parameters = [Counting(v) for v in np.ravel(sampler.parameters)]
    state = [Counting(0.1)] * len(sampler.state)
    return counted(blue.law, Sample(**known), state, parameters, [Counting(0.0)] * blue.ports)


def times(tally: Counter[str], count: int) -> Counter[str]:
    """The same so many times."""
    return Counter({name: count * value for name, value in tally.items()})


def end_in_words(source: Source) -> str:
    """What `dampen_end_trial` does, beside a step's reading."""
    blue = source.blue
    n = blue.samples * blue.ports
    if blue.learning == "gains" and source.names["filter"] is not None:
        return f"the low-pass there and back: {10 * n:,} multiplications; call it in a pause, or in the background"
    if blue.learning == "lifted":
        each = blue.samples * (blue.samples + 1) * blue.ports**2
        return f"conjugate gradients, at least tens of rounds of {each:,} multiplications each; for a pause between trials"
    return "as quick as a step"
