"""How fast are many experiments: he2017 (25 trials of 2,000 steps, 64 modes, both ports closed) under many gains.

    python benchmarks/batch.py

Members of a batch against the loop over single runs that one would write without it; loads are sampled beforehand in all, and
only figures of merit at the ports are kept. Each line is the best of several rounds, in which all take turns, so that a machine
that slows down slows all of them.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy: one thread is one core

import platform
import time
from collections.abc import Callable
from dataclasses import replace

import numpy as np

import dampen
from dampen.simulation.batch import Batch, alone
from dampen.simulation.bench import Bench

MODES, MEMBERS, SINGLE, ROUNDS = 64, 128, 4, 6


def members(nominal: dampen.Scenario, count: int) -> list[dampen.Scenario]:
    """Gains of the damping between 0.3 and 3, others as they are."""
    law = nominal.controller
    return [replace(nominal, controller=replace(law, alpha_4=float(a))) for a in np.geomspace(0.3, 3, count)]  # type: ignore[call-arg]


def plants(nominal: dampen.Scenario, count: int) -> list[dampen.Scenario]:
    """Payloads from 0.07 to 0.13 kg."""
    return [replace(nominal, plant=replace(nominal.plant, tip_mass=float(m))) for m in np.linspace(0.07, 0.13, count)]  # type: ignore[call-arg]


def seconds(run: Callable[[], object]) -> float:
    """Wall time of one call."""
    begin = time.perf_counter()
    run()
    return time.perf_counter() - begin


def main() -> None:
    """Print the table that the README quotes."""
    nominal = dampen.read_scenario("he2017", [f"numerics.modes={MODES}"])
    batch, bench = Batch(nominal), Bench(nominal)
    gains, changed = members(nominal, MEMBERS), plants(nominal, MEMBERS // 2)

    def loop() -> None:
        for member in gains[:SINGLE]:
            dampen.simulate(member, bench=bench)

    def lean_loop() -> None:
        for member in gains[:SINGLE]:
            alone(member, bench)

    cases: dict[str, tuple[Callable[[], object], int]] = {
        "loop over simulate(), bench shared": (loop, SINGLE),
        "loop over single runs, figures only": (lean_loop, SINGLE),
        "batch of gains, one thread": (lambda: batch.run(gains), MEMBERS),
        "batch of gains, two threads": (lambda: batch.run(gains, 2), MEMBERS),
        "batch of plants, one thread": (lambda: batch.run(changed), len(changed)),
        "batch of plants, two threads": (lambda: batch.run(changed, 2), len(changed)),
    }
    best = dict.fromkeys(cases, np.inf)
    for number in range(ROUNDS + 1):
        for name, (run, count) in cases.items():
            taken = seconds(run) / count
            best[name] = min(best[name], taken) if number else np.inf  # the first round compiles, and samples the loads
    reference = best["loop over simulate(), bench shared"]
    print(f"{platform.processor() or platform.machine()}, Python {platform.python_version()}, NumPy {np.__version__}")
    print(f"{'25 trials of 2,000 steps, 64 modes':<38} {'ms each':>9} {'per second':>11} {'x loop':>8}")
    for name, taken in best.items():
        print(f"{name:<38} {1e3 * taken:9.2f} {1 / taken:11.1f} {reference / taken:8.1f}")
    for kind in ("gains", "plants"):
        one, two = best[f"batch of {kind}, one thread"], best[f"batch of {kind}, two threads"]
        print(f"two threads, {kind}: {one / two:.2f} times one")


if __name__ == "__main__":
    main()
