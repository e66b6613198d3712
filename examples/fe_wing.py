"""Matrices from a finite-element code to dampen: a tapered wing spar with an engine, by scikit-fem's Hermite elements.

    pip install scikit-fem
    python examples/fe_wing.py wing.npz

The file carries what dampen needs of a structure: mass and stiffness matrix, one column for each port, and, for pictures and
distributed loads, the values of the deflection at some points for each degree of freedom.
"""

import sys

import numpy as np
from skfem import Basis, BilinearForm, ElementLineHermite, MeshLine
from skfem.helpers import dd, ddot

LENGTH, ELEMENTS = 2.0, 40
ENGINE, ENGINE_MASS, STORE_MASS = 0.7, 4.0, 0.8  # m, kg, kg


@BilinearForm
def bending(u, v, w):
    """int EI u'' v'' dx, a spar that gets thinner outwards."""
    return 900.0 * (1 - 0.3 * w.x[0]) ** 3 * ddot(dd(u), dd(v))


@BilinearForm
def inertia(u, v, w):
    """int rho u v dx."""
    return 3.0 * (1 - 0.3 * w.x[0]) * u * v


def wing() -> dict[str, np.ndarray]:
    """The arrays that dampen reads."""
    basis = Basis(MeshLine(np.linspace(0, LENGTH, ELEMENTS + 1)), ElementLineHermite())
    free = basis.complement_dofs(basis.get_dofs(lambda x: x[0] == 0.0))  # clamped: neither deflection nor slope
    places = np.linspace(0, LENGTH, 81)
    values = basis.probes(np.clip(places, 0, LENGTH - 1e-12)[None, :]).toarray()[:, free]
    at = {x: values[np.argmin(np.abs(places - x))] for x in (ENGINE, LENGTH)}
    mass = inertia.assemble(basis)[free][:, free].toarray()
    mass += ENGINE_MASS * np.outer(at[ENGINE], at[ENGINE]) + STORE_MASS * np.outer(at[LENGTH], at[LENGTH])
    stiffness = bending.assemble(basis)[free][:, free]
    rigid = np.zeros(basis.N)
    rigid[basis.nodal_dofs[0]] = 1.0  # all deflections move with the root, no slope does
    return {
        "mass": mass,
        "stiffness": stiffness.toarray(),
        "port_vectors": np.array([at[ENGINE], at[LENGTH]]),
        "port_names": np.array(["engine", "tip"]),
        "port_efforts": np.array(["force", "force"]),
        "port_x": np.array([ENGINE, LENGTH]),
        "port_fields": np.array(["w", "w"]),
        "shape_names": np.array(["w"]),
        "shape_units": np.array(["m"]),
        "shape_x": places,
        "shape_w": values,
        "translation": rigid[free],
    }


if __name__ == "__main__":
    np.savez_compressed(sys.argv[1], **wing())
