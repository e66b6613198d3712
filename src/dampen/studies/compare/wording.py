"""Figures of merit, their units and names in the sentences of a comparison."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from dampen.analysis.merits import merit, merit_unit
from dampen.simulation.scenario import Scenario
from dampen.studies.compare.comparison import Contender
from dampen.studies.compare.settle import counted_ports


def figure(scenario: Scenario, name: str, merits: Mapping[str, float]) -> str:
    """A figure with its unit; shares in percent; where ports of different units are in it, each of them."""
    number = merits[name]
    if not np.isfinite(number):
        return "diverged"
    if is_share(scenario, name):
        return f"{100 * number:.3g} %"
    kinds = units(scenario, name)
    if len(set(kinds.values())) > 1:
        return ", ".join(f"{merits[f'{name}.{port}']:.3g} {unit} at {port}" for port, unit in kinds.items())
    unit = next(iter(kinds.values()), merit_unit(name, scenario))
    return f"{number:.3g} {unit}".strip()


def over_searches(scenario: Scenario, one: Contender, name: str) -> str:
    """The range of a figure over a contender's searches, at the experiment's numerics; "" where there is none."""
    ends = one.over_searches(name)
    if ends is None:
        return ""
    if is_share(scenario, name):
        return f"{span([100 * end for end in ends])} %"
    kinds = units(scenario, name)
    if len(set(kinds.values())) > 1:
        parts = [(port, unit, one.over_searches(f"{name}.{port}")) for port, unit in kinds.items()]
        return ", ".join(f"{span(found)} {unit} at {port}" for port, unit, found in parts if found)
    return f"{span(ends)} {next(iter(kinds.values()), merit_unit(name, scenario))}".strip()


def span(ends: Sequence[float]) -> str:
    """A range, as one number where its ends do not differ in three digits."""
    low, high = (f"{end:.3g}" for end in ends)
    return low if low == high else f"{low} to {high}"


def is_share(scenario: Scenario, name: str) -> bool:
    """Whether a figure is a share, to be told in percent."""
    kind, _, port = name.partition(".")
    return kind in ("margin", "stuck") or (kind in ("peak", "residual") and not port and bool(scenario.task.constraint))


def units(scenario: Scenario, name: str) -> dict[str, str]:
    """By port, the units of the figures that one without a port is made of; {} where it is not made of any."""
    kind, _, port = name.partition(".")
    unit = merit(kind).unit
    if port or unit not in ("motion", "effort"):
        return {}
    among = counted_ports(scenario) if unit == "motion" else scenario.ports
    return {p.name: p.motion_unit if unit == "motion" else p.effort_unit for p in scenario.plant.ports if p.name in among}


def words(name: str) -> str:
    """A figure of merit in a sentence."""
    kind, _, port = name.partition(".")
    return f"{kind} at {port}" if port else kind


def first_up(text: str) -> str:
    """With a capital."""
    return text[0].upper() + text[1:]
