"""The user's own pieces, checked where they come in, so that a mistake is reported with its class and line."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from dampen.component import ArgumentError, own_name
from dampen.controllers.base import Controller, SampledFeedback, Setting
from dampen.own import blame, own
from dampen.plants.base import Modes, Plant
from dampen.simulation.compiled import compiled
from dampen.simulation.digital import Sample
from dampen.stage import Stage

Array = np.ndarray
TRIED = np.linspace(-10.0, 10.0, 41)
FASTEST = 1e75  # 1/s: beyond, fourth powers leave what a double can hold
PLACE = re.compile(r'File "(?P<file>[^"]+)", line (?P<line>\d+)')


def modes_of(plant: Plant, count: int, grid: int | None) -> Modes:
    """The plant's modes, their shapes checked."""
    try:
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):  # what comes of it is checked
            modes = plant.modes(count) if grid is None else plant.modes(count, grid)
    except np.linalg.LinAlgError:
        text = "Argument `plant` must have numbers nearer to one another: its modes cannot be told from round-off."
        raise ArgumentError(text) from None
    n, ports = np.size(modes.omega), len(plant.ports)
    wanted = {"omega": (n,), "decay": (n,), "b": (ports, n)}
    for name, shape in wanted.items():
        value = np.asarray(getattr(modes, name))
        if value.shape != shape or value.dtype.kind not in "fiu":
            raise ArgumentError(f"{own_name(plant)}.modes must give `{name}` of shape {shape}, but gives {value.shape}.")
        if not np.all(np.isfinite(value)):
            raise ArgumentError(f"{own_name(plant)}.modes must give a finite `{name}`, but does not.")
    for name, sign in (("omega", modes.omega), ("decay", modes.decay)):
        if np.any(sign < 0):
            raise ArgumentError(f"{own_name(plant)}.modes must give `{name}` >= 0, but the least is {np.min(sign):g}.")
    fastest = max(modes.omega.max(initial=0.0), modes.decay.max(initial=0.0), np.abs(modes.b).max(initial=0.0) ** 2)
    if fastest > FASTEST:
        raise ArgumentError(f"Argument `plant` must be slower or heavier: rates of its modes go up to {fastest:.3g} 1/s.")
    if [f.name for f in modes.fields] != [name for name, _ in plant.fields]:
        raise ArgumentError(f"{own_name(plant)}.modes must give the fields that the plant names, {[n for n, _ in plant.fields]}.")
    return modes


def check_stages(stages: tuple[Stage, ...], dt: float) -> None:
    """Try each of the user's own stages once in plain Python, then compile it alone."""
    for stage in stages:
        if not own(type(stage)):
            continue
        with blame(stage, "row"):
            row = np.array(stage.row(dt), float)
        state = np.zeros(max(1, stage.states))
        if len(stage.start()) != stage.states:
            raise ArgumentError(f"{own_name(stage)}.start must give {stage.states} numbers, but gives {len(stage.start())}.")
        state[: stage.states] = stage.start()
        with blame(stage, "step"):
            outputs = np.array([float(type(stage).step(u, state.copy(), row, state.copy())) for u in TRIED])
        if not np.all(np.isfinite(outputs)):
            raise ArgumentError(
                f"{own_name(stage)}.step must give finite numbers, but gives {outputs[~np.isfinite(outputs)][0]}."
            )
        if stage.monotone and np.any(np.diff(outputs) < -1e-12 * np.abs(outputs).max()):
            raise ArgumentError(f"{own_name(stage)}.step must not fall as its command rises; if it may, let `monotone` be False.")
        compile_alone(type(stage), type(stage).step, (0.0, state, row, state.copy()))


def check_sampled(controller: Controller, setting: Setting) -> None:
    """The same for a sampled law."""
    if not isinstance(controller, SampledFeedback) or not own(type(controller)):
        return
    with blame(controller, "row"):
        row = np.ascontiguousarray(controller.row(setting), float)
    if row.ndim > 1:
        raise ArgumentError(f"{own_name(controller)}.row must give a row of numbers, but gives an array of shape {row.shape}.")
    nothing, command = np.zeros(len(setting.ports)), np.zeros(len(setting.ports))
    state = np.zeros(max(1, controller.states(setting)))
    sample = Sample(*(nothing,) * len(Sample._fields))
    with blame(controller, "step"):
        type(controller).step(sample, state.copy(), row, command)
    compile_alone(type(controller), type(controller).step, (sample, state, row, command))


@cache
def _compiled(function: Callable[..., Any]) -> Any:
    return compiled(function)


def compile_alone(cls: type, function: Callable[..., Any], arguments: tuple[Any, ...]) -> None:
    """Compile one function of the user's own, and blame its line if that fails."""
    from numba.core.errors import NumbaError

    try:
        _compiled(function)(*arguments)
    except NumbaError as error:
        places = list(PLACE.finditer(str(error)))
        at = f" ({places[-1]['file']}, line {places[-1]['line']})" if places else ""
        reason = next((line.strip() for line in str(error).splitlines() if line.strip() and "Failed in" not in line), "")
        raise ArgumentError(f"{own_name(cls)}.step cannot be compiled: {reason}{at}.") from None
