"""What a law remembers from trial to trial, checked as it begins and after each trial."""

from __future__ import annotations

from collections.abc import Mapping
from types import FunctionType

import numpy as np

from dampen.component import ArgumentError, listed, own_name
from dampen.controllers.base import Controller, Memory, Setting, Trial
from dampen.own import blame, own
from dampen.simulation.scenario import Scenario
from dampen.simulation.variables import TAKEN, why_not


def begun(scenario: Scenario, setting: Setting) -> Memory:
    """The memories of the scenario's law before trial 0."""
    controller = scenario.controller
    with blame(controller, "begin"):  # its own, or one that it inherits and leads astray
        memory = controller.begin(setting)
    if own(type(controller)):
        taken = TAKEN | {name for name, _ in scenario.plant.fields}
        shape = (setting.steps, len(setting.ports))
        for name, value in memory.items():
            begin = f"{own_name(controller)}.begin"
            if why := why_not(name, taken):
                known = f"; call it none of {', '.join(sorted(taken))}." if name in taken else "; give it another one."
                raise ArgumentError(f"{begin} gives a memory `{name}`, which {why}{known}")
            if not _spreads(np.shape(value), shape):
                raise ArgumentError(f"{begin} must give the memory `{name}` in shape {shape}, but gives {np.shape(value)}.")
            if not np.all(np.isfinite(value)):
                raise ArgumentError(f"{begin} must give a finite memory `{name}`, but does not.")
    return memory


def after(controller: Controller, before: Memory, trial: Trial, setting: Setting, whole: bool = True) -> Memory:
    """What the law makes of its memories after a trial; what it learns of one that did not go to its end need not be finite."""
    with blame(controller, "learn"):
        memory = controller.learn(before, trial, setting)
    if own(type(controller)):
        shapes = [{name: np.shape(value) for name, value in one.items()} for one in (before, memory)]
        if shapes[0] != shapes[1]:
            raise ArgumentError("{}.learn must keep the memories {}, but returns {}.".format(own_name(controller), *shapes))
        for name, value in memory.items() if whole else ():
            if not np.all(np.isfinite(value)):
                raise ArgumentError(
                    f"{own_name(controller)}.learn must keep the memory `{name}` finite, but does not after trial {trial.index}."
                )
    return memory


def never_learned(controller: Controller, memory: Mapping[str, object]) -> list[str]:
    """A note on memories that stay what they were, since the user's class has no `learn`."""
    if not (memory and own(type(controller)) and type(controller).learn is Controller.learn):
        return []
    names = listed([f"`{name}`" for name in memory])
    what = f"memory {names} never changes" if len(memory) == 1 else f"memories {names} never change"
    return [f"{own_name(controller)} {lacking(controller, 'learn')}: its {what}."]


def lacking(controller: Controller, name: str) -> str:
    """What to say of a method that the user's class does not define: perhaps it is there under another name."""
    members = {key: value for cls in type(controller).__mro__ if own(cls) for key, value in vars(cls).items()}
    others = [key for key, value in members.items() if isinstance(value, FunctionType) and not hasattr(Controller, key)]
    methods = [f"`{key}`" for key in others if not key.startswith("_")]
    return f"defines no `{name}`{f', only {listed(methods)}' if methods else ''}"


def _spreads(shape: tuple[int, ...], over: tuple[int, ...]) -> bool:
    """Whether an array of a shape can be written down as one of another."""
    try:
        return np.broadcast_shapes(shape, over) == over
    except ValueError:
        return False
