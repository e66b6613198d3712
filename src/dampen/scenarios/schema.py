"""What a scenario file can hold, as plain data: every kind and table, its parameters, their types, ranges, units and meaning.

A form, a document or another program can be made from it without knowing any class. Types are tables with the key `is`:

    number, integer, boolean, text          file, function: what lies beside the scenario
    choice      of: the words               list, table     of: the type of their members
    component   summary, parameters         kind            family: where its `kind` is one of
    any         of: the types that will do
"""

from __future__ import annotations

import inspect
import json
from collections.abc import Callable
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from annotated_types import Ge, Gt, Le, Lt

from dampen.component import Component, InFile, hints_of, parameters, plain, split_hint
from dampen.scenarios.kinds import FAMILIES, KINDS
from dampen.scenarios.read import TABLES

PLAIN = {float: "number", int: "integer", bool: "boolean", str: "text"}
BOUNDS = (Gt, Ge, Lt, Le)


def schema() -> dict[str, Any]:
    """{"kinds": {family: [{kind, summary, parameters}]}, "tables": {name: {summary, parameters}}}."""
    return {
        "kinds": {family: [{"kind": cls.kind, **described(cls)} for cls in classes] for family, classes in KINDS.items()},
        "tables": {name: described(cls) for name, cls in TABLES.items()},
    }


def described(cls: type[Component]) -> dict[str, Any]:
    """Summary and parameters of a class."""
    hints = hints_of(cls)
    return {"summary": cls.summary(), "parameters": [_parameter(p, hints[p.name]) for p in parameters(cls)]}


def _parameter(p: Any, hint: Any) -> dict[str, Any]:
    base, extras = split_hint(hint)
    in_file = any(isinstance(extra, InFile) for extra in extras)
    bounds = {type(extra).__name__.lower(): _limit(extra) for extra in extras if isinstance(extra, BOUNDS)}
    about = {"name": p.name, "type": type_of(base, in_file), "required": p.required, "unit": p.unit, "doc": p.doc}
    about["range"] = bounds
    return about if p.required or p.default is None else {**about, "default": _plain(p.default)}


def _limit(bound: Any) -> float:
    return float(getattr(bound, type(bound).__name__.lower()))


def type_of(hint: Any, in_file: bool = False) -> dict[str, Any]:
    """The type behind a hint; `in_file`: text in it names a file."""
    base, _ = split_hint(hint)
    origin, inner = get_origin(base), get_args(base)
    if base in PLAIN:
        return {"is": "file" if in_file and base is str else PLAIN[base]}
    if origin is Literal:
        return {"is": "choice", "of": list(inner)}
    if origin is tuple:
        return {"is": "list", "of": type_of(inner[0], in_file)}
    if origin is dict:
        return {"is": "table", "of": type_of(inner[1], in_file)}
    if origin in (UnionType, Union):
        options = [option for option in inner if option is not NoneType]
        types = [type_of(option, in_file) for option in options]
        if {"is": "function"} in types:  # text beside a function is a function's name
            types = [one for one in types if one["is"] != "text"]
        return types[0] if len(types) == 1 else {"is": "any", "of": types}
    if origin is Annotated:
        return type_of(inner[0], in_file)
    if inspect.isclass(base) and issubclass(base, Component):
        family = next((name for name, cls in FAMILIES.items() if cls is base), None)
        return {"is": "kind", "family": family} if family else {"is": "component", **described(base)}
    if base is Callable or origin is Callable:
        return {"is": "function"}
    return type_of(origin or Any, in_file) if origin else {"is": "function"} if callable(base) else {"is": "text"}


def _plain(value: Any) -> Any:
    """A default as JSON has it."""
    ready = plain(value) if isinstance(value, Component) else value
    return json.loads(json.dumps(ready, default=lambda one: plain(one) if isinstance(one, Component) else str(one)))
