"""The digital controller's equipment: the record that the kernel samples with, made for a run and prepared for each trial."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from dampen.controllers.base import PortLaw, SampledFeedback, Setting
from dampen.modal import propagator
from dampen.simulation.digital import Sampler
from dampen.simulation.digital_law import COLUMNS, EXPLICIT, IMPLICIT, LAYER
from dampen.simulation.sampling import Sampling
from dampen.simulation.scenario import Scenario

Array = np.ndarray
CAUTION = 3.0
USUAL_LAYER = 0.01  # m/s, rad/s
SWITCHING = {"explicit": EXPLICIT, "boundary-layer": LAYER, "implicit": IMPLICIT}


def idle(ports: int) -> Sampler:
    """No digital controller: the law acts continuously."""
    row, table = np.zeros(ports), np.zeros((1, ports))
    return Sampler(0, 0, 1, 1.0, *(table,) * 6, *(row,) * 4, row, row, row, row, row, table, table, table)


def sampler_of(scenario: Scenario, setting: Setting) -> Sampler:
    """The equipment of a run, before its first sample."""
    sampling, ports, controller = scenario.sampling, len(setting.ports), scenario.controller
    step = scenario.numerics.step
    period, delay = round(sampling.period / step), round(sampling.delay / step)
    gain_1, gain_2 = estimator_gains(sampling)
    states = controller.states(setting) if isinstance(controller, SampledFeedback) else ports
    ahead = max(1, -(-delay // period))
    samples = setting.steps
    return idle(ports)._replace(
        period=period,
        delay=delay,
        ahead=ahead,
        seconds=sampling.period,
        quantum=setting.by_port(sampling.quantum),
        gain_1=np.full(ports, gain_1),
        gain_2=np.full(ports, gain_2),
        ceiling=setting.by_port(sampling.command_limit, np.inf),
        e_hat=np.zeros(ports),
        v_hat=np.zeros(ports),
        state=np.zeros(max(1, states)),
        begun=np.zeros(1),
        error=np.zeros((samples + 1, ports)),
        rate=np.zeros((samples, ports)),
        issued=np.zeros((ahead + samples, ports)),
    )


def prepare(sampler: Sampler, scenario: Scenario, setting: Setting, law: PortLaw, trial: int) -> Sampler:
    """The equipment as a trial begins: its noise, its memory, and the commands that are still on their way."""
    sampling, samples, controller = scenario.sampling, setting.steps, scenario.controller
    noise = np.zeros((samples + 1, len(setting.ports)))
    spread = setting.by_port(sampling.noise)
    if np.any(spread):
        noise = spread * np.random.default_rng([sampling.seed, trial]).standard_normal(noise.shape)
    sampler.issued[: sampler.ahead] = sampler.issued[samples:]
    arrays: dict[str, Any] = {
        "noise": noise,
        "reference": setting.reference,
        "feedforward": law.feedforward,
        "coulomb": law.coulomb,
        "low": setting.low[:-1],
        "high": setting.high[:-1],
        "parameters": controller.row(setting)
        if isinstance(controller, SampledFeedback)
        else port_law_row(sampling, setting, law),
    }
    arrays = {name: np.ascontiguousarray(a, float) for name, a in arrays.items()}
    return sampler._replace(**arrays)


def linear(scenario: Scenario, setting: Setting, gain: Array) -> Scenario:
    """The scenario with sensors that read exactly and commands without limit, for a law that is scaled by `gain` (ports,).

    A law whose commands are `gain` times as large means the same nominal model where its compliance is that much smaller.
    """
    compliance = nominal_compliance(scenario.sampling, setting) / np.where(gain > 0, gain, 1.0)
    by_port = {port.name: float(c) for port, c in zip(setting.ports, compliance, strict=True)}
    return replace(scenario, sampling=replace(scenario.sampling, noise={}, quantum={}, command_limit={}, compliance=by_port))


def begin_again(sampler: Sampler) -> None:
    """Forget everything, as after a reset."""
    for array in (sampler.e_hat, sampler.v_hat, sampler.state, sampler.begun, sampler.issued):
        array[...] = 0.0


def readings_of(error: Array, reference: Array) -> Array:
    """Readings whose distance from the reference rounds to the recorded error."""
    readings = np.asarray(error + reference)
    for _ in range(4):
        off = error - (readings - reference)
        if not off.any():
            break
        toward = np.nextafter(readings, np.where(off > 0, np.inf, -np.inf))
        closer = np.abs(error - (toward - reference)) < np.abs(off)
        readings = np.where(closer, toward, readings)
    return readings


def estimator_gains(sampling: Sampling) -> tuple[float, float]:
    """l1 and l2: of the filtered difference quotient, or of an observer with both poles at its bandwidth."""
    if sampling.rate == "difference":
        return 1.0, 1.0 if sampling.filter_time == 0 else float(-np.expm1(-sampling.period / sampling.filter_time))
    pole = float(np.exp(-2 * np.pi * sampling.observer_bandwidth * sampling.period))
    return 1 - pole**2, (1 - pole) ** 2


def port_law_row(sampling: Sampling, setting: Setting, law: PortLaw) -> Array:
    """The parameters of `digital_law.port_law`, port after port."""
    ports, compliance = len(setting.ports), nominal_compliance(sampling, setting)
    columns = {
        "damping": law.damping,
        "stiffness": law.stiffness,
        "barrier": law.barrier,
        "edge": np.full(ports, sampling.barrier_edge),
        "switching": np.full(ports, SWITCHING[sampling.switching]),
        "layer": setting.by_port(sampling.layer, USUAL_LAYER),
        "compliance": compliance,
        "pending": compliance * 2 / CAUTION * sampling.delay / sampling.period,
    }
    return np.column_stack([columns[name] for name in COLUMNS]).ravel()


def nominal_compliance(sampling: Sampling, setting: Setting) -> Array:
    """(ports,) as given, or CAUTION times the mean velocity in a sample period per unit of force, by the model.

    A difference of samples is the mean rate of the period past, half a period late. With c = 2 / CAUTION a free mass then
    goes to rest as z^2 - (1 - c/2) z + c/2 = 0: at c = 2 it would be thrown from side to side for ever, at 2/3 each sample
    leaves 0.58 of the motion.
    """
    if all(port.name in sampling.compliance for port in setting.ports):
        return setting.by_port(sampling.compliance)
    model = setting.model()
    own = CAUTION * np.sum(model.b**2 * propagator(model, sampling.period).psi, axis=1) / sampling.period
    return np.array([sampling.compliance.get(port.name, float(own[p])) for p, port in enumerate(setting.ports)])
