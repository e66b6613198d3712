"""What is left in the last trials: an offset at which ports stick, energy that is trapped, or a vibration that comes and goes."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from dampen.analysis.audit.finding import Finding, Quantity
from dampen.analysis.audit.sticking import Left, Sticking, driven, left, sticking
from dampen.analysis.merits import LATE
from dampen.simulation.bench import Bench
from dampen.simulation.result import Result

MOSTLY, SWIFT = 0.5, 0.2  # shares: of steps, mean square or energy; of the run


def residual(result: Result, bench: Bench) -> Iterator[Finding]:
    """A row for each driven port that mostly sticks, and one for the energy; nothing without control, or for a tracking task."""
    if not driven(result) or result.scenario.task.reference:
        return
    found = sticking(result)
    if found is not None:
        yield from (held_off(found, i) for i in range(len(found.ports)) if found.share[i] > MOSTLY)
    yield trapped(left(result, bench), found, result)


def held_off(found: Sticking, i: int) -> Finding:
    """Whether what is left at a port that mostly sticks is where it was stopped, and not a vibration."""
    (unit, effort), offset, rms = found.units[i], found.offset[i], found.rms[i]
    frozen = offset**2 > MOSTLY * rms**2
    return Finding.of(
        "residual",
        f"residual.offset.{found.ports[i]}",
        f"the residual at {found.ports[i]} is a vibration, not an offset at which it sticks",
        f"mean {offset:.3g} {unit}, RMS {rms:.3g} {unit}, last trials",
        not frozen,
        f"It is where the port was stopped: Sgn holds it there, off its rest, with up to {found.force[i]:.3g} {effort}, and what "
        "is neither moving nor measured cannot be learned away."
        if frozen
        else "What is left moves.",
        {"mean, last trials": Quantity(offset, unit), "RMS, last trials": Quantity(rms, unit)},
    )


def trapped(rest: Left, found: Sticking | None, result: Result) -> Finding:
    """The energy that is left, and how long the control takes to take as much: what is trapped it takes for ever."""
    task, few = result.scenario.task, result.trials <= LATE
    run = task.trials * task.trial_duration
    taken = rest.taken + 0.0  # no negative zero
    span = rest.energy / taken * task.trial_duration if taken > 0 else np.inf
    holds = span <= SWIFT * run
    static = "" if rest.static is None else f", {rest.static:.2g} J of it static"
    stuck = "" if found is None else f"; all driven ports stuck {found.together:.0%} of the time"
    share = 0.0 if rest.static is None or not rest.energy else rest.static / rest.energy
    bend = f" {share:.0%} of it is no vibration but the bend that holds the ports off their rest." if share > MOSTLY else ""
    return Finding.of(
        "residual",
        "residual.trapped-energy",
        f"within a fifth of the run, {SWIFT * run:g} s, the control takes as much energy as is left in the last trials",
        "nothing is left"
        if not rest.energy
        else f"{rest.energy:.3g} J left{static}; {taken:.2g} J taken a trial: as much in {span:.3g} s{stuck}",
        None if few or not rest.energy else holds,
        "Too few trials to tell what will be left."
        if few
        else "The structure is at rest."
        if not rest.energy
        else f"What vibrates comes and goes.{bend}"
        if holds
        else f"Trapped: the ports hardly move, so that hardly anything leaves through them.{bend} Less authority (Sgn, damping) "
        "would let them slip.",
        {
            "left, last trials": Quantity(rest.energy, "J"),
            "of it static": Quantity(rest.static, "J"),
            "taken a trial, last trials": Quantity(rest.taken, "J"),
            **({} if found is None else stuck_together(found)),
        },
    )


def stuck_together(found: Sticking) -> dict[str, Quantity]:
    """How long all driven ports stick together, and on what energy."""
    return {
        "share of steps all stuck, last trials": Quantity(found.together),
        "share of steps all stuck, by trial": Quantity(found.together_by_trial),
        "energy while all stuck, by trial": Quantity(found.kept_by_trial, "J"),
    }
