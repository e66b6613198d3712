"""The same experiment in other units of length, mass and time is the same experiment: nothing has a size of its own inside."""

from __future__ import annotations

import numpy as np
import pytest

import dampen
from dampen.scenarios.read import read_scenario
from dampen.simulation.scenario import Scenario
from tests.other_units import Units, difference, in_units

UNITS = {
    "length": Units(length=2.0),
    "mass": Units(mass=2.0**-3),
    "time": Units(time=2.0**4),
    "micrometres": Units(2.0**-17, 2.0**-40, 2.0**-12),
    "kilometres": Units(2.0**10, 2.0**21, 2.0**5),
    "picograms": Units(2.0**20, 2.0**50, 2.0**19),
}
FEW = ["task.trials=2", "task.trial_duration=0.5"]
PLANTS = {
    "timoshenko": ("he2017", FEW),
    "differences": ("he2017", [*FEW, "numerics.discretisation=finite-difference", "numerics.modes=12"]),
    "euler-bernoulli": ("euler-bernoulli-payload", FEW),
    "string": ("string-tip-mass", ["task.trials=2"]),
    "arm": ("flexible-arm-point-to-point", ["task.trials=2", "task.reference={}"]),
}
LOOPS = {
    "paper": ("he2017", FEW),
    "direct": ("he2017", [*FEW, "controller.compensate=false"]),
    "tuned": ("he2017-tuned", FEW),
    "sampled": ("he2017-sampled", FEW),
    "explicit": ("he2017-sampled", [*FEW, "sampling.switching=explicit"]),
    "layer": ("he2017-sampled", [*FEW, "sampling.switching=boundary-layer", "sampling.layer={tip_w=0.02,tip_phi=0.01}"]),
    "observer": ("he2017-sampled", [*FEW, "sampling.rate=observer"]),
    "hysteresis": ("he2017-hysteresis", FEW),
    "adaptive": ("euler-bernoulli-payload", FEW),
    "damping": ("string-tip-mass", ["task.trials=2"]),
    "lqg": (
        "string-tip-mass",
        ["task.trials=2", "numerics.mode=sampled", "sampling.period=0.004", "controller={kind='lqg',error_weight={tip_w=100.0}}"],
    ),
    "norm-optimal": ("string-tip-mass", ["task.trials=2", "controller={kind='norm-optimal-ilc',error_weight={tip_w=100.0}}"]),
    "p-type": (
        "he2017",
        [*FEW, "controller={kind='p-type-ilc',learning={tip_w=0.5,tip_phi=0.3},damping={tip_w=2.0,tip_phi=2.0}}"],
    ),
}


def scenario(case: tuple[str, list[str]], controlled: bool = True) -> Scenario:
    name, changes = case
    return read_scenario(name, changes if controlled else [*changes, "controller={kind='none'}"])


@pytest.mark.parametrize("units", UNITS)
@pytest.mark.parametrize("plant", PLANTS)
def test_without_control_every_number_scales(plant: str, units: str) -> None:
    its = scenario(PLANTS[plant], controlled=False)
    there = in_units(its, UNITS[units])
    assert difference(dampen.simulate(its), dampen.simulate(there), UNITS[units]) < 1e-12


@pytest.mark.parametrize("units", UNITS)
@pytest.mark.parametrize("loop", LOOPS)
def test_in_closed_loop_every_number_scales(loop: str, units: str) -> None:
    its = scenario(LOOPS[loop])
    there = in_units(its, UNITS[units])
    one, other = dampen.simulate(its), dampen.simulate(there)
    assert difference(one, other, UNITS[units]) < 1e-6
    assert one.status == other.status
    assert np.abs(np.asarray(one["y"])).max() > 0


def test_other_units_are_other_numbers() -> None:
    its = scenario(LOOPS["paper"])
    for units in UNITS.values():
        there = in_units(its, units)
        assert there != its
        assert there.numerics.step == its.numerics.step * units.time
        assert there.plant.length == units.length
        assert there.controller.alpha_3 == 0.1 * units.length**2 * units.mass / units.time**2
        assert there.actuators["tip_phi"][0].right == 0.1 * units.length**2 * units.mass / units.time**2
