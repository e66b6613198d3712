"""Iterative learning with a gain on the error: P-type and PD-type."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Ge, Gt, Lt, Unit
from typing_extensions import Doc

from dampen.controllers.base import Array, Assumption, Controller, Memory, PortLaw, Setting, Trial, named
from dampen.controllers.scales import feedback, first_period, scales, span


@dataclass(frozen=True)
class PTypeILC(Controller):
    """P-type iterative learning control, beside an optional PD feedback.

        u_(j+1)(k) = Q [ (1 - forgetting) u_j(k) - learning e_j(k + 1 + lead) ],     e = y - reference
        command    = u_j - damping e' - stiffness e

    Q is a zero-phase low-pass: a second-order Butterworth filter run forwards and backwards. The error is taken one sample
    later than the command, and `lead` more: what a command does to a structure with inertia comes late. Sources: Arimoto,
    Kawamura and Miyazaki, J. Robotic Systems 1, 1984; Bristow, Tharayil and Alleyne, IEEE Control Systems Magazine 26, 2006.
    """

    kind: ClassVar[str] = "p-type-ilc"

    learning: Annotated[dict[str, float], Unit("N/m, N m/rad"), Doc("by port, learning gain")] = field(default_factory=dict)
    lead: Annotated[float, Ge(0), Unit("s"), Doc("how much later than one sample the error is taken")] = 0.0
    forgetting: Annotated[float, Ge(0), Lt(1), Doc("share of the learned command that is forgotten from trial to trial")] = 0.0
    cutoff: Annotated[float | None, Gt(0), Unit("Hz"), Doc("cut-off frequency of Q; left out: Q = 1")] = None
    damping: Annotated[dict[str, float], Ge(0), Unit("N s/m, N m s"), Doc("by port, damping of the feedback")] = field(
        default_factory=dict
    )
    stiffness: Annotated[dict[str, float], Ge(0), Unit("N/m, N m/rad"), Doc("by port, stiffness of the feedback")] = field(
        default_factory=dict
    )

    def ports_named(self) -> Mapping[str, str]:
        return named(learning=self.learning, damping=self.damping, stiffness=self.stiffness)

    @property
    def relies_on(self) -> tuple[Assumption, ...]:
        return ("equal starts", "repetition")

    def search(self, setting: Setting) -> Mapping[str, str]:
        """Learning gain and feedback of every port with an actuator in units of its static stiffness and impedance; forgetting
        up to a half, lead up to a quarter of the structure's first period, the cut-off from two periods a trial to just below
        half the sample rate. A port learns from its own error."""
        found = {f"learning.{s.port.name}": span(s.stiffness, 1e-3, 10) for s in scales(setting)}
        whole = {"lead": f"0:{first_period(setting) / 4:.3g}", "forgetting": "0:0.5"}
        whole["cutoff"] = f"{2 / (setting.steps * setting.dt):.3g}:{0.45 / setting.dt:.3g}:log"
        return {**found, **whole, **feedback(scales(setting))} if found else {}

    def begin(self, setting: Setting) -> Memory:
        return {"learned": np.zeros((setting.steps, len(setting.ports)))}

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        return PortLaw(memory["learned"], damping=setting.by_port(self.damping), stiffness=setting.by_port(self.stiffness))

    def learn(self, memory: Memory, trial: Trial, setting: Setting) -> Memory:
        raw = (1 - self.forgetting) * memory["learned"] - self.correction(trial, setting)
        return {"learned": low_pass(raw, self.cutoff, setting.dt)}

    def correction(self, trial: Trial, setting: Setting) -> Array:
        """(steps, ports) what the error of a trial adds to the command, with the sign turned."""
        shift = round(self.lead / setting.dt)
        late = np.minimum(np.arange(1, setting.steps + 1) + shift, setting.steps)
        return setting.by_port(self.learning) * trial.error[late]


@dataclass(frozen=True)
class PDTypeILC(PTypeILC):
    """PD-type iterative learning control: P-type with the error's rate.

        u_(j+1)(k) = Q [ (1 - forgetting) u_j(k) - learning e_j(k') - rate_learning (e_j(k') - e_j(k' - 1)) / T ],
        k' = k + 1 + lead

    Sources as for P-type.
    """

    kind: ClassVar[str] = "pd-type-ilc"

    rate_learning: Annotated[dict[str, float], Unit("N s/m, N m s"), Doc("by port, learning gain on the rate")] = field(
        default_factory=dict
    )

    def ports_named(self) -> Mapping[str, str]:
        return {**super().ports_named(), **named(rate_learning=self.rate_learning)}

    def search(self, setting: Setting) -> Mapping[str, str]:
        """As for P-type, and the gain on the rate in units of the impedance."""
        rate = {f"rate_learning.{s.port.name}": span(s.impedance, 1e-3, 10) for s in scales(setting)}
        return {**super().search(setting), **rate}

    def correction(self, trial: Trial, setting: Setting) -> Array:
        shift = round(self.lead / setting.dt)
        late = np.minimum(np.arange(1, setting.steps + 1) + shift, setting.steps)
        rate = (trial.error[late] - trial.error[late - 1]) / setting.dt
        return setting.by_port(self.learning) * trial.error[late] + setting.by_port(self.rate_learning) * rate


def low_pass(signal: Array, cutoff: float | None, dt: float) -> Array:
    """A zero-phase low-pass along the first axis; without a cut-off, or beyond half the sample rate, nothing is done."""
    if cutoff is None or cutoff * dt >= 0.5:
        return signal
    from scipy.signal import butter, sosfiltfilt

    section = butter(2, cutoff, fs=1 / dt, output="sos")
    return np.asarray(sosfiltfilt(section, signal, axis=0, padlen=mirrored(len(signal))))


def mirrored(samples: int) -> int:
    """By how many samples the low-pass goes on at both ends, with the mirror image: three for each coefficient, if there are."""
    return min(9, samples - 1)
