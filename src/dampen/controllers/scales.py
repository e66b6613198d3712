"""What a structure's own scales are at its ports, so that a search for gains can begin anywhere: ranges in units of these."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from dampen.controllers.base import Array, Setting
from dampen.port import Port

LOWEST = 6  # elastic modes from which the impedance is taken
RIGID = 1e-6  # of the highest frequency: what is slower is a rigid-body mode


@dataclass(frozen=True)
class PortScale:
    """What is much and what is little at a port, counted in the law's command: what the actuator's slope makes of it is
    divided out.

    impedance: [N s/m, N m s] of the port where the structure is taken as endless: a damping of this size swallows most.
    stiffness: [N/m, N m/rad] static stiffness of the elastic structure, as the port feels it.
    room:      [m, rad] least distance from the reference to the constraint; infinite without one.
    """

    port: Port
    impedance: float
    stiffness: float
    room: float


def scales(setting: Setting) -> tuple[PortScale, ...]:
    """The scales of every port that has an actuator and can be moved.

    Impedance by Skudrzyk's mean-value method: the mean mobility of a port over its lowest modes is pi/2 sum b^2 over the
    band of frequencies that they fill, whatever the boundaries; for a string it is sqrt(tension mass_per_length). Source:
    Skudrzyk, J. Acoust. Soc. Am. 67, 1980.
    """
    omega, b = elastic(setting)
    if not len(omega):
        return ()
    mobility, compliance = mean_mobility(omega, b), np.sum((b / omega) ** 2, axis=1)
    room = np.minimum(setting.high, -setting.low).min(axis=0, initial=np.inf)
    return tuple(
        PortScale(port, float(1 / (mobility[p] * gain)), float(1 / (compliance[p] * gain)), float(room[p]))
        for p, (port, gain) in enumerate(zip(setting.ports, setting.gains, strict=True))
        if gain > 0 and compliance[p] > 0 and mobility[p] > 0
    )


def elastic(setting: Setting) -> tuple[Array, Array]:
    """Angular frequencies and port vectors, (modes,) and (ports, modes), of all modes but the rigid ones."""
    model = setting.model()
    kept = model.omega > RIGID * model.omega[-1]
    return model.omega[kept], model.b[:, kept]


def mean_mobility(omega: Array, b: Array) -> Array:
    """(ports,) mean point mobility [m/(s N), rad/(s N m)] over the lowest modes: angular frequencies, (ports, modes) vectors."""
    count = min(LOWEST, len(omega))
    end = (omega[count - 1] + omega[count]) / 2 if len(omega) > count else 1.5 * omega[-1]
    return np.asarray(np.pi / 2 * np.sum(b[:, :count] ** 2, axis=1) / end)


def span(scale: float, low: float, high: float) -> str:
    """A logarithmic range in units of a scale, as a search takes it."""
    return f"{scale * low:.3g}:{scale * high:.3g}:log"


def feedback(found: Iterable[PortScale]) -> dict[str, str]:
    """Ranges of a PD feedback: damping from a thousandth to a hundred of the impedance, stiffness from a thousandth to ten
    of the static one."""
    ranges: dict[str, str] = {}
    for s in found:
        ranges[f"damping.{s.port.name}"] = span(s.impedance, 1e-3, 1e2)
        ranges[f"stiffness.{s.port.name}"] = span(s.stiffness, 1e-3, 10)
    return ranges


def first_period(setting: Setting) -> float:
    """The period of the lowest elastic mode [s], at most the trial."""
    omega, trial = elastic(setting)[0], setting.steps * setting.dt
    return float(min(2 * np.pi / omega[0], trial)) if len(omega) else trial
