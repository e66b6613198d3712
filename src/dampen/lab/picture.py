"""A result as the page shows it: the whole run thinned so that no peak is lost, and one trial in full."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

import numpy as np

from dampen.analysis.energy import energy_account
from dampen.analysis.metrics import error_peaks
from dampen.controllers.none import NoControl
from dampen.lab.frames import framed
from dampen.plants.base import Modes
from dampen.port import Port
from dampen.report.names import port_names
from dampen.simulation.bench import Bench
from dampen.simulation.result import Result
from dampen.simulation.setting import setting_of
from dampen.studies.compare.ranges import ranges_said

Array = np.ndarray
BUCKETS = 800  # of a run: about what a plot has pixels
COLUMNS = 400
POINTS = 101
NEAR = 1e-4  # of the span: where a structure's slope at its base is read


def picture(result: Result, trial: int, bench: Bench, about: Mapping[str, Any]) -> bytes:
    """The frame that answers a request: everything about the run, and the trial that is being looked at, or the last there is.

    about: what else is to be said of it: which request it answers, where it comes from.
    """
    trial = max(0, min(trial, result.trials - 1))
    return framed({**header(result, bench), **about, "trial": trial}, {**overview(result), **detail(result, trial)})


def trial_frame(result: Result, trial: int, id: int) -> bytes:
    """The frame of another trial of the run that request `id` has shown."""
    return framed({"say": "trial", "id": id, "trial": trial}, detail(result, trial))


def header(result: Result, bench: Bench) -> dict[str, Any]:
    """What is not an array."""
    scenario, modes, setting = result.scenario, bench.modes, setting_of(result.scenario, bench=bench)
    account = energy_account(result)
    return {
        "say": "picture",
        "name": scenario.name,
        "title": scenario.title,
        "status": result.status,
        "warnings": result.warnings,
        "trials": result.trials,
        "asked": scenario.task.trials,
        "duration": scenario.task.trial_duration,
        "steps": scenario.steps,
        "step": scenario.numerics.step,
        "span": scenario.plant.span,
        "tip": payload(modes, scenario.plant.span),
        "clamped": base(modes, scenario.plant.span),
        "ports": [described(port, result) for port in scenario.plant.ports],
        "fields": [{"name": name, "unit": unit} for name, unit in scenario.plant.fields],
        "gains": [float(gain) for gain in setting.gains],
        "sampled": scenario.sampled,
        "controlled": not isinstance(scenario.controller, NoControl),
        "tracking": bool(scenario.task.reference),
        "reset": scenario.task.start == "reset",
        "energy": {**asdict(account), "law": account.law, "error": account.error},
        "sliders": sliders(ranges_said(scenario.controller, setting)),
    }


def described(port: Port, result: Result) -> dict[str, Any]:
    """A port, with what it is called."""
    names = port_names(result, port.name)
    symbol = names.text if names.math else ""
    units = {"motion_unit": names.motion, "effort_unit": names.effort}
    return {"name": port.name, "field": port.field, "x": port.x, "kind": port.kind, **units, "symbol": symbol}


def payload(modes: Modes, span: float) -> dict[str, float]:
    """Mass [kg] and rotary inertia [kg m^2] that the structure carries at its tip."""
    lumps = {f.unit: sum(lump for place, lump in f.lumps if abs(place - span) < NEAR * span) for f in modes.fields}
    return {"mass": float(lumps.get("m", 0.0)), "inertia": float(lumps.get("rad", 0.0))}


def base(modes: Modes, span: float) -> str:
    """How the structure is held at x = 0: "clamped", "pinned" or "free"."""
    shifts = [f for f in modes.fields if f.unit == "m"]
    if not shifts:
        return "clamped"
    at = np.array([0.0, NEAR * span, span])
    shape, turns = shifts[0].shapes(at), [f.shapes(at) for f in modes.fields if f.unit == "rad"]
    largest = np.abs(shape[2]).max()
    if np.abs(shape[0]).max() > NEAR * largest:
        return "free"
    turned = np.abs(turns[0][0]).max() * span if turns else np.abs(shape[1] - shape[0])[0] / NEAR
    return "clamped" if turned < 10 * NEAR * largest * modes.count else "pinned"


def sliders(ranges: Mapping[str, str]) -> dict[str, dict[str, Any]]:
    """The ranges in which a search would look for the controller's gains."""
    found = {}
    for path, text in ranges.items():
        low, high, *scale = text.split(":")
        found[f"controller.{path}"] = {"low": float(low), "high": float(high), "log": scale == ["log"]}
    return found


def overview(result: Result) -> dict[str, Array]:
    """The whole run: smallest and largest value in each bucket, and the fields by their largest modulus in each column."""
    trials, scenario = range(result.trials), result.scenario
    buckets = max(1, -(-BUCKETS // result.trials))
    length = -(-len(result.time) // buckets)
    found = {"time": bucket_middles(result.time, length)}
    found |= {f"all.{name}": bucketed(whole(result, name), length) for name in ("y", "command", "delivered", "energy")}
    found |= limits(result, length)
    if scenario.task.reference:
        found["all.reference"] = bucketed(whole(result, "reference"), length)
    found["peaks"] = np.stack([error_peaks(result, port) for port in scenario.ports], axis=1)
    points = selected(len(result.x))
    found["x"] = result.x[points]
    found["time_out"] = result.time_out
    columns = max(1, -(-COLUMNS // len(trials)))
    for name, _ in scenario.plant.fields:
        values = whole(result, name)[:, :, points]
        found[f"all.{name}"] = largest_in(values, -(-values.shape[1] // columns))
    return found


def detail(result: Result, trial: int) -> dict[str, Array]:
    """One trial: its signals at every step, its fields at every snapshot."""
    low, high = result.scenario.limits(trial)
    found = {name: np.asarray(result[name][trial]) for name in ("y", "command", "delivered", "energy")}
    found |= {"barrier": np.asarray(result["barrier_energy"][trial]), "low": low, "high": high}
    if result.scenario.task.reference:
        found["reference"] = np.asarray(result["reference"][trial])
    points = selected(len(result.x))
    return found | {name: np.asarray(result[name][trial])[:, points] for name, _ in result.scenario.plant.fields}


def whole(result: Result, name: str) -> Array:
    """(trials, ...) a variable of all finished trials."""
    return np.asarray(result[name][: result.trials])


def limits(result: Result, length: int) -> dict[str, Array]:
    """The limits of all trials, in buckets; every trial has those of the first where they are steady."""
    scenario, trials = result.scenario, result.trials
    each = [scenario.limits(j) for j in range(1 if scenario.task.steady else trials)]
    found = {}
    for name, values in zip(("all.low", "all.high"), zip(*each, strict=True), strict=True):
        own = bucketed(np.stack(values), length)
        found[name] = np.broadcast_to(own, (trials, *own.shape[1:]))
    return found


def selected(count: int) -> Array:
    """Which of `count` points along the structure are shown: at most POINTS, as even as can be, both ends among them."""
    return np.unique(np.round(np.linspace(0, count - 1, min(count, POINTS))).astype(int))


def in_buckets(values: Array, length: int) -> Array:
    """(trials, ..., buckets, length) of (trials, times, ...); the last value fills the last bucket."""
    missing = -values.shape[1] % length
    if missing:
        values = np.concatenate([values, np.repeat(values[:, -1:], missing, axis=1)], axis=1)
    along = np.ascontiguousarray(np.moveaxis(values, 1, -1))
    return along.reshape(*along.shape[:-1], -1, length)


def bucketed(values: Array, length: int) -> Array:
    """(trials, buckets, 2, ...) the smallest and the largest value of each bucket, in order of time."""
    grouped = in_buckets(values, length)
    first, second = grouped.argmin(axis=-1), grouped.argmax(axis=-1)
    order = np.sort(np.stack([first, second], axis=-1), axis=-1)
    return np.moveaxis(np.take_along_axis(grouped, order, axis=-1), (-2, -1), (1, 2))


def bucket_middles(time: Array, length: int) -> Array:
    """(buckets,) the time in the middle of each bucket."""
    return np.asarray(in_buckets(time[None], length)[0].mean(axis=-1))


def largest_in(values: Array, length: int) -> Array:
    """(trials, columns, points) the value of largest modulus in each column."""
    missing = -values.shape[1] % length
    if missing:
        values = np.concatenate([values, np.repeat(values[:, -1:], missing, axis=1)], axis=1)
    grouped = values.reshape(len(values), -1, length, values.shape[2])
    low, high = grouped.min(axis=2), grouped.max(axis=2)
    return np.where(-low > high, low, high)
