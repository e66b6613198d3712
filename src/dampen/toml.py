"""Components as TOML text, every parameter written out with its unit and meaning."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from dampen.component import Component, own_name, parameters

CHAINS = {"actuators": "actuator", "compensation": "compensation"}  # for each port a chain: field of a scenario, table of a file


def to_toml(scenario: Component) -> str:
    """A scenario as a TOML file that reads back to the same scenario."""
    lines: list[str] = []
    for f in fields(scenario):
        value = getattr(scenario, f.name)
        if not isinstance(value, Component | Mapping) and value not in (None, ""):
            lines.append(f"{f.name} = {literal(value)}")
    for f in fields(scenario):
        value = getattr(scenario, f.name)
        if isinstance(value, Component):
            lines += _table(f.name, value)
        elif isinstance(value, Mapping) and f.name not in CHAINS and value:
            lines += ["", f"[{f.name}]", *(f"{bare(key)} = {literal(v)}" for key, v in value.items())]
    for name, table in CHAINS.items():
        for port, chain in getattr(scenario, name, {}).items():
            lines += ["", f"[{table}.{bare(port)}]", f"chain = {literal(chain)}"]
    return "\n".join(lines) + "\n"


def literal(value: Any) -> str:
    """A value as TOML writes it, on one line."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return quoted(value)
    if callable(value) and not isinstance(value, Component):
        return literal(own_name(value))
    if isinstance(value, tuple | list):
        return "[" + ", ".join(literal(v) for v in value) + "]"
    if isinstance(value, Component):
        kind = {"kind": kind_of(value)} if kind_of(value) else {}
        value = {**kind, **{f.name: getattr(value, f.name) for f in fields(value) if getattr(value, f.name) is not None}}
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{bare(k)} = {literal(v)}" for k, v in value.items()) + " }"
    return repr(value)


def bare(key: str) -> str:
    """A key as TOML writes it: a port's name may need quotes."""
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else quoted(key)


def quoted(text: str) -> str:
    """Text as TOML writes it: as JSON does, but for DEL, which TOML wants escaped too."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def kind_of(component: Component) -> str:
    """The name that a scenario file uses for the component's class; "module:Class" for a class of the user's own."""
    cls = type(component)
    if not hasattr(cls, "kind") or cls.__module__.startswith("dampen."):
        return cls.kind
    return own_name(cls)


def _table(name: str, component: Component) -> list[str]:
    lines = ["", f"[{name}]"]
    if kind_of(component):
        lines.append(f"kind = {literal(kind_of(component))}")
    inner: list[str] = []
    for parameter in parameters(type(component)):
        value = getattr(component, parameter.name)
        if isinstance(value, Component):
            inner += _table(f"{name}.{parameter.name}", value)
        elif value is not None and value != {}:
            comment = ", ".join(part for part in (parameter.unit, parameter.doc) if part)
            line = f"{parameter.name} = {literal(value)}"
            lines.append(f"{line:<28}  # {comment}" if comment else line)
    return lines + inner
