"""Every kind that a scenario file can name, by table."""

from __future__ import annotations

import dataclasses
import inspect
from pathlib import Path
from typing import Any

from dampen.actuators.absent import Absent
from dampen.actuators.backlash import Backlash
from dampen.actuators.bouc_wen import BoucWen
from dampen.actuators.dead_zone import DeadZone
from dampen.actuators.effectiveness import Effectiveness
from dampen.actuators.first_order_lag import FirstOrderLag
from dampen.actuators.ideal import Ideal
from dampen.actuators.prandtl_ishlinskii import PrandtlIshlinskii
from dampen.actuators.rate_limit import RateLimit
from dampen.actuators.saturation import Saturation
from dampen.component import ArgumentError, Component, hints_of, shown, suggestion
from dampen.controllers.adaptive_boundary import AdaptiveBoundary
from dampen.controllers.base import Controller
from dampen.controllers.boundary_damping import BoundaryDamping
from dampen.controllers.compensation.backlash_inverse import BacklashInverse
from dampen.controllers.compensation.dead_zone_inverse import DeadZoneInverse
from dampen.controllers.compensation.prandtl_ishlinskii_inverse import PrandtlIshlinskiiInverse
from dampen.controllers.dual_loop_ailc import DualLoopAILC
from dampen.controllers.lqg import LQG
from dampen.controllers.none import NoControl
from dampen.controllers.norm_optimal_ilc import NormOptimalILC
from dampen.controllers.open_loop import OpenLoop
from dampen.controllers.p_type_ilc import PDTypeILC, PTypeILC
from dampen.disturbances.band_noise import BandNoise
from dampen.disturbances.base import Disturbance
from dampen.disturbances.base_shaking import BaseShaking
from dampen.disturbances.constant_load import ConstantLoad
from dampen.disturbances.function import FunctionDisturbance
from dampen.disturbances.harmonic_families import HarmonicFamilies
from dampen.disturbances.harmonics import Harmonics
from dampen.disturbances.impulse import Impulse
from dampen.disturbances.moving_load import MovingLoad
from dampen.disturbances.none import NoDisturbance
from dampen.disturbances.recorded import Recorded
from dampen.disturbances.sum import Sum
from dampen.own import complaint, own_object, with_colon
from dampen.plants.assembled import Assembled
from dampen.plants.base import Plant
from dampen.plants.euler_bernoulli import EulerBernoulliBeam
from dampen.plants.flexible_arm import FlexibleArm
from dampen.plants.string import String
from dampen.plants.timoshenko import TimoshenkoBeam
from dampen.signals.base import Signal
from dampen.signals.decay import Decay
from dampen.signals.hold import Hold
from dampen.signals.minimum_jerk import MinimumJerk
from dampen.signals.recorded import RecordedSignal
from dampen.signals.sinusoid import Sinusoid
from dampen.stage import Stage

KINDS: dict[str, tuple[type[Component], ...]] = {
    "plant": (TimoshenkoBeam, EulerBernoulliBeam, FlexibleArm, String, Assembled),
    "actuator": (
        Ideal,
        Absent,
        Backlash,
        Saturation,
        DeadZone,
        PrandtlIshlinskii,
        BoucWen,
        FirstOrderLag,
        RateLimit,
        Effectiveness,
    ),
    "compensation": (DeadZoneInverse, BacklashInverse, PrandtlIshlinskiiInverse),
    "disturbance": (
        NoDisturbance,
        HarmonicFamilies,
        Harmonics,
        BandNoise,
        Impulse,
        ConstantLoad,
        MovingLoad,
        BaseShaking,
        Recorded,
        FunctionDisturbance,
        Sum,
    ),
    "signal": (Hold, MinimumJerk, Sinusoid, Decay, RecordedSignal),
    "controller": (
        NoControl,
        OpenLoop,
        BoundaryDamping,
        AdaptiveBoundary,
        DualLoopAILC,
        PTypeILC,
        PDTypeILC,
        NormOptimalILC,
        LQG,
    ),
}
FAMILIES: dict[str, type[Component]] = {
    "plant": Plant,
    "actuator": Stage,
    "compensation": Stage,
    "disturbance": Disturbance,
    "controller": Controller,
    "signal": Signal,
}


def find_kind(table: str, kind: object, where: str, folder: Path) -> type[Component]:
    """The class behind a `kind`: a shipped one by its name, or a user's own as "module:Class", looked for in `folder` too.

    Raises ArgumentError with what is known.
    """
    known = {cls.kind: cls for cls in KINDS[table]}
    if isinstance(kind, str) and ":" in kind:
        return own_class(own_object(kind, f"{where}.kind", folder), FAMILIES[table], kind, f"{where}.kind")
    if not isinstance(kind, str) or kind not in known:
        hint = with_colon(str(kind), folder) or suggestion(str(kind), known)
        raise ArgumentError(f"Argument `{where}.kind` must be a known kind of {table}, but is {shown(kind)}{hint}")
    return known[kind]


def find_own_kind(kind: str, argument: str) -> tuple[str, type[Component]]:
    """The table that a user's own "module:Class" belongs in, and the class, from the current folder or from what is installed."""
    cls = own_object(kind, argument)
    for table, family in FAMILIES.items():
        if isinstance(cls, type) and issubclass(cls, family):
            return table, own_class(cls, family, kind, argument)
    known = ", ".join(dict.fromkeys(f"dampen.{family.__name__}" for family in FAMILIES.values()))
    raise ArgumentError(f"Argument `{argument}` must name a subclass of one of {known}, but {shown(kind)} is none.")


def own_class(cls: Any, family: type[Component], kind: str, argument: str) -> type[Component]:
    """The class that "module:Class" names, if a component of a family can be made of it. Raises ArgumentError."""
    if not (isinstance(cls, type) and issubclass(cls, family)):
        raise ArgumentError(f"Argument `{argument}` must name a subclass of dampen.{family.__name__}, but {shown(kind)} is none.")
    if not dataclasses.is_dataclass(cls) or "__dataclass_params__" not in cls.__dict__:
        raise ArgumentError(
            f"Argument `{argument}` must name a frozen dataclass, but {shown(kind)} lacks @dataclass(frozen=True)."
        )
    if inspect.isabstract(cls):
        missing = ", ".join(sorted(getattr(cls, "__abstractmethods__", ())))
        raise ArgumentError(f"Argument `{argument}` must name a complete class, but {shown(kind)} does not define {missing}.")
    try:
        hints_of(cls)
    except Exception as error:  # whatever reading annotations can end in
        raise ArgumentError(
            f"Argument `{argument}` names {shown(kind)}, whose parameters cannot be read: {complaint(error)}."
        ) from None
    return cls
