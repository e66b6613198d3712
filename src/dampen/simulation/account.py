"""The energy account of a trial: the work of every force over every step, and what springs and compliances hold."""

from __future__ import annotations

from typing import Any

import numpy as np

from dampen.simulation.closure import RELAXATION
from dampen.simulation.kernel import Inputs, Record
from dampen.simulation.scenario import Scenario

Array = np.ndarray


def accounts(scenario: Scenario, trial: int, record: Record, inputs: Inputs, ports: Any) -> dict[str, Array]:
    """Works on steps [J]; energies of the law and of the ports' compliance at times."""
    moved = np.diff(record.y, axis=0) + np.diff(scenario.reference(trial), axis=0)
    return {
        "work_control": record.delivered * moved,
        "work_actuator": (record.delivered - ports.gain * record.command) * moved,
        "work_disturbance": inputs.disturbance * moved,
        "work_load": record.work_load,
        "dissipated": record.dissipated,
        **law_account(record, inputs, ports, scenario.controller.barrier_shape),
        **compliance_account(record, ports, scenario.numerics.step),
    }


def law_account(record: Record, inputs: Inputs, ports: Any, shape: str) -> dict[str, Array]:
    """Energy of the law's barrier and stiffness, as the actuator's slope delivers it: gain (barrier V(e) + stiffness e^2/2)."""
    low, high = (np.vstack([limit[:1], limit]) for limit in (inputs.low, inputs.high))
    scaled = np.where(ports.barrier > 0, record.y / np.where(record.y >= 0, high, -low), 0.0)
    inside = np.abs(scaled) < 1
    square = np.where(inside, scaled, 0.0) ** 2
    potential = np.tan(np.pi / 2 * square) / np.pi if shape == "tan" else np.log1p(-square) ** 2 / 4
    stored = np.where(inside, ports.gain * ports.barrier * potential, np.inf if np.any(ports.barrier > 0) else 0.0)
    return {"barrier_energy": (stored + ports.gain * ports.stiffness * record.y**2 / 2).sum(axis=1)}


def compliance_account(record: Record, ports: Any, dt: float) -> dict[str, Array]:
    """Energy that the ports' numerical compliance stores, at times, and what it dissipates, at steps (see `closure`)."""
    stored = ports.soft * dt * record.slow**2 / (2 * RELAXATION)
    lost = ports.soft * dt * (1 - RELAXATION / 2) * (record.delivered - record.slow[:-1]) ** 2
    return {"compliance_energy": stored.sum(axis=1), "compliance_loss": lost.sum(axis=1)}
