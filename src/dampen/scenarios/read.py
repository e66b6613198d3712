"""Scenario files: strict TOML in, objects out, every fault reported in one line with its path."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import fields
from importlib import resources
from pathlib import Path
from typing import Any, get_args, get_origin

from dampen.arguments import PATH, TEXTS, takes
from dampen.component import (
    WITH_UNIT,
    ArgumentError,
    Component,
    InFile,
    hints_of,
    near,
    parameters,
    placed,
    shown,
    split_hint,
    suggestion,
    wrong,
)
from dampen.controllers.none import NoControl
from dampen.disturbances.none import NoDisturbance
from dampen.own import own_function
from dampen.scenarios.kinds import FAMILIES, KINDS, find_kind
from dampen.scenarios.slips import fault, meant
from dampen.simulation.sampling import Sampling
from dampen.simulation.scenario import Numerics, Output, Scenario
from dampen.simulation.task import Task
from dampen.stage import Stage
from dampen.toml import CHAINS

Table = dict[str, Any]
TABLES: dict[str, type[Component]] = {"task": Task, "sampling": Sampling, "numerics": Numerics, "output": Output}
TOP = ("name", "title", "claims", "plant", "disturbance", "actuator", "compensation", "controller", "bounds", *TABLES)
LARGEST = 64 * 2**20  # bytes of a scenario file
BARE_WORD = re.compile(r"[A-Za-z][\w:.-]*")


def shipped() -> dict[str, Path]:
    """The scenarios that come with the package, by name."""
    root = Path(str(resources.files("dampen.scenarios")))
    return {path.parent.name.replace("_", "-"): path for path in sorted(root.glob("*/scenario.toml"))}


@takes(source=PATH, overrides=TEXTS)
def read_scenario(source: str | Path, overrides: Sequence[str] = ()) -> Scenario:
    """A shipped scenario by name, or a TOML file by path, with `key=value` overrides such as "controller.alpha_8=0.5".

    Values are TOML values; a bare word is taken as a string. Setting a table's `kind` starts that table afresh from the
    defaults of the new kind. Raises ArgumentError, one line for every fault.
    """
    return build(override(table_of(source), overrides), folder_of(source))


def table_of(source: str | Path, above: tuple[str, ...] = ()) -> Table:
    """The table of a scenario; one that says `based_on = "another"` is laid over that one, table by table."""
    table = parse(source_text(source), str(source))
    if "based_on" not in table:
        return table
    base = table.pop("based_on")
    if not isinstance(base, str):
        raise wrong("based_on", "name a scenario or a file", base)
    known = base in shipped()
    base = base if known else str(folder_of(source) / base)
    if base in above:
        raise wrong("based_on", "not lead back to where it came from", base)
    return laid_over(table_of(base, (*above, str(source))), table)


def laid_over(below: Table, above: Table) -> Table:
    """`above` over `below`: tables are merged, but one that names another `kind` starts afresh; everything else is replaced."""
    merged = dict(below)
    for key, value in above.items():
        old = merged.get(key)
        fresh = not (isinstance(value, dict) and isinstance(old, dict)) or value.get("kind", old.get("kind")) != old.get("kind")
        merged[key] = value if fresh else laid_over(old, value)  # type: ignore[arg-type]
    return merged


def folder_of(source: str | Path) -> Path:
    """Where files that a scenario names are looked for."""
    return shipped().get(str(source), Path(source)).parent


def source_text(source: str | Path) -> str:
    """The text of a shipped scenario or of a file."""
    known = shipped()
    path = known.get(str(source), Path(source))
    try:
        if not path.exists() and path.suffix != ".toml" and len(path.parts) == 1:
            beside = Path(f"{source}.toml")
            hint = f"; did you mean `{beside}`?" if beside.is_file() else suggestion(str(source), known)
            raise ArgumentError(f"Scenario `{source}` is neither a shipped scenario nor a file{hint}")
        if path.is_dir():
            inside = f": did you mean `{path / 'scenario.toml'}`?" if (path / "scenario.toml").is_file() else "."
            raise ArgumentError(f"Scenario `{source}` must be a file, but is a folder{inside}")
        with path.open("rb") as file:
            content = file.read(LARGEST + 1)  # a device may have no end
        if len(content) > LARGEST:
            raise ArgumentError(
                f"Scenario file `{source}` must be at most {LARGEST // 2**20} MiB: name files for large matrices."
            )
        return content.decode("utf-8")
    except (OSError, ValueError) as error:
        if isinstance(error, ArgumentError):
            raise
        named = getattr(error, "strerror", None) or error  # ValueError: no name that a file can have
        reason = "not UTF-8 text" if isinstance(error, UnicodeDecodeError) else named
        other = near(path.name, neighbours(path)) if isinstance(error, FileNotFoundError) else ""
        raise ArgumentError(f"Scenario file `{source}` cannot be read: {reason}{other or '.'}") from None


def neighbours(path: Path) -> list[str]:
    """What may be meant by a file that is not there: the shipped scenarios, and the TOML files of its folder."""
    return [*shipped(), *(other.name for other in path.parent.glob("*.toml"))]


def parse(text: str, name: str) -> Table:
    """TOML text as nested tables."""
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # also numbers too long, tables too deep
        raise ArgumentError(f"Scenario file `{name}` is not valid TOML: {fault(error, text, lists_of_tables())}") from None


def every_table() -> Iterator[tuple[str, type[Component]]]:
    """Name and class of all that a table of a scenario may hold, whatever its kind."""
    yield from TABLES.items()
    for name in ("plant", "disturbance", "controller"):
        yield from ((name, cls) for cls in KINDS[name])


def lists_of_tables() -> set[str]:
    """The keys under which scenario files have lists of tables."""
    hints = [(name, split_hint(hint)[0]) for _, cls in every_table() for name, hint in hints_of(cls).items()]
    members = [(name, get_args(base)[0]) for name, base in hints if get_origin(base) is tuple]
    return {"chain", *(name for name, member in members if isinstance(member, type) and issubclass(member, Component))}


def override(table: Table, settings: Sequence[str]) -> Table:
    """`table` with every `path.to.key=value` set; kinds first, since they start their table afresh."""
    pairs = []
    for setting in settings:
        path, equals, text = setting.partition("=")
        keys = [key.strip() for key in path.split(".")]
        if not equals or not all(keys) or keys == ["kind"]:
            must = "look like table.key=value, without spaces or in quotes"
            raise ArgumentError(f"Option `--set` must {must}, but is {shown(setting)}.")
        pairs.append((keys, _value(path.strip(), text.strip())))
    for keys, value in sorted(pairs, key=lambda pair: pair[0][-1] != "kind"):
        target: Any = table
        for key in keys[:-1]:
            target = _inside(target, key, keys)
        if isinstance(target, list):
            target[_index(target, keys[-1], keys)] = value
            continue
        if keys[-1] == "kind":
            target.clear()
        target[keys[-1]] = value
    return table


def _value(path: str, text: str) -> Any:
    try:
        table = tomllib.loads(f"value = {text}")
        if list(table) == ["value"]:
            return table["value"]
    except (ValueError, RecursionError):
        if BARE_WORD.fullmatch(text) or WITH_UNIT.fullmatch(text):  # a number with a unit is refused where the unit is known
            return text
    hint = meant(f"{path}={text}", "--set '{}'")
    raise ArgumentError(f"Option `--set {path}` must have a TOML value, but has {shown(text)}{hint}")


def _inside(target: Any, key: str, keys: list[str]) -> Any:
    if isinstance(target, list):
        return target[_index(target, key, keys)]
    inner = target.setdefault(key, {})
    if not isinstance(inner, dict | list):
        raise ArgumentError(
            f"Option `--set {'.'.join(keys)}` must name a key, but `{key}` is a value, {shown(inner)}, not a table."
        )
    return inner


def _index(target: list[Any], key: str, keys: list[str]) -> int:
    if not (key.isascii() and key.isdigit() and len(key) < 10) or int(key) >= len(target):
        raise ArgumentError(f"Option `--set {'.'.join(keys)}` must give a list index below {len(target)}, but gives `{key}`.")
    return int(key)


def build(table: Mapping[str, Any], folder: Path = Path()) -> Scenario:
    """The scenario that a parsed file describes; files and modules that it names are looked for in `folder`."""
    return Builder(folder).scenario(table)


class Builder:
    """Turns tables into objects, collecting every fault on the way.

    What a table names outside itself goes through `kind`, `file` and `function`: override them where not everything may be named.
    """

    def __init__(self, folder: Path):
        self.folder = folder
        self.table: Mapping[str, Any] = {}  # of the scenario that is built

    def kind(self, table: str, kind: object, where: str) -> type[Component]:
        """The class that a `kind` names."""
        return find_kind(table, kind, where, self.folder)

    def file(self, name: str, where: str) -> str:
        """The path of a file."""
        try:
            return str((self.folder / name).resolve())
        except (OSError, ValueError) as error:  # no name that a file can have
            raise ArgumentError(f"Argument `{where}` must name a file, but is {shown(name)}: {error}.") from None

    def function(self, name: str, where: str) -> Callable[..., Any]:
        """A function of the user's own."""
        return own_function(name, where, self.folder)

    def scenario(self, table: Mapping[str, Any]) -> Scenario:
        faults: list[str] = []

        def attempt(make: Any, *arguments: Any) -> Any:
            try:
                return make(*arguments)
            except ArgumentError as error:
                faults.extend(error.lines)

        self.table = table
        faults += [f"Argument `{key}` is not known{self.suggestion(_first(key, table), TOP)}" for key in table if key not in TOP]
        if "plant" not in table:
            faults.append("Argument `plant` must be given: a table with a `kind`.")
        parts: dict[str, Any] = {key: table[key] for key in ("name", "title", "claims") if key in table}
        defaults = {"controller": NoControl, "disturbance": NoDisturbance}
        for name in ("plant", "controller", "disturbance"):
            given = name in table or name not in defaults
            parts[name] = attempt(self.of_kind, name, table.get(name, {}), name) if given else defaults[name]()
        for name, cls in TABLES.items():
            parts[name] = attempt(self.component, cls, table.get(name, {}), name)
        parts["bounds"] = attempt(_mapping, table.get("bounds", {}), "bounds")
        for name, key in CHAINS.items():
            parts[name] = attempt(self.chains, table.get(key, {}), key, parts["plant"])
        if faults:
            raise ArgumentError(faults)
        return Scenario(**parts)

    def suggestion(self, path: str, known: Sequence[str]) -> str:
        """'; did you mean `x`?': a table of this scenario that has a parameter there, else a word that is near or all known."""
        return placed(path, self.tables()) or suggestion(path.partition(".")[0], known)

    def tables(self) -> Iterator[tuple[str, type[Component]]]:
        """The tables of this scenario by name, with the class of each whose kind is known."""
        for name in ("disturbance", "plant", "controller"):
            values = self.table.get(name)
            if isinstance(values, dict) and "kind" in values:
                with suppress(ArgumentError):
                    yield name, self.kind(name, values["kind"], name)
        yield from TABLES.items()

    def of_kind(self, table: str, values: Any, where: str) -> Any:
        """A component of the class that `kind` names."""
        values = _mapping(values, where)
        if "kind" not in values:
            known = ", ".join(f'"{cls.kind}"' for cls in KINDS[table])
            raise ArgumentError(f"Argument `{where}.kind` must be given, one of {known}.")
        cls = self.kind(table, values["kind"], where)
        return self.component(cls, {key: value for key, value in values.items() if key != "kind"}, where)

    def component(self, cls: type[Component], values: Any, where: str) -> Any:
        """A component from its table; inner tables become inner components."""
        values, hints = _mapping(values, where), hints_of(cls)
        names = [f.name for f in fields(cls)]
        faults = [f"Argument `{where}.{key}` is not known{self.suggestion(key, names)}" for key in values if key not in names]
        missing = [p for p in parameters(cls) if p.required and p.name not in values]
        faults += [f"Argument `{where}.{p.name}` must be given{f': {p.doc}' if p.doc else ''}." for p in missing]
        ready = {}
        for key in (key for key in values if key in names):
            try:
                ready[key] = self.value(hints[key], values[key], f"{where}.{key}")
            except ArgumentError as error:
                faults += error.lines
        if faults:
            raise ArgumentError(faults)
        try:
            return cls(**ready)
        except ArgumentError as error:
            raise error.under(where) from None

    def value(self, hint: Any, value: Any, where: str) -> Any:
        """A value as its type hint wants it: tables become components, also inside lists and tables; names of functions become
        functions; files get their folder."""
        base, extras = split_hint(hint)
        inner, kinds = get_args(base), {family: name for name, family in reversed(FAMILIES.items())}
        if isinstance(base, type) and issubclass(base, Component):
            return self.of_kind(kinds[base], value, where) if base in kinds else self.component(base, value, where)
        if any(isinstance(extra, InFile) for extra in extras) and isinstance(value, str) and value:
            return self.file(value, where)
        if isinstance(value, str) and any(get_origin(option) is Callable for option in inner):
            return self.function(value, where)
        if get_origin(base) is tuple and isinstance(value, list) and inner:
            return tuple(self.value(inner[0], v, f"{where}[{i}]") for i, v in enumerate(value))
        if get_origin(base) is dict and isinstance(value, dict):
            return {k: self.value(inner[1], v, f"{where}.{k}") for k, v in value.items()}
        if isinstance(value, dict) and inner:
            known = [option for option in inner if isinstance(option, type) and issubclass(option, Component)]
            return self.value(known[0], value, where) if known else value
        return value

    def chains(self, tables: Any, name: str, plant: Any) -> dict[str, tuple[Stage, ...]]:
        """The chain of every port: its own table, or the one of `all`."""
        chains: dict[str, tuple[Stage, ...]] = {}
        for port, table in _mapping(tables, name).items():
            where = f"{name}.{port}"
            table = _mapping(table, where)
            for key in table:
                if key != "chain":
                    raise ArgumentError(f"Argument `{where}.{key}` is not known{suggestion(key, ['chain'])}")
            chain = table.get("chain", [])
            if not isinstance(chain, list):
                raise wrong(f"{where}.chain", "be a list of tables", chain)
            chains[port] = tuple(self.of_kind(name, stage, f"{where}.chain[{i}]") for i, stage in enumerate(chain))
        common = chains.pop("all", None)
        if common is not None and plant is not None:
            chains = {port.name: chains.pop(port.name, common) for port in plant.ports} | chains
        return chains


def _first(key: str, table: Mapping[str, Any]) -> str:
    """The path of the first value that a table has under a key."""
    path, inner = [key], table[key]
    while isinstance(inner, dict) and inner:
        path.append(next(iter(inner)))
        inner = inner[path[-1]]
    return ".".join(path)


def _mapping(value: Any, where: str) -> Table:
    if not isinstance(value, dict):
        raise wrong(where, "be a table", value)
    return value
