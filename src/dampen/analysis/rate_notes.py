"""What has to be known with decay rates: what a linear loop leaves out, and what a payload does to the continuum."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np

from dampen.controllers.base import PortLaw, Setting
from dampen.modal import ModalModel
from dampen.plants.base import Modes
from dampen.simulation.memory import begun
from dampen.simulation.scenario import Scenario

Array = np.ndarray
FALLS = 0.99  # a rate less than this of the one before has fallen
WHERE = 1e-9  # lumps and ports nearer than this share of the span are in one place


def law_notes(scenario: Scenario, law: PortLaw, setting: Setting) -> list[str]:
    """What the linear loop leaves out of the law."""
    notes = []
    if scenario.sampled and scenario.sampling.command_limit:
        notes.append("The controller's limits of its commands are left out.")
    if np.any(setting.gains * law.barrier > 0):
        notes.append("The barrier counts with its curvature at zero error: farther out it is stiffer.")
    if begun(scenario, setting):
        notes.append("The law learns between trials: these are the rates of trial 0; a learned feedforward does not move them.")
    return notes


def stage_notes(scenario: Scenario, setting: Setting, driven: Sequence[bool]) -> list[str]:
    """Which actuators are taken for linear that are not."""
    curved: dict[str, list[str]] = {}
    for p, port in enumerate(scenario.ports):
        names = [type(stage).__name__ for stage in scenario.chain(p) if not stage.is_linear]
        if names and driven[p]:
            curved.setdefault(f"slope {setting.gains[p]:.4g} of {', '.join(names)}", []).append(port)
    return [
        f"At {', '.join(ports)} the rates hold for the {what} in full motion: where motion is large against gaps and within "
        "limits. Smaller or larger motion decays otherwise."
        for what, ports in curved.items()
    ]


def payloads(modes: Modes, damped: Array) -> dict[str, float]:
    """The damped ports at which a lumped inertia sits, with that inertia [kg, kg m^2]."""
    found = {}
    for port, is_damped in zip(modes.ports, damped, strict=True):
        lumps = [lump for f in modes.fields if f.name == port.field for lump in f.lumps]
        near = WHERE * max([abs(x) for x, _ in lumps], default=0.0)
        there = sum(inertia for x, inertia in lumps if abs(x - port.x) <= near)
        if is_damped and there > 0:
            found[port.name] = there
    return found


def payload_note(payload: dict[str, float], slowest: Sequence[tuple[int, float]], plant_damped: bool, own: bool) -> str:
    """The warning that comes with an inertia at the law's ports; its figures where they bear it out. own: whether the rate of
    the slowest motion is for the most part that of the plant alone."""
    where = f"There is inertia where the law damps, at {', '.join(payload)}"
    rates = [rate for _, rate in slowest]
    if len(rates) > 1 and all(after < FALLS * before for before, after in pairwise(rates)):
        falls = ", ".join(f"{rate:.3g} 1/s with {n}" for n, rate in slowest)
        left = (
            "towards high modes only the plant's own damping is left"
            if plant_damped
            else "the continuum has no uniform decay rate"
        )
        return (
            f"{where}: the higher a mode, the less it moves there; {left}. The slowest of the modes kept decays at {falls} modes."
        )
    if own:
        return f"{where}: what the law adds falls towards high modes; the structure's own damping sets the slowest rate."
    left = "only the plant's own damping is left" if plant_damped else "no uniform decay rate is left"
    return f"{where}: towards high modes {left}. Among the modes kept it is not yet what sets the slowest rate."


def evidence(model: ModalModel, slowest: Callable[[ModalModel], float]) -> tuple[tuple[int, float], ...]:
    """(modes, slowest rate [1/s]) of the loop around a quarter of the modes, a half, and all."""
    found = []
    for n in sorted({max(1, model.count // 4), max(1, model.count // 2), model.count}):
        found.append((n, slowest(ModalModel(omega=model.omega[:n], b=model.b[:, :n], decay=model.decay[:n]))))
    return tuple(found)
