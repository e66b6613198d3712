"""The static compliance of the modes that a model leaves out."""

from __future__ import annotations

import numpy as np

from dampen.component import ArgumentError
from dampen.plants.base import Modes, Plant

Array = np.ndarray


def residual_compliance(plant: Plant, modes: Modes, grid: int | None) -> Array:
    """(ports, ports) R = sum over the modes left out of b_i b_i^T / omega_i^2, without finding them.

    A structure that is held bends by its whole compliance K^-1. One that is free to move bends under what is left of a force when
    the inertia of the rigid motion that it causes is taken off (inertia relief): with M-orthonormal rigid modes P and any s > 0

        sum over elastic modes of v_i v_i^T / omega_i^2 = (K + s M P P^T M)^-1 - P P^T / s

    Raises ArgumentError for a structure that is free to move and tells only its modes.
    """
    if modes.compliance is not None:
        return modes.residual_compliance
    whole = plant.discretise(modes.count, grid)
    if whole is None or modes.vectors is None:
        raise ArgumentError("Argument `residual` must be false: this plant is free to move, and tells only its modes.")
    from scipy.linalg import cho_factor, cho_solve

    energies, rigid = whole.energies, modes.omega == 0
    inertia = energies.mass @ modes.vectors[:, rigid]
    s = float(np.trace(energies.stiffness) / np.trace(energies.mass))
    held = cho_factor(energies.stiffness + s * inertia @ inertia.T)
    relieved = whole.port_vectors.T - inertia @ modes.b[:, rigid].T
    bent = cho_solve(held, relieved)
    bent -= modes.vectors[:, rigid] @ (inertia.T @ bent)
    elastic = modes.b[:, ~rigid]
    return np.asarray(whole.port_vectors @ bent - (elastic / modes.omega[~rigid] ** 2) @ elastic.T)
