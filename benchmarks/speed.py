"""How fast: one experiment (He et al. 2017, 25 trials of 2,000 steps), four ways, in one process.

    python benchmarks/speed.py            all of it, about a minute
    python benchmarks/speed.py --quick    without solve_ivp

dampen is timed twice: the kernel alone (64 modes, both ports closed, loads precomputed), and `simulate` as a user calls it,
loads, learning, energy account and all. Every time is the best of several runs.
"""

from __future__ import annotations

import platform
import sys
import time
from collections.abc import Callable

import numpy as np
from baselines import numpy_loop, solve_ivp_smoothed
from paper_loop import paper_loop

import dampen
from dampen.controllers.base import Trial
from dampen.simulation.bench import Bench
from dampen.simulation.digital_side import idle
from dampen.simulation.records import empty_record, port_records
from dampen.simulation.setting import setting_of

MODES, TRIALS, STEPS = 64, 25, 2000


def kernel_seconds(scenario: dampen.Scenario, bench: Bench) -> tuple[float, float]:
    """Seconds that the compiled kernel takes for all trials, and the last trial's largest |w(L)|."""
    kernel, classes = bench.kernel(scenario)
    ports, stages = port_records([scenario.chain(p) for p in range(2)], bench.step, classes)
    modal, sampler = bench.modal_record(), idle(2)
    setting, controller = setting_of(scenario, bench=bench), scenario.controller
    memory, seconds = controller.begin(setting), 0.0
    record = empty_record(scenario.steps, len(ports), bench.modes.count, scenario.output.every)
    for j in range(scenario.task.trials):
        law = controller.law(memory, setting)
        ports.damping, ports.barrier = law.damping, law.barrier
        inputs = bench.inputs(scenario, j, law)
        begin = time.perf_counter()
        kernel(modal, bench.step, inputs, sampler, ports, stages, scenario.output.every, record)
        seconds += time.perf_counter() - begin
        memory = controller.learn(memory, Trial(j, record.y, record.v, record.command), setting)
    return seconds, float(np.abs(record.y[:, 0]).max())


def best(measure: Callable[[], tuple[float, float]], runs: int) -> tuple[float, float]:
    return min(measure() for _ in range(runs))


def of_dampen(reading: str) -> list[tuple[str, float, float]]:
    scenario = dampen.read_scenario("he2017", [f"numerics.modes={MODES}", f"controller.compensate={reading}"])
    bench = Bench(scenario)
    kernel_seconds(scenario, bench)  # compile, and sample the loads

    def whole() -> tuple[float, float]:
        begin = time.perf_counter()
        result = dampen.simulate(scenario)
        return time.perf_counter() - begin, float(np.abs(result["y"][-1][:, 0]).max())

    name = "designed" if reading == "true" else "direct"
    return [
        (f"dampen, kernel ({name})", *best(lambda: kernel_seconds(scenario, bench), 20)),
        (f"dampen, simulate() ({name})", *best(whole, 3)),
    ]


def main() -> None:
    """Print the table that the README quotes."""

    def baseline(function: Callable[[], object]) -> tuple[float, float]:
        run = function()
        return run.seconds, run.peak_w[-1]  # type: ignore[attr-defined]

    rows = [
        ("NumPy loop, as printed in the paper", *best(lambda: baseline(paper_loop), 2)),
        ("NumPy loop, tuned by hand", *best(lambda: baseline(numpy_loop), 3)),
    ]
    if "--quick" not in sys.argv:
        rows.append(("SciPy solve_ivp, smoothed law", *baseline(lambda: solve_ivp_smoothed(TRIALS))))
    rows += of_dampen("true") + of_dampen("false")
    reference = next(seconds for name, seconds, _ in rows if name == "dampen, kernel (designed)")
    print(f"{platform.processor() or platform.machine()}, Python {platform.python_version()}, NumPy {np.__version__}")
    print(f"{'25 trials of 2,000 steps':<38} {'seconds':>9} {'ns/step':>9} {'x kernel':>9}   max |w(L)| in trial 24 [m]")
    for name, seconds, peak in rows:
        print(f"{name:<38} {seconds:9.4f} {seconds / (TRIALS * STEPS) * 1e9:9.0f} {seconds / reference:9.1f}   {peak:.5f}")


if __name__ == "__main__":
    main()
