"""A policy of one's own, found by trying: linear gains by CMA-ES on many environments at once.

    python examples/gym_policy.py

Each candidate is a PD law, action = -K_e error - K_r rate, with two gains a port. All candidates of a generation are stepped
in one compiled call.
"""

import cmaes
import numpy as np

from dampen.gym import BeamVectorEnv

PERIOD = 0.004  # s between actions


def environments(count, trials, constrained=True):
    """The paper's experiment, its first trials; without the constraint, an episode always goes to its end."""
    free = [] if constrained else ["controller.kind=none", "task.constraint={}"]
    overrides = [f"task.trials={trials}", "numerics.modes=40", "numerics.step=0.002", *free]
    return BeamVectorEnv(
        count, "he2017", overrides=overrides, period=PERIOD, command_limit={"tip_w": 3.0, "tip_phi": 7.0}, error_scale=0.2
    )


def actions(gains, seen):
    """Of every environment, (count, 2); gains (count, 4): of both errors, then of both rates."""
    return -(gains[:, :2] * seen[:, :2] + gains[:, 2:] * seen[:, 2:4])


def returns(env, gains):
    """(count,) the return of one episode under each row of gains."""
    seen, _ = env.reset()
    total, going = np.zeros(len(gains)), np.ones(len(gains), bool)
    while going.any():
        seen, reward, terminated, truncated, _ = env.step(actions(gains, seen))
        total += np.where(going, reward, 0.0)
        going &= ~(terminated | truncated)
    return total


def search(generations=8, trials=3, seed=1):
    """Return without control, best return found, and the gains that reach it."""
    optimizer = cmaes.CMA(mean=np.zeros(4), sigma=1.0, population_size=16, seed=seed)
    env = environments(16, trials)
    without = best = returns(env, np.zeros((16, 4)))[0]
    found = np.zeros(4)
    for _ in range(generations):
        candidates = np.array([optimizer.ask() for _ in range(16)])
        scores = returns(env, candidates)
        optimizer.tell([(gains, -score) for gains, score in zip(candidates, scores, strict=True)])
        if scores.max() > best:
            best, found = scores.max(), candidates[scores.argmax()]
    return without, best, found


def error_of(gains, trials=3):
    """Root mean square of the tip's displacement over all trials [m], whatever the constraint."""
    env = environments(1, trials, constrained=False)
    seen, squares, truncated = env.reset()[0], [], [False]
    while not truncated[0]:
        seen, _, _, truncated, info = env.step(actions(gains[None], seen))
        squares.append(info["displacement"][0, 0] ** 2)
    return float(np.sqrt(np.mean(squares)))


if __name__ == "__main__":
    without, found, gains = search()
    print(f"return without control {without:.2f}, under the gains found {found:.2f}: {np.round(gains, 2)}")
    print(f"RMS of the tip: {error_of(np.zeros(4)):.4f} m without control, {error_of(gains):.4f} m with")
