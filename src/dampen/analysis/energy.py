"""The energy account: what went in, what came out, and how well it closes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dampen.simulation.result import Result


@dataclass(frozen=True)
class EnergyAccount:
    """Energies and works over all finished trials [J].

    final - initial = law + actuator + disturbance + load - dissipated + resets. `control` = law + actuator is the work of the
    delivered forces, `dissipated` what the structure's own damping takes, `resets` what putting it back between trials adds.
    `law` is what the actuator's slope makes of the law's value, `actuator` the rest (a backlash's bounded part, a saturation's
    loss). The law's part that goes into barrier and stiffness is `barrier_final - barrier_initial`, taken from `law`; what the
    ports' numerical compliance stores and loses is part of `control` as well.
    """

    initial: float
    final: float
    control: float
    actuator: float
    disturbance: float
    load: float
    dissipated: float
    resets: float
    barrier_initial: float
    barrier_final: float
    compliance_stored: float
    compliance_lost: float
    largest: float

    @property
    def law(self) -> float:
        return self.control - self.actuator

    @property
    def error(self) -> float:
        """|change of energy - work| / largest energy, over the whole run."""
        change = self.final - self.initial - self.control - self.disturbance - self.load + self.dissipated - self.resets
        return abs(change) / self.largest if self.largest else 0.0


def energy_account(result: Result) -> EnergyAccount:
    """The account of a run, read trial by trial."""
    if not result.trials:
        return EnergyAccount(*(0.0,) * 13)
    last = result.trials - 1

    def total(name: str) -> float:
        return float(sum(np.sum(np.asarray(result[name][j])) for j in range(result.trials)))

    return EnergyAccount(
        initial=float(result["energy"][0][0]),
        final=float(result["energy"][last][-1]),
        control=total("work_control"),
        actuator=total("work_actuator"),
        disturbance=total("work_disturbance"),
        load=total("work_load"),
        dissipated=total("dissipated"),
        resets=put_back(result) if result.scenario.task.start == "reset" else 0.0,
        barrier_initial=float(result["barrier_energy"][0][0]),
        barrier_final=float(result["barrier_energy"][last][-1]),
        compliance_stored=float(result["compliance_energy"][last][-1]),
        compliance_lost=total("compliance_loss"),
        largest=float(max(np.max(np.asarray(result["energy"][j])) for j in range(result.trials))),
    )


def put_back(result: Result) -> float:
    """What the resets between trials add to the energy [J]."""
    return float(sum(result["energy"][j][0] - result["energy"][j - 1][-1] for j in range(1, result.trials)))
