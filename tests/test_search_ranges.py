"""Where a search for gains is told to look: at the structure's own scales, whatever the units, actuators and limits."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import dampen
from dampen.component import parameters
from dampen.controllers.scales import elastic, first_period, mean_mobility, scales
from dampen.modal import ModalModel
from dampen.port import Port
from dampen.scenarios.read import read_scenario
from dampen.simulation.setting import setting_of
from tests.other_units import Units, at_port, in_units

STRING = dampen.String(length=3.0, mass_per_length=0.7, tension=50.0, tip_mass=0.0)
SHORT = ("task.trials=2", "task.trial_duration=0.5", "numerics.modes=12", "numerics.step=0.002", "output.every=50")
UNITS = Units(length=2.0**3, mass=2.0**-5, time=2.0**4)


def string(law: dampen.Controller, *sets: str, **changes: Any) -> dampen.Scenario:
    """A string that is fixed at one end, with a force at the other and nothing that shakes it."""
    case = read_scenario("string-tip-mass", [*SHORT, *sets])
    return replace(case, plant=STRING, disturbance=dampen.NoDisturbance(), controller=law, **changes)


def ranges(case: dampen.Scenario) -> dict[str, tuple[float, float]]:
    found = case.controller.search(setting_of(case))
    return {path: tuple(float(end) for end in text.split(":")[:2]) for path, text in found.items()}  # type: ignore[misc]


def structure(omega: list[float], b: list[list[float]], **changes: Any) -> dampen.Setting:
    """The setting of a structure that is given by its modes, with forces at its ports."""
    model = ModalModel(omega=np.array(omega), b=np.array(b))
    ports = tuple(Port(f"p{i}", "w", 1.0) for i in range(len(b)))
    free = np.full((11, len(b)), np.inf)
    known: dict[str, Any] = {
        "ports": ports, "steps": 10, "dt": 0.1, "length": 1.0, "bounds": {},
        "reference": np.zeros((11, len(b))), "low": -free, "high": free, "gains": np.ones(len(b)), "model": lambda: model,
    }  # fmt: skip
    return dampen.Setting(**{**known, **changes})


LAWS = {
    "boundary-damping": (string(dampen.BoundaryDamping()), {"damping", "stiffness"}),
    "p-type": (string(dampen.PTypeILC()), {"learning", "lead", "forgetting", "cutoff", "damping", "stiffness"}),
    "norm-optimal": (string(dampen.NormOptimalILC(error_weight={"tip_w": 40.0})), {"change_weight", "damping", "stiffness"}),
    "lqg": (
        string(dampen.LQG(energy_weight=3.0, force_noise=0.2), "numerics.mode=sampled", "sampling.period=0.002"),
        {"error_weight", "modes", "effort_weight", "sensor_noise"},
    ),
    "dual-loop": (read_scenario("he2017", SHORT), {f"alpha_{i}" for i in range(1, 10)}),
    "pd-type": (
        read_scenario("he2017", ["controller.kind=pd-type-ilc", *SHORT]),
        {"learning", "lead", "forgetting", "cutoff", "damping", "stiffness", "rate_learning"},
    ),
}


@pytest.mark.parametrize("name", LAWS)
def test_in_other_units_the_ranges_are_the_same_ones_in_these_units(name: str) -> None:
    """But for the three digits to which they are told."""
    case, names = LAWS[name]
    ports = {port.name: port for port in case.plant.ports}
    units = {p.name: p.unit for p in parameters(type(case.controller))}
    its, there = ranges(case), ranges(in_units(case, UNITS))
    assert {path.partition(".")[0] for path in its} == names
    for path, ends in its.items():
        parameter, _, port = path.partition(".")
        factor = UNITS.factor(at_port(units[parameter], ports.get(port)))
        assert there[path] == pytest.approx([factor * end for end in ends], rel=0.012), path


def test_an_actuator_of_half_the_slope_needs_twice_the_gain() -> None:
    (whole,) = scales(setting_of(string(dampen.NoControl(), actuators={})))
    (half,) = scales(setting_of(string(dampen.NoControl(), actuators={"tip_w": (dampen.Backlash(0.5, 0.0, -1e-9),)})))
    assert half.impedance == pytest.approx(2 * whole.impedance, rel=1e-12)
    assert half.stiffness == pytest.approx(2 * whole.stiffness, rel=1e-12)
    assert half.room == whole.room


def test_room_is_the_least_distance_from_the_reference_to_either_limit() -> None:
    limits = {"tip_w": dampen.Constraint(high=dampen.Decay(0.3, 0.2, 0.1), low=-0.16)}
    for target, room in ((0.0, 0.16), (-0.1, 0.06), (0.15, 0.05)):
        task = dampen.Task(
            trials=1, trial_duration=3.0, constraint=limits, reference={"tip_w": dampen.MinimumJerk(target=target, duration=2.0)}
        )
        (found,) = scales(setting_of(string(dampen.NoControl(), task=task)))
        assert found.room == pytest.approx(room, rel=1e-9)
    (free,) = scales(setting_of(string(dampen.NoControl(), task=dampen.Task(trials=1, trial_duration=3.0))))
    assert free.room == np.inf


def test_what_turns_freely_is_no_spring() -> None:
    """Two springs in a row give way by the sum of both; a mode that is rigid but for rounding gives way to no end."""
    setting = structure([1e-8, 2.0, 5.0], [[3.0, 1.0, 2.0], [3.0, 0.0, 0.0]])
    np.testing.assert_array_equal(elastic(setting)[0], [2.0, 5.0])
    (only,) = scales(setting)
    assert only.port.name == "p0"
    assert only.stiffness == pytest.approx(1 / (1 / 4 + 4 / 25))
    assert first_period(replace(setting, dt=1.0)) == pytest.approx(np.pi)
    assert first_period(setting) == 1.0
    assert first_period(structure([0.0, 0.0], [[1.0, 1.0]])) == 1.0
    assert scales(structure([0.0], [[1.0]])) == ()


def test_the_mean_mobility_of_evenly_spaced_modes_is_the_mean_of_each_in_its_own_band() -> None:
    """pi/2 b^2 / spacing, each mode in the middle of its band, in the mean of six; what is beyond the sixth does not count."""
    for count in (7, 20):
        omega, b = 4.0 * (np.arange(count) + 0.5), np.full((1, count), 100.0)
        b[0, :6] = np.sqrt([1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
        assert mean_mobility(omega, b) == pytest.approx(np.pi / 2 * 3.5 / 4.0, rel=1e-12)
    assert mean_mobility(np.array([2.0]), np.array([[1.5]])) == pytest.approx(np.pi / 2 * 1.5**2 / 3.0, rel=1e-12)


def test_a_learning_law_on_a_string_looks_where_closed_forms_say() -> None:
    """Impedance sqrt(T mu), stiffness T / L, first period 4 L / c; lead at most a quarter of it or of the trial."""
    impedance, stiffness, quarter = np.sqrt(50.0 * 0.7), 50.0 / 3.0, 3.0 / np.sqrt(50.0 / 0.7)
    found = ranges(string(dampen.PDTypeILC(), "task.trial_duration=2.0"))
    expected = {
        "learning.tip_w": (1e-3 * stiffness, 10 * stiffness),
        "rate_learning.tip_w": (1e-3 * impedance, 10 * impedance),
        "damping.tip_w": (1e-3 * impedance, 100 * impedance),
        "stiffness.tip_w": (1e-3 * stiffness, 10 * stiffness),
        "lead": (0, quarter),
        "forgetting": (0, 0.5),
        "cutoff": (2 / 2.0, 0.45 / 0.002),
    }
    assert set(found) == set(expected)
    for path, ends in expected.items():
        near = 0.06 if "stiffness" in path or path.startswith("learning") else 0.006  # of 12 modes, of three digits
        assert found[path] == pytest.approx(ends, rel=near), path


def test_only_gains_that_act_are_looked_for() -> None:
    both = read_scenario("he2017", SHORT)
    law = both.controller
    force, torque = {"alpha_4", "alpha_3", "alpha_2", "alpha_8", "alpha_1"}, {"alpha_7", "alpha_6", "alpha_5", "alpha_9"}

    def names(**changes: Any) -> set[str]:
        return set(ranges(replace(both, **changes)))

    def told(**bounds: float) -> Mapping[str, float]:
        return {**both.bounds, **bounds}

    assert names() == force | torque
    assert names(bounds=told(f=0.0)) == (force | torque) - {"alpha_1"}
    assert names(bounds=told(tip_w=0.0)) == (force | torque) - {"alpha_2"}
    assert names(bounds=told(tip_phi=0.0)) == (force | torque) - {"alpha_5"}
    assert names(controller=replace(law, barrier="none")) == (force | torque) - {"alpha_3", "alpha_6"}
    assert names(actuators={"tip_phi": (dampen.Absent(),)}) == force
    assert names(actuators={"tip_w": (dampen.Absent(),)}) == torque


def test_only_other_ports_errors_are_weighed_against_the_first_port_s() -> None:
    case = read_scenario("he2017", ["controller.kind=norm-optimal-ilc", *SHORT])
    found, (first, second) = ranges(case), scales(setting_of(case))
    assert [path for path in found if path.startswith("error_weight")] == ["error_weight.tip_phi"]
    softest = 1 / min(first.stiffness, second.stiffness)
    assert found["change_weight"] == pytest.approx((1e-6 * softest**2, 10 * softest**2), rel=0.006)
    assert found["error_weight.tip_phi"] == (0.01, 100)
    weighty = ranges(replace(case, controller=replace(case.controller, error_weight={"tip_w": 50.0, "tip_phi": 7.0})))
    for path in ("change_weight", "error_weight.tip_phi"):
        assert weighty[path] == pytest.approx([50 * end for end in found[path]], rel=0.006)
