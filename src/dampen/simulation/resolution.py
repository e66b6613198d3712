"""Can modes, step and quadrature resolve what shakes the structure? Refuse what they cannot, warn where it is thin, and where
a number may be in other units."""

from __future__ import annotations

import numpy as np

from dampen.component import wrong
from dampen.plants.base import Modes
from dampen.port import Site
from dampen.simulation.scenario import Scenario

REFUSED, WANTED = 4, 10
HARDLY = 0.01  # of the lowest period: a run this short sees nothing move
SHORTEST_WAVES = 2000


def check_ports(scenario: Scenario, modes: Modes) -> None:
    """Raise ArgumentError where modes cannot move every port by itself, and samples or resets need that."""
    if not (scenario.sampled or any(scenario.task.reset_error.values())):
        return
    size = np.linalg.norm(modes.b, axis=1, keepdims=True)
    if np.linalg.matrix_rank(modes.b / np.where(size > 0, size, 1.0)) < len(modes.b):
        why = "a law that acts through samples" if scenario.sampled else "`task.reset_error`"
        must = f"be larger, or ports be apart: for {why} modes must move each of the {len(modes.b)} ports by itself"
        raise wrong("numerics.modes", must, modes.count)


def check_resolution(scenario: Scenario, modes: Modes, site: Site) -> list[str]:
    """Warnings, one line each; raises ArgumentError where a disturbance would be sampled beyond recognition.

    A period must have more than 4 steps and should have 10; the highest mode should be faster than anything that shakes a
    port, since what is faster than all modes meets only their static compliance.
    """
    step, span, source = scenario.numerics.step, scenario.plant.span, scenario.disturbance
    different = sorted({source.same_as(j) for j in range(scenario.task.trials)})
    contents = [[part.content(j, site) for part in source.parts] for j in different]
    fastest = [max((max((*c.port_frequency, c.load_frequency)) for c in parts), default=0.0) for parts in contents]
    worst = int(np.argmax(fastest))
    trial, frequency = different[worst], fastest[worst]
    wave = min((c.load_wave for parts in contents for c in parts), default=np.inf)
    if frequency * step * REFUSED >= 1:
        must = f"be < {1 / (REFUSED * frequency):.2g} s to resolve the {frequency:g} Hz that shake trial {trial}"
        raise wrong("numerics.step", must, step)
    if span / wave > SHORTEST_WAVES:
        raise wrong("disturbance", f"have waves longer than {span / SHORTEST_WAVES:.2g} m on this structure", wave)
    warnings = []
    if frequency * step * WANTED > 1:
        warnings.append(
            f"Trial {trial} is shaken at {frequency:g} Hz, {1 / (frequency * step):.1f} steps a period: "
            f"`numerics.step` = {1 / (WANTED * frequency):.2g} would do."
        )
    highest = modes.omega[-1] / (2 * np.pi)
    if frequency > highest > 0:
        enough = int(np.ceil(modes.count * frequency / highest)) + 1
        warnings.append(
            f"Trial {trial} is shaken at {frequency:g} Hz, but the highest of {modes.count} modes is at {highest:.1f} Hz: "
            f"about `numerics.modes` = {enough} would do."
        )
    return warnings


def odd_sizes(scenario: Scenario, modes: Modes) -> list[str]:
    """Warnings, one line each, of what may be a slip of units: limits, a lowest frequency far too high or low, damping."""
    warnings, span, step = [], scenario.plant.span, scenario.numerics.step
    low, high = (limit[0] for limit in scenario.limits(0))
    for port, room in zip(scenario.plant.ports, (high - low) / 2, strict=True):
        if port.kind == "force" and span < room < np.inf:
            allowed = f"At {port.name} {room:g} m are allowed, more than the {span:g} m of the structure"
            warnings.append(f"{allowed}: is the constraint in m?")
    lowest = np.min(modes.omega[modes.omega > 0], initial=np.inf) / (2 * np.pi)
    if 1 / (REFUSED * step) < lowest < np.inf:
        warnings.append(
            f"The lowest mode is at {lowest:.4g} Hz, {1 / (lowest * step):.2g} steps a period: are the plant's parameters in the "
            f"units that `dampen list` gives? If so, `numerics.step` = {1 / (WANTED * lowest):.2g} would do."
        )
    whole = scenario.task.trials * scenario.task.trial_duration
    if lowest * whole < HARDLY:
        warnings.append(
            f"The lowest mode is at {lowest:.2g} Hz, of whose period the {whole:g} s of the run are {lowest * whole:.1g}: are "
            "the plant's parameters in the units that `dampen list` gives?"
        )
    swinging = modes.omega > 0
    if swinging.any() and np.all(modes.decay[swinging] >= modes.omega[swinging]):
        ratio = float(np.min(modes.decay[swinging] / modes.omega[swinging]))
        warnings.append(
            f"No mode swings: each is damped by {ratio:.3g} times the critical damping or more. A damping ratio of 4 % is 0.04."
        )
    return warnings
