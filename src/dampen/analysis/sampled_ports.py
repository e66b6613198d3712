"""The loop that a law port by port closes through samples: estimator, law and commands under way around the sampled plant."""

from __future__ import annotations

import numpy as np

from dampen.controllers.base import PortLaw, Setting
from dampen.controllers.sampled_plant import sampled_model
from dampen.modal import ModalModel
from dampen.simulation.digital_law import RELAXATION
from dampen.simulation.digital_side import estimator_gains, nominal_compliance, port_law_row
from dampen.simulation.sampling import Sampling

Array = np.ndarray
PENDING = -1  # the last of a port's parameters


def sampled_port_loop(model: ModalModel, law: PortLaw, stiffness: Array, sampling: Sampling, setting: Setting) -> Array:
    """The matrix of z+ = A z from sample to sample, for a law without coulomb terms; z: the sampled plant's x (q, q', lags,
    commands under way), then by port e_hat, v_hat, u_slow and the command before, as in `simulation.digital`.

        r = y - (e_hat + T v_hat),    e_hat+ = e_hat + T v_hat + l1 r,    v_hat+ = v_hat + l2 r / T

    explicit and boundary layer: u = -stiffness e_hat+ - damping v_hat+. implicit: the rate is the one that u brings about,
    u = (-stiffness e_hat+ - damping (v_hat+ + pending (u_before - u_slow) - c u_slow)) / (1 + damping c).
    stiffness: (ports,) with the barrier's curvature. Sensors are exact here, and commands without limit.
    """
    a, b, c = sampled_model(model, setting, setting.lags)
    n, ports, seconds = len(a), len(b.T), sampling.period
    size, (gain_1, gain_2) = n + 4 * ports, estimator_gains(sampling)
    e, v, slow, before = (np.eye(size)[n + k * ports : n + (k + 1) * ports] for k in range(4))
    expected = e + seconds * v
    surprise = np.hstack([c, np.zeros((ports, 4 * ports))]) - expected
    e_new, v_new = expected + gain_1 * surprise, v + gain_2 * surprise / seconds
    damping, spring = law.damping[:, None], np.asarray(stiffness)[:, None]
    if sampling.switching == "implicit":
        compliance = nominal_compliance(sampling, setting)[:, None]
        pending = port_law_row(sampling, setting, law).reshape(ports, -1)[:, PENDING, None]
        rate = v_new + pending * (before - slow) - compliance * slow
        u = (-spring * e_new - damping * rate) / (1 + damping * compliance)
        slow_new = slow + RELAXATION * (u - slow)
    else:
        u, slow_new = -spring * e_new - damping * v_new, np.zeros_like(slow)
    x_new = np.hstack([a, np.zeros((n, 4 * ports))]) + b @ u
    return np.vstack([x_new, e_new, v_new, slow_new, u])
