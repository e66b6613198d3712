"""A unit, written to a file: description, sources, library, tables."""

from __future__ import annotations

import re
import uuid
from collections.abc import Sequence
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Literal, get_args

from dampen.archive import archive, whole_file
from dampen.arguments import NOTHING, PATH, SCENARIO, TEXT, TRUTH, of_class, takes
from dampen.component import ArgumentError, wrong
from dampen.export.c.blueprint import Guards, blueprint
from dampen.export.c.source import Source, source_of
from dampen.export.fmu.building import library, library_ending, platform_folder
from dampen.export.fmu.description import model_description
from dampen.export.fmu.plant import Plant
from dampen.export.fmu.source import MARK, UNNAMED, names_of, page, timing, unit_sources
from dampen.export.fmu.variables import Variable, variables_of
from dampen.simulation.bench import Bench
from dampen.simulation.scenario import Scenario
from dampen.toml import to_toml

What = Literal["plant", "controller", "loop"]


@dataclass(frozen=True)
class Unit:
    """What was written. built: whether it has a library for this machine; step: the communication step it is made for [s]."""

    file: Path
    variables: Sequence[Variable]
    built: bool
    step: float
    timing: str


@takes(scenario=SCENARIO, file=PATH, guards=of_class("Guards") | NOTHING, build=TRUTH, what=TEXT)
def export_fmu(
    scenario: Scenario, file: str | Path, what: What = "loop", guards: Guards | None = None, build: bool = True
) -> Unit:
    """Write the scenario's plant, its sampled controller, or both in closed loop as a unit for co-simulation by FMI 2.0.

    what:   "plant": drives in, readings out;  "controller": readings in, drives out;  "loop": both, nothing left to connect.
    guards: how the controller looks after itself.
    build:  compile a library for this machine where there is a C compiler; the sources are in the unit in any case.

    Raises ArgumentError for what cannot be exported, and where the file cannot be written.
    """
    if what not in get_args(What):
        raise wrong("what", "be plant, controller or loop", what)
    file = Path(file)
    if file.suffix != ".fmu":
        raise ArgumentError(f"Output file `{file}` must end in .fmu.")
    if not file.absolute().parent.is_dir():
        raise ArgumentError(f"Output file `{file}` cannot be written: there is no folder {file.parent}.")
    bench = Bench(scenario)
    plant = Plant(scenario, bench)
    source = source_of(blueprint(scenario, False, guards, bench, tunable=True)) if what != "plant" else None
    variables = variables_of(plant, source.blue if source else None, what)
    identifier = re.sub(r"\W", "_", f"{scenario.name}_{what}", flags=re.ASCII)
    identifier = identifier if identifier[0].isalpha() else f"dampen_{identifier}"
    content, built, step, told = unit_files(plant, source, what, identifier, variables, build)
    with whole_file(file) as out:
        out.write(archive(content))
    return Unit(file, variables, built, step, told)


def unit_files(
    plant: Plant, source: Source | None, what: What, identifier: str, variables: Sequence[Variable], build: bool
) -> tuple[dict[str, bytes], bool, float, str]:
    """The files of a unit by their place in it; whether it was built, its communication step and what is said of that."""
    scenario = plant.scenario
    step, told = timing(plant, what)
    tables = b"".join(table.tobytes() for table in plant.tables.values()) if what != "controller" else b""
    names = names_of(plant, source, what, variables)
    unnamed = unit_sources(source, what, names)
    guid = str(uuid.uuid5(uuid.NAMESPACE_URL, "\n".join([what, *unnamed.values()]) + sha256(tables).hexdigest()))
    sources = {name: text.replace(UNNAMED, guid) for name, text in unnamed.items()}
    listed = sorted(name for name in sources if name.endswith(".c"))
    title = f"{scenario.title or scenario.name}: {what}. {told}"
    stop = scenario.steps * scenario.numerics.step * scenario.task.trials
    xml = model_description(identifier, identifier, guid, title, variables, listed, step, stop)
    content = {"modelDescription.xml": xml, "resources/scenario.toml": to_toml(scenario).encode()}
    content["documentation/index.html"] = page(plant, what, variables, names).encode()
    content |= {f"sources/{name}": text.encode() for name, text in sources.items()}
    if tables:
        content["resources/tables.bin"] = MARK + tables
    binary = library(sources, identifier) if build else None
    if binary is not None:
        content[f"binaries/{platform_folder()}/{identifier}{library_ending()}"] = binary
    return content, binary is not None, step, told
