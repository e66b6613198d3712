"""How far a controller in float may be from one in double: rounded readings, through the gains of estimator, law and learning.

    bound = MARGIN 2^-24 ( Y (K_e + K_v G) + memory + U )

Y: largest reading of the run; G: of the estimator from error to rate, the sum of its impulse response's magnitudes; K_e,
K_v: of the law, per unit of error and of rate; U: largest command. `memory` is what rounding leaves in what is learned over all
trials. Of a linear law with states, K_e is the sum of its |commands| after a unit of error, as many times as it has states:
each is rounded at each sample. It is a first-order estimate with a margin, not a proof: a law that switches (Sgn as it is) may
moreover take the other side where the rate is within rounding of zero, and u_slow of the implicit law adds up what it is given.
"""

from __future__ import annotations

import numpy as np

from dampen.controllers.norm_optimal_ilc import NormOptimalILC
from dampen.controllers.p_type_ilc import PDTypeILC, PTypeILC
from dampen.controllers.pointwise import PointwiseLearning
from dampen.export.c.blueprint import Blueprint
from dampen.simulation.digital import Sample, Sampler, follow
from dampen.simulation.digital_law import COLUMNS, IMPLICIT, LAYER, port_law

Array = np.ndarray
MARGIN, UNIT, IMPULSE, NUDGE = 4.0, 2.0**-24, 2000, 1e-6


def float_bound(blue: Blueprint, reach: Array, largest: Array) -> Array:
    """(ports,) bound on the difference of commands; reach, largest: (ports,) the largest readings and commands."""
    rate = rate_gain(blue.sampler)
    if blue.law.__code__ is port_law.__code__:
        by_error, by_rate = port_law_gains(blue)
        moved = reach * (by_error + by_rate * rate)
    else:
        moved = len(blue.sampler.state) * linear_gains(blue) @ reach
    return MARGIN * UNIT * (moved + memory_gain(blue, rate, reach) + largest)


def rate_gain(sampler: Sampler) -> Array:
    """(ports,) the sum of |v_hat| after a unit of error at one sample [1/s]."""
    ports = len(sampler.gain_1)
    e_hat, v_hat, total = np.zeros(ports), np.zeros(ports), np.zeros(ports)
    for k in range(IMPULSE):
        for p in range(ports):
            follow(p, float(k == 0), sampler.seconds, sampler.gain_1[p], sampler.gain_2[p], e_hat, v_hat)  # type: ignore[no-untyped-call]
        total += np.abs(v_hat)
    return total


def port_law_gains(blue: Blueprint) -> tuple[Array, Array]:
    """(ports,) K_e and K_v of `port_law`, the barrier's at its edge, Sgn by its layer or compliance."""
    table = dict(zip(COLUMNS, np.reshape(blue.sampler.parameters, (blue.ports, -1)).T, strict=True))
    coulomb = blue.sampler.coulomb.max(axis=0)
    sharp = np.select(
        [table["switching"] == IMPLICIT, table["switching"] == LAYER], [1 / table["compliance"], coulomb / table["layer"]], 0.0
    )
    high = np.minimum(blue.sampler.high.min(axis=0), -blue.sampler.low.max(axis=0))
    with np.errstate(divide="ignore", invalid="ignore"):
        near = (1 - table["edge"]) * high
        steep = np.where(np.isfinite(high) & (table["barrier"] > 0), table["barrier"] / near**2, 0.0)
    return table["stiffness"] + steep, table["damping"] + sharp


def linear_gains(blue: Blueprint) -> Array:
    """(ports, ports) the sum of |command| after a unit of error at one sample, of a linear law."""
    ports, zero = blue.ports, np.zeros(blue.ports)
    total = np.zeros((ports, ports))
    for q in range(ports):
        state, command = np.zeros(len(blue.sampler.state)), np.zeros(ports)
        for k in range(IMPULSE // 4):
            error = np.where(np.arange(ports) == q, float(k == 0), 0.0)
            blue.law(Sample(error, *(zero,) * 7), state, np.ravel(blue.sampler.parameters), command)
            total[:, q] += np.abs(command)
    return total


def memory_gain(blue: Blueprint, rate: Array, reach: Array) -> Array:
    """(ports,) what a unit of relative rounding leaves in the memories over all trials."""
    trials, controller, setting = blue.scenario.task.trials, blue.controller, blue.setting
    if isinstance(controller, PointwiseLearning):
        row = np.abs(np.asarray(controller.learning_row(setting), float))[:2].sum(axis=0)
        return trials * row * rate * reach
    if isinstance(controller, PTypeILC):
        gain = np.abs(setting.by_port(controller.learning))
        if isinstance(controller, PDTypeILC):
            gain = gain + 2 * np.abs(setting.by_port(controller.rate_learning)) / setting.dt
        return trials * gain * reach
    if isinstance(controller, NormOptimalILC):
        ridge = controller.effort_weight + controller.change_weight
        weight = np.sqrt(setting.by_port(controller.error_weight, 1.0) / ridge) / 2
        return np.full(blue.ports, trials * float(weight @ reach))
    return np.zeros(blue.ports)
