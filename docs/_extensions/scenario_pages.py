"""Pages of the scenario file, from its schema: of every table and kind the keys, with type, unit, range, default and meaning."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from words import about, code, table, unit

from dampen.scenarios.schema import schema

SIGNS = {"gt": ">", "ge": "≥", "lt": "<", "le": "≤"}
TITLES = {
    "plant": ("[plant]", "What vibrates. One table, with its `kind`."),
    "actuator": (
        "[actuator]",
        "What stands between a command and the force that is delivered: a list of stages, `chain`, for all ports in "
        "`[actuator.all]`, or for one in `[actuator.PORT]`, which goes before. A port without one has an ideal actuator.",
    ),
    "compensation": (
        "[compensation]",
        "Stages before the actuator, on the controller's side: inverses of what it is taken for. Given as actuators are: "
        "`[compensation.all]`, `[compensation.PORT]`.",
    ),
    "disturbance": ("[disturbance]", "What shakes it. One table, with its `kind`; several at once by the kind `sum`."),
    "signal": (
        "Signals",
        "What a port is to follow, `[task.reference]`, and limits that move, `[task.constraint]`: tables with a `kind`.",
    ),
    "controller": ("[controller]", "Who decides. One table, with its `kind`."),
}
TOP = Path(__file__).with_suffix(".md")  # what the first page begins with


def scenario_pages() -> Iterator[tuple[str, str]]:
    """(name, text) of every page."""
    known = schema()
    parts = [TOP.read_text(encoding="utf-8")]
    for name, described in known["tables"].items():
        parts += [f"({name})=\n## [{name}]", about(described["summary"]), keys(described)]
    pages = "\n".join(f"scenario-{family}" for family in known["kinds"])
    parts.append(f"```{{toctree}}\n:hidden:\n\n{pages}\n```")
    yield "scenario", "\n\n".join(parts)
    for family, kinds in known["kinds"].items():
        title, what = TITLES[family]
        sections = [f"## {kind['kind']}\n\n{about(kind['summary'])}\n\n{keys(kind)}" for kind in kinds]
        yield f"scenario-{family}", "\n\n".join([f"# {title}", what, *sections])


def keys(described: dict[str, Any]) -> str:
    """The keys of a table or kind."""
    rows = list(_rows(described["parameters"]))
    return table(("key", "type", "unit", "range", "default", "meaning"), rows) if rows else "No keys."


def _rows(parameters: list[dict[str, Any]], prefix: str = "") -> Iterator[tuple[str, ...]]:
    for p in parameters:
        name, kind = prefix + p["name"], p["type"]
        inner = members(kind)
        if kind["is"] != "component":
            given = "required" if p["required"] else code(p["default"]) if p.get("default") not in (None, {}, [], "") else ""
            limits = " and ".join(f"{SIGNS[sign]} {value:g}" for sign, value in p["range"].items())
            yield f"`{name}`", type_words(kind), unit(p["unit"]), limits, given, about(p["doc"])
        if inner:
            yield from _rows(inner, name + {"component": ".", "list": "[].", "table": ".PORT."}.get(kind["is"], "."))


def members(kind: dict[str, Any]) -> list[dict[str, Any]]:
    """The keys of the tables that a value may be made of."""
    if kind["is"] == "component":
        return kind["parameters"]
    inner = kind.get("of", [])
    options = inner if kind["is"] == "any" else [inner] if kind["is"] in ("list", "table") else []
    return next((found for option in options if (found := members(option))), [])


def type_words(kind: dict[str, Any]) -> str:
    """A type in words."""
    match kind["is"]:
        case "choice":
            return " or ".join(f"`{word}`" for word in kind["of"])
        case "any":
            return " or ".join(map(type_words, kind["of"]))
        case "list":
            return f"list of {many(kind['of'])}"
        case "table":
            return f"table of {many(kind['of'])}"
        case "kind":
            return f"table with a `kind` of [{kind['family']}](scenario-{kind['family']}.md)"
        case "component":
            return "table"
        case "file":
            return "path of a file"
        case "function":
            return "function"
        case "boolean":
            return "true or false"
        case other:
            return "whole number" if other == "integer" else other


def many(kind: dict[str, Any]) -> str:
    """A type in words, of which there are several."""
    words = type_words(kind)
    plain = kind["is"] in ("number", "integer", "component", "text")
    return f"{words}s" if plain else words.replace("list of", "lists of", 1).replace("table with", "tables with", 1)
