"""The variables of a unit: what can be set, connected and seen, each a member of the C model."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from annotated_types import Ge, Gt, Le, Lt

from dampen.component import hints_of, parameters, split_hint
from dampen.export.c.blueprint import Blueprint
from dampen.export.fmu.plant import Placed, Plant
from dampen.port import Port
from dampen.simulation.digital_law import COLUMNS, port_law

INPUT, OUTPUT, LOCAL, FIXED, TUNABLE = "INPUT", "OUTPUT", "LOCAL", "FIXED", "TUNABLE"
LARGEST = 1.7976931348623157e308
LAW = {
    "damping": "d in u = feedforward - d v - coulomb Sgn(v) - k e - barrier'(e)",
    "stiffness": "k in the same",
    "barrier": "gain of the barrier",
    "edge": "share of the constraint at which the barrier's command ends",
    "switching": "Sgn: 0 as it is, 1 in a boundary layer, 2 implicit",
    "layer": "half-width of the boundary layer",
    "compliance": "nominal compliance of the implicit Sgn",
    "pending": "what of it a command on its way will still do",
}
STATUS = "0 fine, 1 a reading was replaced, 4 stopped: sensor, 5 stopped: constraint crossed, 6 stopped: fault"


@dataclass(frozen=True)
class Variable:
    """A member of the model. at: in C; start: None where it is computed; whole: an int there."""

    name: str
    at: str
    role: str
    unit: str
    meaning: str
    start: float | None = None
    least: float = -LARGEST
    most: float = LARGEST
    whole: bool = False

    @property
    def kind(self) -> str:
        """What C knows of it."""
        return "SHOWN" if self.role in (OUTPUT, LOCAL) else self.role


def variables_of(plant: Plant, blue: Blueprint | None, what: str) -> list[Variable]:
    """All variables of a unit: "plant", "controller" or "loop"."""
    found: list[Variable] = []
    ports = plant.scenario.plant.ports
    if what != "controller":
        found += [*plant_signals(plant, "plant."), *pushes(plant)]
    if what == "plant":
        found += [signal(port, p, "drive", INPUT, "what goes to the actuator") for p, port in enumerate(ports)]
    if what == "controller":
        found += readings(plant)
    if blue is not None:
        found += commands(blue, OUTPUT if what == "controller" else LOCAL)
        found += [*estimates(blue), *law_parameters(blue)]
    found += [
        Variable("trial", "trial", OUTPUT, "", "the trial that is going on", whole=True),
        Variable("sample", "sample", OUTPUT, "", "the sample of the trial", whole=True),
    ]
    return found + (plant_parameters(plant, "plant.") if what != "controller" else [])


def signal(port: Port, p: int, name: str, role: str, meaning: str, motion: bool = False, at: str = "") -> Variable:
    """A signal at a port, a force there or a displacement."""
    unit = port.motion_unit if motion else effort(port)
    return Variable(
        f"{name}.{port.name}", f"{at or name}[{p}]", role, unit, f"{meaning}, {port.name}", 0.0 if role == INPUT else None
    )


def effort(port: Port) -> str:
    """The unit of what acts at a port, as FMI writes it."""
    return "N" if port.kind == "force" else "N.m"


def apart(plant: Plant) -> bool:
    """Whether the reading as a trial ends is another than that as the next one begins."""
    return plant.reset or plant.noisy


def readings(plant: Plant) -> list[Variable]:
    """The inputs of a controller."""
    ports = list(enumerate(plant.scenario.plant.ports))
    found = [signal(port, p, "reading", INPUT, "what the sensor shows", True) for p, port in ports]
    if apart(plant):
        found += [signal(port, p, "last_reading", INPUT, "what it showed as the last trial ended", True) for p, port in ports]
    return found


def plant_signals(plant: Plant, at: str) -> Iterator[Variable]:
    """What can be seen of a plant."""
    for p, port in enumerate(plant.scenario.plant.ports):
        rate = f"{port.motion_unit}/s"
        yield signal(port, p, "displacement", OUTPUT, "displacement, or angle", True, f"{at}displacement")
        yield signal(port, p, "reading", OUTPUT, "what the sensor shows since the last sample", True, f"{at}reading")
        if apart(plant):
            meaning = "what the sensor showed as the last trial ended"
            yield signal(port, p, "last_reading", OUTPUT, meaning, True, f"{at}last_reading")
        yield signal(port, p, "delivered", OUTPUT, "what the actuator delivered in the last time step", at=f"{at}delivered")
        yield Variable(f"velocity.{port.name}", f"{at}velocity[{p}]", LOCAL, rate, f"rate of displacement, {port.name}")
    yield Variable("energy", f"{at}energy", OUTPUT, "J", "kinetic and potential energy of the structure")
    for f, field in enumerate(plant.bench.modes.fields):
        for k, x in enumerate(plant.bench.x):
            meaning = f"{field.name} at x = {x:.6g} m"
            yield Variable(f"field.{field.name}[{k + 1}]", f"{at}field_{f}[{k}]", LOCAL, field.unit, meaning)


def pushes(plant: Plant) -> Iterator[Variable]:
    """What else may act on a plant, from outside."""
    for p, port in enumerate(plant.scenario.plant.ports):
        yield signal(port, p, "force", INPUT, "a further load at the port, held over the communication step")
    if plant.bench.modes.translation is not None:
        yield Variable("base_acceleration", "base_acceleration", INPUT, "m/s2", "a further acceleration of the base", 0.0)


def commands(blue: Blueprint, role: str) -> Iterator[Variable]:
    """What a controller gives out."""
    for p, port in enumerate(blue.setting.ports):
        yield signal(port, p, "drive", role, "what goes to the actuator")
        yield signal(port, p, "command", role, "what is to be delivered")
    yield Variable("status", "status", OUTPUT, "", STATUS, whole=True)


def estimates(blue: Blueprint) -> Iterator[Variable]:
    """What a controller makes of its readings."""
    for p, port in enumerate(blue.setting.ports):
        unit = port.motion_unit
        yield Variable(f"estimate.error.{port.name}", f"law.e_hat[{p}]", LOCAL, unit, f"tracking error as estimated, {port.name}")
        yield Variable(f"estimate.rate.{port.name}", f"law.v_hat[{p}]", LOCAL, f"{unit}/s", f"its rate, {port.name}")


def law_parameters(blue: Blueprint) -> Iterator[Variable]:
    """A law's numbers at the ports, and the limits of commands."""
    plain = blue.law.__code__ is port_law.__code__
    table = np.reshape(blue.sampler.parameters, (blue.ports, -1)) if plain else np.zeros((blue.ports, 0))
    for p, port in enumerate(blue.setting.ports):
        for i, value in enumerate(table[p]):
            name, (least, most) = COLUMNS[i], law_range(COLUMNS[i])
            at, unit = f"law.parameters[{p * len(COLUMNS) + i}]", law_unit(name, port)
            yield Variable(f"law.{port.name}.{name}", at, TUNABLE, unit, LAW[name], float(value), least, most)
        ceiling = float(blue.ceiling[p])
        yield Variable(f"law.{port.name}.limit", f"law.ceiling[{p}]", TUNABLE, effort(port), "largest command", ceiling, 0.0)


def law_range(name: str) -> tuple[float, float]:
    """Least and largest value of a law's number."""
    above = math.nextafter(0.0, 1.0)
    return {
        "edge": (above, math.nextafter(1.0, 0.0)),
        "switching": (0.0, 2.0),
        "layer": (above, LARGEST),
        "compliance": (above, LARGEST),
    }.get(name, (0.0, LARGEST))


def law_unit(name: str, port: Port) -> str:
    """Its unit."""
    force = port.kind == "force"
    soft = "m/(N.s)" if force else "rad/(N.m.s)"
    units = {
        "damping": "N.s/m" if force else "N.m.s/rad",
        "stiffness": "N/m" if force else "N.m/rad",
        "barrier": "J",
        "layer": f"{port.motion_unit}/s",
    }
    return units.get(name, soft if name in ("compliance", "pending") else "1")


def plant_parameters(plant: Plant, at: str) -> list[Variable]:
    """What can be changed of a plant before it moves: loads, sensors, actuators, its start."""
    found = [Variable("disturbance", f"{at}disturbance", TUNABLE, "1", "what is made of all loads of the scenario: 0 none", 1.0)]
    if plant.noisy:
        found.append(Variable("noise", f"{at}noise", TUNABLE, "1", "what is made of the sensors' noise: 0 none", 1.0))
    for p, port in enumerate(plant.scenario.plant.ports):
        meaning = "step of the sensor's quantiser, 0 none"
        found.append(
            Variable(f"quantum.{port.name}", f"{at}quantum[{p}]", FIXED, port.motion_unit, meaning, float(plant.quantum[p]), 0.0)
        )
    for placed in plant.stages:
        found += stage_parameters(plant, placed, at)
    for name, unit, start in zip(("q", "rate"), ("kg^(1/2).m", "kg^(1/2).m/s"), plant.bench.start, strict=True):
        for i, value in enumerate(start):
            meaning = f"mode {i + 1} at the start, {plant.bench.modes.omega[i] / (2 * np.pi):.6g} Hz"
            found.append(Variable(f"start.{name}[{i + 1}]", f"{at}{name}_start[{i}]", FIXED, unit, meaning, float(value)))
    return found


def stage_parameters(plant: Plant, placed: Placed, at: str) -> Iterator[Variable]:
    """The parameters of an actuator's stage that its function reads as they are."""
    port, cls = plant.scenario.plant.ports[placed.port], type(placed.stage)
    several = [other.stage.kind for other in plant.stages if other.port == placed.port].count(placed.stage.kind) > 1
    stage = f"{placed.stage.kind}_{placed.index + 1}" if several else placed.stage.kind
    for name, place in placed.adjustable:
        parameter = next(p for p in parameters(cls) if p.name == name)
        least, most = declared_range(cls, name)
        unit = {"N": effort(port), "": "1", "-": "1"}.get(parameter.unit, parameter.unit)
        where, start = f"{at}{placed.name}_row[{place}]", float(placed.row[place])
        yield Variable(f"actuator.{port.name}.{stage}.{name}", where, FIXED, unit, parameter.doc, start, least, most)


def declared_range(cls: type, name: str) -> tuple[float, float]:
    """Least and largest value of a component's parameter."""
    least, most = -LARGEST, LARGEST
    for mark in split_hint(hints_of(cls)[name])[1]:
        if isinstance(mark, Ge | Gt):
            bound = float(mark.ge if isinstance(mark, Ge) else mark.gt)  # type: ignore[arg-type]
            least = bound if isinstance(mark, Ge) else math.nextafter(bound, math.inf)
        elif isinstance(mark, Le | Lt):
            bound = float(mark.le if isinstance(mark, Le) else mark.lt)  # type: ignore[arg-type]
            most = bound if isinstance(mark, Le) else math.nextafter(bound, -math.inf)
    return least, most
