"""Modes of changed plants on a fixed basis: against modes solved anew, back to the nominal ones, and where it will not do."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

import dampen
from dampen import Assembled, Damping, Deflection, EulerBernoulliBeam, FlexibleArm, Modes, String, TimoshenkoBeam
from dampen.plants.base import Plant
from dampen.plants.fixed_basis import FixedBasis
from tests.test_assembled import PORTS, cantilever, hermite, shapes

RIGID = np.tile([1.0, 0.0], 30)
TIMOSHENKO = TimoshenkoBeam(initial=dampen.BeamState(w=(0, 0.16), phi=(0, 0.18), w_rate=(0, 0.1)), damping=Damping(ratio=0.01))
SLENDER = EulerBernoulliBeam(initial=Deflection(w=(0, 0, 0.1)))
ARM = FlexibleArm(initial=Deflection(w=(0, 0.1, 0.05), w_rate=(0, 0.2)))
WIRE = String(initial=Deflection(w=(0, 0.01), w_rate=(0, 0.1)))
ELEMENTS = cantilever(30, shape=shapes(30), translation=RIGID)
NOMINAL: dict[str, tuple[Plant, int | None]] = {
    "timoshenko": (TIMOSHENKO, None),
    "timoshenko on a grid": (TIMOSHENKO, 101),
    "euler-bernoulli": (SLENDER, None),
    "euler-bernoulli under tension": (replace(SLENDER, tension=50.0), None),
    "tapered": (replace(SLENDER, bending_stiffness=(4.2, -1.0), mass_per_length=(0.47, -0.1)), None),
    "pinned": (EulerBernoulliBeam(base="pinned", initial=Deflection(w=(0, 0.1))), None),
    "flexible arm": (ARM, None),
    "string": (WIRE, None),
    "string on a grid": (WIRE, 101),
    "assembled": (ELEMENTS, None),
}
SPREAD = {
    "tip_mass": 0.3, "tip_inertia": 0.3, "hub_inertia": 0.3, "bending_stiffness": 0.2, "shear_stiffness": 0.2, "tension": 0.2,
}  # fmt: skip


def changed(plant: Plant) -> list[Plant]:
    """Corners and insides of the box of uncertain constants; of matrices the damping and a payload."""
    if isinstance(plant, Assembled):
        payload = np.zeros((60, 60))
        payload[-2, -2] = 0.03
        return [replace(plant, damping=Damping(ratio=0.02)), replace(plant, mass=np.array(plant.mass) + payload)]  # type: ignore[arg-type]
    random = np.random.default_rng(7)
    names = [name for name in SPREAD if hasattr(plant, name)]
    corners = [dict.fromkeys(names, 1.0), {name: (-1.0) ** i for i, name in enumerate(names)}]
    inside = [{name: random.uniform(-1, 1) for name in names} for _ in range(2)]
    return [replace(plant, **{n: scaled(getattr(plant, n), 1 + s[n] * SPREAD[n]) for n in names}) for s in corners + inside]


def scaled(value: Any, factor: float) -> Any:
    return tuple(factor * v for v in value) if isinstance(value, tuple) else factor * value


def basis(plant: Plant, count: int, grid: int | None = None) -> FixedBasis:
    made = FixedBasis.of(plant, count, grid)
    assert made is not None
    return made


def on(made: FixedBasis, plant: Plant, count: int) -> tuple[Modes, np.ndarray]:
    found = made.reprojected(plant, count)
    assert found is not None
    return found


def assert_same_modes(found: Modes, anew: Modes, tolerance: float, shapes: float) -> None:
    """Frequencies within a relative tolerance, rigid ones exactly 0, and ports, whatever the signs of the modes."""
    np.testing.assert_array_equal(found.omega == 0, anew.omega == 0)
    np.testing.assert_allclose(found.omega, anew.omega, rtol=tolerance)
    np.testing.assert_allclose(np.abs(found.b), np.abs(anew.b), atol=shapes * np.abs(anew.b).max(axis=1).max())
    np.testing.assert_allclose(found.decay, anew.decay, rtol=3 * tolerance)


@pytest.mark.parametrize("count", [4, 16, 40])
@pytest.mark.parametrize(("plant", "grid"), NOMINAL.values(), ids=NOMINAL)
def test_modes_of_changed_plants_are_those_solved_anew(plant: Plant, grid: int | None, count: int) -> None:
    made = basis(plant, count, grid)
    for other in changed(plant):
        found, _ = on(made, other, count)
        anew = other.modes(count, grid)
        assert_same_modes(found, anew, 1e-5, 3e-3)
        lowest = slice(0, count // 4)
        np.testing.assert_allclose(found.omega[lowest], anew.omega[lowest], rtol=3e-6 if count < 40 else 5e-8)


def test_all_64_modes_of_the_papers_beam_are_within_1e_5_and_the_lowest_16_within_2e_8() -> None:
    made = basis(TIMOSHENKO, 64)
    for other in changed(TIMOSHENKO):
        found, anew = on(made, other, 64)[0], other.modes(64)
        assert_same_modes(found, anew, 1e-5, 1e-3)
        np.testing.assert_allclose(found.omega[:16], anew.omega[:16], rtol=2e-8)


def test_frequencies_on_a_basis_are_never_too_low() -> None:
    made = basis(SLENDER, 20)
    for other in changed(SLENDER):
        assert np.all(on(made, other, 20)[0].omega / other.modes(20).omega > 1 - 1e-12)


@pytest.mark.parametrize(("plant", "grid"), NOMINAL.values(), ids=NOMINAL)
def test_the_nominal_plant_comes_back(plant: Plant, grid: int | None) -> None:
    """To round-off, which from mass and stiffness themselves grows with the square of the frequency ratio."""
    found, anew = on(basis(plant, 20, grid), plant, 20)[0], plant.modes(20, grid)
    elastic = anew.omega[anew.omega > 0]
    squared = isinstance(plant, Assembled | TimoshenkoBeam | String)
    assert_same_modes(found, anew, 1e-12 + 1e-15 * squared * (elastic[-1] / elastic[0]) ** 2, 1e-9)
    for name, value in (("compliance", anew.compliance), ("translation", anew.translation)):
        if value is not None:
            np.testing.assert_allclose(np.abs(getattr(found, name)), np.abs(value), rtol=1e-9, atol=1e-9 * np.abs(value).max())


def test_all_64_modes_of_the_papers_beam_come_back() -> None:
    np.testing.assert_allclose(on(basis(TIMOSHENKO, 64), TIMOSHENKO, 64)[0].omega, TIMOSHENKO.modes(64).omega, rtol=1e-12)


@pytest.mark.parametrize(("plant", "grid"), NOMINAL.values(), ids=NOMINAL)
def test_shapes_and_loads_are_those_of_the_carrier_combined(plant: Plant, grid: int | None) -> None:
    made, x = basis(plant, 12, grid), np.linspace(0, plant.span, 50)
    for other in (plant, changed(plant)[0]):
        found, combine = on(made, other, 12)
        assert combine.shape == (made.carrier.count, 12)
        for field, carried in zip(found.fields, made.carrier.fields, strict=True):
            same = {"rtol": 0, "atol": 1e-12 * np.abs(field.shapes(x)).max()}
            np.testing.assert_allclose(field.shapes(x), carried.shapes(x) @ combine, **same)
            (points, matrix), (own_points, own) = (m.load_rule(field.name, 0.5) for m in (made.carrier, found))
            np.testing.assert_allclose(np.sin(9 * points) @ matrix @ combine, np.sin(9 * own_points) @ own, atol=1e-10)
        np.testing.assert_allclose(np.abs(made.carrier.b @ combine), np.abs(found.b), atol=1e-11 * np.abs(found.b).max())


@pytest.mark.parametrize(("plant", "grid"), [c for n, c in NOMINAL.items() if n != "assembled"])
def test_a_changed_plant_starts_with_the_energy_that_it_has(plant: Plant, grid: int | None) -> None:
    made = basis(plant, 40, grid)
    for other in changed(plant):
        energies = []
        for modes in (on(made, other, 40)[0], other.modes(40, grid)):
            q, rate = other.initial_state(modes)
            energies.append([np.sum((modes.omega * q) ** 2) / 2, np.sum(rate**2) / 2])
        np.testing.assert_allclose(energies[0], energies[1], rtol=1e-5, atol=1e-15)
        np.testing.assert_allclose(
            np.abs(on(made, other, 40)[0].translation), np.abs(other.modes(40, grid).translation), atol=1e-3
        )


def test_the_rigid_mode_of_an_arm_stays_exactly_rigid() -> None:
    made = basis(ARM, 40)
    for other in (ARM, *changed(ARM)):
        found, anew = on(made, other, 40)[0], other.modes(40)
        assert found.omega[0] == 0.0 < found.omega[1]
        assert found.compliance is None
        np.testing.assert_allclose(np.abs(found.b[:, 0]), np.abs(anew.b[:, 0]), rtol=1e-12)


def test_both_rigid_modes_of_free_elements_stay_exactly_rigid() -> None:
    mass, stiffness = hermite(20, held=0)
    free = Assembled(mass=mass, stiffness=stiffness, port_vectors=np.eye(42)[-2:], port=PORTS)  # type: ignore[arg-type]
    made, other = basis(free, 12), replace(free, stiffness=1.2 * stiffness)  # type: ignore[arg-type]
    found = on(made, other, 12)[0]
    np.testing.assert_array_equal(found.omega[:2], 0.0)
    np.testing.assert_allclose(found.omega[2:], other.modes(12).omega[2:], rtol=1e-8)


def test_the_basis_is_orthonormal_and_holds_the_static_deflections() -> None:
    nominal = TIMOSHENKO.discretise(16)
    assert nominal is not None
    columns = nominal.ritz_basis(16)
    assert columns.shape == (nominal.size, 16 + 8 + 2)
    np.testing.assert_allclose(columns.T @ nominal.energies.mass @ columns, np.eye(26), atol=1e-11)
    np.testing.assert_allclose(nominal.on(columns).modes(4).compliance, nominal.modes(4).compliance, rtol=1e-12)


def test_a_basis_of_all_there_is_has_no_more_columns_than_that() -> None:
    small = cantilever(3)
    made = basis(small, 5)
    assert made.columns.shape == (6, 6)
    heavier = replace(small, mass=1.5 * np.array(small.mass))  # type: ignore[arg-type]
    np.testing.assert_allclose(on(made, heavier, 5)[0].omega, heavier.modes(5).omega, rtol=1e-10)


def test_modes_are_told_in_their_shape_functions() -> None:
    nominal = SLENDER.discretise(10)
    assert nominal is not None
    vectors = SLENDER.modes(10).vectors
    assert vectors is not None
    np.testing.assert_allclose(vectors.T @ nominal.energies.mass @ vectors, np.eye(10), atol=1e-11)
    np.testing.assert_allclose(nominal.port_vectors @ vectors, SLENDER.modes(10).b, rtol=1e-14)


MISFITS: dict[str, tuple[Plant, Plant, int]] = {
    "another length": (TIMOSHENKO, replace(TIMOSHENKO, length=1.1), 8),
    "another length of a slender beam": (SLENDER, replace(SLENDER, length=1.1), 8),
    "another base": (SLENDER, EulerBernoulliBeam(base="pinned"), 8),
    "another class": (WIRE, TIMOSHENKO, 8),
    "another class, with the same functions": (EulerBernoulliBeam(base="pinned"), ARM, 8),
    "other matrices' size": (cantilever(8), cantilever(9), 8),
    "other shapes": (cantilever(8), cantilever(8, shape=shapes(8)), 8),
    "more modes than it was made for": (SLENDER, SLENDER, 9),
    "no rigid mode any more": (EulerBernoulliBeam(base="pinned"), EulerBernoulliBeam(base="pinned", tension=5.0), 8),
    "a rigid mode that has come": (EulerBernoulliBeam(base="pinned", tension=5.0), EulerBernoulliBeam(base="pinned"), 8),
}


@pytest.mark.parametrize(("plant", "other", "count"), MISFITS.values(), ids=MISFITS)
def test_where_a_basis_will_not_do_there_is_none(plant: Plant, other: Plant, count: int) -> None:
    assert basis(plant, 8).reprojected(other, count) is None


def test_another_grid_is_another_space() -> None:
    for first, second in ((51, 101), (51, None), (None, 51)):
        assert TIMOSHENKO.discretise(8, first, like=TIMOSHENKO.discretise(8, second)) is None
    fewer, more = TIMOSHENKO.discretise(8), TIMOSHENKO.discretise(40)
    assert fewer is not None
    assert more is not None
    like = TIMOSHENKO.discretise(40, like=fewer)
    assert like is not None
    assert like.space == fewer.space != more.space
    assert TIMOSHENKO.discretise(8, like=fewer.on(fewer.ritz_basis(8))) is None


@dataclass(frozen=True)
class Mass(Plant):
    """A plant of the user's own, that tells its modes alone."""

    @property
    def ports(self) -> tuple[dampen.Port, ...]:
        return (dampen.Port("p", "", 1.0),)

    def modes(self, count: int, grid: int | None = None) -> Modes:
        return Modes(omega=np.array([9.0]), b=np.array([[1.0]]), ports=self.ports)


@dataclass(frozen=True)
class Detuned(String):
    """A shipped plant whose modes the user has changed, but not how they are found."""

    def modes(self, count: int, grid: int | None = None) -> Modes:
        modes = super().modes(count, grid)
        return replace(modes, omega=1.1 * modes.omega)


@dataclass(frozen=True)
class Loaded(String):
    """A shipped plant with another mass at its tip, put in where energies are made."""

    def in_space(self, space: Any) -> Any:
        return String.in_space(replace(self, tip_mass=2 * self.tip_mass), space)


def test_a_plant_that_tells_only_its_modes_has_no_basis() -> None:
    assert Mass().discretise(1) is None
    assert FixedBasis.of(Mass(), 1) is None
    assert FixedBasis.of(Detuned(), 4) is None
    assert basis(String(), 4).reprojected(Detuned(), 4) is None


def test_a_plant_that_changes_its_energies_has_the_modes_and_the_basis_of_those() -> None:
    found = on(basis(Loaded(), 4), Loaded(), 4)[0]
    np.testing.assert_allclose(found.omega, String(tip_mass=0.02).modes(4).omega, rtol=1e-12)
    np.testing.assert_allclose(Loaded().modes(4).omega, found.omega, rtol=1e-12)
