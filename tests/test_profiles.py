"""Properties along x, in every form, and the spaces that integrate them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import dampen
from dampen import EulerBernoulliBeam, FlexibleArm, TimoshenkoBeam
from dampen.plants.base import Plant
from dampen.plants.spaces import Bending, FiniteDifference, Spectral
from dampen.scenarios.read import build, parse
from dampen.toml import literal, to_toml


def test_gram_matrices_of_a_constant_weight_are_the_plain_integrals() -> None:
    x = np.polynomial.Polynomial([0, 1])
    space = Bending(1.5, 9, pinned=True)
    powers = [x**2, x**3 - x, x**5]
    points = np.linspace(0, 1.5, 40)
    basis = space.values(points)
    coefficients = [np.linalg.lstsq(basis, p(points), rcond=None)[0] for p in powers]
    for a, b in ((0, 0), (1, 1), (2, 2), (1, 0)):
        gram = space.gram(a, b, lambda x: 2.0 + 0 * x)
        for c, p in zip(coefficients, powers, strict=True):
            for d, r in zip(coefficients, powers, strict=True):
                exact = 2 * (p.deriv(a) * r.deriv(b)).integ()(1.5)
                assert c @ gram @ d == pytest.approx(exact, rel=1e-10)
    np.testing.assert_allclose(space.gram(2, 2, lambda x: np.ones_like(x)), np.diag(np.r_[0, np.full(8, 8 / 1.5**3)]), atol=1e-11)


@pytest.mark.parametrize("space", [Spectral(1.2, 12), Bending(1.2, 12, False), Bending(1.2, 12, True)])
def test_basis_functions_and_their_derivatives_agree(space: Spectral | Bending) -> None:
    x, h = np.linspace(0.1, 1.1, 7), 1e-5
    for order in range(1 if isinstance(space, Spectral) else 2):
        difference = (space.values(x + h, order) - space.values(x - h, order)) / (2 * h)
        np.testing.assert_allclose(space.values(x, order + 1), difference, atol=1e-6)


def test_constant_profiles_of_every_form_are_the_same_beam() -> None:
    plain = TimoshenkoBeam().modes(20)
    for form in (35, (35.0,), [35.0, 0.0], lambda x: 35.0, "tests.test_profiles:constant_35"):
        modes = TimoshenkoBeam(bending_stiffness=form).modes(20)  # type: ignore[arg-type]
        np.testing.assert_allclose(modes.omega, plain.omega, rtol=1e-12)
        grid = TimoshenkoBeam(bending_stiffness=form).modes(20, 41)  # type: ignore[arg-type]
        np.testing.assert_allclose(grid.omega, TimoshenkoBeam().modes(20, 41).omega, rtol=1e-12)
    assert FiniteDifference(1.0, 5).gram(1, 0, np.ones_like)[-1, -1] == 0.5


def constant_35(x: np.ndarray) -> np.ndarray:
    return np.full(len(x), 35.0)


def test_profiles_compare_hash_and_are_written_out() -> None:
    one, other = TimoshenkoBeam(bending_stiffness=[35.0, -1]), TimoshenkoBeam(bending_stiffness=(35.0, -1))  # type: ignore[arg-type]
    assert one == other
    assert hash(one) == hash(other)
    assert TimoshenkoBeam(bending_stiffness=constant_35) == TimoshenkoBeam(bending_stiffness=constant_35)
    assert literal(constant_35) == '"tests.test_profiles:constant_35"'
    again = build(parse(to_toml(alone(TimoshenkoBeam(bending_stiffness=constant_35))), "x")).plant
    assert isinstance(again, TimoshenkoBeam)
    assert again == TimoshenkoBeam(bending_stiffness=constant_35)
    assert build(parse(to_toml(alone(again)), "x")).plant == again


def alone(plant: Plant) -> dampen.Scenario:
    return dampen.Scenario(plant, dampen.NoControl(), dampen.NoDisturbance())


def test_a_scenario_file_finds_its_functions_beside_it(tmp_path: Path) -> None:
    (tmp_path / "own_taper_of_a_test.py").write_text("def stiffness(x):\n    return 2 - x\n")
    table = {"plant": {"kind": "euler-bernoulli", "bending_stiffness": "own_taper_of_a_test:stiffness"}}
    plant = build(table, tmp_path).plant
    assert isinstance(plant, EulerBernoulliBeam)
    np.testing.assert_allclose(plant.modes(5).omega, EulerBernoulliBeam(bending_stiffness=(2.0, -1.0)).modes(5).omega, rtol=1e-12)


def broken(x: np.ndarray) -> np.ndarray:
    return x[:, 7]


WRONG = {
    "must be > 0 N m^2 everywhere, but is -1 at x = 1.": (1.0, -2.0),
    "must be > 0 N m^2, but is -1.": -1.0,
    "must be a number or coefficients of c0 + c1 x + ... or string or function in N m^2, but is None.": None,
    "must be a number, a list of coefficients, a function of x, or its name \"module:function\", but is 'stiff'.": "stiff",
    "names 'tests.test_profiles:missing', which cannot be loaded: AttributeError": "tests.test_profiles:missing",
    "must name a function of x, but is [1.0, 2.0].": "tests.test_profiles:PAIR",
    "is a function that fails on an array of x: IndexError": broken,
    "must be finite everywhere, but is not at x = 0.": lambda x: 1 / np.where(x > 0, x, np.inf) / np.where(x > 0, 1, 0),
}
PAIR = (1.0, 2.0)


@pytest.mark.filterwarnings("ignore::RuntimeWarning")
@pytest.mark.parametrize("words", WRONG)
def test_a_bad_profile_gets_one_clear_line(words: str) -> None:
    for kind in (TimoshenkoBeam, EulerBernoulliBeam, FlexibleArm):
        with pytest.raises(dampen.ArgumentError) as error:
            kind(bending_stiffness=WRONG[words])  # type: ignore[arg-type]
        assert len(error.value.lines) == 1
        assert error.value.lines[0].startswith(f"Argument `bending_stiffness` {words}")
