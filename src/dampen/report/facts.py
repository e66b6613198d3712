"""The tables of the page: what was run, the gains, the energy account."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from dampen.analysis.energy import EnergyAccount, energy_account
from dampen.component import Component, parameters
from dampen.report.joined import uncontrolled
from dampen.report.style import MINUS, number, plain_number
from dampen.simulation.result import Result
from dampen.stage import Stage
from dampen.toml import kind_of, literal


@dataclass(frozen=True)
class Gain:
    """One parameter of the controller, as the scenario file names it."""

    name: str
    value: str
    unit: str
    doc: str


@dataclass(frozen=True)
class Row:
    """One row of the energy account. depth: 1 for a part of the row above it; `values`, one for each run."""

    name: str
    values: tuple[str, ...]
    depth: int = 0
    kind: str = ""


def facts(result: Result) -> list[tuple[str, str]]:
    """What was run, in a few words each."""
    scenario, numerics, task = result.scenario, result.scenario.numerics, result.scenario.task
    rows = [("Plant", described(scenario.plant)), ("Controller", described(scenario.controller))]
    if scenario.compensation:
        rows.append(("Compensation", chains(scenario.compensation, "none")))
    rows.append(("Actuators", chains(scenario.actuators, "ideal")))
    rows.append(("Disturbance", described(scenario.disturbance)))
    units = {port.name: port.motion_unit for port in scenario.plant.ports}
    low, high = (limit[0] for limit in scenario.limits())
    limits = [_limit(port, low[p], high[p], units[port]) for p, port in enumerate(units) if np.isfinite(high[p])]
    rows.append(("Constraint", ", ".join(limits) or "none"))
    rows.append(("Trials", f"{task.trials} of {plain_number(task.trial_duration)} s, {task.start}"))
    rows.append(("Numerics", f"{numerics.discretisation}, {numerics.modes} modes, step {plain_number(1000 * numerics.step)} ms"))
    return [*rows, ("Version", f"dampen {result.version}")]


def _limit(port: str, low: float, high: float, unit: str) -> str:
    """A constraint as it stands at the start of a trial."""
    if low == -high:
        return f"|{port}| < {plain_number(high)} {unit}"
    return f"{plain_number(low)} < {port} < {plain_number(high)} {unit}"


def chains(by_port: Mapping[str, Sequence[Stage]], nothing: str) -> str:
    """The kinds in the chain of each port."""
    kinds = {port: ", ".join(kind_of(stage) or type(stage).__name__ for stage in chain) for port, chain in by_port.items()}
    return "; ".join(f"{port}: {chain or nothing}" for port, chain in kinds.items()) or nothing


def described(component: Component) -> str:
    """The first sentence about a component, and its kind."""
    return f"{component.summary().rstrip('.')} ({kind_of(component) or type(component).__name__})"


def status_sentence(result: Result, baseline: Result | None) -> str:
    """Empty for complete runs; otherwise which run broke off, and where."""
    parts = []
    for run, name in ((result, "The run"), (baseline, "The run without control")):
        if run is not None and run.status != "complete":
            parts.append(f"{name} broke off ({run.status}) after {run.trials} of {run.scenario.task.trials} trials.")
    return " ".join(parts)


def gains(result: Result) -> list[Gain]:
    """The controller's parameters, those of nested tables by their full names."""
    return _gains(result.scenario.controller, "")


def _gains(component: Component, prefix: str) -> list[Gain]:
    rows: list[Gain] = []
    for parameter in parameters(type(component)):
        value = getattr(component, parameter.name)
        if isinstance(value, Component):
            rows += _gains(value, f"{prefix}{parameter.name}.")
        elif value is not None:
            rows.append(Gain(prefix + parameter.name, literal(value), parameter.unit, parameter.doc))
    return rows


def account_rows(result: Result, baseline: Result | None) -> list[Row]:
    """The energy account of the run and, beside it, of the run without control; empty if no trial was finished."""
    runs = [run for run in (result, baseline) if run is not None]
    if not all(run.trials for run in runs):
        return []
    accounts = [energy_account(run) for run in runs]

    def row(name: str, attribute: str, depth: int = 0, kind: str = "") -> Row:
        return Row(name, tuple(energy(account, attribute) for account in accounts), depth, kind)

    heads = tuple("without control" if uncontrolled(run) else "with control" for run in runs)
    rows = [
        Row("Energy [J]", heads, kind="head"),
        row("Energy at the start", "initial", kind="sum"),
        row("Work of the control", "control"),
        row("of the law, through the actuator's slope", "law", 1),
        row("of the actuator: what it adds to that", "actuator", 1),
        row("Work of the port disturbances", "disturbance"),
        row("Work of the distributed load", "load"),
        row("Energy at the end", "final", kind="sum"),
        row(f"Closing error, |change of energy {MINUS} work| / largest energy", "error", kind="error"),
    ]
    if any(account.control for account in accounts):
        rows += [
            Row("Within the control's work: barrier and numerical compliance [J]", ("",) * len(runs), kind="head"),
            row("Energy of the barrier at the start", "barrier_initial"),
            row("Energy of the barrier at the end", "barrier_final"),
            row("Stored in the ports' numerical compliance at the end", "compliance_stored"),
            row("Dissipated in the ports' numerical compliance", "compliance_lost"),
        ]
    return rows


def energy(account: EnergyAccount, attribute: str) -> str:
    """A number of the account."""
    return number(float(getattr(account, attribute)), 2 if attribute == "error" else 4)
