"""How often an actuator stood at its limit, and a sampled law's command at its own."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from dampen.analysis.metrics import port_index
from dampen.simulation.result import Result
from dampen.stage import Stage

CLOSE = 1e-9  # of the limit: rounding


def ends_of(chain: Sequence[Stage], dt: float) -> tuple[float, float]:
    """The least and the largest that a chain can deliver; infinite where it has no limit, or where none can be told of its force.

    The ends of a stage go through the memoryless ones behind it as any command does. Behind one with a memory, such as a lag,
    what is delivered does not tell whether the limit was reached.
    """
    low, high = -math.inf, math.inf
    for stage in chain:
        if stage.states or not stage.monotone:
            low, high = -math.inf, math.inf
        low, high = (end if math.isinf(end) else _delivered(stage, end, dt) for end in (low, high))
        least, most = stage.ends
        low, high = min(max(low, least), most), max(min(high, most), least)
    return low, high


def _delivered(stage: Stage, command: float, dt: float) -> float:
    return float(type(stage).step(command, np.zeros(1), np.array(stage.row(dt)), np.zeros(1)))


def share_at_limit(result: Result, port: str) -> float | None:
    """Share of all steps in which the actuator delivered the most or the least that it can; None: it has no limit."""
    index = port_index(result, port)
    low, high = ends_of(result.scenario.chain(index), result.scenario.numerics.step)
    return None if math.isinf(low) and math.isinf(high) else _share(result, "delivered", index, low, high)


def share_of_command(result: Result, port: str) -> float | None:
    """Share of all steps in which a sampled law's command stood at `sampling.command_limit`; None: it has none."""
    limit = result.scenario.sampling.command_limit.get(port) if result.scenario.sampled else None
    return None if limit is None else _share(result, "command", port_index(result, port), -limit, limit)


def _share(result: Result, name: str, index: int, low: float, high: float) -> float:
    near = CLOSE * max(abs(end) for end in (low, high) if math.isfinite(end))
    at = 0
    for j in range(result.trials):
        values = np.asarray(result[name][j])[:, index]
        at += int(np.sum((values >= high - near) | (values <= low + near)))
    return at / (result.trials * result.scenario.steps)
