"""What the C controller learns between trials, as tables and memory: for each way of learning what its template asks for."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dampen.controllers.norm_optimal_ilc import ITERATIONS, TOLERANCE, NormOptimalILC
from dampen.controllers.p_type_ilc import PDTypeILC, PTypeILC, mirrored
from dampen.controllers.pointwise import PointwiseLearning
from dampen.export.c.blueprint import Blueprint
from dampen.export.c.numbers import literal

Array = np.ndarray


@dataclass(frozen=True)
class Slot:
    """A member of the controller's record. shape: in C; numbers: how many it holds; restart: what a new trial does to it."""

    name: str
    shape: str
    numbers: int
    note: str = ""
    type: str = "dampen_real"
    restart: str = ""


@dataclass(frozen=True)
class Table:
    """A constant table: (rows, columns). moves: whether it has a row for each sample, and not one for all; wide: of doubles,
    whatever the controller computes in."""

    name: str
    values: Array
    note: str
    moves: bool = False
    wide: bool = False


@dataclass(frozen=True)
class Learning:
    """memories: names of what is learned, (samples, ports) each; slots: all that is kept for it; names: for the template."""

    memories: tuple[str, ...] = ()
    slots: tuple[Slot, ...] = ()
    tables: tuple[Table, ...] = ()
    names: dict[str, Any] = field(default_factory=dict)


def learning_of(blue: Blueprint) -> Learning:
    """How the blueprint's controller learns."""
    controller = blue.controller
    if isinstance(controller, PointwiseLearning):
        return pointwise(blue, controller)
    if isinstance(controller, PTypeILC):
        return gains(blue, controller)
    if isinstance(controller, NormOptimalILC):
        return lifted(blue, controller)
    return Learning()


def a_trial(blue: Blueprint, name: str, note: str, type: str = "dampen_real", restart: str = "") -> Slot:
    """A number for every sample and port."""
    return Slot(name, "[DAMPEN_SAMPLES][DAMPEN_PORTS]", blue.samples * blue.ports, note, type, restart)


def pointwise(blue: Blueprint, controller: PointwiseLearning) -> Learning:
    """Both memories, and the law's own numbers by port."""
    row = np.asarray(controller.learning_row(blue.setting), float).T
    slots = tuple(a_trial(blue, name, f"learned {name}") for name in controller.memories)
    return Learning(controller.memories, slots, (Table("LEARNING", row, "what `relearn` calls row, port by port"),))


def gains(blue: Blueprint, controller: PTypeILC) -> Learning:
    """The learned commands; with a low-pass also room for one port's, extended at both ends."""
    setting, single = blue.setting, blue.single
    columns, slots = [setting.by_port(controller.learning)], [a_trial(blue, "learned", "learned commands")]
    if isinstance(controller, PDTypeILC):
        columns.append(setting.by_port(controller.rate_learning))
        slots.append(Slot("last", "[DAMPEN_PORTS]", blue.ports, "last tracking error"))
    names: dict[str, Any] = {
        "lead": round(controller.lead / setting.dt),
        "kept": literal(1 - controller.forgetting, single),
        "rate_learning": isinstance(controller, PDTypeILC),
        "filter": None,
    }
    if controller.cutoff is not None and controller.cutoff * setting.dt < 0.5:
        names["filter"] = low_pass(controller.cutoff, setting.dt, blue.samples, single)
        room = blue.samples + 2 * names["filter"]["pad"]
        slots.append(Slot("work", f"[{room}]", room, "for the low-pass"))
    note = "by port: learning gain" + (", and that on the rate" if len(columns) > 1 else "")
    return Learning(("learned",), tuple(slots), (Table("LEARNING", np.column_stack(columns), note),), names)


def low_pass(cutoff: float, dt: float, samples: int, single: bool) -> dict[str, Any]:
    """The section of `p_type_ilc.low_pass`, its state at rest under 1, and by how much signals are extended at both ends."""
    from scipy.signal import butter, sosfilt_zi

    sections = butter(2, cutoff, fs=1 / dt, output="sos")
    section, steady = sections[0], sosfilt_zi(sections)[0]
    write = {"b": section[:3], "a": section[3:], "steady": steady}
    return {"pad": mirrored(samples), **{name: [literal(v, single) for v in values] for name, values in write.items()}}


def lifted(blue: Blueprint, controller: NormOptimalILC) -> Learning:
    """The response of the structure, its weights, and the vectors of conjugate gradients: all in double, for what is to be solved
    is badly conditioned."""
    setting = blue.setting
    response = setting.response().reshape(blue.samples, -1)
    notes = {"learned": "learned commands", "rest": "", "way": "", "product": ""}
    slots = [a_trial(blue, *item, type="double") for item in notes.items()]
    slots.append(a_trial(blue, "error", "tracking errors; 0 as long as none is known", "double", "no_errors(c);"))
    names = {
        "effort": literal(controller.effort_weight),
        "ridge": literal(controller.effort_weight + controller.change_weight),
        "tolerance": literal(TOLERANCE),
        "iterations": ITERATIONS,
    }
    tables = (
        Table("RESPONSE", response, "errors, by port, after a unit of command, by port, in the first sample", True, True),
        Table("WEIGHT", setting.by_port(controller.error_weight, 1.0)[None, :], "of the error, by port", wide=True),
    )
    return Learning(("learned",), tuple(slots), tables, names)
