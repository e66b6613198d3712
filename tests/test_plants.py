"""Plants: frequencies against characteristic equations, limits of one theory in another, varying properties, whole runs."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import brentq

import dampen
from dampen import Deflection, EulerBernoulliBeam, FlexibleArm, String, TimoshenkoBeam
from dampen.modal import propagator
from dampen.plants.base import Damping, Plant
from dampen.plants.beams import Lump, SlenderBeam
from dampen.plants.spaces import Bending
from tests.references import bending_residual, roots, string_residual, timoshenko_residual

BODY = {"mass_per_length": 0.7, "length": 1.3, "tip_mass": 0.2, "tip_inertia": 0.01, "bending_stiffness": 2.5}
BASES = {
    "clamped": {},
    "pinned": {"base": "pinned"},
    "clamped under tension": {"tension": 100.0},
    "pinned under tension": {"base": "pinned", "tension": 30.0},
    "taut as a string": {"tension": 1e4},
}
TAPER = 0.4 / 1.3


def thick(x: np.ndarray) -> np.ndarray:
    """Thickness of a tapered beam, against its base."""
    return 1 - TAPER * x


def tapered_stiffness(x: np.ndarray) -> np.ndarray:
    return 2.5 * thick(x) ** 3


TAPERED = EulerBernoulliBeam(
    **{**BODY, "mass_per_length": (0.7, -0.7 * TAPER), "bending_stiffness": tapered_stiffness}, initial=Deflection(w=(0, 0, 0.05))
)
PLANTS: list[Plant] = [
    TimoshenkoBeam(initial=dampen.BeamState(w=(0, 0.16))),
    TAPERED,
    EulerBernoulliBeam(initial=Deflection(w=(0, 0, 0.1), w_rate=(0.1,))),
    EulerBernoulliBeam(base="pinned", initial=Deflection(w=(0, 0.1), w_rate=(0, 0.3))),
    FlexibleArm(initial=Deflection(w=(0, 0.1, 0.05), w_rate=(0, 0.2))),
    String(initial=Deflection(w=(0, 0.01), w_rate=(0.1,))),
]


@pytest.mark.parametrize("changed", BASES.values(), ids=BASES)
def test_euler_bernoulli_frequencies_equal_the_characteristic_equation(changed: dict[str, object]) -> None:
    beam = EulerBernoulliBeam(**{**BODY, **changed})  # type: ignore[arg-type]
    omega = beam.modes(40).omega
    elastic = omega[omega > 0]
    exact = roots(
        lambda o: bending_residual(o, lambda x: 0.7, lambda x: 2.5, 1.3, 0.2, 0.01, beam.tension, beam.base),
        10, 1.1 * elastic[10], 400,
    )  # fmt: skip
    np.testing.assert_allclose(elastic[:10], exact, rtol=1e-11)


def test_arm_frequencies_equal_the_characteristic_equation_with_the_hub_in_it() -> None:
    arm = FlexibleArm(**BODY, hub_inertia=0.03)  # type: ignore[arg-type]
    omega = arm.modes(40).omega
    exact = roots(
        lambda o: bending_residual(o, lambda x: 0.7, lambda x: 2.5, 1.3, 0.2, 0.01, base="pinned", hub=0.03),
        10, 1.1 * omega[11], 400,
    )  # fmt: skip
    assert omega[0] == 0.0
    np.testing.assert_allclose(omega[1:11], exact, rtol=1e-11)


def test_a_bare_cantilevers_hundred_frequencies_equal_the_closed_form() -> None:
    """cos(b) cosh(b) = -1: nothing of the four decades between first and last is lost."""
    beam = EulerBernoulliBeam(mass_per_length=1.0, bending_stiffness=1.0, tip_mass=0.0, tip_inertia=0.0)
    middles = (np.arange(1, 101) - 0.5) * np.pi
    exact = [brentq(lambda b: np.cos(b) + 2 * np.exp(-b) / (1 + np.exp(-2 * b)), m - 0.4, m + 0.4, xtol=1e-14) for m in middles]
    np.testing.assert_allclose(beam.modes(100).omega, np.array(exact) ** 2, rtol=1e-10)


def test_string_frequencies_equal_the_closed_form() -> None:
    """T k cos(kL) = M omega^2 sin(kL), one root in every half wave."""
    string = String(mass_per_length=0.02, length=1.4, tip_mass=0.03, tension=30.0)
    c = np.sqrt(30.0 / 0.02)
    ends = np.arange(11) * np.pi / 1.4
    exact = [
        c * brentq(lambda k: 30 * np.cos(1.4 * k) - 0.03 * c**2 * k * np.sin(1.4 * k), a + 1e-9, b, xtol=1e-15, rtol=1e-15)
        for a, b in pairwise(ends)
    ]
    np.testing.assert_allclose(string.modes(40).omega[:10], exact, rtol=1e-12)


def test_all_modes_asked_for_are_converged() -> None:
    for plant in PLANTS:
        few, many = plant.modes(60), plant.modes(120)
        np.testing.assert_allclose(few.omega, many.omega[:60], rtol=1e-10, err_msg=type(plant).__name__)


def test_tapered_beam_frequencies_equal_the_integrated_characteristic_equation() -> None:
    omega = TAPERED.modes(40).omega
    exact = roots(
        lambda o: bending_residual(o, lambda x: 0.7 * thick(x), tapered_stiffness, 1.3, 0.2, 0.01, varies=True),
        8, 1.02 * omega[7], 24,
    )  # fmt: skip
    np.testing.assert_allclose(omega[:8], exact, rtol=1e-10)


def tapered_timoshenko() -> TimoshenkoBeam:
    return TimoshenkoBeam(
        mass_per_length=(1.0, -0.3),
        rotary_inertia=(0.5, -0.2),
        bending_stiffness=(35.0, -10.0, -5.0),
        shear_stiffness=(15.0, -5.0),
    )


def test_tapered_timoshenko_frequencies_equal_the_integrated_characteristic_equation() -> None:
    beam = tapered_timoshenko()
    properties = [
        lambda x: 1 - 0.3 * x, lambda x: 35 - 10 * x - 5 * x * x, lambda x: 15 - 5 * x, lambda x: 0.5 - 0.2 * x,
    ]  # fmt: skip
    omega = beam.modes(40).omega
    exact = roots(lambda o: timoshenko_residual(o, *properties, 1.0, 0.1, 0.1), 8, 1.05 * omega[7], 60, 1.0)
    np.testing.assert_allclose(omega[:8], exact, rtol=1e-10)


def test_varying_string_frequencies_equal_the_integrated_characteristic_equation() -> None:
    string = String(mass_per_length=(0.02, 0.01), tip_mass=0.03, tension=lambda x: 30 + 5 * np.cos(3 * x))
    omega = string.modes(40).omega
    exact = roots(
        lambda o: string_residual(o, lambda x: 0.02 + 0.01 * x, lambda x: 30 + 5 * np.cos(3 * x), 1.0, 0.03),
        8, 1.05 * omega[7], 120, 1.0,
    )  # fmt: skip
    np.testing.assert_allclose(omega[:8], exact, rtol=1e-10)


def test_bending_converges_exponentially_in_the_degree() -> None:
    tip = Lump(1.3, 0.2, 0.01)
    beam = SlenderBeam(
        length=1.3, pinned=False, mass_per_length=TAPERED.mass_per_length, bending_stiffness=tapered_stiffness, tension=0.0,
        lumps=(tip,), ports=TAPERED.ports, damping=Damping(),
    )  # fmt: skip
    exact = TAPERED.modes(40).omega[:4]
    degrees = (8, 10, 12, 14)
    errors = [np.abs(beam.in_space(Bending(1.3, p, False)).modes(4).omega / exact - 1).max() for p in degrees]
    assert np.all(np.array(errors[1:]) < np.array(errors[:-1]) / 50), "two more degrees, a factor of 50 and more"
    assert errors[-1] < 1e-11


@pytest.mark.parametrize(
    "plant",
    [tapered_timoshenko(), String(mass_per_length=(0.02, 0.01), tension=lambda x: 30 + 5 * np.cos(3 * x))],
    ids=lambda p: type(p).__name__,
)
def test_finite_differences_of_varying_properties_converge_at_second_order(plant: Plant) -> None:
    exact = plant.modes(16).omega[:5]
    errors = [np.abs(plant.modes(5, n).omega / exact - 1) for n in (41, 81, 161)]
    np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / np.array(errors[1:])), 2, atol=0.1)


def slender(**changed: float) -> np.ndarray:
    beam = TimoshenkoBeam(bending_stiffness=2.0, tip_inertia=0.01, **changed)  # type: ignore[arg-type]
    return beam.modes(60).omega[:3]


@pytest.mark.parametrize("what", ["shear flexibility", "rotary inertia"])
def test_timoshenko_tends_to_euler_bernoulli_at_first_order(what: str) -> None:
    exact = EulerBernoulliBeam(mass_per_length=1.0, bending_stiffness=2.0, tip_inertia=0.01).modes(60).omega[:3]
    small = np.array([1.0, 0.5, 0.25])
    if what == "shear flexibility":
        errors = np.array([slender(rotary_inertia=1e-9, shear_stiffness=4e4 / s) for s in small]) / exact - 1
    else:
        errors = np.array([slender(rotary_inertia=1e-4 * s, shear_stiffness=1e8) for s in small]) / exact - 1
    np.testing.assert_allclose(np.log2(errors[:-1] / errors[1:]), 1, atol=0.02)
    assert np.all(errors < 0), "shear and rotary inertia both lower frequencies"


def test_static_compliance_equals_beam_theory() -> None:
    length, ei = 1.3, 2.5
    exact = np.array([[length**3 / 3, length**2 / 2], [length**2 / 2, length]]) / ei
    np.testing.assert_allclose(EulerBernoulliBeam(**BODY).modes(40).compliance, exact, rtol=1e-12)  # type: ignore[arg-type]
    wedge = EulerBernoulliBeam(bending_stiffness=(1.0, -0.5)).modes(40).compliance
    assert wedge is not None
    np.testing.assert_allclose(wedge[1, 1], 2 * np.log(2), rtol=1e-11)  # int dx / (1 - x/2)
    pulled = EulerBernoulliBeam(tension=50.0).modes(40).compliance
    k = np.sqrt(50.0 / 4.2)
    assert pulled is not None
    np.testing.assert_allclose(pulled[0, 0], (1 - np.tanh(k) / k) / 50.0, rtol=1e-10)
    np.testing.assert_allclose(String(length=0.7, tension=30.0).modes(9, 41).compliance, [[0.7 / 30]], rtol=1e-12)


@pytest.mark.parametrize("plant", PLANTS, ids=lambda p: type(p).__name__)
def test_ports_see_the_fields_where_they_are(plant: Plant) -> None:
    modes = plant.modes(30)
    for p, port in enumerate(modes.ports):
        np.testing.assert_allclose(modes.field(port.field).shapes(np.array([port.x]))[0], modes.b[p], rtol=1e-9, atol=1e-9)


def test_rigid_rotation_is_of_zero_frequency_and_right_inertia() -> None:
    arm = FlexibleArm(**BODY, hub_inertia=0.03)  # type: ignore[arg-type]
    total = 0.03 + 0.7 * 1.3**3 / 3 + 0.2 * 1.3**2 + 0.01
    pinned = EulerBernoulliBeam(**BODY, base="pinned")  # type: ignore[arg-type]
    for count in (1, 2, 40, 150):
        modes, alone = arm.modes(count), pinned.modes(count)
        assert modes.omega[0] == alone.omega[0] == 0.0
        assert np.all(modes.omega[1:] > 0)
        np.testing.assert_allclose(np.abs(modes.b[:, 0]), np.array([1, 1.3]) / np.sqrt(total), rtol=1e-11)
        np.testing.assert_allclose(np.abs(alone.b[:, 0]), np.array([1.3, 1]) / np.sqrt(total - 0.03), rtol=1e-11)
    assert modes.compliance is None
    assert modes.b[0, 0] * modes.b[1, 0] > 0


def test_a_rigid_start_is_the_rigid_mode_alone() -> None:
    arm = FlexibleArm(initial=Deflection(w=(0, 0.2), w_rate=(0, 0.5)))
    modes = arm.modes(40)
    q, rate = arm.initial_state(modes)
    np.testing.assert_allclose(q[1:], 0, atol=1e-11)
    np.testing.assert_allclose(modes.b @ q, [0.2, 0.2], rtol=1e-10)
    np.testing.assert_allclose(modes.b @ rate, [0.5, 0.5], rtol=1e-10)
    assert arm.initial_ports() == pytest.approx((0.2, 0.2))


def test_initial_shape_is_rebuilt_everywhere() -> None:
    beam = replace(PLANTS[2], initial=Deflection(w=(0, 0, 0.1, -0.02)))  # type: ignore[call-arg]
    modes, x = beam.modes(100), np.linspace(0, 1, 51)
    q, _ = beam.initial_state(modes)
    np.testing.assert_allclose(modes.field("w").shapes(x) @ q, 0.1 * x**2 - 0.02 * x**3, atol=1e-6)
    np.testing.assert_allclose(modes.b @ q, beam.initial_ports(), atol=1e-4)


def test_shaking_the_base_moves_the_whole_mass() -> None:
    """sum_i translation_i^2 tends to the mass that moves: all of it, as modes go on."""
    for plant, mass in ((EulerBernoulliBeam(), 0.57), (String(), 0.0162), (FlexibleArm(), 0.57)):
        translation = plant.modes(200).translation
        assert translation is not None
        assert np.sum(translation**2) == pytest.approx(mass, rel=0.01)


@pytest.mark.parametrize("plant", PLANTS, ids=lambda p: type(p).__name__)
def test_decay_rates_are_what_the_damping_says(plant: Plant) -> None:
    omega = plant.modes(12).omega
    for damping, decay in (
        (Damping(ratio=0.02), 0.02 * omega),
        (Damping(ratio=(0.01, 0.03)), np.array([0.01] + [0.03] * 11) * omega),
        (Damping(kelvin_voigt=1e-4), 1e-4 * omega**2 / 2),
        (Damping(viscous=0.4), np.full(12, 0.2)),
    ):
        np.testing.assert_allclose(replace(plant, damping=damping).modes(12).decay, decay, rtol=1e-14)  # type: ignore[call-arg]


def test_ports_of_a_light_beam_are_strongly_coupled() -> None:
    beam = EulerBernoulliBeam(tip_mass=0.01, tip_inertia=1e-5)
    modes = beam.modes(40)
    for share in (0.2, 0.3, 0.4):  # of the lowest mode's period
        g = (modes.b * propagator(modes, share * 2 * np.pi / modes.omega[0]).psi) @ modes.b.T
        assert abs(g[0, 1]) / np.sqrt(g[0, 0] * g[1, 1]) >= 0.8


def test_other_bad_parameters_get_one_clear_line() -> None:
    for make, words in (
        (lambda: EulerBernoulliBeam(base="free"), "Argument `base` must be 'clamped' or 'pinned', but is 'free'."),
        (lambda: EulerBernoulliBeam(tension=-1.0), "Argument `tension` must be >= 0 N, but is -1.0."),
        (lambda: String(tension=(0.0, 1.0)), "Argument `tension` must be > 0 N everywhere, but is 0 at x = 0."),
        (lambda: EulerBernoulliBeam(initial=Deflection(w=(0, 0.1))), "Argument `initial.w` must start with 0, 0, since"),
        (lambda: Deflection(w=(0.1,)), "Argument `w` must start with 0"),
    ):
        with pytest.raises(dampen.ArgumentError) as error:
            make()
        assert error.value.lines[0].startswith(words)
        assert len(error.value.lines) == 1
