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
from dampen.simulation.closure import RELAXATION, SOFTNESS
from dampen.simulation.scenario import Scenario
from dampen.stage import Stage

Array = np.ndarray


MOST = 300.0  # exponent of the bound's growth beyond which it says nothing, and must not overflow


class NoBound(Exception):
    """There is no bound; the message is the reason."""


@dataclass(frozen=True)
class Supply:
    """V' <= sum_p max_(v, x, z) [push_p |v| - damping_p v^2 + stated_p soft_p |x| - m soft_p x^2
                                + (damping_p |v| + all_p) soft_p |z|] + load sqrt(2 V)

    v: the velocity that the law sees.   x, z: how far the delivered force, but for barrier and stiffness, and that of the
    stiffness are off their slow parts (`simulation.closure`); the port moves with v - soft (x + z).   m = 1 - RELAXATION / 2.
    |v - soft (x + z)| <= reach sqrt(2 V),    |z| <= 2 sqrt(stiffness) sqrt(2 V).
    push: (ports,) [N, N m] what disturbance, feedforward and the actuator's deviation come to beyond dry friction; all: together
    with it.   damping, stiffness: (ports,) as delivered [N s/m, N m s], [N/m, N m].   reach: (ports,) sqrt(sum_i b_pi^2)
    [1/sqrt(kg)].   load: f_bar sqrt(int dx / rho) [N/sqrt(kg)].   stated: (ports,) the disturbance's bound [N, N m].
    soft: (ports,) numerical compliance, 0 where nothing is commanded [m/(N s), rad/(N m s)].
    """

    push: Array
    all: Array
    damping: Array
    stiffness: Array
    reach: Array
    load: float
    stated: Array
    soft: Array

    @property
    def growth(self) -> float:
        """The rate k at which the bound grows by what the compliance exchanges between damping and stiffness [1/s]."""
        return float(np.sum(2 * self.damping * self.soft**2 * self.stiffness))

    def largest(self, t: Array, initial: float) -> Array:
        """(times,) the largest V that this allows [J]: for each port the law's damping takes what pushes, or it is left out and
        push reach sqrt(2 V) comes in; whichever choice gives less at the time. V' <= a + c sqrt(2 V) + k V lets V rise to
        e^(k t) times what it would rise to without k."""
        bounds = []
        for choice in product(*(self.choices(p) for p in range(len(self.push)))):
            power, push = (float(sum(terms)) for terms in zip(*choice, strict=True))
            bounds.append(largest_energy(t, initial, power, push + self.load))
        return np.asarray(np.min(bounds, axis=0) * np.exp(np.minimum(self.growth * t, MOST)))

    def choices(self, p: int) -> list[tuple[float, float]]:
        """Power [W] and push [N/sqrt(kg)] of a port, without what grows with V: push^2 / (4 damping) + soft stated^2 / (4 m) and
        s (all + push / 2), or soft (stated + push)^2 / (4 m) and push reach + s (all + push), with
        s = 2 soft sqrt(stiffness)."""
        push, damping, everything, stated = (float(given[p]) for given in (self.push, self.damping, self.all, self.stated))
        soft = float(self.soft[p]) / (4 - 2 * RELAXATION)
        spring = float(2 * self.soft[p] * np.sqrt(self.stiffness[p]))
        undamped = (soft * (stated + push) ** 2, push * float(self.reach[p]) + spring * (everything + push))
        if push == 0 or damping == 0:
            return [undamped]
        return [(push**2 / (4 * damping) + soft * stated**2, spring * (everything + push / 2)), undamped]


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
    given = [_port_push(scenario, law, setting, bench, p, disturbed[p]) for p in range(len(scenario.ports))]
    push, everything = np.array(given).T
    idle = np.array([_idle(scenario, law, bench, p) for p in range(len(scenario.ports))])
    return Supply(
        push=push,
        all=everything,
        damping=setting.gains * law.damping,
        stiffness=setting.gains * law.stiffness,
        reach=np.sqrt(np.sum(bench.modes.b**2, axis=1)),
        load=_load(scenario, bench),
        stated=setting.by_port(scenario.bounds),
        soft=np.where(idle, 0.0, SOFTNESS * np.diag(bench.step.g)),
    )


def _port_push(scenario: Scenario, law: PortLaw, setting: Setting, bench: Bench, p: int, disturbed: bool) -> tuple[float, float]:
    """(d_bar + w + gain max |feedforward| - gain coulomb)_+ of one port, and the same with + gain coulomb [N, N m]."""
    port, gain = scenario.ports[p], float(setting.gains[p])
    if port not in scenario.bounds and disturbed:
        raise NoBound(f"No bound is stated for the disturbance at {port}.")
    low, high = (0.0, 0.0) if _idle(scenario, law, bench, p) else deviation(scenario.chain(p))
    if not math.isfinite(low) or not math.isfinite(high):
        names = ", ".join(type(stage).__name__ for stage in scenario.chain(p) if not math.isfinite(sum(stage.deviation)))
        raise NoBound(f"At {port} {names} may deviate from its slope without limit.")
    given = scenario.bounds.get(port, 0.0) + max(high, -low) + gain * float(np.abs(law.feedforward[:, p]).max())
    coulomb = law.coulomb[:, p]
    return max(given - gain * float(coulomb.min()), 0.0), given + gain * float(coulomb.max())


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
