"""A plant and a controller of the tests' own: any modes with any ports, and every term of the law at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

import numpy as np

import dampen
from dampen.controllers.base import Memory, PortLaw, Setting, Trial
from dampen.plants.base import Modes

Row = tuple[float, ...]


@dataclass(frozen=True)
class Lumps(dampen.Plant):
    """Modes as they are given; `b` has a row a port. Even ports are forces, odd ones torques."""

    kind: ClassVar[str] = "lumps"

    omega: Row
    decay: Row
    b: tuple[Row, ...]
    q: Row
    rate: Row

    @property
    def ports(self) -> tuple[dampen.Port, ...]:
        return tuple(dampen.Port(f"p{i}", "w", 1.0, "torque" if i % 2 else "force") for i in range(len(self.b)))

    def modes(self, count: int, grid: int | None = None) -> Modes:
        rows = (np.array(self.omega)[:count], np.array(self.b)[:, :count], np.array(self.decay)[:count])
        return Modes(omega=rows[0], b=np.ascontiguousarray(rows[1]), decay=rows[2], ports=self.ports)

    def initial_state(self, modes: Modes) -> tuple[np.ndarray, np.ndarray]:
        return np.array(self.q)[: modes.count], np.array(self.rate)[: modes.count]

    def initial_ports(self) -> Row:
        return tuple(float(y) for y in np.array(self.b) @ np.array(self.q))


def lumps(random: np.random.Generator, ports: int, modes: int, coupling: float, y: float = 0.02) -> Lumps:
    """Random modes up to some 300 rad/s: the first at zero frequency, then a light, an overdamped and a critically damped one.

    coupling: about |G_pr| / sqrt(G_pp G_rr) between all ports.   y: about the size of the initial displacements.
    """
    omega = np.sort(random.uniform(2, 300, modes))
    omega[0] = 0.0
    decay = random.uniform(0.001, 0.05, modes) * omega
    decay[0], decay[2], decay[3] = random.uniform(0, 0.5), 3 * omega[2], omega[3]
    common, own = random.standard_normal(modes), random.standard_normal((ports, modes))
    common[:4] = np.sign(common[:4]) * np.maximum(np.abs(common[:4]), 0.5)
    b = np.sqrt(coupling) * common + np.sqrt(1 - coupling) * own
    q = random.standard_normal(modes) / (1 + omega)
    q *= y / np.max(np.abs(b @ q))
    rate = 0.2 * random.standard_normal(modes) / (1 + omega / 20)
    return Lumps(tuple(omega), tuple(decay), tuple(map(tuple, b)), tuple(q), tuple(rate))


@dataclass(frozen=True)
class Everything(dampen.Controller):
    """All terms of the law, by port, a feedforward that oscillates, and memories that it adds the rate and its size to."""

    kind: ClassVar[str] = "everything"

    damping: Row
    stiffness: Row
    barrier_gain: Row
    coulomb: Row
    push: Row
    learning: float = 0.1
    barrier: Literal["log", "tan", "none"] = "log"

    @property
    def barrier_shape(self) -> Literal["log", "tan", "none"]:
        return self.barrier

    def begin(self, setting: Setting) -> Memory:
        nothing = np.zeros((setting.steps, len(setting.ports)))
        return {"pushed": nothing, "rubbed": nothing}

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        wave = np.sin(2 * np.pi * 3 * setting.times)[:, None]
        coulomb = np.array(self.coulomb)
        return PortLaw(
            feedforward=wave * np.array(self.push) + memory["pushed"],
            coulomb=coulomb + (coulomb > 0) * memory["rubbed"],
            damping=np.array(self.damping),
            stiffness=np.array(self.stiffness),
            barrier=np.array(self.barrier_gain) * (self.barrier != "none"),
        )

    def learn(self, memory: Memory, trial: Trial, setting: Setting) -> Memory:
        return {
            "pushed": memory["pushed"] - self.learning * trial.v,
            "rubbed": memory["rubbed"] + self.learning * np.abs(trial.v),
        }
