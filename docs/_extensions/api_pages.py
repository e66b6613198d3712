"""Pages of the Python interface, from the public names in `__init__.pyi`: signature, docstring, parameters, methods."""

from __future__ import annotations

import importlib
import inspect
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from words import about, docstring, table, unit

import dampen
from dampen.component import Component, Parameter, parameters
from dampen.scenarios.kinds import KINDS
from dampen.toml import literal

STUB = Path(dampen.__file__).with_suffix(".pyi")
NAME = re.compile(r"^from \.([\w.]+) import (\w+) as \2$", re.MULTILINE)
GROUPS = {  # page: title, what it is, rooms of the package
    "run": ("Run", "Scenarios, and what comes of them.", ("scenarios", "simulation", "component", "release")),
    "plants": ("Plants", "What vibrates.", ("plants", "port")),
    "actuators": (
        "Actuators",
        "What stands between command and force, and its inverses.",
        ("actuators", "compensation", "stage"),
    ),
    "disturbances": ("Disturbances and signals", "What shakes it; what it is to follow.", ("disturbances", "signals")),
    "controllers": ("Controllers", "Who decides, and what it learns between trials.", ("controllers",)),
    "checks": ("Checks", "What to believe of a run.", ("analysis",)),
    "studies": ("Studies", "Many runs.", ("studies",)),
    "exports": ("Exports", "What leaves for other tools, and programs in the loop.", ("export", "sil")),
    "gym": ("Gymnasium", "Scenarios as environments; `import dampen.gym`.", ("gym",)),
}


def public_names() -> dict[str, list[str]]:
    """Page: the names on it."""
    pages: dict[str, list[str]] = {page: [] for page in GROUPS}
    for module, name in NAME.findall(STUB.read_text(encoding="utf-8")):
        pages[page_of(module)].append(name)
    pages["gym"] = ["gym.BeamEnv", "gym.BeamVectorEnv"]
    return pages


def page_of(module: str) -> str:
    """The page that a module's names belong to; a deeper room goes before the one around it."""
    for room in reversed(module.split(".")):
        for page, (_, _, rooms) in GROUPS.items():
            if room in rooms:
                return page
    raise LookupError(f"no page of the reference takes dampen.{module}: name its room in GROUPS")


def api_pages() -> Iterator[tuple[str, str]]:
    """(name, text) of every page."""
    importlib.import_module("dampen.gym")  # not there before it is asked for
    for page, names in public_names().items():
        title, what, _ = GROUPS[page]
        functions = sorted(names, key=lambda name: (inspect.isclass(found(name)), name.lower()))
        yield f"api-{page}", "\n\n".join([f"# {title}", what, *(entry(name, found(name)) for name in functions)])


def found(name: str) -> Any:
    """The thing behind a public name."""
    thing: Any = dampen
    for part in name.split("."):
        thing = getattr(thing, part)
    return thing


def entry(name: str, thing: Any) -> str:
    """One public name."""
    if not inspect.isclass(thing):
        return described("py:function", f"dampen.{name}{signature(thing)}", docstring(thing))
    body = [docstring(thing)]
    if issubclass(thing, Component):
        body += component(thing)
    kind = issubclass(thing, Component) and thing.kind
    body += [] if kind else list(members(thing))
    return described("py:class", f"dampen.{name}{signature(thing)}", "\n\n".join(body))


def component(cls: type[Component]) -> Iterator[str]:
    """How a scenario names it, and its parameters."""
    family = next((family for family, classes in KINDS.items() if cls in classes), None)
    if family:
        yield f'In a scenario: [{family}, kind `"{cls.kind}"`](scenario-{family}.md#{cls.kind})'
    rows = [(f"`{p.name}`", p.type, unit(p.unit), p.range, default(p), about(p.doc)) for p in parameters(cls)]
    if rows:
        yield table(("parameter", "type", "unit", "range", "default", "meaning"), rows)


def default(p: Parameter) -> str:
    """What a parameter is when nobody says."""
    if p.required:
        return "required"
    return "" if p.default in (None, {}, (), "") else f"`{literal(p.default)}`"


def members(cls: type) -> Iterator[str]:
    """Methods and properties that have something to say."""
    for name, member in vars(cls).items():
        inner = member.__func__ if isinstance(member, classmethod | staticmethod) else member
        if name.startswith("_") or not getattr(inner, "__doc__", None):
            continue
        if isinstance(inner, property) or type(inner).__name__ == "cached_property":
            yield described("py:property", name, docstring(inner), inner=True)
        elif inspect.isfunction(inner):
            yield described("py:method", name + signature(inner, method=inner is member), docstring(inner), inner=True)


def described(directive: str, head: str, body: str, inner: bool = False) -> str:
    """A directive of Sphinx's Python domain."""
    fence = ":" * (4 if inner else 6)
    return f"{fence}{{{directive}}} {head}\n\n{body}\n{fence}"


def signature(thing: Any, method: bool = False) -> str:
    """The arguments as one would write them; defaults that are no plain values are left as dots."""
    try:
        found = inspect.signature(thing)
        arguments = list(found.parameters.values())[1 if method else 0 :]
    except (TypeError, ValueError):
        return "()"
    typed = not (inspect.isclass(thing) and issubclass(thing, Component))
    words, starred = [], False
    for a in arguments:
        starred |= a.kind is a.VAR_POSITIONAL
        if a.kind is a.KEYWORD_ONLY and not starred:
            words.append("*")
            starred = True
        mark = {a.VAR_POSITIONAL: "*", a.VAR_KEYWORD: "**"}.get(a.kind, "")
        hint = f": {a.annotation}" if typed and isinstance(a.annotation, str) else ""
        plain = isinstance(a.default, str | int | float | bool | tuple | None)
        value = "" if a.default is a.empty else f" = {a.default!r}" if plain else " = ..."
        words.append(f"{mark}{a.name}{hint}{value}")
    returned = found.return_annotation
    back = f" -> {returned}" if isinstance(returned, str) and not inspect.isclass(thing) else ""
    return f"({', '.join(words)}){back}"
