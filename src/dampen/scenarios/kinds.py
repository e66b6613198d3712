"""Every kind that a scenario file can name, by table."""

from __future__ import annotations

from dampen.actuators.backlash import Backlash
from dampen.actuators.ideal import Ideal
from dampen.component import ArgumentError, Component, suggestion
from dampen.controllers.dual_loop_ailc import DualLoopAILC
from dampen.controllers.none import NoControl
from dampen.disturbances.harmonic_families import HarmonicFamilies
from dampen.disturbances.none import NoDisturbance
from dampen.plants.timoshenko import TimoshenkoBeam

KINDS: dict[str, tuple[type[Component], ...]] = {
    "plant": (TimoshenkoBeam,),
    "actuator": (Ideal, Backlash),
    "disturbance": (NoDisturbance, HarmonicFamilies),
    "controller": (NoControl, DualLoopAILC),
}


def find_kind(table: str, kind: object, where: str) -> type[Component]:
    """The class behind a `kind`; raises ArgumentError with what is known."""
    known = {cls.kind: cls for cls in KINDS[table]}
    if not isinstance(kind, str) or kind not in known:
        raise ArgumentError(
            f"Argument `{where}.kind` must be a known kind of {table}, but is {kind!r}{suggestion(str(kind), known)}"
        )
    return known[kind]
