"""audit.json: every number of an audit and of what goes with it, beside the result, in one schema."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from dampen.analysis.audit.audit import Audit
from dampen.analysis.credit import Credit
from dampen.analysis.limit.curve import Limit
from dampen.analysis.limit.standing import Standing
from dampen.component import ArgumentError
from dampen.release import version
from dampen.simulation.scenario import Scenario
from dampen.studies.compare.comparison import Comparison
from dampen.toml import to_toml

SCHEMA = "dampen-audit/1"
FILE = "audit.json"
APART = {"comparison": ("results", "experiment")}  # files of their own, and the scenario, which is there already


@dataclass(frozen=True)
class Record:
    """What audit.json holds; a part that was not asked for is null. schema: name and version of this layout.

    scenario: as TOML.   version: of dampen.   standings: of the run, one for each of the limits.   A number that is not known, or
    not finite, is null.
    """

    schema: str
    version: str
    name: str
    scenario: str
    audit: Audit | None = None
    credit: Credit | None = None
    limits: tuple[Limit, ...] = ()
    standings: tuple[Standing, ...] = ()
    comparison: Comparison | None = None


def record(scenario: Scenario, **parts: Any) -> Record:
    """The record of a scenario with these parts."""
    return Record(SCHEMA, version(), scenario.name, to_toml(scenario), **parts)


def write_record(folder: Path, found: Record) -> Path:
    """Write audit.json; returns its path. Raises ArgumentError where it cannot be written."""
    path = Path(folder) / FILE
    try:
        path.write_text(json.dumps(plain(found), indent=1) + "\n", encoding="utf-8")
    except OSError as error:
        raise ArgumentError(f"File `{path}` cannot be written: {error.strerror or error}.") from None
    return path


def plain(found: Record) -> dict[str, Any]:
    """The record as JSON has it."""
    values: dict[str, Any] = json.loads(_adapter().dump_json(found, exclude={part: set(names) for part, names in APART.items()}))
    return values


def schema() -> dict[str, Any]:
    """The JSON Schema of audit.json."""
    found = _or_null(_adapter().json_schema(mode="serialization"))
    for name in APART["comparison"]:
        del found["$defs"]["Comparison"]["properties"][name]
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **found}


@cache
def _adapter() -> Any:
    from pydantic import TypeAdapter

    return TypeAdapter(Record)


def _or_null(node: Any) -> Any:
    """The schema, with every number allowed to be null: one that is not known, or not finite."""
    if isinstance(node, list):
        return [_or_null(item) for item in node]
    if not isinstance(node, dict):
        return node
    inner = {key: _or_null(value) for key, value in node.items()}
    return {**inner, "type": ["number", "null"]} if node.get("type") == "number" else inner
