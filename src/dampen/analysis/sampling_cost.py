"""What sampling costs: the run under samples held against the same experiment under the continuous law."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from dampen.analysis.metrics import field_rms, fraction_of_limit, port_index, tracking_error
from dampen.arguments import RESULT, takes
from dampen.component import ArgumentError
from dampen.simulation.result import Result

Array = np.ndarray
METRICS = {
    "chatter": "total variation of the command over the run",
    "margin": "1 - largest share of the constraint that was used",
    "residual": "root mean square in the last trial: of a field over the structure, of a port's tracking error",
    "effort": "root mean square of the delivered force over the run",
}


@dataclass(frozen=True)
class Cost:
    """One row of the comparison. metric: one of METRICS, which tells its meaning; of: the port or field it is taken at."""

    metric: str
    of: str
    unit: str
    continuous: float
    sampled: float

    @property
    def ratio(self) -> float | None:
        """sampled / continuous; None where the continuous run has nothing to compare with."""
        usable = self.continuous > 0 and np.isfinite(self.continuous) and np.isfinite(self.sampled)
        return self.sampled / self.continuous if usable else None


@takes(sampled=RESULT, continuous=RESULT)
def sampling_cost(sampled: Result, continuous: Result) -> list[Cost]:
    """Chatter, margin, residual and effort of both runs, over the trials that both have finished; empty if there are none.

    chatter:  total variation of the command at a port over the run [N, N m].
    margin:   1 - largest share of its constraint that a port used; below 0 where the constraint was lost.
    residual: root mean square of a field over the structure, and of a port's tracking error, in the last trial.
    effort:   root mean square of the delivered force (torque) over the run [N, N m].

    Raises ArgumentError where the two do not have the same ports, fields and task.
    """
    runs = (continuous, sampled)
    plants, tasks = [run.scenario.plant for run in runs], [run.scenario.task for run in runs]
    if plants[0].ports != plants[1].ports or plants[0].fields != plants[1].fields or tasks[0] != tasks[1]:
        raise ArgumentError("Arguments `sampled` and `continuous` must be runs of one plant at one task, but are not.")
    trials = min(run.trials for run in runs)
    if not trials:
        return []
    ports, fields, last = sampled.scenario.plant.ports, sampled.scenario.plant.fields, trials - 1
    rows = [Cost("chatter", p.name, p.effort_unit, *(chatter(run, p.name, trials) for run in runs)) for p in ports]
    rows += [
        Cost("margin", p.name, "", *(margin(run, p.name, trials) for run in runs)) for p in ports if limited(sampled, p.name)
    ]
    rows += [Cost("residual", name, unit, *(field_rms(run, name, last) for run in runs)) for name, unit in fields]
    rows += [Cost("residual", p.name, p.motion_unit, *(_rms(tracking_error(run, p.name, last)) for run in runs)) for p in ports]
    rows += [Cost("effort", p.name, p.effort_unit, *(effort(run, p.name, trials) for run in runs)) for p in ports]
    return rows


def chatter(result: Result, port: str, trials: int | None = None) -> float:
    """Total variation of the command at a port over the first trials (default: all); a reset between trials is none of it."""
    p, total, before = port_index(result, port), 0.0, None
    for j in range(result.trials if trials is None else trials):
        command = np.asarray(result["command"][j])[:, p]
        total += float(np.sum(np.abs(np.diff(command))))
        if before is not None and result.scenario.task.start == "chained":
            total += abs(float(command[0]) - before)
        before = float(command[-1])
    return total


def margin(result: Result, port: str, trials: int | None = None) -> float:
    """1 - largest share of its constraint that a port used in the first trials (default: all)."""
    return 1 - float(np.max(fraction_of_limit(result, port)[:trials]))


def effort(result: Result, port: str, trials: int | None = None) -> float:
    """Root mean square of the delivered force over the first trials (default: all)."""
    p, count = port_index(result, port), result.trials if trials is None else trials
    return float(np.sqrt(np.mean([np.mean(np.square(np.asarray(result["delivered"][j])[:, p])) for j in range(count)])))


def limited(result: Result, port: str) -> bool:
    """Whether the task has a constraint at a port."""
    return port in result.scenario.task.constraint


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
