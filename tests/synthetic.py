"""Studies of every kind, made up: tables whose numbers follow from formulas, so that tests know what must be found."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pandas as pd

import dampen
from dampen.analysis.merits import columns
from dampen.studies.samples import saltelli
from dampen.studies.variation import Axis, read_axis
from tests.conftest import scenario

TRIALS = 25


@dataclass(frozen=True)
class Defined:
    """Stands for a study's definition."""

    kind: Literal["sweep", "robust", "tune"]
    scenario: dampen.Scenario
    axes: tuple[Axis, ...]
    objectives: tuple[str, ...] = ()
    base: int = 0
    sampler: str = "sobol"
    seed: int = 3
    population: int = 0
    robust_axes: tuple[Axis, ...] = ()
    robust_samples: int = 0


@dataclass(frozen=True)
class StandIn:
    """Stands for a study."""

    definition: Defined
    members: int
    table: Any
    folder: Path | None = None
    version: str = field(default="0.1.0")

    @property
    def done(self) -> int:
        return len(self.table)


def axes(option: Literal["vary", "uncertain", "search"], *texts: str) -> tuple[Axis, ...]:
    return tuple(read_axis(option, text, scenario()) for text in texts)


def rows(case: dampen.Scenario, taken: dict[str, Any], share: np.ndarray, effort: np.ndarray, seed: int = 0) -> pd.DataFrame:
    """A table from the largest share of the constraint and the effort of each member.

    Lost from a share of 1, diverged (all but the margin nan) from 3; peaks fall over the trials from 1 to `share`.
    """
    rng, n = np.random.default_rng(seed), len(share)
    table: dict[str, Any] = {"member": np.arange(n), **taken}
    table["status"] = np.where(share >= 3, "diverged", np.where(share >= 1, "constraint_lost", "complete"))
    table["message"] = [""] * n
    unknown = np.where(share >= 3, np.nan, 0.0)
    for name in columns(case):
        kind, _, port = name.partition(".")
        part = 0.8 if port == "tip_phi" else 1.0
        room = 0.2 if port else 1.0
        value = {
            "peak": part * room * share, "residual": 0.4 * part * room * share, "largest": part * room * np.maximum(share, 0.9),
            "margin": 1 - part * share, "effort": part * effort, "chatter": 30 * effort, "stuck": 0.1 + 0 * share,
            "energy": 0.02 * share**2, "unsettled": 0 * share,
        }[kind]  # fmt: skip
        table[name] = value if kind in ("margin", "unsettled") else value + unknown
    trial = np.arange(TRIALS)
    for port, part in (("tip_w", 1.0), ("tip_phi", 0.8)):
        ripple = 1 + 0.1 * rng.standard_normal((n, TRIALS))
        curve = 0.2 * part * (share[:, None] + (1 - np.minimum(share, 1))[:, None] * np.exp(-trial / 4)) * ripple
        table[f"peaks.{port}"] = [list(c[: 4 if s >= 3 else TRIALS]) for c, s in zip(curve, share, strict=True)]
    return pd.DataFrame(table)


def refuse(table: pd.DataFrame, members: list[int], message: str, status: str = "refused") -> pd.DataFrame:
    """The same table with some members that did not run."""
    table = table.copy()
    for m in members:
        for name in table.columns:
            if name.partition(".")[0] in ("peak", "residual", "largest", "margin", "effort", "chatter", "stuck", "energy"):
                table.loc[m, name] = np.nan
            if name.startswith("peaks."):
                table.at[m, name] = []
        table.loc[m, "status"] = status
        table.loc[m, "message"] = message
    return table


def robust_study(base: int = 256, sampler: str = "sobol") -> StandIn:
    """Payload first, stiffness second, the rest hardly at all."""
    case = scenario()
    varied = axes(
        "uncertain", "plant.tip_mass=+-50%", "plant.bending_stiffness=+-20%:normal", "actuator.all.chain.0.right=0.02:0.4:log",
        "plant.shear_stiffness,plant.rotary_inertia=+-10%",
    )  # fmt: skip
    u = saltelli(base, 4, sampler, 3)
    taken = {axis.name: axis.at(u[:, i]) for i, axis in enumerate(varied)}
    share = np.exp(-1.6 + 1.5 * (u[:, 0] - 0.3) - 0.8 * (u[:, 1] - 0.5) + 0.5 * u[:, 2] * u[:, 0] + 0.02 * u[:, 3])
    share = np.where((u[:, 0] > 0.97) & (u[:, 1] < 0.5), 1.5 * share / 0.7, share)
    share = np.where((u[:, 0] > 0.985) & (u[:, 1] < 0.25), 5.0, share)
    table = rows(case, taken, share, 2 + u[:, 2] + 0.3 * u[:, 1])
    table = refuse(table, [5], "Argument `plant.tip_mass` must be >= 0 kg, but is -0.1.")
    table = refuse(table, [7], "FloatingPointError: overflow", "crashed")
    return StandIn(Defined("robust", case, varied, base=base, sampler=sampler), len(u), table)


def sweep_study(*texts: str, fine: bool = True) -> StandIn:
    """A grid, best at alpha_4 = 2.5 and alpha_7 = 1, lost where both are large, diverged beyond; texts: further axes."""
    case = scenario()
    count = 20 if fine else 6
    given = texts or (f"controller.alpha_4=0.1:10:log:{count}", f"controller.alpha_7=0.1:10:log:{count}")
    varied = axes("vary", *given)
    grid = np.array(np.meshgrid(*(range(len(axis.values)) for axis in varied), indexing="ij")).reshape(len(varied), -1)
    taken = {axis.name: [axis.values[i] for i in row] for axis, row in zip(varied, grid, strict=True)}
    a = np.log10(np.array(taken.get("controller.alpha_4", [2.5])) / 2.5)
    b = np.log10(np.array(taken.get("controller.alpha_7", [1.0])))
    share = 0.08 * np.exp(2.2 * a**2 + 1.5 * (b + 0.3 * a) ** 2 + 2.6 * np.maximum(0, a + b - 0.4) ** 2) + 0 * grid[0]
    shift = [0.05 * row for axis, row in zip(varied, grid, strict=True) if isinstance(axis.values[0], str | bool)]
    share = share * (1 + sum(shift))
    share = np.where(a + b > 1.2, 4.0, share)
    return StandIn(Defined("sweep", case, varied), len(share), rows(case, taken, share, 1.5 * 10 ** (0.3 * a) + 0 * share))


def tune_study(objectives: tuple[str, ...] = ("peak",), generations: int = 40, population: int = 16) -> StandIn:
    """Gains that draw near alpha_4 = 3, alpha_7 = 0.5, and alpha_9 at its upper bound."""
    case = scenario()
    varied = axes(
        "search", "controller.alpha_4=0.01:100:log", "controller.alpha_7=0.01:100:log", "controller.alpha_9=0.01:0.9",
    )  # fmt: skip
    rng, n = np.random.default_rng(8), generations * population
    generation = np.repeat(np.arange(generations), population)
    spread = 1.5 * np.exp(-generation / (10 if len(objectives) == 1 else 25))[:, None]
    z = np.clip(spread * rng.standard_normal((n, 3)), -1.6, 1.5)
    last = np.minimum(0.9, 0.895 - 0.2 * np.abs(z[:, 2]))
    taken = {varied[0].name: 3 * 10 ** z[:, 0], varied[1].name: 0.5 * 10 ** z[:, 1], varied[2].name: last}
    share = 0.09 * np.exp(1.2 * z[:, 0] ** 2 + 0.8 * z[:, 1] ** 2 + 2 * (0.9 - last))
    table = rows(case, taken, share, 2.0 * 10 ** (0.25 * z[:, 0] + 0.1 * z[:, 1]))
    table.insert(1, "generation", generation)
    return StandIn(Defined("tune", case, varied, objectives, population=population), n, table)
