"""What `dampen list` prints: shipped scenarios, and every kind with its parameters, straight from the code."""

from __future__ import annotations

from dataclasses import fields
from typing import get_type_hints

from dampen.component import Component, parameters, split_hint
from dampen.scenarios.kinds import KINDS
from dampen.scenarios.read import TABLES, parse, shipped
from dampen.toml import literal


def listing() -> str:
    """The whole list as text."""
    lines = ["Scenarios (dampen run NAME, dampen show NAME)"]
    for name, path in shipped().items():
        lines.append(f"  {name:<14} {parse(path.read_text(encoding='utf-8'), name).get('title', '')}")
    for table, classes in KINDS.items():
        for cls in classes:
            lines += ["", f'[{table}] kind = "{cls.kind}"    {cls.summary()}', *_rows(cls)]
    for table, cls in TABLES.items():
        lines += ["", f"[{table}]    {cls.summary()}", *_rows(cls)]
    return "\n".join(lines)


def _rows(cls: type[Component], prefix: str = "") -> list[str]:
    rows, hints = [], get_type_hints(cls, include_extras=True)
    inner = {f.name: split_hint(hints[f.name])[0] for f in fields(cls)}
    for p in parameters(cls):
        if isinstance(inner[p.name], type) and issubclass(inner[p.name], Component):
            rows += _rows(inner[p.name], f"{prefix}{p.name}.")
            continue
        default = "" if p.default in (None, {}) else literal(p.default)
        about = ", ".join(part for part in (p.range, p.doc) if part)
        rows.append(f"  {prefix + p.name:<24} {default:<20} {p.unit:<10} {about}".rstrip())
    return rows
