"""Frequencies and shapes from mass and stiffness: exact to round-off, rigid-body modes included."""

from __future__ import annotations

import numpy as np

from dampen.component import ArgumentError, wrong

Array = np.ndarray
SURE, DOUBTFUL = 1e-3, 1e-6  # least eigenvalue, as a share of the shift, that is good for the next shift, or known at all


def solve_modes(mass: Array, stiffness: Array, count: int, at_once: bool = False) -> tuple[Array, Array]:
    """Lowest `count` solutions of K v = omega^2 M v: omega ascending, and mass-normalised vectors as columns.

    Solved as M v = 1/(omega^2 + s) (K + s M) v, whose largest eigenvalues are the lowest frequencies: those come out with
    relative errors near round-off, where the direct form loses the ratio of the highest to the lowest eigenvalue. The shift
    s is 0 for a structure that is held, and of the order of the first elastic omega^2 for one that is free to move as a
    rigid body, whose rigid modes have omega = 0 exactly. `at_once`: all modes are found, and the lowest kept, which is
    quicker if those are the most of a few hundred.

    Masses are taken in units of a power of two that goes with the first of them, so that the same structure in other units of
    mass has the same modes to the last digit.
    """
    from scipy.linalg import eigh

    _enough(count, len(mass))
    _known(mass, stiffness)
    heavy = np.diag(mass)[np.diag(mass) > 0]
    unit = power_of_two(float(heavy[0])) if len(heavy) else 1.0
    mass, stiffness = mass / unit, stiffness / unit
    rigid = rigid_modes(stiffness)
    shift = elastic_shift(mass, stiffness, rigid) if rigid else 0.0
    held = stiffness + shift * mass if rigid else stiffness
    if at_once:
        inverse, vectors = (part[..., len(mass) - count :] for part in eigh(mass, held, driver="gvd"))
    else:
        inverse, vectors = eigh(mass, held, subset_by_index=(len(mass) - count, len(mass) - 1))
    return _unshifted(1 / inverse[::-1], shift, rigid), vectors[:, ::-1] / np.sqrt(inverse[::-1]) / np.sqrt(unit)


def solve_roots(mass_root: Array, stiffness_root: Array, count: int) -> tuple[Array, Array]:
    """The same for M = A^T A and K = B^T B, given as A and B, (points, size) each: the singular values of A R^-1, B = Q R.

    Nothing is squared, so that errors grow with the ratio of frequencies only, not with that of their squares: what counts
    in bending, where a hundred modes span four decades of frequency.
    """
    from scipy.linalg import qr, solve_triangular, svd

    size = mass_root.shape[1]
    _enough(count, size)
    mass, stiffness = mass_root.T @ mass_root, stiffness_root.T @ stiffness_root
    _known(mass, stiffness)
    rigid = rigid_modes(stiffness)
    shift = elastic_shift(mass, stiffness, rigid) if rigid else 0.0
    held = np.vstack([stiffness_root, np.sqrt(shift) * mass_root]) if rigid else stiffness_root
    triangle = qr(held, mode="r")[0][:size]
    reduced = solve_triangular(triangle, mass_root.T, trans="T").T
    _, singular, rows = svd(qr(reduced, mode="r")[0][:size])
    vectors = solve_triangular(triangle, rows[:count].T) / singular[:count]
    return _unshifted(1 / singular[:count] ** 2, shift, rigid), vectors


def power_of_two(size: float) -> float:
    """The power of two next above `size` > 0: dividing by it rounds nothing."""
    return float(2.0 ** np.frexp(size)[1])


def rigid_modes(stiffness: Array) -> int:
    """Number of independent motions without any stiffness, beyond round-off."""
    from scipy.linalg import LinAlgError, cholesky, eigvalsh

    diagonal = np.diag(stiffness)
    scale = 1 / np.sqrt(np.where(diagonal > 0, diagonal, 1.0))
    scaled = stiffness * scale[:, None] * scale
    nothing = 10 * len(stiffness) * np.finfo(float).eps
    try:
        if np.min(np.diag(cholesky(scaled))) ** 2 > nothing:
            return 0
    except LinAlgError:
        pass
    return int(np.sum(eigvalsh(scaled) < nothing))


def elastic_shift(mass: Array, stiffness: Array, rigid: int) -> float:
    """A shift s > 0 of the order of the first elastic omega^2, for a structure with `rigid` modes of zero frequency.

    Sought from above: under a shift s eigenvalues are known to about s times round-off, enough to go on from.
    """
    from scipy.linalg import eigh

    size, soft = len(mass), np.diag(stiffness) > 0
    if rigid >= size or not np.any(soft):
        return 1.0
    shift = float(np.min(np.diag(stiffness)[soft] / np.diag(mass)[soft]))
    place = size - 1 - rigid
    for _ in range(20):
        inverse = eigh(mass, stiffness + shift * mass, subset_by_index=(place, place), eigvals_only=True)[0]
        elastic = float(1 / inverse - shift)
        if elastic > SURE * shift:
            return elastic
        shift = elastic if elastic > DOUBTFUL * shift else DOUBTFUL * shift
    return shift


def static_compliance(stiffness: Array, port_vectors: Array) -> Array:
    """(ports, ports) matrix of static port displacements per unit port force."""
    from scipy.linalg import cho_factor, cho_solve

    return port_vectors.T @ cho_solve(cho_factor(stiffness), port_vectors)


def _unshifted(squares: Array, shift: float, rigid: int) -> Array:
    """omega from omega^2 + shift, exactly 0 for rigid modes."""
    squares = np.maximum(squares - shift, 0.0)
    squares[:rigid] = 0.0
    return np.sqrt(squares)


def _known(mass: Array, stiffness: Array) -> None:
    """Raise ArgumentError for matrices that the plant's numbers have driven out of a double's range."""
    if not (np.all(np.isfinite(mass)) and np.all(np.isfinite(stiffness)) and np.any(np.diag(mass) > 0)):
        raise ArgumentError("Argument `plant` must have numbers nearer to one another: its mass or stiffness cannot be computed.")


def _enough(count: int, size: int) -> None:
    if count > size:
        raise wrong("modes", f"be <= {size}, the number of modes that this discretisation has", count)
