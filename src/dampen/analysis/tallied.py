"""The figures that studies keep of a run, from its result: what a comparison tabulates anyone can work out from the file."""

from __future__ import annotations

import numpy as np

from dampen.analysis.metrics import tracking_error
from dampen.simulation.batch import Tally, figures_of
from dampen.simulation.kernel import Record
from dampen.simulation.result import Result
from dampen.simulation.tally import BY_PORT, WHOLE

Array = np.ndarray
UNSETTLED = "did not settle"


def tallied(result: Result) -> Tally:
    """The tally of a result's finished trials: that of the same member of a study, but for the rounding of a reference that was
    added and taken away again, and for the steps that did not settle, of which a result tells only whether there are any. A
    run that diverged has a trial more, of which nothing is known."""
    scenario, ports = result.scenario, len(result.scenario.ports)
    rows = figures_of(scenario, ((j, record_of(result, j), scenario.steps) for j in range(result.trials)))
    if result.status == "diverged" or not rows:
        rows.append((np.full((ports, len(BY_PORT)), np.nan), np.zeros(len(WHOLE))))
    by_ports, wholes = (np.stack(side) for side in zip(*rows, strict=True))
    wholes[0, WHOLE.index("unsettled")] = any(UNSETTLED in line for line in result.warnings)
    return Tally(scenario, by_ports, wholes)


def record_of(result: Result, trial: int) -> Record:
    """What the tally reads of a trial, as the kernel left it; the rest is empty."""
    error = np.column_stack([tracking_error(result, port, trial) for port in result.scenario.ports])
    none, names = np.zeros(0), ("energy", "v", "command", "delivered")
    energy, v, command, delivered = (np.array(result[name][trial], float, order="C") for name in names)
    return Record(error, np.zeros((0, 0)), energy, v, command, delivered, none, none, np.zeros((0, 0)), np.zeros(1))
