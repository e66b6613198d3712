"""What can push energy into a closed loop at most, from the stated bounds; and why there is no such bound where there is none."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from dampen.analysis.growth import largest_energy
from dampen.controllers.base import PortLaw, Setting
from dampen.simulation.bench import Bench
from dampen.simulation.scenario import Scenario
from dampen.stage import Stage

Array = np.ndarray


class NoBound(Exception):
    """There is no bound; the message is the reason."""


@dataclass(frozen=True)
class Supply:
    """V' <= sum_p max_v (push_p |v| - damping_p v^2) + load sqrt(2 V),    |v_p| <= reach_p sqrt(2 V)

    push: (ports,) [N, N m] what disturbance, feedforward and the actuator's deviation come to beyond dry friction.
    damping: (ports,) as it is delivered [N s/m, N m s].   reach: (ports,) sqrt(sum_i b_pi^2) [1/sqrt(kg)].
    load: f_bar sqrt(int dx / rho) [N/sqrt(kg)].
    """

    push: Array
    damping: Array
    reach: Array
    load: float

    def largest(self, t: Array, initial: float) -> Array:
        """(times,) the largest V that this allows [J]: for each port push^2 / (4 damping) or push reach sqrt(2 V), whichever
        choice gives less at the time."""
        either = [
            ((push**2 / (4 * damping), 0.0), (0.0, push * reach)) if damping > 0 and push > 0 else ((0.0, push * reach),)
            for push, damping, reach in zip(self.push, self.damping, self.reach, strict=True)
        ]
        bounds = []
        for choice in product(*either):
            power, push = (float(sum(terms)) for terms in zip(*choice, strict=True))
            bounds.append(largest_energy(t, initial, power, push + self.load))
        return np.asarray(np.min(bounds, axis=0))


def supply(scenario: Scenario, law: PortLaw, setting: Setting, bench: Bench, disturbed: Sequence[bool]) -> Supply:
    """The supply under the law of one trial. disturbed: for each port whether any disturbance was seen there.

    Raises NoBound where something can push that no stated bound covers.
    """
    if scenario.sampled:
        raise NoBound("A law that acts through samples is not passive: what it holds between samples can push.")
    if scenario.task.reference:
        raise NoBound("There is a reference: the error then moves by it too, and no stated bound says how much that brings in.")
    if np.any(law.barrier > 0) and not scenario.task.steady:
        raise NoBound("The constraint moves, and with it the barrier: that brings in energy that no stated bound covers.")
    push = [_port_push(scenario, law, setting, bench, p, disturbed[p]) for p in range(len(scenario.ports))]
    reach = np.sqrt(np.sum(bench.modes.b**2, axis=1))
    return Supply(np.array(push), setting.gains * law.damping, reach, _load(scenario, bench))


def _port_push(scenario: Scenario, law: PortLaw, setting: Setting, bench: Bench, p: int, disturbed: bool) -> float:
    """(d_bar + w + gain max |feedforward| - gain coulomb)_+ of one port [N, N m]."""
    port, gain = scenario.ports[p], float(setting.gains[p])
    if port not in scenario.bounds and disturbed:
        raise NoBound(f"No bound is stated for the disturbance at {port}.")
    low, high = (0.0, 0.0) if _idle(scenario, law, bench, p) else deviation(scenario.chain(p))
    if not math.isfinite(low) or not math.isfinite(high):
        names = ", ".join(type(stage).__name__ for stage in scenario.chain(p) if not math.isfinite(sum(stage.deviation)))
        raise NoBound(f"At {port} {names} may deviate from its slope without limit.")
    given = scenario.bounds.get(port, 0.0) + max(high, -low) + gain * float(np.abs(law.feedforward[:, p]).max())
    return max(given - gain * float(law.coulomb[:, p].min()), 0.0)


def deviation(chain: Sequence[Stage]) -> tuple[float, float]:
    """The least and the largest that a chain's output can be off its slope times the input: each stage's own deviation goes
    through the slopes of those behind it."""
    low = high = 0.0
    for stage in chain:
        gain, (least, most) = stage.gain, stage.deviation
        low, high = (gain * low + least, gain * high + most) if gain else (least, most)
    return low, high


def _idle(scenario: Scenario, law: PortLaw, bench: Bench, p: int) -> bool:
    """Whether nobody commands anything at a port, and its actuator then delivers nothing."""
    acts = law.damping[p] or law.stiffness[p] or law.barrier[p] or np.any(law.coulomb[:, p]) or np.any(law.feedforward[:, p])
    command = 0.0
    for stage in scenario.chain(p):
        state = np.array(stage.start() or (0.0,), float)
        command = float(type(stage).step(command, state, np.array(stage.row(bench.step.dt), float), state.copy()))
    return not acts and command == 0.0


def _load(scenario: Scenario, bench: Bench) -> float:
    """f_bar sqrt(int dx / rho) over the loaded fields: |int f v dx| <= f_bar int |v| dx, and that by Cauchy and Schwarz."""
    fields = set()
    for part in scenario.disturbance.parts:
        if part.point_field is not None:
            raise NoBound("A concentrated load acts on the structure, for which no bound is stated.")
        if part.base_acceleration(0, bench.midpoints, bench.site) is not None:
            raise NoBound("The base is shaken, for which no bound is stated.")
        if part.load_field is not None:
            fields.add(part.load_field)
    if fields and "f" not in scenario.bounds:
        raise NoBound("No bound is stated for the distributed load.")
    total = 0.0
    for name in sorted(fields):
        field, rule = bench.modes.field(name), bench.modes.rule
        inertia = None if field.inertia is None or rule is None else field.inertia(rule[0])
        if inertia is None or rule is None or not np.all(inertia > 0):
            raise NoBound(f"The load acts on {name}, whose inertia along x is zero or not known.")
        total += scenario.bounds["f"] * math.sqrt(float(np.sum(rule[1] / inertia)))
    return total
