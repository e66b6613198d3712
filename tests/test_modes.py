"""Modes: exact frequencies, declared convergence, static compliance, projections."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.optimize import brentq

from dampen import BeamState, TimoshenkoBeam
from dampen.plants.base import polynomial

PRINTED_HZ = [0.79092126, 1.09672275, 2.65599426, 3.00363604, 4.46215364, 4.99211699, 6.29663937, 6.99457971]


def tip_residual(beam: TimoshenkoBeam, omega: float) -> float:
    """The characteristic function: determinant of the tip's two residuals, integrated from the clamp (no modes, no basis)."""
    k, ei, rho, i_rho = beam.shear_stiffness, beam.bending_stiffness, beam.mass_per_length, beam.rotary_inertia
    a = np.array([[0, 1, 1 / k, 0], [0, 0, 0, 1 / ei], [-rho * omega**2, 0, 0, 0], [0, -i_rho * omega**2, -1, 0]])
    w, phi, q, m = expm(a * beam.length)[:, 2:]
    return float(np.linalg.det([q - beam.tip_mass * omega**2 * w, m - beam.tip_inertia * omega**2 * phi]))


def exact_frequencies(beam: TimoshenkoBeam, count: int) -> np.ndarray:
    grid = np.linspace(0.1, 400, 40_000)
    values = [tip_residual(beam, o) for o in grid]
    roots = []
    for a, b, fa, fb in zip(grid[:-1], grid[1:], values[:-1], values[1:], strict=True):
        if fa * fb < 0:
            roots.append(brentq(lambda o: tip_residual(beam, o), a, b, xtol=1e-13, rtol=1e-14))
        if len(roots) == count:
            break
    return np.array(roots)


def test_spectral_frequencies_equal_the_characteristic_equation() -> None:
    beam = TimoshenkoBeam()
    np.testing.assert_allclose(beam.modes(64).omega[:8] / (2 * np.pi), PRINTED_HZ, rtol=1e-8)
    np.testing.assert_allclose(beam.modes(64).omega[:24], exact_frequencies(beam, 24), rtol=1e-11)


def test_spectral_frequencies_hold_for_another_beam() -> None:
    beam = TimoshenkoBeam(
        mass_per_length=0.7, length=1.6, tip_mass=0.4, tip_inertia=0.02, rotary_inertia=0.3, shear_stiffness=60.0
    )
    np.testing.assert_allclose(beam.modes(40).omega[:10], exact_frequencies(beam, 10), rtol=1e-10)


def test_all_modes_asked_for_are_converged() -> None:
    few, many = TimoshenkoBeam().modes(80), TimoshenkoBeam().modes(160)
    np.testing.assert_allclose(few.omega, many.omega[:80], rtol=1e-10)


def test_finite_difference_frequencies_converge_at_second_order() -> None:
    exact = TimoshenkoBeam().modes(16).omega[:6]
    errors = [np.abs(TimoshenkoBeam().modes(6, n).omega / exact - 1) for n in (41, 81, 161)]
    rates = np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
    np.testing.assert_allclose(rates, 2, atol=0.1)


@pytest.mark.parametrize(("grid", "tolerance"), [(None, 1e-9), (51, None)])
def test_static_compliance_equals_beam_theory(grid: int | None, tolerance: float | None) -> None:
    beam = TimoshenkoBeam(length=1.3)
    length, ei, k = beam.length, beam.bending_stiffness, beam.shear_stiffness
    exact = np.array([[length**3 / (3 * ei) + length / k, length**2 / (2 * ei)], [length**2 / (2 * ei), length / ei]])
    if tolerance:
        np.testing.assert_allclose(beam.modes(64, grid).compliance, exact, rtol=tolerance)
    else:
        errors = [np.abs(beam.modes(4, n).compliance - exact)[0, 0] for n in (41, 81)]
        assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.1)


def test_modal_sum_of_compliances_tends_to_the_static_one() -> None:
    residual = [np.abs(np.diag(TimoshenkoBeam().modes(n).residual_compliance)) for n in (32, 64, 128)]
    assert np.all(residual[1] < residual[0] / 4)
    assert np.all(residual[2] < residual[1] / 4)


@pytest.mark.parametrize("grid", [None, 51])
def test_ports_see_the_fields_at_the_tip(grid: int | None) -> None:
    modes = TimoshenkoBeam(length=0.8).modes(30, grid)
    for p, port in enumerate(modes.ports):
        np.testing.assert_allclose(modes.field(port.field).shapes(np.array([0.8]))[0], modes.b[p], rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize(("grid", "tolerance"), [(None, 2e-5), (51, 1e-9)])
def test_initial_shape_is_rebuilt_everywhere(grid: int | None, tolerance: float) -> None:
    beam = TimoshenkoBeam(initial=BeamState(w=(0, 0.16), phi=(0, 0.18), w_rate=(0, 0.1)))
    modes = beam.modes(100, grid)
    q, rate = beam.initial_state(modes)
    x = np.linspace(0, 1, 51)
    np.testing.assert_allclose(modes.field("w").shapes(x) @ q, 0.16 * x, atol=tolerance)
    np.testing.assert_allclose(modes.field("phi").shapes(x) @ q, 0.18 * x, atol=tolerance)
    np.testing.assert_allclose(modes.b @ rate, [0.1, 0], atol=2e-3)


def test_a_rate_at_odds_with_the_clamp_keeps_the_right_kinetic_energy() -> None:
    beam = TimoshenkoBeam(initial=BeamState(w_rate=(0.1,), phi_rate=(0.1,)))
    energies = [np.sum(beam.initial_state(beam.modes(n))[1] ** 2) / 2 for n in (50, 100, 200)]
    exact = 0.5 * 0.01 * (1.0 + 0.1 + 2.0 + 0.1)
    errors = exact - np.array(energies)
    assert np.all(errors > 0)
    np.testing.assert_allclose(errors[:-1] / errors[1:], 2, rtol=0.1)


def test_load_projection_resolves_short_waves() -> None:
    modes = TimoshenkoBeam().modes(40)
    x, matrix = modes.load_rule("w", shortest_wave=1 / 75)
    fine_x, fine_matrix = modes.load_rule("w", shortest_wave=1 / 600)
    load = np.sin(2 * np.pi * 75 * np.array([x]))
    np.testing.assert_allclose(load @ matrix, np.sin(2 * np.pi * 75 * fine_x)[None] @ fine_matrix, atol=1e-12)


def test_polynomial_takes_coefficients_in_ascending_order() -> None:
    np.testing.assert_allclose(polynomial((1.0, 2.0, 3.0))(np.array([2.0])), 17.0)
