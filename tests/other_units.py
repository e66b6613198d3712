"""A scenario in other units of length, mass and time: every number times the factor that its declared unit says."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

import numpy as np

from dampen.component import parameters
from dampen.port import Port
from dampen.simulation.result import Result
from dampen.simulation.scenario import Scenario

# exponents of length, mass, time
BASE = {
    "m": (1, 0, 0), "kg": (0, 1, 0), "s": (0, 0, 1), "Hz": (0, 0, -1), "rad": (0, 0, 0), "1": (0, 0, 0),
    "N": (1, 1, -2), "J": (2, 1, -2),
}  # fmt: skip
BOUNDS = {"f": "N/m"}  # of what a controller is told; all others are by port
POLYNOMIALS = ("BeamState", "Deflection")
BY_PORT = {  # of what a result has by port, for forces and for torques
    "y": "m, rad", "v": "m/s, rad/s", "reference": "m, rad", "reading": "m, rad", "rate_estimate": "m/s, rad/s",
    "command": "N, N m", "delivered": "N, N m", "disturbance": "N, N m", "issued": "N, N m",
    "zeta": "N, N m", "d_hat": "N, N m", "learned": "N, N m",
}  # fmt: skip
ACCOUNTS = re.compile("energy|work|dissipated|loss")


@dataclass(frozen=True)
class Units:
    """How many of the new units one of the old ones is: 2.0 for a length makes 1 m the number 2."""

    length: float = 1.0
    mass: float = 1.0
    time: float = 1.0

    def factor(self, unit: str) -> float:
        """Of a unit such as "N s/m", "1/(N m)^2" or ""."""
        over, _, under = unit.partition("/")
        return self._product(over) / self._product(under)

    def _product(self, text: str) -> float:
        found = 1.0
        for inside, powered, plain, power in re.findall(r"\(([^)]*)\)(?:\^(\d))?|(\w+)(?:\^(\d))?", text):
            if inside:
                found *= self._product(inside) ** int(powered or 1)
            else:
                length, mass, time = BASE[plain]
                found *= (self.length**length * self.mass**mass * self.time**time) ** int(power or 1)
        return found


def at_port(unit: str, port: Port | None) -> str:
    """The unit at a port: of "N, N m", or plain "N" for a force that is a torque there."""
    force, *torque = unit.split(", ")
    if port is None or port.kind == "force":
        return force
    return torque[0] if torque else {"N": "N m", "N/s": "N m/s"}.get(force, force)


def in_units(scenario: Scenario, units: Units) -> Scenario:
    """The same experiment, written in other units."""
    ports = {port.name: port for port in scenario.plant.ports}
    changed = {f.name: scaled(getattr(scenario, f.name), units, ports) for f in fields(scenario)}
    for name in ("actuators", "compensation"):
        chains = getattr(scenario, name)
        changed[name] = {p: tuple(scaled(s, units, ports, port=ports[p]) for s in chain) for p, chain in chains.items()}
    told = scenario.bounds
    changed["bounds"] = {k: v * units.factor(BOUNDS.get(k) or at_port("N, N m", ports[k])) for k, v in told.items()}
    return replace(scenario, **changed)


def scaled(thing: Any, units: Units, ports: dict[str, Port], unit: str = "", port: Port | None = None) -> Any:
    """A number, a table, a list or a component in other units; `unit`: what it is in, `port`: where it is."""
    if isinstance(thing, bool) or thing is None or isinstance(thing, int | str):
        return thing
    if isinstance(thing, float):
        return thing * units.factor(at_port(unit, port))
    if isinstance(thing, tuple):
        return tuple(scaled(one, units, ports, unit, port) for one in thing)
    if isinstance(thing, dict):
        return {key: scaled(value, units, ports, unit, ports.get(key, port)) for key, value in thing.items()}
    if not is_dataclass(thing):
        return thing
    changed = {}
    known = {p.name: p.unit for p in parameters(type(thing))}
    for name in (f.name for f in fields(thing) if f.init):
        value, own = getattr(thing, name), known.get(name) or (unit if is_signal(thing) else "")
        if type(thing).__name__ in POLYNOMIALS:
            value = tuple(c / units.length**k for k, c in enumerate(value))
        if name == "assumed_torque_backlash":
            value = value or thing.assumed_backlash
        torque = next((p for p in ports.values() if p.kind == "torque"), None) if "torque" in name else port
        changed[name] = scaled(value, units, ports, own, torque)
    return replace(thing, **changed)


def is_signal(thing: Any) -> bool:
    """Whether its numbers are in the unit of what it is for."""
    return type(thing).__module__.startswith("dampen.signals") or type(thing).__name__ == "Constraint"


def difference(old: Result, new: Result, units: Units, leave_out: Sequence[str] = ()) -> float:
    """The largest difference of two results in the old units, of the largest of its kind; energies and works are one kind."""
    ports = old.layout.scenario.plant.ports
    accounts, worst = 0.0, 0.0
    found = []
    for name, variable in old.layout.variables.items():
        if name in ("status", "unsettled", "peak", *leave_out) or variable.kind == "f4":
            continue
        unit = variable.unit or BY_PORT[name]
        factors = units.factor(unit) if variable.unit else np.array([units.factor(at_port(unit, port)) for port in ports])
        a, b = np.asarray(old[name], float), np.asarray(new[name], float) / factors
        size = np.abs(a).max(initial=0.0)
        found.append((name, np.abs(a - b).max(initial=0.0), size))
        if ACCOUNTS.search(name):
            accounts = max(accounts, size)
    for name, off, size in found:
        of = accounts if ACCOUNTS.search(name) else size
        worst = max(worst, off / of if of else off)
    return worst
