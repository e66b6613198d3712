"""The kernel's records: modes, ports and stages as arrays that it reads and carries from trial to trial."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dampen.component import ArgumentError, own_name
from dampen.modal import ModalModel, Propagator, dissipation
from dampen.simulation.closure import SOFTNESS
from dampen.simulation.kernel import MODAL, PORT, STAGE, STAGE_PARAMETERS, STAGE_STATES, Record, Step
from dampen.stage import Stage

Array = np.ndarray


def exact_step(model: ModalModel, motion: Propagator, dt: float) -> Step:
    """What the ports see of a step of the modes under held forces."""
    b = model.b
    g = (b * motion.psi) @ b.T / dt
    return Step(dt, 1 / dt, aligned(b), aligned(g), aligned(g))


def modal_record(model: ModalModel, motion: Propagator, step: Step, q: Array, rate: Array) -> Any:
    """The kernel's record of all modes, in the state q, rate."""
    n = model.count
    modal = on_cache_line(MODAL.itemsize).view(MODAL).view(np.recarray)
    rows = {"q": q, "rate": rate, "omega2": model.omega**2}
    rows |= {name: getattr(motion, name) for name in ("c11", "c12", "c22", "psi")}
    rows |= {f"b{p}": row for p, row in enumerate(step.b[:2])}
    if model.damped:
        names = ("loss_qq", "loss_qr", "loss_rr", "loss_qa", "loss_ra", "loss_aa")
        rows |= dict(zip(names, (dissipation(model, step.dt) * [1, 2, 1, 2, 2, 1]).T, strict=True))
    for name, row in rows.items():
        modal[name][0, :n] = row
    modal["count"] = n
    return modal


def port_records(chains: Sequence[Sequence[Stage]], step: Step, classes: Sequence[type[Stage]]) -> tuple[Any, Any]:
    """The records of all ports and of the stages in front of them, at rest; a stage's code is its class's place in `classes`."""
    ports = np.zeros(len(chains), PORT).view(np.recarray)
    stages = np.zeros(max(1, sum(map(len, chains))), STAGE).view(np.recarray)
    ports.soft, ports.gain, ports.feedthrough = SOFTNESS * np.diag(step.g), 1.0, 1.0
    s = 0
    for port, chain in zip(ports, chains, strict=True):
        port.first, port.last = s, s + len(chain)
        for stage in chain:
            row = stage.row(step.dt)
            if len(row) > STAGE_PARAMETERS or stage.states > STAGE_STATES:
                most = f"at most {STAGE_PARAMETERS} parameters and {STAGE_STATES} states"
                raise ArgumentError(f"{own_name(stage)} must have {most}, but has {len(row)} and {stage.states}.")
            stages[s].code, stages[s].states = classes.index(type(stage)), stage.states
            stages[s].parameters[: len(row)] = row
            stages[s].state[: stage.states] = stage.start()
            port.gain *= stage.gain
            port.feedthrough *= stage.feedthrough(step.dt)
            s += 1
        port.per_feedthrough = 1 / port.feedthrough
    return ports, stages


def empty_record(steps: int, ports: int, modes: int, every: int) -> Record:
    """Arrays for the kernel to fill."""
    on_times, on_steps, once = (steps + 1, ports), (steps, ports), (steps,)
    shapes = (on_times, on_times, (steps + 1,), on_steps, on_steps, on_steps, once, once, (steps // every + 1, modes), (1,))
    return Record(*map(np.zeros, shapes))


def aligned(a: Array) -> Array:
    """A contiguous copy that starts on a cache line: a tenth of the kernel's time."""
    out = on_cache_line(8 * a.size).view(float).reshape(a.shape)
    out[...] = a
    return out


def on_cache_line(size: int) -> Array:
    """`size` zero bytes that start on a cache line."""
    buffer = np.zeros(size + 64, np.uint8)
    offset = -buffer.ctypes.data % 64
    return buffer[offset : offset + size]
