"""The C sources of a unit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import gcd
from typing import Any

import numpy as np

from dampen.export.c.blueprint import compensation
from dampen.export.c.numbers import literal, rows
from dampen.export.c.source import ARRAYS, HELPERS, Source, template
from dampen.export.c.translate import Translator
from dampen.export.fmu.plant import Plant
from dampen.export.fmu.variables import LARGEST, Variable, apart
from dampen.release import version

UNNAMED = "00000000-0000-0000-0000-000000000000"  # the GUID of nothing
MARK = b"dampen\x01\n"
FOLDER = "dampen.export.fmu"
NONE = "there are no variables of this type"
ABSENT = [  # functions of the interface that have nothing to do here: name, type of the values, what they answer
    ("fmi2GetBoolean", "fmi2Boolean", NONE),
    ("fmi2GetString", "fmi2String", NONE),
    ("fmi2SetInteger", "const fmi2Integer", "no integer variable can be set"),
    ("fmi2SetBoolean", "const fmi2Boolean", NONE),
    ("fmi2SetString", "const fmi2String", NONE),
]
STATUSES = [
    ("fmi2GetStatus", "fmi2Status"),
    ("fmi2GetRealStatus", "fmi2Real"),
    ("fmi2GetIntegerStatus", "fmi2Integer"),
    ("fmi2GetBooleanStatus", "fmi2Boolean"),
    ("fmi2GetStringStatus", "fmi2String"),
]


def timing(plant: Plant, what: str) -> tuple[float, str]:
    """The communication step that a unit is made for [s], and what is to be said of delay."""
    scenario = plant.scenario
    dt = scenario.numerics.step
    delay = delay_steps(plant)
    moving = moves_in_time(plant)
    step = dt if moving else gcd(plant.period, delay) * dt
    if what != "controller":
        return step, (
            f"Communication points at multiples of {dt:g} s; inputs are held in between; a trial takes {scenario.steps * dt:g} s."
        )
    held = (
        f"A command is put out {delay * dt:g} s after its reading, the controller's own delay: the communication step that "
        "co-simulation takes until the plant sees it is a part of that, and adds nothing as long as delay and sample period are "
        "multiples of it."
        if delay
        else "The design has no delay, but the plant sees a command one communication step late, unless the master lets the "
        "controller step first and hands on what it puts out in the same step."
    )
    if moving:
        held += f" Between samples what drives the actuators moves on, every {dt:g} s: the plant is to see it at each."
    return step, f"A sample every {plant.period * dt:g} s, which a communication step must not reach over. {held}"


def moves_in_time(plant: Plant) -> bool:
    """Whether a compensation moves on while its command is held: then what its function reads depends on the time step."""
    scenario, dt = plant.scenario, plant.scenario.numerics.step
    stages = [stage for p in range(len(scenario.ports)) for stage in compensation(scenario, p)]
    return any(tuple(stage.row(dt)) != tuple(stage.row(2 * dt)) for stage in stages)


def delay_steps(plant: Plant) -> int:
    """Time steps from a reading until its command acts."""
    scenario = plant.scenario
    return round(scenario.sampling.delay / scenario.numerics.step) if scenario.sampled else 0


def unit_sources(source: Source | None, what: str, names: Mapping[str, Any]) -> dict[str, str]:
    """The sources by file name, UNNAMED where the unit's GUID is to stand."""
    own = ["model.h", "model.c", "fmi2.c", "plant.h"] + (["plant.c"] if what != "controller" else [])
    found = {name: template(name, FOLDER).render(**names) for name in own}
    if source is not None:
        found |= {name: source.file(name) for name in ("controller.h", "controller.c")}
    return found


def page(plant: Plant, what: str, variables: Sequence[Variable], names: Mapping[str, Any]) -> str:
    """The unit's documentation."""
    brief = [v for v in variables if not v.name.startswith(("start.", "field."))]
    more = {"timing": timing(plant, what)[1], "variables": brief, "trials": plant.scenario.task.trials}
    return template("index.html", FOLDER).render(**{**names, **more})


def names_of(plant: Plant, source: Source | None, what: str, variables: Sequence[Variable]) -> dict[str, Any]:
    """What the templates are filled with."""
    scenario, bench = plant.scenario, plant.bench
    delay = delay_steps(plant)
    tables = plant.tables if what != "controller" else {}
    translator = Translator({}, ARRAYS)
    functions = [translator.add(type(placed.stage).step).name for placed in plant.stages]
    text = translator.text
    return {
        "title": scenario.title or scenario.name,
        "name": scenario.name,
        "version": version(),
        "about": {"plant": "the plant", "controller": "the controller", "loop": "plant and controller in closed loop"}[what],
        "plant": what != "controller",
        "law": source is not None,
        "driven": bool(source and source.stages),
        "apart": apart(plant),
        "reset": plant.reset,
        "noisy": plant.noisy,
        "misplaced": bool(tables and tables["misplaced"].size),
        "at_ports": bool(tables and tables["at_ports"].size),
        "ranks": plant.ranks if tables and any(plant.ranks) else (),
        "before": [sum(plant.ranks[:row]) for row in range(len(plant.ranks))] if tables else [],
        "rows": max(plant.row_of_trial) + 1,
        "row_of_trial": plant.row_of_trial,
        "table_sizes": {name: table.size for name, table in tables.items()} or {"at_ports": 0},
        "table_bytes": sum(table.nbytes for table in tables.values()),
        "mark": "{" + ", ".join(map(str, MARK)) + "}",
        "shakeable": bench.modes.translation is not None,
        "ports": scenario.plant.ports,
        "modes": bench.modes.count,
        "steps": scenario.steps,
        "samples": plant.samples,
        "period": plant.period,
        "delay": delay,
        "ring": max(1, -(-delay // plant.period)) + 1,
        "seconds": literal(scenario.numerics.step),
        "period_seconds": f"{plant.period * scenario.numerics.step:g}",
        "fields": [{"name": field.name, "points": len(bench.x)} for field in bench.modes.fields],
        "stages": [
            {
                "name": placed.name,
                "index": placed.port,
                "port": scenario.ports[placed.port],
                "kind": placed.stage.kind,
                "row": placed.row,
                "states": placed.stage.states,
                "start": [literal(value) for value in placed.stage.start()],
                "function": function,
            }
            for placed, function in zip(plant.stages, functions, strict=True)
        ],
        "tables": [] if what == "controller" else constants(plant),
        "helpers": [helper for name, helper in HELPERS.items() if f"{name}(" in text],
        "functions": text,
        "reals": [{"at": v.at, "kind": v.kind, "ends": f"{edge(v.least)}, {edge(v.most)}"} for v in variables if not v.whole],
        "integers": [{"at": v.at, "kind": v.kind} for v in variables if v.whole],
        "guid": UNNAMED,
        "absent": ABSENT,
        "statuses": STATUSES,
    }


def edge(value: float) -> str:
    """The end of a range in C."""
    return ("-" if value < 0 else "") + "HUGE_VAL" if abs(value) >= LARGEST else literal(value)


def constants(plant: Plant) -> list[dict[str, Any]]:
    """The constant tables of a plant."""
    bench, motion = plant.bench, plant.bench.motion
    one = {
        "C11": (motion.c11, "the exact step of each mode: q+ = C11 q + C12 q' + PSI a"),
        "C12": (motion.c12, "q'+ = C22 q' + C12 (a - OMEGA2 q)"),
        "C22": (motion.c22, "under a modal force a that is held"),
        "PSI": (motion.psi, "the same"),
        "OMEGA2": (bench.modes.omega**2, "square of its angular frequency"),
        "TRANSLATION": (plant.translation, "its inertia against a translation of the base"),
        "Q_START": (bench.start[0], "where it starts"),
        "RATE_START": (bench.start[1], "how fast"),
        "QUANTUM": (plant.quantum, "of the sensors, by port"),
    }
    if bench.modes.translation is None:
        del one["TRANSLATION"]
    found = [{"name": name, "note": note, "shape": f"[{len(v)}]", "rows": lines(v)} for name, (v, note) in one.items()]
    many = {"B": (bench.modes.b, "how ports push modes, and modes move ports")}
    many |= {f"SHAPES_{f}": (bench.shapes[field.name], field.name) for f, field in enumerate(bench.modes.fields)}
    found += [{"name": n, "note": note, "shape": f"[{len(v)}][{v.shape[1]}]", "rows": rows(v)} for n, (v, note) in many.items()]
    for placed in plant.stages:
        note = f"{type(placed.stage).__name__} at {plant.scenario.ports[placed.port]}: what its function calls parameters"
        values = lines(np.array(placed.row))
        found.append({"name": placed.name.upper(), "note": note, "shape": f"[{len(placed.row)}]", "rows": values})
    return found


def lines(values: np.ndarray) -> list[str]:
    """Numbers, eight on a line, without the last comma."""
    texts = [literal(v) for v in values]
    return [", ".join(texts[i : i + 8]) for i in range(0, len(texts), 8)]
