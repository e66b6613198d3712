"""The C source of a blueprint: tables from its numbers, functions from its Python, templates around them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from jinja2 import Environment, PackageLoader, StrictUndefined, Template

from dampen.controllers.pointwise import PointwiseLearning
from dampen.export.c.blueprint import LARGEST, Blueprint, compensation
from dampen.export.c.learning import Learning, Slot, Table, learning_of
from dampen.export.c.numbers import literal, rows
from dampen.export.c.translate import Translator
from dampen.export.names import distinct
from dampen.release import version
from dampen.simulation.digital import Sample, follow, limited
from dampen.simulation.digital_law import COLUMNS, port_law

HELPERS = {
    "least": "static real least(real a, real b)\n{\n    return b < a ? b : a;\n}",
    "most": "static real most(real a, real b)\n{\n    return b > a ? b : a;\n}",
    "squared": "static real squared(real a)\n{\n    return a * a;\n}",
}
ARRAYS = {"state": "array", "new_state": "array", "parameters": "array"}


@dataclass(frozen=True)
class StageSlot:
    """A stage on the controller's side: its function, port, table of parameters, and where its state is kept."""

    function: str
    port: int
    table: str
    slot: str
    states: int


@dataclass(frozen=True)
class Source:
    """What the templates are filled with, and what the footprint counts."""

    blue: Blueprint
    learning: Learning
    tables: tuple[Table, ...]
    slots: tuple[Slot, ...]
    stages: tuple[StageSlot, ...]
    functions: str
    names: Mapping[str, Any]

    def file(self, name: str, **more: Any) -> str:
        """A file of the export."""
        return template(name).render(**self.names, **more)


@cache
def template(name: str, package: str = "dampen.export.c") -> Template:
    """A template of a package's folder of templates."""
    loader = PackageLoader(package)
    environment = Environment(
        loader=loader, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True
    )
    environment.filters |= {"remark": remark, "cell": cell}
    return environment.get_template(f"{name}.jinja")


def remark(text: str) -> str:
    """Text of the user's own as part of a comment, which it must not end; what cannot be seen becomes a space."""
    seen = " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())
    return re.sub(r"(?<=\*)(?=/)|(?<=/)(?=\*)|(?<=\?)(?=\?)", " ", seen)


def cell(text: str) -> str:
    """Text of the user's own in a cell of a table."""
    return remark(text).replace("|", "\\|")


def macros(names: Sequence[str]) -> list[str]:
    """Ports' names as parts of macros: another for each, also where they differ in no letter or digit."""
    return distinct([re.sub(r"[^A-Z0-9]", "_", name.upper()) for name in names])


def source_of(blue: Blueprint) -> Source:
    """Everything that the files of an export are made of."""
    learning = learning_of(blue)
    translator = Translator({"command": "DAMPEN_PORTS"}, ARRAYS, blue.single)
    for function in (follow, limited, blue.law):
        translator.add(function)
    if isinstance(blue.controller, PointwiseLearning):
        translator.add(type(blue.controller).relearn)
    stages, stage_tables, stage_slots = stages_of(blue, translator)
    tables = (*tables_of(blue, learning), *learning.tables, *stage_tables)
    slots = (*learning.slots, *stage_slots)
    names = names_of(blue, learning, tables, slots, stages, translator)
    return Source(blue, learning, tables, slots, stages, translator.text, names)


def tables_of(blue: Blueprint, learning: Learning) -> list[Table]:
    """What a trial is given, and the numbers of the estimator and the guards."""
    sampler = blue.sampler
    found = [
        by_sample("REFERENCE", sampler.reference, "what the ports are to follow"),
        by_sample("LOW", sampler.low, "lower limits of the tracking errors"),
        by_sample("HIGH", sampler.high, "upper limits of the tracking errors"),
    ]
    if not learning.memories or blue.learning == "pointwise":
        found.append(by_sample("FEEDFORWARD", sampler.feedforward, "the law's feedforward, without what is learned"))
    if len(learning.memories) < 2 or blue.learning == "pointwise":
        found.append(by_sample("COULOMB", sampler.coulomb, "what multiplies Sgn in the law, without what is learned"))
    gains = np.column_stack([sampler.gain_1, sampler.gain_2])
    return [
        *found,
        Table("GAINS", gains, "of the estimator, port by port: for the error, for its rate"),
        Table("CEILING", blue.ceiling[None, :], "the largest commands"),
        Table("BELIEVED", blue.believed, "least and largest reading that is believed, port by port"),
    ]


def by_sample(name: str, values: np.ndarray, note: str) -> Table:
    """A table with one row where all samples have the same."""
    moves = bool(np.any(values != values[0]))
    return Table(name, values if moves else values[:1], f"{note}, {'sample by sample' if moves else 'at all samples'}", moves)


def stages_of(blue: Blueprint, translator: Translator) -> tuple[tuple[StageSlot, ...], list[Table], list[Slot]]:
    """The stages on the controller's side."""
    stages, tables, slots = [], [], []
    for p, port in enumerate(blue.scenario.ports):
        for i, stage in enumerate(compensation(blue.scenario, p)):
            function = translator.add(type(stage).step)
            one = StageSlot(function.name, p, f"STAGE_{p}_{i}", f"stage_{p}_{i}", stage.states)
            stages.append(one)
            row = np.array([stage.row(blue.scenario.numerics.step) or (0.0,)])
            tables.append(Table(one.table, row, f"{type(stage).__name__} at {port}: what its function calls parameters"))
            if stage.states:
                slots.append(Slot(one.slot, f"[{stage.states}]", stage.states, f"of the {type(stage).__name__} at {port}"))
                tables.append(Table(f"{one.table}_START", np.array([stage.start()]).T, "its state at the start"))
    return tuple(stages), tables, slots


def names_of(
    blue: Blueprint, learning: Learning, tables: Sequence[Table], slots: Sequence[Slot], stages: Sequence[StageSlot],
    translator: Translator,
) -> dict[str, Any]:  # fmt: skip
    """The names that templates use."""
    sampling, single = blue.scenario.sampling, blue.single
    functions = translator.text
    written = [
        {
            "type": "double" if t.wide else "real",
            "name": t.name,
            "note": t.note,
            "rows": rows(t.values, single and not t.wide),
            "columns": t.values.shape[1],
        }
        for t in tables
    ]
    return {
        "title": blue.scenario.title or blue.scenario.name,
        "name": blue.scenario.name,
        "version": version(),
        "ports": blue.setting.ports,
        "macros": macros([port.name for port in blue.setting.ports]),
        "samples": blue.samples,
        "period": literal(blue.sampler.seconds, single),
        "seconds": literal(blue.sampler.seconds),
        "delay": literal(sampling.delay),
        "single": single,
        "tunable": blue.tunable,
        "states": len(blue.sampler.state),
        "patience": blue.guards.patience,
        "stop_at_constraint": blue.guards.stop_at_constraint,
        "reset": blue.scenario.task.start == "reset",
        "tables": written,
        "moves": {table.name: table.moves for table in tables},
        "parameters": [literal(value, single) for value in np.ravel(blue.sampler.parameters)],
        "parameter_note": f"of the law, port by port: {', '.join(COLUMNS)}" if law_name(blue) == "port_law" else "of the law",
        "fields": Sample._fields,
        "helpers": [text for name, text in HELPERS.items() if f"{name}(" in functions],
        "functions": functions,
        "law": law_name(blue),
        "learning": blue.learning,
        "memories": learning.memories,
        "slots": slots,
        "stages": stages,
        "largest": literal(LARGEST[not single], single),
        **learning.names,
    }


def law_name(blue: Blueprint) -> str:
    """What the law is called in C."""
    return "port_law" if blue.law.__code__ is port_law.__code__ else blue.law.__name__
