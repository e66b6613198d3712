"""Composing the kernel: which plain functions it is made of for a scenario, and compiling them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from types import ModuleType
from typing import Any

from dampen.simulation import kernel, log_barrier, members, tan_barrier, windows
from dampen.simulation.compiled import bind, compiled, is_cached

BARRIERS: dict[str, ModuleType] = {"log": log_barrier, "tan": tan_barrier}


@dataclass(frozen=True)
class Composition:
    """What a kernel is made of: the number of ports, the stages' step functions by code, whether modes are damped, the shape
    of the barrier, and the function of a sampled law (None: continuous)."""

    ports: int
    steps: tuple[Callable[..., float], ...]
    damped: bool = False
    barrier: str = "log"
    sampled_law: Callable[..., None] | None = None

    def bind(self) -> Callable[..., int]:
        """The kernel in plain Python."""
        dispatch: Any = no_stage
        for code in reversed(range(len(self.steps))):
            dispatch = bind(one_stage, own_code=code, own_step=self.steps[code], other_stage=dispatch)
        names: dict[str, Any] = {"stage_step": dispatch, "PORTS": self.ports, "DAMPED": self.damped}
        if self.barrier != "log":
            shape = BARRIERS[self.barrier]
            names |= {name: getattr(shape, name) for name in ("carried", "fresh", "gradient", "potential")}
        law = self.sampled_law
        if law is not None:
            names |= {"SAMPLED": True, "sampled_law": bind(law, **names)}
        return bind(kernel.run_trial, **names)

    def bind_members(self, relearn: Callable[..., Any] | None) -> Callable[..., None]:
        """What runs the members of a batch through a trial, around the same kernel; `relearn`: how their law learns."""
        learning = {} if relearn is None else {"LEARNS": True, "relearn": relearn}
        return bind(members.run_members, run_trial=self.bind(), PORTS=self.ports, **learning)

    def bind_windows(self) -> Callable[..., None]:
        """What takes many runs through a sample period each, around the same kernel."""
        return bind(windows.run_windows, run_trial=self.bind(), PORTS=self.ports)


@cache
def compiled_kernel(composition: Composition) -> Any:
    """The kernel, compiled; see `is_ready` for whether that will take a while."""
    return compiled(composition.bind())


@cache
def compiled_members(composition: Composition, relearn: Callable[..., Any] | None) -> Any:
    """The same for the members of a batch."""
    return compiled(composition.bind_members(relearn))


@cache
def compiled_windows(composition: Composition) -> Any:
    """The same for runs that are stepped from outside."""
    return compiled(composition.bind_windows())


def is_ready(kernel_function: Any) -> bool:
    """Whether the compiled kernel is there already, in memory or on disk."""
    return bool(kernel_function.signatures) or is_cached(kernel_function)


def one_stage(code, command, state, parameters, new_state):  # type: ignore[no-untyped-def]
    """One link of the dispatch from a stage's code to its step function."""
    if code == own_code:  # type: ignore[name-defined]  # noqa: F821  (bound by `Composition.bind`)
        return own_step(command, state, parameters, new_state)  # type: ignore[name-defined]  # noqa: F821
    return other_stage(code, command, state, parameters, new_state)  # type: ignore[name-defined]  # noqa: F821


def no_stage(code, command, state, parameters, new_state):  # type: ignore[no-untyped-def]
    """The end of the dispatch."""
    return command
