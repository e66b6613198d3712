"""An independent code: a cantilever from scikit-fem's Hermite elements, through `Assembled`, against the built-in beam."""

from __future__ import annotations

import numpy as np
import pytest

import dampen

skfem = pytest.importorskip("skfem")

PAYLOAD = {"tip_mass": 0.2, "tip_inertia": 0.0005}
DAMPING = dampen.Damping(ratio=0.01)
BEAM = dampen.EulerBernoulliBeam(length=1.2, mass_per_length=0.432, bending_stiffness=14.9, damping=DAMPING, **PAYLOAD)


def cantilever(elements: int) -> dampen.Assembled:
    """The same beam with its payload, from element matrices that scikit-fem assembled."""
    from skfem.helpers import dd, ddot

    basis = skfem.Basis(skfem.MeshLine(np.linspace(0, BEAM.length, elements + 1)), skfem.ElementLineHermite())
    bending = skfem.BilinearForm(lambda u, v, w: BEAM.bending_stiffness * ddot(dd(u), dd(v))).assemble(basis)
    inertia = skfem.BilinearForm(lambda u, v, w: BEAM.mass_per_length * u * v).assemble(basis)
    free = basis.complement_dofs(basis.get_dofs(lambda x: x[0] == 0.0))
    deflection, slope = np.zeros(basis.N), np.zeros(basis.N)
    deflection[basis.nodal_dofs[0, -1]], slope[basis.nodal_dofs[1, -1]] = 1.0, 1.0
    tip, turn = deflection[free], slope[free]
    mass = inertia[free][:, free].toarray() + BEAM.tip_mass * np.outer(tip, tip) + BEAM.tip_inertia * np.outer(turn, turn)
    ports = (
        dampen.AssembledPort(name="tip_w", effort="force", x=BEAM.length),
        dampen.AssembledPort(name="tip_phi", effort="torque", x=BEAM.length),
    )
    stiffness = bending[free][:, free].toarray()
    return dampen.Assembled(mass=mass, stiffness=stiffness, port_vectors=np.array([tip, turn]), port=ports, damping=DAMPING)


def test_frequencies_agree_at_the_elements_fourth_order() -> None:
    exact = BEAM.modes(4).omega
    errors = np.array([np.abs(cantilever(n).modes(4).omega / exact - 1) for n in (6, 12, 24)])
    rates = np.log2(errors[:-1] / errors[1:])
    np.testing.assert_allclose(rates[:, 1:], 4, atol=0.15)  # the first mode is exact to 1e-9 with the finest mesh
    assert errors[-1, 0] < 1e-8


def test_two_seconds_of_motion_agree_to_half_a_percent() -> None:
    """Shaken and damped at the tip, without and with control through a backlash."""
    disturbance = dampen.Harmonics(frequencies=(0.9, 2.3), force={"tip_w": (0.3, 0.2), "tip_phi": (0.01, 0.02)})
    law = dampen.BoundaryDamping(damping={"tip_w": 1.0, "tip_phi": 0.02}, stiffness={"tip_w": 5.0})
    play = (dampen.Backlash(slope=1.0, right=0.02, left=-0.02),)
    for controller, chain in ((dampen.NoControl(), ()), (law, play)):
        runs = [
            dampen.simulate(
                dampen.Scenario(
                    plant=plant,
                    controller=controller,
                    disturbance=disturbance,
                    actuators={"tip_w": chain},
                    task=dampen.Task(trials=1, trial_duration=2.0),
                    numerics=dampen.Numerics(modes=12, step=0.001),
                )
            )["y"][0]
            for plant in (BEAM, cantilever(10))
        ]
        peak = np.abs(runs[0]).max(axis=0)
        assert np.all(np.abs(runs[1] - runs[0]).max(axis=0) < 0.005 * peak)
