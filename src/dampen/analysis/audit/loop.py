"""The closed loop's rates and the a-priori bounds, as rows of the audit."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from dampen.analysis.audit.finding import Finding, Quantity
from dampen.analysis.bounds import Bounds
from dampen.analysis.rates import NoRates, Rates
from dampen.simulation.scenario import Scenario

FEW = 4  # modes that are listed


def rate_rows(found: Rates | NoRates, scenario: Scenario) -> Iterator[Finding]:
    """Does every motion of the loop decay, and does a reduced-order law harm the modes that it left out? Without a control the
    first is told of the structure alone, and not judged."""
    alone = scenario.controller.kind == "none"
    criterion = "every mode of the structure alone decays" if alone else "every mode of the closed loop decays"
    if isinstance(found, NoRates):
        yield Finding.of("rates", "rates.slowest", criterion, "not a linear law", None, found.reason, {})
        return
    whose = f"mode {found.slowest}" if found.slowest else "a motion that is no mode of the plant"
    yield Finding.of(
        "rates",
        "rates.slowest",
        criterion,
        f"slowest {found.rate:.3g} 1/s, {whose}; {len(found.modes)} modes",
        found.rate > 0,
        rate_meaning(found),
        {
            "slowest rate": Quantity(found.rate, "1/s"),
            "rate, by mode": Quantity(tuple(mode.rate for mode in found.modes), "1/s"),
            "frequency, by mode": Quantity(tuple(mode.frequency for mode in found.modes), "Hz"),
        },
        judged=not alone,
    )
    spilt = found.spillover
    if spilt is None:
        return
    if spilt.worst is None:
        measured = f"none of {spilt.left_out} slowed"
    else:
        measured = f"{spilt.slowed} of {spilt.left_out} slowed; mode {spilt.worst} by {-spilt.change:.3g} 1/s"
    yield Finding.of(
        "rates",
        "rates.spillover",
        f"the law, designed on {spilt.known} modes, makes none of those that it left out grow (spillover)",
        measured,
        not spilt.growing,
        f"Growing: modes {', '.join(map(str, spilt.growing))}."
        if spilt.growing
        else "What the law does not know of takes no harm."
        if spilt.worst is None
        else "The structure's own damping outweighs what the law does to modes that it does not know of.",
        {"slowed": Quantity(spilt.slowed), "worst change": Quantity(spilt.change, "1/s"), "growing": Quantity(spilt.growing)},
    )


def rate_meaning(found: Rates) -> str:
    """What the slowest rate says, in words."""
    if found.rate < 0:
        return f"It grows, by {-found.rate:.3g} 1/s: left alone, the slightest motion runs away until something limits it."
    if found.rate == 0:
        rigid = [n for n in found.still if found.modes[n - 1].plant_frequency == 0]
        swinging = [n for n in found.still if n not in rigid]
        told = (
            [f"{numbered(swinging, 'does', 'do')} not decay: nothing damps {'it' if len(swinging) == 1 else 'them'}"]
            if swinging
            else []
        )
        told += [f"{numbered(rigid, 'is', 'are')} rigid motion, which nothing brings back"] if rigid else []
        said = "; ".join(told or ["what is no mode of the plant does not decay"]) + "."
        return said[0].upper() + said[1:]
    said = f"Left alone, every motion dies out; the slowest takes {np.log(3) / found.rate:.3g} s to fall to a third."
    return f"{said} {found.notes[-1]}" if found.with_modes else said


def numbered(modes: Sequence[int], one: str, many: str) -> str:
    """Modes by number, a few of them, and the verb that follows."""
    listed = ", ".join(map(str, modes[:FEW]))
    if len(modes) == 1:
        return f"mode {listed} {one}"
    return f"modes {listed}{f' and so on ({len(modes)} modes)' if len(modes) > FEW else ''} {many}"


def bound_rows(found: Bounds, scenario: Scenario) -> Iterator[Finding]:
    """Do energy and ports stay within what a passive law guarantees, from the stated bounds?"""
    if scenario.controller.kind == "none" and found.holds is not False:
        return
    criterion = "energy and barrier, and |y|, within the a-priori bound of a passive law"
    values = {"measured V, by trial": Quantity(found.measured, "J")}
    if found.reason:
        yield Finding.of("bounds", "bounds.energy", criterion, "no bound", None, found.reason, values)
        return
    until = found.trials - 1
    span = "in trial 0" if until == 0 else f"up to trial {until}"
    ports = [
        f"|y| at {port.port} {max(port.measured[: found.trials]):.3g} of {port.bound[-1]:.3g} {port.unit}"
        for port in found.ports
        if port.bound
    ]
    most = "; ".join([f"{span}: V {max(found.measured[: found.trials]):.3g} of {max(found.bound):.3g} J", *ports])
    broken = found.broken
    yield Finding.of(
        "bounds",
        "bounds.energy",
        criterion,
        most
        if broken is None
        else f"trial {broken.trial}, {broken.time:.6g} s: {broken.what} {broken.value:.6g} of {broken.bound:.6g} {broken.unit}",
        found.holds,
        " ".join(found.notes) or "The bound follows from the stated bounds of the disturbances alone.",
        values
        | {"bound on V, by trial": Quantity(found.bound, "J")}
        | {f"bound on |y| at {port.port}, by trial": Quantity(port.bound, port.unit) for port in found.ports},
    )
