"""The kernel's family against independent references: damping, stiffness, tracking, limits, barriers, resets, sampled laws."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Literal

import numpy as np
import pytest

import dampen
from dampen.analysis.energy import energy_account
from dampen.controllers.inner_loop import AssumedBacklash, FlankInverse
from dampen.simulation.setting import of_trial, setting_of
from tests import oracle, oracle_sampled
from tests.certificate import faults
from tests.own_parts import Everything, lumps

STEP, STEPS = 2e-3, 150
FLANK = AssumedBacklash(slope=0.5, right=0.2, left=-0.1)
PLAY = dampen.Backlash(slope=0.4, right=0.15, left=-0.1)
SHAKING = dampen.Harmonics(
    frequencies=(1.3, 4.0), force={"p0": (0.3, 0.2), "p1": (0.1, -0.3)}, phases=(0.4, 1.1), trials="continue"
)
LIMITS = {
    "p0": dampen.Constraint(
        high=dampen.Sinusoid(amplitude=0.01, frequency=2.0, offset=0.05), low=dampen.Decay(-0.09, -0.05, 0.1), on="error"
    ),
    "p1": dampen.Constraint(high=0.11, low=-0.06),
}
REFERENCE = {
    "p0": dampen.Sinusoid(amplitude=0.02, frequency=1.5, ramp=0.2),
    "p1": dampen.MinimumJerk(target=0.03, duration=0.25, begin=0.05),
}


def family(shape: Literal["log", "tan"], start: Literal["chained", "reset"]) -> dampen.Scenario:
    """Every term of the law on a damped structure with a zero-frequency mode, both chains with backlash, one compensated."""
    return dampen.Scenario(
        plant=lumps(np.random.default_rng(11), 2, 22, 0.3),
        controller=Everything(
            damping=(0.6, 0.2), stiffness=(3.0, 8.0), barrier_gain=(0.02, 0.05), coulomb=(0.1, 0.05), push=(0.2, 0.3),
            barrier=shape,
        ),
        disturbance=SHAKING,
        task=dampen.Task(
            trials=2, trial_duration=STEP * STEPS, start=start, reference=REFERENCE, constraint=LIMITS,
            reset_error={"p0": 2e-3, "p1": 1e-3} if start == "reset" else {}, seed=5,
        ),
        numerics=dampen.Numerics(modes=22, step=STEP),
        output=dampen.Output(every=STEPS),
        actuators={"p0": (PLAY,), "p1": (PLAY,)},
        compensation={"p0": (FlankInverse(FLANK),)},
    )  # fmt: skip


SLOPES = np.array([0.4 / 0.5, 0.4])
DELIVER = [oracle.compensated_play(0.4, 0.15, -0.1, 0.5, -0.1), oracle.play(0.4, 0.15, -0.1)]


def agree(result: dampen.Result, j: int, trial: oracle.Trial, names: tuple[str, ...]) -> None:
    for name in names:
        expected = getattr(trial, name)
        atol = 1e-9 * np.abs(expected).max() + 1e-300
        np.testing.assert_allclose(result[name][j], expected, atol=atol, rtol=0, err_msg=f"{name} of trial {j}")


SIGNALS = ("y", "v", "command", "delivered", "energy", "dissipated")


@pytest.mark.parametrize("start", ["chained", "reset"])
@pytest.mark.parametrize("shape", ["log", "tan"])
def test_damping_stiffness_tracking_moving_uneven_limits_and_resets_agree_with_the_oracle(shape: Any, start: Any) -> None:
    case = family(shape, start)
    result, modes = dampen.simulate(case), case.plant.modes(22)
    q, rate = (np.array(a) for a in (case.plant.q, case.plant.rate))
    begin, setting = (q, rate, [0.0, 0.0], np.zeros(2), np.zeros(2)), setting_of(case)
    memory = case.controller.begin(setting)
    for j in range(2):
        if j == 0 or start == "reset":
            q, rate, states, slow, force = begin
            q = q + misplaced(modes, case, j)
        law, reference, (low, high) = case.controller.law(memory, of_trial(setting, case, j)), case.reference(j), case.limits(j)
        disturbance = SHAKING.at_ports(j, (np.arange(STEPS) + 0.5) * STEP, dampen.Site(case.plant.ports, 1.0, STEP * STEPS))
        trial = oracle.simulate(
            modes.omega, modes.b, q, rate, STEP, law.feedforward, law.coulomb, law.damping, law.barrier,
            (low - reference)[1:], (high - reference)[1:], disturbance, np.zeros((STEPS, 22)), DELIVER, states, slow, force,
            decay=modes.decay, stiffness=law.stiffness, reference=reference, shape=shape,
        )  # fmt: skip
        agree(result, j, trial, SIGNALS)
        q, rate, states, slow, force = trial.q, trial.rate, trial.states, trial.slow, trial.delivered[-1]
        memory = {"pushed": memory["pushed"] - 0.1 * trial.v, "rubbed": memory["rubbed"] + 0.1 * np.abs(trial.v)}
    assert np.any(result["v"] == 0)
    assert np.any(result["v"] != 0)


def misplaced(modes: Any, case: dampen.Scenario, j: int) -> np.ndarray:
    """The least bend, in the norm sum (omega^2 + omega_1^2) q^2, that puts the ports where the reset's draw says."""
    if case.task.start != "reset":
        return np.zeros(modes.count)
    off = np.array([2e-3, 1e-3]) * np.random.default_rng([5, j]).standard_normal(2)
    scale = 1 / np.sqrt(modes.omega**2 + modes.omega[1] ** 2)
    return scale * np.linalg.lstsq(modes.b * scale, off, rcond=None)[0]


PERIOD = 5 * STEP
SENSORS = {"noise": {"p0": 1e-4, "p1": 5e-5}, "quantum": {"p1": 2e-4}, "command_limit": {"p0": 0.9}, "seed": 3}
SAMPLINGS = {
    "explicit": dampen.Sampling(period=PERIOD, delay=3 * STEP, switching="explicit", filter_time=0.004, **SENSORS),
    "boundary-layer": dampen.Sampling(
        period=PERIOD,
        delay=7 * STEP,
        switching="boundary-layer",
        rate="observer",
        observer_bandwidth=20.0,
        layer={"p0": 0.02, "p1": 0.02},
    ),
    "implicit": dampen.Sampling(period=PERIOD, switching="implicit", compliance={"p0": 0.3}, filter_time=0.0, **SENSORS),
    "late": dampen.Sampling(period=PERIOD, delay=12 * STEP, switching="implicit", filter_time=0.004, barrier_edge=0.6),
}


def through_samples(case: dampen.Scenario, sampling: dampen.Sampling) -> dampen.Scenario:
    return replace(case, sampling=sampling, numerics=replace(case.numerics, mode="sampled"))


def equipment(sampling: dampen.Sampling) -> oracle_sampled.Digital:
    gains = oracle_sampled.difference_gains(PERIOD, sampling.filter_time)
    if sampling.rate == "observer":
        gains = oracle_sampled.observer_gains(PERIOD, sampling.observer_bandwidth)
    quantum, ceiling = (
        [table.get(p, d) for p in ("p0", "p1")] for table, d in ((sampling.quantum, 0), (sampling.command_limit, np.inf))
    )
    return oracle_sampled.Digital(5, round(sampling.delay / STEP), PERIOD, *gains, np.array(quantum), np.array(ceiling))


def noise(sampling: dampen.Sampling, trial: int) -> np.ndarray:
    spread = np.array([sampling.noise.get(p, 0.0) for p in ("p0", "p1")])
    return spread * np.random.default_rng([sampling.seed, trial]).standard_normal((STEPS // 5 + 1, 2))


def compliances(sampling: dampen.Sampling, modes: Any) -> np.ndarray:
    """As given, or three times the mean velocity over a period under a unit of held force."""
    moved = oracle.Structure(modes.omega, modes.decay, modes.b, PERIOD).gain / PERIOD
    return np.array([sampling.compliance.get(p, 3 * moved[i, i]) for i, p in enumerate(("p0", "p1"))])


def follow(case: dampen.Scenario, result: dampen.Result, laws: Any, learn: Any) -> None:
    """All trials of a sampled case by the oracle; laws(j) is the law of a trial, learn(trial) is told of it."""
    modes, sampling = case.plant.modes(22), case.sampling
    q, rate, states, command = np.array(case.plant.q), np.array(case.plant.rate), [0.0, 0.0], np.zeros(2)
    digital = equipment(sampling)
    for j in range(result.trials):
        disturbance = SHAKING.at_ports(j, (np.arange(STEPS) + 0.5) * STEP, dampen.Site(case.plant.ports, 1.0, STEP * STEPS))
        trial = oracle_sampled.simulate(
            modes.omega, modes.b, modes.decay, q, rate, STEP, digital, laws(j), noise(sampling, j), case.reference(j),
            disturbance, np.zeros((STEPS, 22)), DELIVER, states, command,
        )  # fmt: skip
        agree(result, j, trial, (*SIGNALS, "reading", "rate_estimate", "issued"))
        learn(trial)
        q, rate, states, command = trial.q, trial.rate, trial.states, trial.command[-1]


@pytest.mark.parametrize("name", list(SAMPLINGS))
def test_a_law_through_samples_agrees_with_the_oracle(name: str) -> None:
    """Estimators, delays short and long, noise, quantiser, command limit, three kinds of Sgn, learning from estimates."""
    sampling, shape = SAMPLINGS[name], "tan" if name == "boundary-layer" else "log"
    case = through_samples(family(shape, "chained"), sampling)  # type: ignore[arg-type]
    law, modes = case.controller, case.plant.modes(22)
    kind = "implicit" if name == "late" else name
    ports = oracle_sampled.PortLaws(
        kind,
        law.damping,
        law.stiffness,
        law.barrier_gain,
        sampling.barrier_edge,
        sampling.layer.get("p0", 0.01),
        compliances(sampling, modes),
        shape,
        sampling.delay / PERIOD,
        equipment(sampling).ceiling,
    )
    pushed, rubbed = np.zeros((STEPS // 5, 2)), np.zeros((STEPS // 5, 2))

    def laws(j: int) -> Any:
        low, high = ((limit - case.reference(j))[::5] for limit in case.limits(j))

        def command(s: int, e: np.ndarray, v: np.ndarray, r: np.ndarray) -> np.ndarray:
            wave = np.sin(2 * np.pi * 3 * s * PERIOD) * np.array(law.push)
            return ports(e, v, wave + pushed[s], np.array(law.coulomb) + rubbed[s], low[s], high[s])

        return command

    def learn(trial: oracle_sampled.Sampled) -> None:
        nonlocal pushed, rubbed
        pushed, rubbed = pushed - 0.1 * trial.rate_estimate, rubbed + 0.1 * np.abs(trial.rate_estimate)

    follow(case, dampen.simulate(case), laws, learn)


@pytest.mark.parametrize("delay", [0, 3, 12])
def test_lqg_agrees_with_a_design_from_its_definition(delay: int) -> None:
    plant = lumps(np.random.default_rng(12), 2, 22, 0.3)
    plant = replace(plant, omega=(1.0, *plant.omega[1:]))
    law = dampen.LQG(modes=3, energy_weight=2.0, error_weight={"p1": 30.0}, effort_weight=0.3, force_noise=0.2, sensor_noise=1e-3)
    sampling = dampen.Sampling(period=PERIOD, delay=delay * STEP, noise={"p0": 1e-4}, command_limit={"p1": 2.0})
    case = replace(through_samples(replace(family("log", "chained"), plant=plant), sampling), controller=law)
    m = plant.modes(3)
    regulator = oracle_sampled.Regulator(
        m.omega, m.decay, m.b, SLOPES, PERIOD, delay * STEP, 2.0, np.array([0.0, 30.0]), 0.3, 0.2, 1e-3
    )
    follow(case, dampen.simulate(case), lambda j: lambda s, e, v, r: regulator(e + r, r), lambda trial: None)


@pytest.mark.parametrize("switching", ["explicit", "implicit"])
def test_the_lifted_response_is_a_pulse_through_the_loop_without_noise_steps_and_limits(switching: Any) -> None:
    """On an actuator with a slope of its own, where the implicit law means a nominal model in its own units."""
    still = replace(family("log", "chained").plant, q=(0.0,) * 22, rate=(0.0,) * 22)
    feedback = {"damping": {"p0": 0.6, "p1": 0.2}, "stiffness": {"p0": 3.0, "p1": 8.0}}
    sloped = (dampen.Backlash(0.4, 0.0, -1e-13),)
    case = dampen.Scenario(
        plant=still, controller=dampen.NormOptimalILC(**feedback), disturbance=dampen.NoDisturbance(),
        task=dampen.Task(trials=1, trial_duration=STEP * STEPS), output=dampen.Output(every=STEPS),
        numerics=dampen.Numerics(modes=22, step=STEP, mode="sampled"),
        actuators={"p0": sloped, "p1": sloped},
        compensation={"p0": (FlankInverse(AssumedBacklash(1.0, 1.0, 0.0)),)},
        sampling=dampen.Sampling(period=PERIOD, switching=switching, delay=3 * STEP, noise={"p0": 1e-3},
                                 quantum={"p1": 1e-3}, command_limit={"p0": 0.1}),
    )  # fmt: skip
    modes, response = case.plant.modes(22), setting_of(case).response()
    nominal = compliances(case.sampling, modes)
    gains = np.array([0.6, 0.2]), np.array([3.0, 8.0]), np.zeros(2)
    for r in range(2):
        laws = oracle_sampled.PortLaws(switching, *gains, 0.99, 0.01, nominal, "log", 3 * STEP / PERIOD)

        def pulse(s: int, e: np.ndarray, v: np.ndarray, _: Any, laws: Any = laws, r: int = r) -> np.ndarray:
            return laws(e, v, np.eye(2)[r] * (s == 0), np.zeros(2), None, None)

        digital = equipment(replace(case.sampling, noise={}, quantum={}, command_limit={}))
        zero = np.zeros((STEPS + 1, 2))
        trial = oracle_sampled.simulate(
            modes.omega, modes.b, modes.decay, still.q, still.rate, STEP, digital, pulse, zero, zero, zero, np.zeros((STEPS, 22)),
            [lambda u, state: (0.4 * u, state)] * 2, [0.0, 0.0], np.zeros(2),
        )  # fmt: skip
        expected = trial.y[5::5]
        np.testing.assert_allclose(response[:, :, r], expected, atol=1e-10 * np.abs(expected).max(), rtol=0)


def tight(seed: int, shape: Literal["log", "tan"], ports: int) -> dampen.Scenario:
    """Ports that all but move as one, each with uneven limits close to where it starts, steps up to 20 ms."""
    random = np.random.default_rng([seed, ports])
    names, step = [f"p{i}" for i in range(ports)], float(random.choice([1e-3, 5e-3, 2e-2]))
    plant = lumps(random, ports, 16, random.choice([0.5, 0.9, 0.99]))
    limits = {
        name: (float(min(y, 0) * 1.2 - 10 ** random.uniform(-3, -1)), float(max(y, 0) * 1.2 + 10 ** random.uniform(-3, -1)))
        for name, y in zip(names, plant.initial_ports(), strict=True)
    }
    draw = {
        name: tuple(float(x) for x in 10 ** random.uniform(*span, ports) * (random.uniform(size=ports) < share))
        for name, span, share in (
            ("damping", (-3, 1), 0.8), ("stiffness", (-2, 2.5), 0.6), ("barrier_gain", (-0.7, 1), 1.0), ("coulomb", (-3, 0), 0.7),
            ("push", (-2, 0), 0.7),
        )
    }  # fmt: skip
    force = {name: (float(10 ** random.uniform(-2, 0)), float(10 ** random.uniform(-2, 0))) for name in names}
    return dampen.Scenario(
        plant=plant, controller=Everything(**draw, barrier=shape),
        disturbance=dampen.Harmonics(frequencies=(4 / (100 * step), 1 / (100 * step)), force=force, trials="continue"),
        task=dampen.Task(trials=2, trial_duration=100 * step, constraint=limits),
        numerics=dampen.Numerics(modes=16, step=step), output=dampen.Output(every=100),
        actuators={"p0": (PLAY,), names[-1]: (PLAY,)}, compensation={"p0": (FlankInverse(FLANK),)},
    )  # fmt: skip


@pytest.mark.parametrize(("shape", "ports"), [("log", 2), ("tan", 2), ("tan", 3)])
def test_strongly_coupled_ports_within_tight_uneven_limits_satisfy_every_equation(shape: Any, ports: int) -> None:
    """Random gains, 40 each: constraint kept, forces settled, energy closed; for some, motion, law and actuator certified."""
    deliver = [DELIVER[0], *[oracle.ideal()] * (ports - 2), DELIVER[1]]
    for seed in range(40):
        case = tight(seed, shape, ports)
        result = dampen.simulate(case)
        assert result.status == "complete", seed
        assert not any("settle" in line for line in result.warnings), seed
        assert np.all(np.isfinite(result["command"])), seed
        assert energy_account(result).error <= 1e-11, seed
        if seed % 5 == 0:
            found = faults(result, case.plant.modes(16), deliver, [0.0] * ports)
            limits = {**dict.fromkeys(found, 1e-10), "law": 1e-8, "dissipated": 1e-8}
            assert all(found[name] <= limits[name] for name in found), (seed, found)


@pytest.mark.parametrize("seed", [100, 181])
def test_the_compiled_kernel_equals_its_plain_source_on_strongly_coupled_ports(seed: int) -> None:
    case = tight(seed, "tan", 3)
    compiled, plain = dampen.simulate(case), dampen.simulate(case, compile=False)
    for name in SIGNALS:
        expected = np.asarray(plain[name])
        np.testing.assert_allclose(compiled[name], expected, atol=1e-9 * np.abs(expected).max(), rtol=0, err_msg=name)
