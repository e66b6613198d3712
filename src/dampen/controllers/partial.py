"""A law with some of its terms left out: what an ablation runs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from dampen.controllers.base import LAW, Controller, Memory, PortLaw, Setting, Trial
from dampen.port import Port
from dampen.stage import Stage


@dataclass(frozen=True)
class PartialLaw(Controller):
    """Another controller's law without some of its `terms`; it goes on learning as it did.

    leave_out: names of terms.   forget: whether nothing is carried from trial to trial.   bare: whether the controller's own
    compensation of the actuator is left out too.
    """

    controller: Controller
    leave_out: tuple[str, ...] = ()
    forget: bool = False
    bare: bool = False

    @property
    def barrier_shape(self) -> Literal["log", "tan", "none"]:
        return "none" if "barrier" in self.leave_out else self.controller.barrier_shape

    def has_barrier(self, port: Port) -> bool:
        return "barrier" not in self.leave_out and self.controller.has_barrier(port)

    @property
    def needs_bounds(self) -> tuple[str, ...]:
        return self.controller.needs_bounds

    def ports_named(self) -> Mapping[str, str]:
        return self.controller.ports_named()

    def compensation(self, port: Port) -> tuple[Stage, ...]:
        return () if self.bare else self.controller.compensation(port)

    def begin(self, setting: Setting) -> Memory:
        return self.controller.begin(setting)

    def law(self, memory: Memory, setting: Setting) -> PortLaw:
        law = PortLaw(np.zeros((setting.steps, len(setting.ports))))
        for name, term in taken_apart(self.controller, memory, setting).items():
            if name not in self.leave_out:
                law = law + term
        return law

    def learn(self, memory: Memory, trial: Trial, setting: Setting) -> Memory:
        return self.begin(setting) if self.forget else self.controller.learn(memory, trial, setting)


def taken_apart(controller: Controller, memory: Memory, setting: Setting) -> Mapping[str, PortLaw]:
    """The terms of a controller's law, those of zero left out; the law's bare parts where its terms do not add up to it."""
    law, terms = controller.law(memory, setting), controller.terms(memory, setting)
    sums = {part: sum(getattr(term, part) for term in terms.values()) for part in LAW}
    adds_up = all(np.allclose(sums[part], getattr(law, part), rtol=1e-9, atol=1e-300) for part in LAW)
    return {name: term for name, term in terms.items() if term.split} if adds_up else law.split
