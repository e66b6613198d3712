"""A linear structure as independent modes, and the exact motion of each over a step under a held force."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

Array = np.ndarray
NODES = 16


@dataclass(frozen=True, kw_only=True)
class ModalModel:
    """q_i'' + 2 decay_i q_i' + omega_i^2 q_i = sum_p b_pi F_p,    y_p = sum_i b_pi q_i

    omega: (modes,) undamped angular frequencies [rad/s], 0 for a rigid-body mode.   b: (ports, modes) port vectors, for
    mass-normalised modes.   decay: (modes,) zeta_i omega_i [1/s]; None: undamped.
    """

    omega: Array
    b: Array
    decay: Array = None  # type: ignore[assignment]  # zeros from then on

    def __post_init__(self) -> None:
        if self.decay is None:
            object.__setattr__(self, "decay", np.zeros_like(self.omega))

    @property
    def count(self) -> int:
        return len(self.omega)

    @property
    def damped(self) -> bool:
        return bool(np.any(self.decay > 0))


@dataclass(frozen=True)
class Propagator:
    """q+ = c11 q + c12 q' + psi a,    q'+ = c21 q + c22 q' + c12 a    under a modal force a held over the step; (modes,) each."""

    c11: Array
    c12: Array
    c21: Array
    c22: Array
    psi: Array


def propagator(model: ModalModel, dt: float) -> Propagator:
    """The exact solution over a step of `dt` seconds: undamped, damped, critical, overdamped, and at zero frequency.

    With s the decay and d^2 = omega^2 - s^2:  c12 = e^(-s dt) sin(d dt)/d,  c11 = e^(-s dt) cos(d dt) + s c12,
    c21 = -omega^2 c12,  c22 = c11 - 2 s c12,  psi = (1 - c11)/omega^2 = int_0^dt c12, in forms that do not cancel.
    """
    omega, decay = model.omega, model.decay
    c12, mean = _impulse_response(omega, decay, dt)
    c11 = mean + decay * c12
    return Propagator(c11, c12, -(omega**2) * c12, mean - decay * c12, _step_response(omega, decay, dt, c11))


def dissipation(model: ModalModel, dt: float) -> Array:
    """(modes, 6): the energy lost in a step, int 2 decay q'^2 dt, is their sum with (q^2, 2 q q', q'^2, 2 q a, 2 q' a, a^2).

    Integrated by Gauss points over a small part of the step and doubled up to the whole: with Phi the map of (q, q', a) over
    h, G(2h) = G(h) + Phi(h)^T G(h) Phi(h). No use is made of the energy balance, which it is there to check.
    """
    from dampen.gauss import gauss_legendre

    stiff = float(np.max((model.omega + 2 * model.decay) * dt, initial=0.0))
    doublings = max(0, int(np.ceil(np.log2(max(stiff, 1e-300)))) + 1)
    h = dt / 2**doublings
    nodes, weights = gauss_legendre(NODES)
    form = np.zeros((model.count, 3, 3))
    for s, weight in zip((nodes + 1) * h / 2, weights * h / 2, strict=True):
        p = propagator(model, float(s))
        rate = np.stack([p.c21, p.c22, p.c12], axis=1)
        form += weight * 2 * model.decay[:, None, None] * rate[:, :, None] * rate[:, None, :]
    for k in range(doublings):
        p = propagator(model, h * 2**k)
        phi = np.zeros_like(form)
        phi[:, 0] = np.stack([p.c11, p.c12, p.psi], axis=1)
        phi[:, 1] = np.stack([p.c21, p.c22, p.c12], axis=1)
        phi[:, 2, 2] = 1
        form = form + phi.transpose(0, 2, 1) @ form @ phi
    return np.stack([form[:, i, j] for i, j in ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2))], axis=1)


def _impulse_response(omega: Array, decay: Array, dt: float) -> tuple[Array, Array]:
    """c12, and e^(-s dt) cos(d dt) or its overdamped continuation."""
    square = omega**2 - decay**2
    d = np.sqrt(np.abs(square))
    moving, over = np.where(d > 0, d, 1.0), square < 0
    fall = np.exp(-np.where(over, omega**2 / (decay + d + (decay + d == 0)), decay) * dt)
    wave = np.where(over, -np.expm1(-2 * d * dt) / 2, np.sin(d * dt))
    mean = np.where(over, (1 + np.exp(-2 * d * dt)) / 2, np.cos(d * dt))
    return fall * np.where(d > 0, wave / moving, dt), fall * mean


def _step_response(omega: Array, decay: Array, dt: float, c11: Array) -> Array:
    """psi = int_0^dt c12: in closed form, or by Gauss points where that would cancel."""
    from dampen.gauss import gauss_legendre

    psi = np.where(omega > 0, 2 * (np.sin(omega * dt / 2) / np.where(omega > 0, omega, 1.0)) ** 2, dt**2 / 2)
    smooth = (decay > 0) & ((omega + 2 * decay) * dt <= 1)
    rough = (decay > 0) & ~smooth
    if np.any(smooth):
        nodes, weights = gauss_legendre(NODES)
        parts = [
            w * dt / 2 * _impulse_response(omega[smooth], decay[smooth], (s + 1) * dt / 2)[0]
            for s, w in zip(nodes, weights, strict=True)
        ]
        psi[smooth] = np.sum(parts, axis=0)
    if np.any(rough):
        o, s = omega[rough], decay[rough]
        d = np.sqrt(np.maximum(s**2 - o**2, 0.0))
        apart = d > 0.5 * s
        slow, fast = o**2 / (s + d), s + d
        gentle = np.where(slow > 0, -np.expm1(-slow * dt) / np.where(slow > 0, slow, 1.0), dt)
        two = (gentle + np.expm1(-fast * dt) / fast) / np.where(apart, 2 * d, 1.0)
        psi[rough] = np.where(apart, two, (1 - c11[rough]) / np.where(apart, 1.0, o) ** 2)
    return np.asarray(psi)
