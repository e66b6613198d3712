"""How fast environments step: he2017 (64 modes, both ports behind their backlash), one sample period a step, 1 ms.

    python benchmarks/gym.py

A loop over single environments, Gymnasium's own vector of them in one process, and the vector that steps in one compiled call;
constant commands, no constraint, so that no episode ends early. Each line is the best of several rounds, in which all take
turns. An environment step is one step of one environment.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy: one thread is one core

import platform
import time
from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np

from dampen.gym import BeamEnv, BeamVectorEnv

MODES, STEPS, ROUNDS = 64, 400, 5
ARGUMENTS: dict[str, Any] = {
    "overrides": (f"numerics.modes={MODES}", "controller.kind=none", "task.constraint={}"),
    "command_limit": 3.0,
    "error_scale": 0.2,
}


def loop(count: int, **more: float) -> tuple[Callable[[int], None], int]:
    """Single environments, one after the other."""
    envs, action = [BeamEnv("he2017", **ARGUMENTS, **more) for _ in range(count)], np.array([0.1, -0.1])
    for env in envs:
        env.reset()

    def run(steps: int) -> None:
        for _ in range(steps):
            for env in envs:
                env.step(action)

    return run, count


def vector(env: gymnasium.vector.VectorEnv) -> tuple[Callable[[int], None], int]:
    """A vector of environments."""
    env.reset()
    actions = np.tile([0.1, -0.1], (env.num_envs, 1))

    def run(steps: int) -> None:
        for _ in range(steps):
            env.step(actions)

    return run, env.num_envs


def synchronous(count: int) -> gymnasium.vector.VectorEnv:
    """Gymnasium's own, without processes."""
    return gymnasium.vector.SyncVectorEnv([lambda: BeamEnv("he2017", **ARGUMENTS)] * count)


def main() -> None:
    """Print the table."""
    cases = {
        "loop over single environments, 16": loop(16),
        "gymnasium's SyncVectorEnv, 16": vector(synchronous(16)),
        **{f"one compiled call, {n}": vector(BeamVectorEnv(n, "he2017", **ARGUMENTS)) for n in (1, 16, 64, 256)},
        "the same on two threads, 256": vector(BeamVectorEnv(256, "he2017", threads=2, **ARGUMENTS)),
        "10 ms a step: single environments, 16": loop(16, period=0.01),
        "10 ms a step: one compiled call, 256": vector(BeamVectorEnv(256, "he2017", period=0.01, **ARGUMENTS)),
        "10 ms a step: on two threads, 256": vector(BeamVectorEnv(256, "he2017", period=0.01, threads=2, **ARGUMENTS)),
    }
    best = dict.fromkeys(cases, np.inf)
    for number in range(ROUNDS + 1):
        for name, (run, count) in cases.items():
            begin = time.perf_counter()
            run(STEPS)
            taken = (time.perf_counter() - begin) / STEPS / count
            best[name] = min(best[name], taken) if number else np.inf  # the first round compiles, and samples the loads
    reference = best["loop over single environments, 16"]
    print(f"{platform.processor() or platform.machine()}, Python {platform.python_version()}, NumPy {np.__version__}")
    print(f"{'environment steps':<38} {'us each':>9} {'per second':>11} {'x loop':>8}")
    for name, taken in best.items():
        print(f"{name:<38} {1e6 * taken:9.2f} {1 / taken:11.0f} {reference / taken:8.1f}")


if __name__ == "__main__":
    main()
