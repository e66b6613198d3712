"""Figures of merit of a member of a batch: what studies tabulate, plot and tune by."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from dampen.simulation.batch import Tally
from dampen.simulation.scenario import Scenario
from dampen.simulation.tally import (
    ENERGY,
    MEAN_SQUARE,
    MEAN_SQUARE_FORCE,
    PEAK,
    SHARE,
    STUCK,
    UNSETTLED,
    VARIATION,
)

Array = np.ndarray
LATE = 5  # trials, at the end of a run, whose figures are those it has come to


@dataclass(frozen=True)
class Merit:
    """A figure of merit. unit: a unit, or "motion" or "effort", which is the port's.   better: which way is better.

    Of each port it stands in the column NAME.PORT; of all together, if there is a `together`, in the column NAME.
    """

    name: str
    unit: str
    meaning: str
    better: Literal["low", "high"] = "low"
    together: str = ""

    @property
    def sign(self) -> int:
        """What turns the figure into one of which less is better."""
        return -1 if self.better == "high" else 1


MERITS = (
    Merit("peak", "motion", "largest |error| in the last five trials", together="the largest share of the constraint"),
    Merit(
        "residual",
        "motion",
        "root mean square error in the last five trials",
        together="the largest, as a share of the constraint where it is tightest",
    ),
    Merit("largest", "motion", "largest |error| in the whole run"),
    Merit("margin", "", "1 - largest share of the constraint that was used; below 0: lost", "high", "the least"),
    Merit("effort", "effort", "root mean square of the delivered force over the run", together="root of the summed squares"),
    Merit("chatter", "effort", "total variation of the command over the run", together="the sum"),
    Merit("stuck", "", "share of the steps in which the port stuck", together="the mean"),
)
WHOLE = (
    Merit("energy", "J", "mean energy of the structure in the last five trials"),
    Merit("unsettled", "steps", "steps whose forces at the ports did not settle"),
)


def merit(name: str) -> Merit:
    """The figure of merit of a column: "peak", "peak.tip_w", "energy"."""
    return next(m for m in (*MERITS, *WHOLE) if m.name == name.partition(".")[0])


def merit_unit(name: str, scenario: Scenario) -> str:
    """The unit of a column; "" for a share."""
    kind, _, port = name.partition(".")
    unit, found = merit(kind).unit, next((p for p in scenario.plant.ports if p.name == port), None)
    if unit == "motion":
        return "" if found is None else found.motion_unit
    if unit == "effort":
        units = {p.effort_unit for p in scenario.plant.ports}
        return found.effort_unit if found is not None else units.pop() if len(units) == 1 else "N, N m"
    return unit


def columns(scenario: Scenario) -> list[str]:
    """Names of all columns that `merits` gives for members of this scenario."""
    limited = set(scenario.task.constraint)
    found = []
    for m in MERITS:
        ports = [port for port in scenario.ports if m.name != "margin" or port in limited]
        found += [f"{m.name}.{port}" for port in ports]
        if m.together and ports:
            found.append(m.name)
    return [*found, *(m.name for m in WHOLE)]


def merits(tally: Tally) -> dict[str, float]:
    """The figures of a member, by column; nan for a motion that has diverged, but for margin and what it took."""
    scenario, figures = tally.scenario, tally.by_port
    late, diverged = figures[-LATE:], tally.status == "diverged"
    by_port = {
        "peak": late[:, :, PEAK].max(axis=0),
        "residual": np.sqrt(late[:, :, MEAN_SQUARE].mean(axis=0)),
        "largest": figures[:, :, PEAK].max(axis=0),
        "margin": 1 - figures[:, :, SHARE].max(axis=0),
        "effort": np.sqrt(figures[:, :, MEAN_SQUARE_FORCE].mean(axis=0)),
        "chatter": figures[:, :, VARIATION].sum(axis=0),
        "stuck": figures[:, :, STUCK].mean(axis=0),
    }
    limited = np.array([port in scenario.task.constraint for port in scenario.ports])
    counted = limited if limited.any() else ~limited
    together = {
        "peak": (late[:, :, SHARE].max(axis=0) if limited.any() else by_port["peak"])[counted].max(),
        "residual": (by_port["residual"] / rooms(scenario))[counted].max(),
        "margin": by_port["margin"][limited].min(initial=np.inf),
        "effort": np.sqrt((by_port["effort"] ** 2).sum()),
        "chatter": by_port["chatter"].sum(),
        "stuck": by_port["stuck"].mean(),
        "energy": tally.whole[-LATE:, ENERGY].mean(),
        "unsettled": tally.whole[:, UNSETTLED].sum(),
    }
    values = dict(together)
    for name, row in by_port.items():
        values |= {f"{name}.{port}": value for port, value in zip(scenario.ports, row, strict=True)}
    unknown = np.nan if diverged else 0.0
    kept = {name: float(values[name]) for name in columns(scenario)}
    return {name: value if name.startswith(("margin", "unsettled")) else value + unknown for name, value in kept.items()}


def rooms(scenario: Scenario) -> Array:
    """(ports,) how far off each port may be where its constraint is tightest, in the first or last trial; 1 without one."""
    room = np.full(len(scenario.ports), np.inf)
    for trial in {0, scenario.task.trials - 1}:
        reference, (low, high) = scenario.reference(trial), scenario.limits(trial)
        room = np.minimum(room, np.minimum(high - reference, reference - low).min(axis=0))
    return np.where(np.isfinite(room), room, 1.0)
