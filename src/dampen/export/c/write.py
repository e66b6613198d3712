"""The files of an export, written to a folder."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from dampen.arguments import NOTHING, PATH, SCENARIO, TRUTH, of_class, takes
from dampen.component import ArgumentError
from dampen.export.c.blueprint import Blueprint, Guards, blueprint, compensation
from dampen.export.c.footprint import Footprint, footprint
from dampen.export.c.numbers import literal, rows
from dampen.export.c.recording import Recorded, record
from dampen.export.c.rounding import MARGIN, float_bound, returns
from dampen.export.c.source import Source, source_of
from dampen.simulation.bench import Bench
from dampen.simulation.digital_law import EXPLICIT, port_law
from dampen.simulation.scenario import Scenario
from dampen.toml import to_toml

Array = np.ndarray
AFTER = 300  # samples of the second trial in the self-test
WHOLE = 4000  # samples of a trial that the self-test still has in full; of a longer one the first AFTER
NEAR, LIFTED = 1e-12, 1e-8  # what another math.h, and another way of solving, may change, of the largest command


@dataclass(frozen=True)
class Export:
    """What was written where; bound: (ports,) how far its commands may be from the simulation's on the same readings."""

    folder: Path
    blue: Blueprint
    footprint: Footprint
    bound: Array


@takes(scenario=SCENARIO, folder=PATH, single=TRUTH, guards=of_class("Guards") | NOTHING)
def export_c(scenario: Scenario, folder: str | Path, single: bool = False, guards: Guards | None = None) -> Export:
    """Write the scenario's sampled controller in C99 to a folder; single: in float.

    Raises ArgumentError for what cannot be exported, and where the folder cannot be written.
    """
    folder, bench = Path(folder), Bench(scenario)
    blue = blueprint(scenario, single, guards, bench)
    source = source_of(blue)
    trials = list(record(scenario, bench, 2))
    bound = bound_of(blue, trials)
    test = test_names(blue, trials, bound)
    cost = footprint(source)
    readme = readme_names(source, cost, bound, len(test["readings"]))
    files = {
        name: source.file(name, **test, **readme)
        for name in ("controller.h", "controller.c", "selftest.c", "sil.c", "Makefile", "README.md")
    }
    files["scenario.toml"] = to_toml(scenario)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            (folder / name).write_text(text, encoding="utf-8")
    except OSError as error:
        raise ArgumentError(f"Output folder `{folder}` cannot be written: {error.strerror or error}.") from None
    return Export(folder, blue, cost, bound)


def bound_of(blue: Blueprint, trials: Sequence[Recorded]) -> Array:
    """(ports,) how far commands may be from recorded ones."""
    reach = np.abs(np.concatenate([trial.readings for trial in trials])).max(axis=0)
    largest = np.abs(np.concatenate([trial.commands for trial in trials])).max(axis=0)
    if blue.single:
        return float_bound(blue, reach, largest)
    return (LIFTED if blue.learning == "lifted" else NEAR) * np.maximum(largest, largest.max()) + 1e-300


def test_names(blue: Blueprint, trials: list[Recorded], bound: Array) -> dict[str, Any]:
    """What the self-test replays: a trial and the beginning of the next, as far as the controller would not stop."""
    first, *later = trials
    readings, commands = first.readings[:-1], first.commands
    if len(readings) > WHOLE:
        readings, commands, later = readings[:AFTER], commands[:AFTER], []
    for second in later:
        readings = np.vstack([readings, second.readings[:-1][:AFTER]])
        commands = np.vstack([commands, second.commands[:AFTER]])
    count = healthy(blue, readings)
    if not count:
        raise ArgumentError(
            "Argument `plant.initial` starts outside the constraint, or the readings that are believed (`--range`): "
            "the controller would stop at once."
        )
    over_end = count > blue.samples
    return {
        "readings": rows(readings[:count], blue.single),
        "commands": rows(commands[:count], blue.single),
        "over_end": over_end,
        "last": rows(first.readings[-1:], blue.single)[0] if over_end else "",
        "allowed": rows(bound[None, :])[0],
        "limits": rows(blue.ceiling[None, :])[0],
    }


def healthy(blue: Blueprint, readings: Array) -> int:
    """How many readings go by before one crosses the constraint, or is not believed."""
    sampler, rows_ = blue.sampler, np.arange(len(readings)) % blue.samples
    error = readings - sampler.reference[rows_]
    fine = (readings >= blue.believed[:, 0]) & (readings <= blue.believed[:, 1])
    if blue.guards.stop_at_constraint:
        fine &= (error > sampler.low[rows_]) & (error < sampler.high[rows_])
    bad = np.flatnonzero(~fine.all(axis=1))
    return int(bad[0]) if len(bad) else len(readings)


def readme_names(source: Source, cost: Footprint, bound: Array, count: int) -> dict[str, Any]:
    """What the README tells beside the names of the source."""
    blue, sampler = source.blue, source.blue.sampler
    limited = np.isfinite(sampler.ceiling)
    names = [port.name for port in blue.setting.ports]
    chains = [compensation(blue.scenario, p) for p in range(blue.ports)]
    switching = (
        np.reshape(sampler.parameters, (blue.ports, -1))[:, 4] if blue.law.__code__ is port_law.__code__ else np.array([-1.0])
    )
    bounds = [f"{b:.2g} {port.effort_unit} at {port.name}" for b, port in zip(bound, blue.setting.ports, strict=True)]
    learned = len(source.learning.memories)
    return {
        "wiring": [wiring(blue, p) for p in range(blue.ports)],
        "unlimited": ", ".join(name for name, has in zip(names, limited, strict=True) if not has),
        "reference": bool(np.any(sampler.reference)),
        "inverses": ", ".join(sorted({type(stage).__name__ for chain in chains for stage in chain})),
        "count": count,
        "memory": cost.memory,
        "memory_note": f", of that {learned} x {blue.samples} samples x {blue.ports} ports of learned memory" if learned else "",
        "tables_bytes": cost.tables,
        "step": cost.step,
        "end": f"is {cost.end}" if cost.end.startswith("as") else f"does {cost.end}",
        "bound": ", ".join(bounds),
        "margin": f"{MARGIN:g}",
        "explicit": bool(np.any(switching == EXPLICIT)),
        "growing": bool(np.any(returns(blue) >= 1)),
    }


def wiring(blue: Blueprint, p: int) -> dict[str, str]:
    """A row of the README's table of ports."""
    port, sampler = blue.setting.ports[p], blue.sampler
    low, high = sampler.low[:, p], sampler.high[:, p]
    moving = " (moving)" if np.any(low != low[0]) or np.any(high != high[0]) else ""
    ends = f"{low[0]:.6g} to {high[0]:.6g} {port.motion_unit}{moving}"
    ceiling = sampler.ceiling[p]
    return {
        "name": port.name,
        "motion": f"displacement [{port.motion_unit}]" if port.motion_unit == "m" else f"angle [{port.motion_unit}]",
        "effort": f"{port.kind} [{port.effort_unit}]",
        "believed": f"{blue.believed[p, 0]:.6g} to {blue.believed[p, 1]:.6g} {port.motion_unit}",
        "constraint": ends if np.isfinite(high).any() else "none",
        "limit": f"{ceiling:.6g} {port.effort_unit}" if np.isfinite(ceiling) else f"none (below {literal(blue.ceiling[p])})",
    }
