"""Families of components that users add kinds of their own to: what these override is watched wherever it is called."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, cached_property, wraps
from inspect import getattr_static
from numbers import Integral, Real
from types import FunctionType, NoneType, UnionType
from typing import Any, Literal, Union, get_args, get_origin

import numpy as np

from dampen.component import ArgumentError, Component, hints_of, own_name, shown
from dampen.own import blame, own

Hook = Callable[..., Any]


class Family(Component):
    """A component of which users write classes of their own.

    A method or property that such a class overrides raises nothing but ArgumentError, one line with class, method and line of
    code, and returns what the family declares that it returns.
    """

    def __init_subclass__(cls, **rest: Any) -> None:
        super().__init_subclass__(**rest)
        if own(cls):
            for name, declared in _declared(cls).items():
                owner = next(c for c in cls.__mro__ if name in vars(c))
                if own(owner) and (owner is cls or not issubclass(owner, Family)):
                    setattr(cls, name, _watched(cls, name, vars(owner)[name], declared))

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, declared in _declared(type(self)).items() if own(type(self)) else ():
            if isinstance(declared, property) and not hasattr(getattr_static(type(self), name), "__get__"):
                _check(f"{own_name(type(self))}.{name}", getattr(self, name), declared.fget, "be", "is")


@cache
def _declared(cls: type) -> Mapping[str, Hook | property]:
    """By name, the methods and properties of a class as its family first declares them."""
    found: dict[str, Hook | property] = {}
    for base in reversed(cls.__mro__):
        if issubclass(base, Component) and not own(base):
            for name, member in vars(base).items():
                if isinstance(member, FunctionType | property) and (not name.startswith("_") or name == "__post_init__"):
                    found.setdefault(name, member)
    return found


def _watched(cls: type, name: str, member: Any, declared: Hook | property) -> Any:
    """What a class overrides, as it is then called; raises ArgumentError where it is another kind of thing than was declared."""
    if isinstance(declared, property):
        if isinstance(member, FunctionType):
            raise ArgumentError(f"{own_name(cls)}.{name} must be a property: write @property above it.")
        if isinstance(member, property) and member.fget is not None:
            return property(_called(name, member.fget, declared.fget), member.fset, member.fdel, member.__doc__)
        if isinstance(member, cached_property):
            kept = cached_property(_called(name, member.func, declared.fget))
            kept.__set_name__(cls, name)
            return kept
        return member
    if isinstance(member, property | cached_property) or not (callable(member) or hasattr(member, "__get__")):
        raise ArgumentError(f"{own_name(cls)}.{name} must be a method, but is {shown(member)}.")
    return _called(name, member, declared) if isinstance(member, FunctionType) else member


def _called(name: str, method: Hook, declared: Hook | None) -> Hook:
    """A method whose errors and whose value are looked at."""

    @wraps(method)
    def called(self: object, *args: Any, **kwargs: Any) -> Any:
        with blame(self, name, method):
            value = method(self, *args, **kwargs)
        _check(f"{own_name(type(self))}.{name}", value, declared, "return", "returns")
        return value

    return called


def _check(whose: str, value: object, declared: Hook | None, must: str, does: str) -> None:
    """Raise ArgumentError for a value that is not of the type which its family declares."""
    hint = _returned(declared)
    if not fits(value, hint):
        found = f"an array of shape {value.shape}" if isinstance(value, np.ndarray) else shown(value)
        raise ArgumentError(f"{whose} must {must} {words(hint)}, but {does} {found}.")


@cache
def _returned(declared: Any) -> Any:
    """The type that a method declares to return; Any where that is nothing, or known to a type checker alone."""
    try:
        hint = eval(declared.__annotations__["return"], declared.__globals__)
    except (KeyError, NameError):
        return Any
    return Any if hint is None else hint


def fits(value: object, hint: Any) -> bool:
    """Whether a value is of a type, where lists may stand for tuples and arrays, and NumPy's numbers for Python's."""
    inner, origin = get_args(hint), get_origin(hint)
    if origin in (Union, UnionType):
        return any(fits(value, one) for one in inner)
    if origin is Literal:
        return value in inner
    if origin in (tuple, list):
        return _is_list(value) and _members_fit(value, inner)
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return isinstance(value, Mapping) and all(fits(k, inner[0]) and fits(v, inner[1]) for k, v in value.items())
    if hint is np.ndarray:
        return _is_array(value)
    if hint in (float, int):
        return isinstance(value, Real if hint is float else Integral) and not isinstance(value, bool)
    if isinstance(hint, type) and issubclass(hint, tuple) and hint is not tuple:  # a NamedTuple
        return isinstance(value, hint) and all(map(fits, value, hints_of(hint).values()))
    kinds = {bool: (bool, np.bool_)}.get(hint, hint)
    return hint is Any or not isinstance(kinds, type | tuple) or isinstance(value, kinds)


def _is_list(value: object) -> bool:
    return value.ndim > 0 if isinstance(value, np.ndarray) else isinstance(value, Sequence) and not isinstance(value, str | bytes)


def _members_fit(value: Any, inner: Sequence[Any]) -> bool:
    if inner[1:] in ((), (Ellipsis,)):
        return all(fits(one, inner[0]) for one in value)
    return len(value) == len(inner) and all(map(fits, value, inner))


def _is_array(value: object) -> bool:
    try:
        return np.asarray(value).dtype.kind in "fiub"
    except ValueError:  # rows of different lengths
        return False


def words(hint: Any, many: bool = False) -> str:
    """What a value of a type is called; `many` of them."""
    inner, origin = get_args(hint), get_origin(hint)
    if origin in (Union, UnionType):
        return " or ".join(words(one, many) for one in inner)
    if origin is Literal:
        return " or ".join(", ".join(f'"{one}"' for one in inner).rsplit(", ", 1))
    if origin is tuple and len(inner) == 2 and inner[0] == inner[1]:
        return f"{'pairs' if many else 'a pair'} of {words(inner[0], many=True)}"
    if origin is tuple and inner[1:] != (Ellipsis,):
        return f"{'tuples' if many else 'a tuple'} of {' and '.join(map(words, inner))}"
    if origin in (tuple, list):
        return f"{'lists' if many else 'a list'} of {words(inner[0], many=True)}"
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return f"{'dicts' if many else 'a dict'} of {words(inner[1], many=True)}"
    plain = {
        np.ndarray: ("an array", "arrays"), float: ("a number", "numbers"), int: ("a whole number", "whole numbers"),
        bool: ("True or False", "True or False"), str: ("text", "texts"), NoneType: ("None", "None"),
    }  # fmt: skip
    name = getattr(hint, "__name__", str(hint))
    plural = name.endswith("s")
    one = name if plural else f"an {name}" if name[0] in "AEIO" else f"a {name}"
    return plain.get(hint, (one, name if plural else f"{name}s"))[many]
