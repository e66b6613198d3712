"""Properties that vary along x: a number, polynomial coefficients, a Python function, or the name of one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, TypeAlias

import numpy as np
from annotated_types import Ge, Gt, Unit

from dampen.component import ArgumentError, hints_of, split_hint, wrong
from dampen.own import complaint, own_object
from dampen.plants.base import Constant, polynomial

Array = np.ndarray
Function = Callable[[Array], Array]
Profile: TypeAlias = float | Annotated[tuple[float, ...], "coefficients of c0 + c1 x + ..."] | str | Function
SAMPLES = 401


def along(profile: Profile, name: str = "profile") -> Function:
    """The function of x that `profile` stands for: x (points,) -> (points,).

    Raises ArgumentError that names the argument `name` where a function of the user's own fails or gives something else.
    """
    if isinstance(profile, tuple):
        return polynomial(profile)
    if isinstance(profile, str):
        if ":" not in profile:
            raise wrong(name, 'be a number, a list of coefficients, a function of x, or its name "module:function"', profile)
        profile = own_object(profile, name)
    if not callable(profile):
        if isinstance(profile, str | tuple):
            raise wrong(name, "name a function of x", profile)
        return Constant(float(profile))
    return lambda x: _called(profile, name, x)


def in_units(function: Function, unit: float) -> Function:
    """The same function, divided by `unit`."""
    return Constant(function.value / unit) if isinstance(function, Constant) else lambda x: function(x) / unit


def sampled(profile: Profile, length: float, name: str = "profile") -> Array:
    """`profile` at sample points along [0, length]."""
    return along(profile, name)(np.linspace(0, length, SAMPLES))


def check_profiles(plant: Any, length: float) -> None:
    """Raise ArgumentError where a property of `plant` that varies along x leaves its declared range."""
    lines: list[str] = []
    kind: Any = type(plant)
    for name, hint in hints_of(kind).items():
        base, extras = split_hint(hint)
        if base == Profile:
            try:
                _check_range(name, getattr(plant, name), length, extras)
            except ArgumentError as error:
                lines += error.lines
    if lines:
        raise ArgumentError(lines)


def _check_range(name: str, profile: Profile, length: float, extras: tuple[Any, ...]) -> None:
    if isinstance(profile, int | float):  # its range has been checked as any number's
        return
    values = sampled(profile, length, name)
    worst = int(np.argmin(values))
    least, x = values[worst], worst * length / (SAMPLES - 1)
    unit = next((f" {extra.unit}" for extra in extras if isinstance(extra, Unit)), "")
    for extra in extras:
        if (isinstance(extra, Gt) and not least > extra.gt) or (isinstance(extra, Ge) and not least >= extra.ge):
            sign, bound = (">", extra.gt) if isinstance(extra, Gt) else (">=", extra.ge)
            raise ArgumentError(f"Argument `{name}` must be {sign} {bound}{unit} everywhere, but is {least:g} at x = {x:g}.")


def _called(function: Callable[[Array], Any], name: str, x: Array) -> Array:
    """What a function of the user's own gives at x, checked."""
    try:
        values = np.broadcast_to(np.asarray(function(x), float), x.shape)
    except Exception as error:
        raise ArgumentError(f"Argument `{name}` is a function that fails on an array of x: {complaint(error)}.") from None
    if not np.all(np.isfinite(values)):
        at = x[np.argmin(np.isfinite(values))]
        raise ArgumentError(f"Argument `{name}` must be finite everywhere, but is not at x = {at:g}.")
    return values
