"""When a contender has settled: what counts as small, and from which trial on it stays so."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from dampen.analysis.merits import rooms
from dampen.analysis.metrics import settling_trial
from dampen.simulation.scenario import Scenario
from dampen.studies.compare.comparison import Contender

SHARE = 0.05


def counted_ports(scenario: Scenario) -> tuple[str, ...]:
    """The ports that are judged: those with a constraint, or all where none has one."""
    return tuple(port for port in scenario.ports if port in scenario.task.constraint) or scenario.ports


def thresholds(scenario: Scenario, contenders: Sequence[Contender]) -> dict[str, float]:
    """By counted port, 5 % of the least room that its constraint leaves the error; without a constraint, 5 % of the largest
    error of all contenders whose motion did not diverge."""
    room = dict(zip(scenario.ports, rooms(scenario), strict=True))
    found = {}
    for port in counted_ports(scenario):
        largest = max((max(c.peaks[port], default=0.0) for c in contenders if c.status != "diverged"), default=0.0)
        found[port] = float(SHARE * (room[port] if port in scenario.task.constraint else largest))
    return found


def settled(contender: Contender, limits: Mapping[str, float]) -> int | None:
    """The trial from which on every counted port stays within its threshold; None: never, or the motion diverged."""
    if contender.status == "diverged" or not contender.trials:
        return None
    errors = np.column_stack([contender.peaks[port] for port in limits])
    return settling_trial(errors, np.array(list(limits.values())))
