"""What public functions take, checked at their door: an error names the argument, what it must be and what it was."""

from __future__ import annotations

import inspect
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import wraps
from typing import Any, ParamSpec, TypeVar

import numpy as np

from dampen.component import LEAST, MOST, is_number, is_whole, wrong

P = ParamSpec("P")
R = TypeVar("R")


@dataclass(frozen=True)
class Taken:
    """What an argument may be, and how that is said."""

    test: Callable[[Any], bool]
    must: str

    def __or__(self, other: Taken) -> Taken:
        must = f"{self.must}, or {other.must.removeprefix('be ')}"
        return Taken(lambda value: self.test(value) or other.test(value), must)


def takes(**expected: Taken) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """A function whose arguments are checked before it begins; what is left at its default is not looked at."""

    def around(function: Callable[P, R]) -> Callable[P, R]:
        signature = inspect.signature(function)

        @wraps(function)
        def checked(*args: P.args, **kwargs: P.kwargs) -> R:
            for name, value in signature.bind(*args, **kwargs).arguments.items():
                if name in expected and not expected[name].test(value):
                    raise wrong(name, expected[name].must, value)
            return function(*args, **kwargs)

        return checked

    return around


def of_class(name: str) -> Taken:
    """An object of the package's class of this name, or of one made from it; told by name, so that nothing is imported for it."""
    article = "an" if name[0] in "AEIO" else "a"
    return Taken(
        lambda v: any(c.__name__ == name and c.__module__.startswith("dampen.") for c in type(v).__mro__), f"be {article} {name}"
    )


def having(name: str, *attributes: str) -> Taken:
    """An object with these attributes."""
    return Taken(lambda v: all(hasattr(v, a) for a in attributes), f"be a {name}")


def count(least: int = 0, most: int | None = None) -> Taken:
    """A whole number."""
    must = f"be a whole number >= {least}" if most is None else f"be a whole number from {least} to {most}"
    return Taken(lambda v: is_whole(v) and least <= v <= (10**9 if most is None else most), must)


def _is_path(value: Any) -> bool:
    return isinstance(value, str | os.PathLike) and "\0" not in os.fspath(value)


def _is_sequence(value: Any) -> bool:
    return isinstance(value, Sequence) and not isinstance(value, str | bytes)


NOTHING = Taken(lambda v: v is None, "be None")
TRUTH = Taken(lambda v: isinstance(v, bool | np.bool_), "be True or False")
TEXT = Taken(lambda v: isinstance(v, str), "be text")
PATH = Taken(_is_path, "be a path")
CALLABLE = Taken(callable, "be a function")
TEXTS = Taken(lambda v: _is_sequence(v) and all(map(TEXT.test, v)), "be a list of texts")
POSITIVE = Taken(lambda v: is_number(v) and LEAST <= v <= MOST, f"be a number from {LEAST:g} to {MOST:g}")
POSITIVES = Taken(
    lambda v: (_is_sequence(v) or isinstance(v, np.ndarray)) and len(v) > 0 and all(map(POSITIVE.test, v)),
    "be finite numbers > 0",
)
RANGES = TEXTS | Taken(lambda v: isinstance(v, Mapping) and all(isinstance(k, str) for k in v), "be ranges by path")
SCENARIO, RESULT, STUDY = of_class("Scenario"), of_class("Result"), having("Study", "definition", "table")
CONTENDERS = NOTHING | Taken(
    lambda v: _is_sequence(v) and all(TEXT.test(one) or SCENARIO.test(one) or of_class("Controller").test(one) for one in v),
    "be a list of kinds, scenarios and controllers",
)
BENCH, STORE = of_class("Bench") | NOTHING, of_class("Store") | NOTHING
PROGRESS = CALLABLE | NOTHING
FOLDER = PATH | NOTHING
ENGINE = count(1) | of_class("Engine") | TEXT | NOTHING
