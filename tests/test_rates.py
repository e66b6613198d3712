"""Declared rates: in the step, second order; in the sample period, first, towards the law that acts continuously."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Literal

import numpy as np
import pytest

import dampen
from dampen.plants.base import Damping
from tests.conftest import scenario

PORTS = ("tip_w", "tip_phi")
DAMPED = dampen.TimoshenkoBeam(damping=Damping(ratio=0.02, viscous=0.3), initial=dampen.BeamState(w=(0, 0.02), phi=(0, 0.02)))
PD = dampen.BoundaryDamping(damping=dict.fromkeys(PORTS, 0.5), stiffness={"tip_w": 5.0, "tip_phi": 3.0})
BARRIER = replace(PD, damping={"tip_w": 1.0, "tip_phi": 2.0}, barrier="log", barrier_gain=dict.fromkeys(PORTS, 0.1))


def case(step: float, law: dampen.Controller, period: float | None = None) -> dampen.Scenario:
    """A damped beam on a smooth reference under smooth disturbances, for 0.8 s; with a period, through samples."""
    return dampen.Scenario(
        plant=DAMPED, controller=law,
        disturbance=dampen.Harmonics(
            frequencies=(1.0, 2.3), force={"tip_w": (0.3, 0.1), "tip_phi": (0.2, 0.2)}, phases=(-np.pi / 2, -np.pi / 2)
        ),
        task=dampen.Task(
            trials=1, trial_duration=0.8, constraint=dict.fromkeys(PORTS, 0.2),
            reference={
                "tip_w": dampen.Sinusoid(amplitude=0.02, frequency=1.0, ramp=0.5),
                "tip_phi": dampen.MinimumJerk(target=0.02, duration=0.6),
            },
        ),
        numerics=dampen.Numerics(modes=8, step=step, mode="sampled" if period else "continuous"),
        sampling=dampen.Sampling(period=period or step, filter_time=period or 0.0),
        output=dampen.Output(every=round(0.8 / step), points=2),
    )  # fmt: skip


def motion(scenario: dampen.Scenario, every: float) -> np.ndarray:
    return np.asarray(dampen.simulate(scenario)["y"])[:, :: round(every / scenario.numerics.step)]


def rates(errors: list[float]) -> np.ndarray:
    return np.log2(np.array(errors[:-1]) / errors[1:])


@pytest.mark.parametrize(("law", "coarsest"), [(dampen.NoControl(), 0.008), (BARRIER, 0.001)])
def test_damped_motion_converges_at_second_order_in_the_step(law: Any, coarsest: float) -> None:
    """Without control, and under damping, stiffness and barrier; the law's numerical compliance needs 20 steps to be short."""
    exact = motion(case(coarsest / 64, law), coarsest)
    errors = [np.abs(motion(case(coarsest / n, law), coarsest) - exact).max() for n in (1, 2, 4)]
    np.testing.assert_allclose(rates(errors), 2, atol=0.1)


def test_a_smooth_law_through_samples_tends_to_the_continuous_one_at_first_order() -> None:
    step = 2.5e-4
    exact = motion(case(step, PD), 0.008)
    errors = [np.abs(motion(case(step, PD, n * step), 0.008) - exact).max() for n in (32, 16, 8, 4)]
    np.testing.assert_allclose(rates(errors), 1, atol=0.03)
    assert errors[-1] < 3e-5


@pytest.mark.parametrize("switching", ["implicit", "explicit"])
@pytest.mark.parametrize("compensate", ["true", "false"])
def test_the_set_valued_law_through_samples_tends_to_the_continuous_one(
    switching: Literal["implicit", "explicit"], compensate: str
) -> None:
    """Not smooth, so no rate is promised to three digits: from 4 ms to 0.5 ms the error falls by 7.5 to 20, 8 at first order."""
    step = 1e-4
    base = scenario(
        "numerics.modes=16", f"numerics.step={step}", "task.trials=2", f"controller.compensate={compensate}", "output.every=1000"
    )
    exact, errors = motion(base, 0.016), []
    for n in (40, 20, 10, 5):
        sampling = dampen.Sampling(period=n * step, filter_time=0.0, switching=switching)
        through = replace(base, sampling=sampling, numerics=replace(base.numerics, mode="sampled"))
        errors.append(np.abs(motion(through, 0.016) - exact).max())
    rate = np.log2(errors[0] / errors[-1]) / 3
    assert 0.9 < rate < 1.55, errors
    assert np.all(rates(errors) > 0.7), errors
    assert errors[-1] < 1e-3
