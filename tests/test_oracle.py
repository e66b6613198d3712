"""The kernel against an oracle that shares no code with it, and against its own source run as plain Python."""

from __future__ import annotations

import numpy as np
import pytest

import dampen
from dampen.controllers.base import PortLaw
from dampen.simulation.bench import Bench
from dampen.simulation.setting import setting_of
from tests import oracle
from tests.conftest import READINGS, scenario

SHORT = ("task.trials=2", "task.trial_duration=0.2", "numerics.modes=6", "output.every=1", "numerics.points=9")
GRIDS = ("numerics.discretisation=spectral", "numerics.discretisation=finite-difference")
LAWS = ("controller.kind=none", *READINGS.values())


def deliveries(case: dampen.Scenario) -> list[oracle.Deliver]:
    law = case.controller
    if isinstance(law, dampen.DualLoopAILC) and law.compensate:
        return [oracle.compensated_play(0.3, 0.1, -0.2, 0.3, -0.2)] * 2
    return [oracle.play(0.3, 0.1, -0.2)] * 2


@pytest.mark.parametrize("grid", GRIDS)
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("step", ["1e-3", "4e-3"])
def test_kernel_agrees_with_the_independent_oracle(law: str, grid: str, step: str) -> None:
    case = scenario(*SHORT, law, grid, f"numerics.step={step}")
    result, bench = dampen.simulate(case), Bench(case)
    modes, n = bench.modes, case.steps
    q, rate = case.plant.initial_state(modes)
    setting = setting_of(case)
    memory = case.controller.begin(setting)
    states, slow, force = [0.0, 0.0], np.zeros(2), np.zeros(2)
    for j in range(case.task.trials):
        port_law: PortLaw = case.controller.law(memory, setting)
        disturbance, load, _ = bench.shaking(j)
        trial = oracle.simulate(
            modes.omega, modes.b, q, rate, case.numerics.step, port_law.feedforward, port_law.coulomb, port_law.damping,
            port_law.barrier, *(limit[0] for limit in case.limits()), disturbance, load, deliveries(case), states, slow, force,
        )  # fmt: skip
        for name in ("y", "v", "delivered", "energy"):
            expected = getattr(trial, name)
            np.testing.assert_allclose(
                result[name][j], expected, atol=1e-9 * np.abs(expected).max() + 1e-300, rtol=0, err_msg=name
            )
        np.testing.assert_allclose(result["command"][j], trial.command, atol=1e-8 * np.abs(trial.command).max() + 1e-300, rtol=0)
        np.testing.assert_allclose(result["work_load"][j], trial.work_load, atol=1e-14)
        q, rate, states, slow, force = trial.q, trial.rate, trial.states, trial.slow, trial.delivered[-1]
        memory = {name: np.asarray(result[name][j]) for name in memory}
    assert n == len(result["v"][0])


@pytest.mark.parametrize("law", LAWS)
def test_compiled_kernel_equals_its_plain_source(law: str) -> None:
    case = scenario("task.trials=1", "task.trial_duration=0.1", "numerics.modes=12", "output.every=1", law)
    compiled, plain = dampen.simulate(case), dampen.simulate(case, compile=False)
    for name in compiled.layout.variables:
        expected = np.asarray(plain[name], float)
        np.testing.assert_allclose(compiled[name], expected, atol=1e-10 * np.abs(expected).max() + 1e-300, rtol=0, err_msg=name)
