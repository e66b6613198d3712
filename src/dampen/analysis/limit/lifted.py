"""A whole run as one linear map: from the forces at the ports, all steps of all trials, to what is measured.

    e = free + P u,      means of squares as norms,      <P u, e> = <u, P* e>

u: (trials, steps, usable ports), in newtons: a torque counts as torque / span.   e: (trials, times, outputs).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from dampen.analysis.limit.measure import Measure, scales, usable
from dampen.analysis.limit.recursions import MODAL, PORT, pull_back, respond
from dampen.simulation.bench import Bench
from dampen.simulation.compiled import compiled
from dampen.simulation.scenario import Scenario

Array = np.ndarray


@dataclass(frozen=True)
class Lifted:
    """The map of a scenario and a measure, on a bench that is set up for the scenario."""

    scenario: Scenario
    bench: Bench
    measure: Measure

    @cached_property
    def scale(self) -> Array:
        """(modes,) frequency that a displacement is multiplied with to weigh like a rate; a rigid mode borrows the lowest."""
        omega = self.bench.modes.omega
        moving = omega[omega > 0]
        return np.where(omega > 0, omega, moving.min() if len(moving) else 2 * np.pi / self.scenario.task.trial_duration)

    @cached_property
    def usable(self) -> list[int]:
        """The ports that have an actuator."""
        return usable(self.scenario)

    @cached_property
    def outputs(self) -> Array:
        """(outputs, modes) what is measured of the first part of the states."""
        return np.ascontiguousarray(self.measure.outputs / self.scale)

    @cached_property
    def free(self) -> Array:
        """(trials, times, outputs) what is measured without forces."""
        return self.others + self.response(self.pushes)

    @cached_property
    def pushes(self) -> Array:
        """(trials, steps, usable ports) disturbance at the usable ports [N]."""
        own = [self.bench.shaking(j)[0][:, self.usable] for j in range(self.trials)]
        return np.stack(own) / scales(self.scenario)[self.usable]

    @cached_property
    def others(self) -> Array:
        """What is measured, reference taken off, of all else: start, load, disturbance at ports without an actuator."""
        modal, bench = self.modal(), self.bench
        found, none = self._empty(), np.zeros((self.steps, 0))
        unusable = [p for p in range(len(bench.modes.b)) if p not in self.usable]
        for j in range(self.trials):
            if j == 0 or not self.chained:
                q, rate = bench.state(j)
                modal["z1"][0, : len(q)], modal["z2"][0, : len(q)] = self.scale * q, rate
            disturbance, load, _ = bench.shaking(j)
            load = load[:, : bench.modes.count] + disturbance[:, unusable] @ bench.modes.b[unusable]
            compiled(respond)(modal, self.ports()[:0], none, load, self.measure.every, self.outputs, found[j])
        return found if self.measure.reference is None else found - self.measure.reference

    def under(self, forces: Array) -> Array:
        """free + P u. Forces and the disturbance beside them are added first: where one cancels the other, nothing is lost."""
        return self.others + self.response(self.pushes + forces)

    def response(self, forces: Array) -> Array:
        """P u."""
        modal, ports, found, none = self.modal(), self.ports(), self._empty(), np.zeros((0, 0))
        for j in range(self.trials):
            self.begin(modal)
            compiled(respond)(modal, ports, forces[j], none, self.measure.every, self.outputs, found[j])
        return found

    def adjoint(self, errors: Array) -> Array:
        """P* e."""
        modal, ports = self.modal(), self.ports()
        slopes = np.zeros((self.trials, self.steps, len(self.usable)))
        for j in self.backwards:
            self.begin(modal)
            compiled(pull_back)(modal, ports, errors[j] * self.share, self.measure.every, self.outputs, slopes[j])
        return slopes

    @property
    def steps(self) -> int:
        return self.scenario.steps

    @property
    def trials(self) -> int:
        return self.scenario.task.trials

    @property
    def chained(self) -> bool:
        return self.scenario.task.start == "chained"

    @property
    def backwards(self) -> Iterable[int]:
        return range(self.trials - 1, -1, -1)

    @property
    def share(self) -> float:
        """What one output at one time weighs against one port at one step, when both are taken in the mean."""
        times, outputs = self.steps // self.measure.every + 1, len(self.outputs)
        return self.steps / (times * outputs)

    def begin(self, modal: Any) -> None:
        """Let the next trial, or in reverse the one before, begin from rest where trials are not chained."""
        if not self.chained:
            modal["z1"], modal["z2"] = 0.0, 0.0

    def modal(self) -> Any:
        """A record of all modes at rest."""
        motion, n, s = self.bench.motion, self.bench.modes.count, self.scale
        rows = {"a11": motion.c11, "a12": s * motion.c12, "a21": motion.c21 / s, "a22": motion.c22}
        modal = np.zeros(1, MODAL).view(np.recarray)
        for name, row in (rows | {"e1": s * motion.psi, "e2": motion.c12}).items():
            modal[name][0, :n] = row
        modal["count"] = n
        return modal

    def ports(self) -> Any:
        """Records of the usable ports: what one newton, held over a step, does to the states."""
        motion, n = self.bench.motion, self.bench.modes.count
        ports = np.zeros(len(self.usable), PORT).view(np.recarray)
        b = (scales(self.scenario)[:, None] * self.bench.modes.b)[self.usable]
        ports["b1"][:, :n], ports["b2"][:, :n] = self.scale * motion.psi * b, motion.c12 * b
        return ports

    def _empty(self) -> Array:
        return np.zeros((self.trials, self.steps // self.measure.every + 1, len(self.outputs)))


def mean_square(values: Array) -> float:
    """Mean over trials, times and outputs."""
    return float(np.mean(np.square(values)))


def effort_square(forces: Array) -> float:
    """Mean over trials and steps of the sum over ports."""
    return float(np.sum(np.square(forces)) / (forces.shape[0] * forces.shape[1]))
