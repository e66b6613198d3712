"""The tables of the page: what was run, the gains, the energy account."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from dampen.analysis.energy import EnergyAccount, energy_account
from dampen.analysis.sampling_cost import Cost
from dampen.component import Component, parameters
from dampen.controllers.base import SampledFeedback
from dampen.report.joined import uncontrolled
from dampen.report.limits import Limits, limits_of
from dampen.report.style import MINUS, number, percent, plain_number, quantity
from dampen.simulation.result import Result
from dampen.simulation.trials import LOST
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
    """What was run, in a few words each; what there is nothing to say about is left out."""
    scenario, numerics = result.scenario, result.scenario.numerics
    damping = getattr(scenario.plant, "damping", None)
    limits = [limits_of(scenario, port) for port in scenario.ports]
    mode = "" if scenario.sampled else ", continuous law"
    rows = [
        ("Plant", described(scenario.plant)),
        ("Damping", ", ".join(settings(damping)) if isinstance(damping, Component) else ""),
        ("Controller", described(scenario.controller)),
        ("Sampling", _sampling(result)),
        ("Actuators", _chains(scenario.actuators) or "ideal"),
        ("Compensation", _chains(scenario.compensation)),
        ("Disturbance", "; ".join(map(described, scenario.disturbance.parts)) or described(scenario.disturbance)),
        ("Reference", "; ".join(_reference(port, signal) for port, signal in scenario.task.reference.items())),
        (
            "Constraint",
            "; ".join(_limit(limit, port) for limit, port in zip(limits, scenario.ports, strict=True) if limit) or "none",
        ),
        ("Trials", _trials(result)),
        ("Numerics", f"{numerics.discretisation}, {numerics.modes} modes, step {plain_number(1000 * numerics.step)} ms{mode}"),
        ("Version", f"dampen {result.version}"),
    ]
    return [(name, text) for name, text in rows if text]


def settings(component: Component, skip: Sequence[str] = ()) -> list[str]:
    """The parameters that are not what they are by default, each with value and unit."""
    found = []
    for parameter in parameters(type(component)):
        value = getattr(component, parameter.name)
        if parameter.name not in skip and value is not None and (parameter.required or value != parameter.default):
            text = plain_number(value) if isinstance(value, int | float) and not isinstance(value, bool) else literal(value)
            found.append(f"{parameter.name.replace('_', ' ')} {text} {parameter.unit}".strip())
    return found


def named(component: Component) -> str:
    """The kind of a component, or its class."""
    return kind_of(component) or type(component).__name__


def _chains(chains: Mapping[str, Sequence[Component]]) -> str:
    return "; ".join(f"{port}: {', '.join(map(named, chain)) or 'ideal'}" for port, chain in chains.items())


def _reference(port: str, signal: Component) -> str:
    details = ", ".join(settings(signal, skip=("sha256",)))
    return f"{port}: {named(signal)}" + (f" ({details})" if details else "")


def _limit(limits: Limits, port: str) -> str:
    """A constraint at the start of a trial, and where it has come to at the end."""
    start, end = limits.inequality(port, 0), limits.inequality(port, -1)
    if not limits.moving:
        return start
    return f"{start}, another one in other trials" if start == end else f"{start} at the start of a trial, {end} at its end"


def _trials(result: Result) -> str:
    task = result.scenario.task
    text = f"{task.trials} of {plain_number(task.trial_duration)} s, "
    if task.start == "chained":
        return text + "chained"
    units = {port.name: port.motion_unit for port in result.scenario.plant.ports}
    errors = [f"{port} {plain_number(value)} {units[port]}" for port, value in task.reset_error.items() if value]
    return text + "each reset to the initial state" + (f", with a random error ({', '.join(errors)})" if errors else "")


def _sampling(result: Result) -> str:
    """Period, delay, what becomes of Sgn, how rates are estimated, and what is between sensor and law."""
    scenario, sampling = result.scenario, result.scenario.sampling
    if not scenario.sampled or uncontrolled(result):
        return ""
    parts = [f"every {plain_number(1000 * sampling.period)} ms"]
    parts.append(f"delay {plain_number(1000 * sampling.delay)} ms" if sampling.delay else "no delay")
    if not isinstance(scenario.controller, SampledFeedback):
        parts.append(f"{sampling.switching} switching")
    observed = sampling.rate == "observer"
    parts.append(
        f"rate from an observer, {plain_number(sampling.observer_bandwidth)} Hz" if observed else "rate from differences"
    )
    units = {port.name: (port.motion_unit, port.effort_unit) for port in scenario.plant.ports}
    for table, words, which in (("noise", "noise", 0), ("quantum", "quantiser", 0), ("command_limit", "commands up to", 1)):
        given = [f"{port} {plain_number(value)} {units[port][which]}" for port, value in sampling.by_port[table].items() if value]
        parts += [f"{words} {', '.join(given)}"] if given else []
    return "; ".join(parts)


def described(component: Component) -> str:
    """The first sentence about a component, and its kind."""
    return f"{component.summary().rstrip('.')} ({named(component)})"


def status_sentence(result: Result, baseline: Result | None) -> str:
    """Empty for runs that went well; otherwise which run broke off and where, and where the constraint was lost.

    The run without control is there to show what happens without: its lost constraint is no fault.
    """
    parts = []
    for run, name in ((result, "The run"), (baseline, "The run without control")):
        if run is not None and run.broke_off:
            parts.append(f"{name} broke off ({run.status}) after {run.trials} of {run.scenario.task.trials} trials.")
    return " ".join([*parts, *(line for line in result.warnings if line.startswith(LOST))])


def cost_row(cost: Cost) -> tuple[str, str, str, str, str]:
    """A row of what sampling costs: metric, where, both values, and their ratio."""
    write = percent if cost.metric == "margin" else lambda value: quantity(value, cost.unit)
    ratio = "" if cost.ratio is None else number(cost.ratio)
    return cost.metric, cost.of, write(cost.continuous), write(cost.sampled), ratio


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
        *(
            [row("Dissipated by the structure's damping", "dissipated")]
            if any(account.dissipated for account in accounts)
            else []
        ),
        *([row("Change by the resets between trials", "resets")] if result.scenario.task.start == "reset" else []),
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
