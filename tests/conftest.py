"""Scenarios and runs that several tests look at."""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy: test processes side by side must not fight for cores

from collections.abc import Callable

import pytest

import dampen
from dampen.simulation.bench import Bench

FINE = ("numerics.modes=100", "numerics.step=1e-4", "task.trials=10", "output.every=100")
COARSE = ("numerics.modes=64", "numerics.step=1e-3", "task.trials=10")
READINGS = {"designed": "controller.compensate=true", "direct": "controller.compensate=false"}


def scenario(*overrides: str) -> dampen.Scenario:
    """The paper's scenario, changed."""
    return dampen.read_scenario("he2017", overrides)


@pytest.fixture(scope="session")
def run() -> Callable[..., dampen.Result]:
    """Run the paper's scenario, changed; each variation once a session."""
    done: dict[tuple[str, ...], dampen.Result] = {}

    def get(*overrides: str) -> dampen.Result:
        if overrides not in done:
            done[overrides] = dampen.simulate(scenario(*overrides))
        return done[overrides]

    return get


@pytest.fixture(scope="session")
def paper_runs() -> tuple[dampen.Result, dampen.Result]:
    """The shipped scenario with and without control."""
    shipped = scenario()
    bench = Bench(shipped)
    return dampen.simulate(shipped, bench=bench), dampen.simulate(shipped.uncontrolled(), bench=bench)
