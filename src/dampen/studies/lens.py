"""Reading and changing one value of a scenario by its path, such as "controller.alpha_4" or "actuator.all.chain.0.right"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

from dampen.component import ArgumentError, parameters, placed, suggestion
from dampen.simulation.scenario import Scenario
from dampen.toml import CHAINS

_FIELDS = {table: name for name, table in CHAINS.items()}


def get(scenario: Scenario, path: str) -> Any:
    """The value at a path; of several that it stands for (`actuator.all`), the first. Raises ArgumentError for no such path."""
    found: Any = scenario
    for keys in spelled(scenario, path)[:1]:
        for depth, key in enumerate(keys):
            found = _inside(found, key, path, keys[:depth])
    return found


def changed(scenario: Scenario, values: Mapping[str, Any]) -> Scenario:
    """The scenario with other values at some paths. Raises ArgumentError where a value is not one that may stand there."""
    parts: dict[str, Any] = {}
    for path, value in values.items():
        for first, *rest in spelled(scenario, path):
            parts[first] = _set(parts.get(first, getattr(scenario, first)), rest, value, path, [first])
    return replace(scenario, **parts) if parts else scenario


def spelled(scenario: Scenario, path: str) -> list[list[str]]:
    """The keys of every value that a path stands for, from a scenario's fields on."""
    keys = path.split(".")
    if keys[0] not in _FIELDS:
        return [keys]
    if len(keys) < 4 or keys[2] != "chain":
        raise ArgumentError(f"Argument `{path}` must look like {keys[0]}.PORT.chain.0.PARAMETER, with a port or `all`.")
    chains = getattr(scenario, _FIELDS[keys[0]])
    ports = [port for port in scenario.ports if port in chains] if keys[1] == "all" else [keys[1]]
    if not ports:
        raise ArgumentError(f"Argument `{path}` is not there: the scenario has no `{keys[0]}`.")
    return [[_FIELDS[keys[0]], port, *keys[3:]] for port in ports]


def _inside(part: Any, key: str, path: str, above: Sequence[str]) -> Any:
    if is_dataclass(part) and not isinstance(part, type):
        known = [f.name for f in fields(part)]
        if isinstance(part, Scenario):
            known = [_table(name) for name in known]
        if key in [f.name for f in fields(part)]:
            return getattr(part, key)
    elif isinstance(part, Mapping):
        known = list(part)
        if key in part:
            return part[key]
    elif isinstance(part, tuple):
        known = [str(i) for i in range(len(part))]
        if key in known:
            return part[int(key)]
    else:
        raise ArgumentError(f"Argument `{path}` must name a value, but `{'.'.join(above)}` is one already, {part!r}.")
    if isinstance(part, Mapping):
        given = f"given there: {', '.join(known)}" if known else "nothing is given there"
        raise ArgumentError(f"Argument `{path}` must have a value in the scenario, by --set for example; {given}.")
    tables = [(f.name, type(getattr(part, f.name))) for f in fields(part)] if isinstance(part, Scenario) else []
    hint = placed(path, tables) or (suggestion(key, known) if known else "; there is nothing.")
    raise ArgumentError(f"Argument `{path}` is not known{hint}")


def _set(part: Any, keys: Sequence[str], value: Any, path: str, above: list[str]) -> Any:
    """`part` with `value` where `keys` lead; a component that does not take it complains under its own place, `above`."""
    if not keys:
        return value
    inner = _set(_inside(part, keys[0], path, above), keys[1:], value, path, [*above, keys[0]])
    if isinstance(part, Mapping):
        return {**part, keys[0]: inner}
    if isinstance(part, tuple):
        return tuple(inner if str(i) == keys[0] else old for i, old in enumerate(part))
    try:
        return replace(part, **{keys[0]: inner})
    except ArgumentError as error:
        raise error.under(".".join(map(_table, above))) from None


def _table(name: str) -> str:
    return CHAINS.get(name, name)


def is_whole(scenario: Scenario, path: str) -> bool:
    """Whether the value at a path is a whole number by declaration."""
    keys = spelled(scenario, path)[0]
    part: Any = scenario
    for key in keys[:-1]:
        part = _inside(part, key, path, [])
    if not is_dataclass(part) or isinstance(part, type):
        return False
    return any(p.name == keys[-1] and p.type == "whole number" for p in parameters(type(part)))
