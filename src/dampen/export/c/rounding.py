"""How far a controller in float may be from one in double: rounded readings, through the gains of estimator, law and learning.

    bound = MARGIN 2^-24 ( Y (K_e + K_v G) + memory + U )

Y: largest reading of the run; G: of the estimator from error to rate, the sum of its impulse response's magnitudes; K_e,
K_v: of the law, per unit of error and of rate; U: largest command. `memory` is what rounding leaves in what is learned over all
trials. Of a linear law with states, K_e is the sum of its |commands| after a unit of error, as many times as it has states:
each is rounded at each sample. The implicit law counts on what its command before will still do while that is on its way: what
was rounded there comes back with a factor -z, and K_v counts 1/(1 - z) times. From z = 1 on, where Sgn holds a port at delays of
more than 1.6 periods, it grows until the law switches: then nothing but 2 U can be stated.

It is a first-order estimate with a margin, not a proof: a law that switches (Sgn as it is) may moreover take the other side where
the rate is within rounding of zero, and u_slow of the implicit law adds up what it is given.
"""

from __future__ import annotations

import numpy as np

from dampen.controllers.norm_optimal_ilc import NormOptimalILC
from dampen.controllers.p_type_ilc import PDTypeILC, PTypeILC
from dampen.controllers.pointwise import PointwiseLearning
from dampen.export.c.blueprint import Blueprint
from dampen.simulation.digital import Sample, Sampler, follow
from dampen.simulation.digital_law import COLUMNS, IMPLICIT, LAYER, RELAXATION, port_law

Array = np.ndarray
MARGIN, UNIT, IMPULSE = 4.0, 2.0**-24, 2000


def float_bound(blue: Blueprint, reach: Array, largest: Array) -> Array:
    """(ports,) bound on the difference of commands; reach, largest: (ports,) the largest readings and commands."""
    rate = rate_gain(blue.sampler)
    if blue.law.__code__ is port_law.__code__:
        by_error, by_rate = port_law_gains(blue)
        moved = reach * (by_error + by_rate * rate)
    else:
        moved = len(blue.sampler.state) * linear_gains(blue) @ reach
    bound = MARGIN * UNIT * (moved + memory_gain(blue, rate, reach) + largest)
    return np.where(np.isfinite(bound), bound, 2 * largest)


def rate_gain(sampler: Sampler) -> Array:
    """(ports,) the sum of |v_hat| after a unit of error at one sample [1/s]."""
    ports = len(sampler.gain_1)
    e_hat, v_hat, total = np.zeros(ports), np.zeros(ports), np.zeros(ports)
    for k in range(IMPULSE):
        for p in range(ports):
            follow(p, float(k == 0), sampler.seconds, sampler.gain_1[p], sampler.gain_2[p], e_hat, v_hat)  # type: ignore[no-untyped-call]
        total += np.abs(v_hat)
    return total


def returns(blue: Blueprint) -> Array:
    """(ports,) z: by which factor the rounding of a command comes back in the next one; 0 unless the law is implicit."""
    if blue.law.__code__ is not port_law.__code__:
        return np.zeros(blue.ports)
    table = dict(zip(COLUMNS, np.reshape(blue.sampler.parameters, (blue.ports, -1)).T, strict=True))
    held = 1 / table["compliance"]
    dragged = table["damping"] / (1 + table["damping"] * table["compliance"])
    sticks = (blue.sampler.coulomb.max(axis=0) > 0) | (blue.learning == "pointwise")
    slope = (1 - RELAXATION) * table["pending"] * np.where(sticks, held, dragged)
    return np.where(table["switching"] == IMPLICIT, slope, 0.0)


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
    back = returns(blue)
    again = np.where(back < 1, 1 / np.maximum(1 - back, UNIT), np.inf)
    return table["stiffness"] + steep, (table["damping"] + sharp) * again


def linear_gains(blue: Blueprint) -> Array:
    """(ports, ports) the sum of |command| after a unit of error at one sample, of a linear law, as long as its states last."""
    ports, size = blue.ports, len(blue.sampler.state)
    table = np.zeros((size + ports, size + ports))  # states and commands, by states and errors before
    for i, unit in enumerate(np.eye(size + ports)):
        state, command = unit[:size].copy(), np.zeros(ports)
        blue.law(Sample(unit[size:], *(np.zeros(ports),) * 7), state, np.ravel(blue.sampler.parameters), command)
        table[:, i] = np.concatenate([state, command])
    task = blue.scenario.task
    total, left = np.abs(table[size:, size:]), table[:size, size:]
    for _ in range(blue.samples * (1 if task.start == "reset" else task.trials) - 1):
        total += np.abs(table[size:, :size] @ left)
        left = table[:size, :size] @ left
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
