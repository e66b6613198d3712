"""What `dampen list` and `--help` print: shipped scenarios, and every kind with its parameters, straight from the code."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, replace

from dampen.component import ArgumentError, Component, Parameter, hints_of, parameters, split_hint, suggestion
from dampen.own import with_colon
from dampen.scenarios.kinds import KINDS, find_own_kind
from dampen.scenarios.read import TABLES, shipped, table_of
from dampen.simulation.scenario import Scenario
from dampen.toml import literal


def listing(kind: str | None = None) -> str:
    """The whole list as text; or what there is under one name: a kind, a user's own "module:Class", or a table of kinds.

    Raises ArgumentError for a name that is none of these.
    """
    entries = [entry for entry in _entries() if kind is None or kind in entry[:2]]
    if kind and ":" in kind:
        table, cls = find_own_kind(kind, "kind")
        entries = [(table, kind, cls.summary(), _rows(cls))]
    if not entries:
        known = sorted({name for table, own, *_ in _entries() for name in (table, own) if name})
        hint = with_colon(str(kind)) or suggestion(str(kind), known)
        raise ArgumentError(f"Argument `kind` must be a kind or a table, but is {kind!r}{hint}")
    lines = [] if kind else ["Scenarios (dampen run NAME, dampen show NAME)", *_scenarios()]
    for table, own, summary, rows in entries:
        name = f'[{table}] kind = "{own}"' if own else f"[{table}]"
        lines += ["", f"{name}    {summary}", *rows]
    return "\n".join(lines).lstrip("\n")


def overview() -> str:
    """Every kind by its name, a line for each table."""
    lines = ["Kinds (dampen list KIND shows parameters, units and defaults):"]
    return "\n".join([*lines, *(f"  {table:<14}{', '.join(cls.kind for cls in classes)}" for table, classes in KINDS.items())])


def _entries() -> Iterator[tuple[str, str, str, list[str]]]:
    """(table, kind, summary, rows) of everything that a scenario file can hold."""
    for table, classes in KINDS.items():
        yield from ((table, cls.kind, cls.summary(), _rows(cls)) for cls in classes)
    bounds = next(p for p in parameters(Scenario) if p.name == "bounds")
    yield "bounds", "", "What the controller is told of the disturbances.", [_row("PORT, f", replace(bounds, type="number"))]
    yield from ((table, "", cls.summary(), _rows(cls)) for table, cls in TABLES.items())


def _scenarios() -> list[str]:
    width = max(map(len, shipped())) + 2
    return [f"  {name:<{width}}{table_of(name).get('title', '')}" for name in shipped()]


def _rows(cls: type[Component], prefix: str = "") -> list[str]:
    rows, hints = [], hints_of(cls)
    inner = {f.name: split_hint(hints[f.name])[0] for f in fields(cls)}
    for p in parameters(cls):
        if isinstance(inner[p.name], type) and issubclass(inner[p.name], Component):
            rows += _rows(inner[p.name], f"{prefix}{p.name}.")
        else:
            rows.append(_row(f"{prefix}{p.name}", p))
    return rows


def _row(name: str, p: Parameter) -> str:
    return f"  {name:<24} {_default(p):<20} {p.unit:<10} {_about(p)}".rstrip()


def _default(p: Parameter) -> str:
    return "(required)" if p.required else "" if p.default in (None, {}) else literal(p.default)


def _about(p: Parameter) -> str:
    """Type where it is not a plain number, range, meaning."""
    kind = "" if p.type == "number" else p.type
    return ", ".join(part for part in (kind, p.range, p.doc) if part)
