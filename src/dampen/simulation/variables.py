"""The variables of a result, and the names that nothing else in it may have."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass


@dataclass(frozen=True)
class Variable:
    """One variable of a result: its dimensions after `trial`, unit and meaning. Unit "" with a port: see the coordinates."""

    dims: tuple[str, ...]
    unit: str
    meaning: str
    kind: str = "f8"


SIGNALS = {
    "y": Variable(("time", "port"), "", "displacement (angle) at the port"),
    "energy": Variable(("time",), "J", "kinetic and potential energy of the structure, payload included"),
    "barrier_energy": Variable(("time",), "J", "energy of the law's barrier and stiffness, as the actuator's slope delivers it"),
    "compliance_energy": Variable(("time",), "J", "energy stored in the ports' numerical compliance"),
    "v": Variable(("step", "port"), "", "rate that the law sees: exactly 0 while the port sticks"),
    "command": Variable(("step", "port"), "", "the law's value"),
    "delivered": Variable(("step", "port"), "", "force (torque) that the actuator delivers"),
    "disturbance": Variable(("step", "port"), "", "disturbing force (torque) at the port"),
    "work_control": Variable(("step", "port"), "J", "work of the delivered force over the step"),
    "work_actuator": Variable(("step", "port"), "J", "part of it that is not the actuator's slope times the command"),
    "work_disturbance": Variable(("step", "port"), "J", "work of the port's disturbance over the step"),
    "work_load": Variable(("step",), "J", "work of the distributed load over the step"),
    "dissipated": Variable(("step",), "J", "energy that the structure's damping takes over the step"),
    "compliance_loss": Variable(("step",), "J", "energy dissipated by the ports' numerical compliance over the step"),
}
SAMPLES = {
    "reading": Variable(("sample", "port"), "", "displacement (angle) as the controller read it"),
    "rate_estimate": Variable(("sample", "port"), "", "rate of the tracking error as the controller estimated it"),
    "issued": Variable(("sample", "port"), "", "command as it was computed, to be held from the end of the delay on"),
}
REFERENCE = {"reference": Variable(("time", "port"), "", "what the port is to follow")}
STATUS = {"status": Variable((), "", "0: finished, 1: broke off", "i1")}
PEAK = {
    "peak": Variable(("field",), "", "largest |field| of the trial, over snapshots everywhere and over ports at every step"),
}
COORDINATES = ("trial", "time", "step", "time_out", "x", "port", "motion_unit", "effort_unit", "field", "sample")
RECORDED = ("unsettled",)  # what a trial hands over beside its variables
TAKEN = frozenset({*SIGNALS, *SAMPLES, *REFERENCE, *STATUS, *PEAK, *COORDINATES, *RECORDED})


def why_not(name: str, taken: Collection[str]) -> str:
    """Why nothing of a user's own may have this name in a result, which may be a file; "" if it may."""
    if name in taken:
        return "is a name that results use themselves"
    fit = bool(name) and "/" not in name and name.isprintable() and name == name.strip()
    return "" if fit else "cannot stand in a file"
