"""The Gymnasium environments: the library's own runs, sample by sample, alone and side by side."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
import warnings
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode

import dampen
import dampen.gym
from dampen.gym import BeamEnv, BeamVectorEnv
from dampen.scenarios.read import shipped
from dampen.simulation.compose import Composition
from tests.conftest import scenario

FEW = ("numerics.modes=12", "task.trials=2", "task.trial_duration=0.2", "numerics.step=0.002", "output.every=10")
SAMPLED = dampen.read_scenario(
    "he2017-sampled",
    ["numerics.modes=16", "task.trials=3", "task.trial_duration=0.3", "sampling.period=0.003", "sampling.delay=0.004"],
)  # fmt: skip


def replayed(case: dampen.Scenario, run: dampen.Result, env: BeamEnv) -> list[dict[str, np.ndarray]]:
    """Every step of an environment whose actions are the commands that the run's own law issued."""
    _, info = env.reset()
    steps = []
    for commands in run["issued"][:]:
        for command in commands:
            observation, _, terminated, truncated, info = env.step(command / 100.0)
            steps.append({"observation": observation, **info})
            assert not terminated
    assert truncated
    return steps


@pytest.mark.parametrize("start", ["chained", "reset"])
def test_the_commands_of_the_scenarios_own_law_reproduce_its_run(start: str) -> None:
    case = replace(SAMPLED, task=replace(SAMPLED.task, start=start))
    run = dampen.simulate(case)
    env = BeamEnv(case, command_limit=100.0)
    steps = replayed(case, run, env)
    shape, period = run["issued"][:].shape, 3
    y = np.array([s["displacement"] for s in steps]).reshape(shape)
    ended = np.array([s["trial_ended"] for s in steps]).reshape(shape[:2])
    np.testing.assert_array_equal(ended, np.arange(shape[1])[None] == shape[1] - 1 + np.zeros((shape[0], 1)))
    np.testing.assert_allclose(y[:, :-1], run["y"][:][:, period:-period:period], rtol=0, atol=1e-9)
    np.testing.assert_allclose(y[-1, -1], run["y"][-1, -1], rtol=0, atol=1e-9)
    seen = np.array([s["observation"] for s in steps]).reshape(*shape[:2], -1)
    np.testing.assert_allclose(seen[:, :-1, :2] * env.scaling.error, run["reading"][:][:, 1:], rtol=0, atol=1e-9)
    np.testing.assert_allclose(seen[:, :-1, 2:4] * env.scaling.rate, run["rate_estimate"][:][:, 1:], rtol=0, atol=1e-9)


def test_the_shipped_sampled_experiment_is_reproduced_over_all_its_steps() -> None:
    case = dampen.read_scenario("he2017-sampled", ["numerics.modes=40"])
    run = dampen.simulate(case)
    steps = replayed(case, run, BeamEnv(case, command_limit=100.0))
    y = np.array([s["displacement"] for s in steps]).reshape(run["issued"][:].shape)
    np.testing.assert_allclose(y[:, :-1], run["y"][:][:, 1:-1], rtol=0, atol=1e-9)


def test_a_continuous_scenario_is_stepped_as_open_loop_commands_step_it() -> None:
    held = {"tip_w": 1.5, "tip_phi": -2.0}
    case = replace(scenario(*FEW), controller=dampen.OpenLoop(command=held), claims=None)
    case = replace(case, task=replace(case.task, constraint={}))
    run = dampen.simulate(case)
    env = BeamEnv(case, command_limit=2.0)
    env.reset()
    found = [env.step(np.array([0.75, -1.0]))[4]["displacement"] for _ in range(200)]
    np.testing.assert_allclose(np.array(found)[:99], run["y"][0, 1:-1], rtol=0, atol=1e-12)
    np.testing.assert_allclose(found[-1], run["y"][1, -1], rtol=0, atol=1e-12)


MOVES = {"tip_w": dampen.Sinusoid(amplitude=0.02, frequency=1.0, ramp=0.1), "tip_phi": dampen.Hold(0.01)}


@pytest.mark.parametrize("start", ["chained", "reset"])
def test_noise_and_a_reference_are_seen_as_the_runs_own_law_sees_them(start: str) -> None:
    sampling = replace(SAMPLED.sampling, noise={"tip_w": 1e-3, "tip_phi": 2e-3}, command_limit={"tip_w": 3.0, "tip_phi": 50.0})
    case = replace(SAMPLED, task=replace(SAMPLED.task, start=start, reference=MOVES), sampling=sampling)
    run = dampen.simulate(case)
    env = BeamEnv(case, command_limit=100.0)
    steps = replayed(case, run, env)
    shape, each = run["issued"][:].shape, 3
    followed, energy = run["reference"][:][:, each:-each:each], run["energy"][:][:, each:-each:each]
    seen = np.array([s["observation"] for s in steps]).reshape(*shape[:2], -1)[:, :-1]
    np.testing.assert_allclose(seen[..., :2] * env.scaling.error + followed, run["reading"][:][:, 1:], rtol=0, atol=1e-9)
    np.testing.assert_allclose(seen[..., 2:4] * env.scaling.rate, run["rate_estimate"][:][:, 1:], rtol=0, atol=1e-9)
    np.testing.assert_allclose(seen[..., 4:6] * env.scaling.error, followed, rtol=0, atol=1e-15)
    told = {name: np.array([s[name] for s in steps]).reshape(*shape[:2], -1)[:, :-1] for name in ("energy", "error", "time")}
    np.testing.assert_allclose(told["energy"][..., 0], energy, rtol=1e-9)
    np.testing.assert_allclose(told["error"], run["y"][:][:, each:-each:each] - followed, rtol=0, atol=1e-9)
    np.testing.assert_allclose(told["time"][0, :, 0], run.time[each:-each:each], rtol=1e-12)
    first = env.reset()[0]
    np.testing.assert_allclose(first[:2] * env.scaling.error + run["reference"][0, 0], run["reading"][0, 0], rtol=0, atol=1e-15)
    np.testing.assert_array_equal(first[2:4], 0.0, "the estimator begins at rest")


@pytest.mark.parametrize(("push", "limits"), [(-20.0, (-0.05, 10.0)), (20.0, (-10.0, 0.17))])
def test_an_episode_ends_at_the_first_step_beyond_either_limit(push: float, limits: tuple[float, float]) -> None:
    case = replace(scenario(*FEW), controller=dampen.OpenLoop(command={"tip_w": push}), claims=None)
    case = replace(case, task=replace(case.task, constraint={"tip_w": limits}))
    y = dampen.simulate(case)["y"][0, 1:, 0]
    first = int(np.argmax((y <= limits[0]) | (y >= limits[1])))
    assert first > 3
    env = BeamEnv(case, command_limit=20.0)
    env.reset()
    assert [env.step(np.array([push / 20.0, 0.0]))[2] for _ in range(first + 1)] == [False] * first + [True]


@pytest.mark.parametrize("name", ["he2017", "he2017-sampled", "flexible-arm-point-to-point"])
def test_the_environment_passes_gymnasiums_checks_without_a_warning(name: str) -> None:
    duration = () if "arm" in name else ("task.trial_duration=0.2", "numerics.modes=12")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        env = gymnasium.make("dampen/Beam-v0", scenario=name, overrides=duration, render_mode="rgb_array")
        check_env(env.unwrapped)
    assert env.render is not None


def test_the_episode_ends_with_the_last_trial_or_at_the_constraint() -> None:
    env = BeamEnv("he2017", overrides=FEW)
    env.reset()
    times = []
    truncated = terminated = False
    while not (truncated or terminated):
        observation, reward, terminated, truncated, info = env.step(np.zeros(2))
        times.append((info["trial"], info["trial_ended"]))
        assert -3 * env.course.share * env.scaling.worst < reward < 0
        assert env.observation_space.contains(observation)
    assert (truncated, terminated, len(times)) == (True, False, 200)
    assert times[99] == (1, True)
    assert times[-1] == (1, True)
    with pytest.raises(dampen.ArgumentError, match="begun with `reset`"):
        env.step(np.zeros(2))

    narrow = BeamEnv("he2017", overrides=[*FEW, "task.constraint={tip_w=0.165, tip_phi=0.2}"])
    narrow.reset()
    total, terminated, count = 0.0, False, 0
    while not terminated:
        _, reward, terminated, truncated, info = narrow.step(np.ones(2))
        total, count = total + reward, count + 1
    assert not truncated
    assert info["crossed"]
    assert max(abs(info["displacement"]) / [0.165, 0.2]) >= 1
    # what was left of two trials counts at the limits of error and effort, of both ports
    assert reward < -(2 - count / 100) * 2 * 1.01
    assert total > -2 * 2 * 1.5


def test_the_return_of_a_trial_is_minus_its_mean_cost() -> None:
    held = {"tip_w": 1.5, "tip_phi": -2.0}
    case = replace(scenario(*FEW), controller=dampen.OpenLoop(command=held), claims=None)
    run = dampen.simulate(case)
    env = BeamEnv(case, command_limit=2.0, error_scale=0.1, effort_weight=0.3, period=0.01)
    env.reset()
    total = sum(env.step(np.array([0.75, -1.0]))[1] for _ in range(20))
    error = np.mean(run["y"][0, 1:] ** 2, axis=0).sum() / 0.1**2
    assert total == pytest.approx(-error - 0.3 * (0.75**2 + 1), rel=1e-9)


def test_a_motion_that_stops_being_finite_ends_the_episode_with_finite_numbers() -> None:
    env = BeamEnv("he2017", overrides=[*FEW, "controller.kind=none", "task.constraint={}"], command_limit=1e25)
    env.reset()
    terminated, steps = False, 0
    while not terminated:
        seen, reward, terminated, _, info = env.step(np.ones(2))
        steps += 1
    assert info["crossed"]
    assert np.isfinite(seen).all()
    assert reward == pytest.approx(-(2 - (steps - 1) / 100) * env.scaling.worst)


def test_a_seed_draws_noise_and_disturbance_and_none_is_the_scenarios_own() -> None:
    noisy = replace(
        SAMPLED,
        disturbance=dampen.Sum(terms=(dampen.BandNoise(rms={"tip_w": 0.2}, low=1.0, high=20.0), dampen.HarmonicFamilies())),
        task=replace(SAMPLED.task, start="reset", reset_error={"tip_w": 1e-3}),
    )

    def episode(env: BeamEnv, **how: int) -> np.ndarray:
        return np.array([env.reset(**how)[0], *(env.step(np.zeros(2))[0] for _ in range(150))])

    env, other = BeamEnv(noisy), BeamEnv(noisy)
    own = episode(env)
    np.testing.assert_array_equal(own, episode(env))
    seeded = episode(env, seed=5)
    np.testing.assert_array_equal(seeded, episode(other, seed=5))
    second = episode(env)
    np.testing.assert_array_equal(second, episode(other))
    assert min(np.abs(a - b).max() for a, b in ((own, seeded), (seeded, second))) > 1e-3


@pytest.mark.parametrize("threads", [1, 2])
def test_environments_side_by_side_are_the_single_ones(threads: int) -> None:
    many = BeamVectorEnv(5, SAMPLED, threads=threads, command_limit=8.0)
    singles = [BeamEnv(SAMPLED, command_limit=8.0) for _ in range(5)]
    gains = np.linspace(0.0, 4.0, 5)[:, None]
    seen, _ = many.reset(seed=3)
    alone = np.array([env.reset(seed=3 + i)[0] for i, env in enumerate(singles)])
    over = np.zeros(5, bool)
    for _ in range(320):  # three trials of 100 samples, and on into the next episodes
        np.testing.assert_array_equal(seen, alone)
        actions = -gains * seen[:, 2:4]
        seen, reward, terminated, truncated, info = many.step(actions)
        for i, env in enumerate(singles):
            if over[i]:
                alone[i], over[i] = env.reset()[0], False
                assert reward[i] == 0
                continue
            alone[i], one_reward, one_terminated, one_truncated, one = env.step(actions[i])
            assert (reward[i], terminated[i], truncated[i]) == (one_reward, one_terminated, one_truncated)
            np.testing.assert_array_equal(info["displacement"][i], one["displacement"])
            assert info["trial"][i] == one["trial"]
            over[i] = one_terminated or one_truncated


def test_episodes_begin_anew_in_each_of_gymnasiums_ways() -> None:
    step = {mode: [] for mode in AutoresetMode}
    for mode in AutoresetMode:
        env = BeamVectorEnv(3, "he2017", overrides=[*FEW, "task.trials=1"], autoreset_mode=mode)
        first, _ = env.reset()
        for _ in range(100):
            seen, reward, terminated, truncated, info = env.step(np.zeros((3, 2)))
        assert truncated.all()
        assert not terminated.any()
        if mode is AutoresetMode.SAME_STEP:
            np.testing.assert_array_equal(seen, first)
            assert info["final_obs"][0][-1] == 1.0
            continue
        assert (seen[:, -1] == 1.0).all()
        if mode is AutoresetMode.NEXT_STEP:
            seen, reward, terminated, truncated, info = env.step(np.ones((3, 2)))
            assert not (terminated | truncated).any()
            assert not reward.any()
        else:
            with pytest.raises(dampen.ArgumentError, match="must be begun anew"):
                env.step(np.zeros((3, 2)))
            seen, _ = env.reset(options={"reset_mask": np.ones(3, bool)})
        np.testing.assert_array_equal(seen, first)
        step[mode].append(seen)


def test_gymnasium_makes_the_vector_that_steps_in_one_call() -> None:
    env = gymnasium.make_vec("dampen/Beam-v0", num_envs=4, vectorization_mode="vector_entry_point", overrides=FEW)
    assert isinstance(env.unwrapped, BeamVectorEnv)
    seen, _ = env.reset(seed=0)
    assert env.observation_space.contains(seen)
    assert env.step(env.action_space.sample())[0].shape == (4, 5)


def test_plain_python_steps_as_the_compiled_windows_do(monkeypatch: pytest.MonkeyPatch) -> None:
    case = replace(SAMPLED, numerics=replace(SAMPLED.numerics, modes=4))
    runs = []
    for plain in (False, True):
        if plain:
            monkeypatch.setattr("dampen.gym.stepper.compiled_windows", Composition.bind_windows)
        env = BeamEnv(case)
        env.course.stepper.fleet = as_records(env.course.stepper.fleet) if plain else env.course.stepper.fleet
        runs.append([env.reset()[0], *(env.step(np.array([0.3, -0.2]))[0] for _ in range(20))])
    np.testing.assert_allclose(runs[1], runs[0], rtol=0, atol=1e-12)


def as_records(fleet):  # type: ignore[no-untyped-def]
    """Records whose fields are attributes, as plain Python needs them."""
    return fleet._replace(**{name: getattr(fleet, name).view(np.recarray) for name in ("modal", "ports", "stages")})


@pytest.mark.parametrize("name", shipped())
def test_every_shipped_scenario_has_scales_of_its_own(name: str) -> None:
    env = BeamEnv(name, overrides=["numerics.modes=6"])
    for scale in (env.scaling.command, env.scaling.error, env.scaling.rate):
        assert scale.shape == env.action_space.shape
        assert np.all((scale > 1e-4) & (scale < 1e4))


def test_a_picture_shows_the_structure() -> None:
    env = BeamEnv("he2017", overrides=FEW, render_mode="rgb_array")
    env.reset()
    picture = env.render()
    assert picture.shape == (300, 400, 3)
    assert picture.dtype == np.uint8
    assert 0 < np.mean(picture < 128) < 0.5


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"period": 0.0007}, "`sampling.period` must"),
        ({"command_limit": {"tip": 1.0}}, "`command_limit.tip` is not a port"),
        ({"command_limit": -1.0}, "`command_limit.tip_w` must be a number > 0"),
        ({"effort_weight": -1.0}, "`effort_weight` must be a number >= 0"),
        ({"effort_weight": "much"}, "`effort_weight` must be a number >= 0"),
        ({"period": "often"}, "`period` must be a number of seconds > 0"),
        ({"scenario": "he2018"}, "did you mean"),
        ({"scenario": None}, "`scenario` must be a Scenario, the name of a shipped one or the path of a file, but is None"),
        ({"overrides": "task.trials=1"}, "`overrides` must be a list of KEY=VALUE, but is 'task.trials=1'"),
        ({"scenario": SAMPLED, "overrides": ["task.trials=1"]}, "`overrides` must be left out"),
        ({"render_mode": "human"}, "`render_mode` must"),
        ({"overrides": ["controller.kind=none", "task.constraint={}"]}, "`command_limit.tip_w` must be given"),
    ],
)
def test_wrong_arguments_are_told_in_one_line(arguments: dict[str, object], said: str) -> None:
    with pytest.raises(dampen.ArgumentError, match=said) as error:
        BeamEnv(**arguments)  # type: ignore[arg-type]
    assert len(error.value.lines) == 1


@pytest.mark.parametrize("action", [np.array([np.nan, 0.0]), np.zeros((2, 1)), np.zeros(3), 0.5, "ab", None, [0.0, [1.0]]])
def test_an_action_that_is_no_number_is_refused(action: object) -> None:
    env = BeamEnv("he2017", overrides=FEW)
    env.reset()
    with pytest.raises(dampen.ArgumentError, match="2 finite numbers") as error:
        env.step(action)  # type: ignore[arg-type]
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"num_envs": True}, "`num_envs` must be a whole number"),
        ({"autoreset_mode": "next"}, "`autoreset_mode` must be one of NextStep, SameStep, Disabled, but is 'next'"),
        ({"render_mode": "rgb_array"}, "`render_mode` must be left out"),
    ],
)
def test_wrong_arguments_of_a_vector_are_told_in_one_line(arguments: dict[str, Any], said: str) -> None:
    with pytest.raises(dampen.ArgumentError, match=said) as error:
        BeamVectorEnv(scenario="he2017", overrides=FEW, **arguments)
    assert len(error.value.lines) == 1


def test_a_seed_that_is_no_whole_number_is_refused_for_a_vector() -> None:
    with pytest.raises(dampen.ArgumentError, match=r"`seed` must be one whole number or 2, but is 1\.5"):
        BeamVectorEnv(2, "he2017", overrides=FEW).reset(seed=1.5)  # type: ignore[arg-type]


def test_limits_may_be_numbers_of_numpy() -> None:
    env = BeamEnv("he2017", overrides=FEW, command_limit=np.float32(3), error_scale={"tip_w": np.int64(1), "tip_phi": 2})
    np.testing.assert_array_equal(env.scaling.command, [3, 3])
    np.testing.assert_array_equal(env.scaling.error, [1, 2])


@pytest.mark.parametrize("copied", [copy.deepcopy, lambda env: pickle.loads(pickle.dumps(env))])
def test_a_copy_goes_on_as_the_environment_would_have(copied: Callable[[Any], Any]) -> None:
    """In the middle of the second trial, noise, disturbance and the generator of coming seeds included."""
    noisy = replace(SAMPLED, disturbance=dampen.BandNoise(rms={"tip_w": 0.2}, low=1.0, high=20.0))
    many, one = BeamVectorEnv(3, noisy, threads=2, command_limit=8.0), BeamEnv(noisy, command_limit=8.0)

    def steps(both: tuple[BeamVectorEnv, BeamEnv], count: int, seen: Any) -> list[Any]:
        found = [seen]
        for _ in range(count):
            found.append((both[0].step(-2 * found[-1][0][:, 2:4])[0], both[1].step(-2 * found[-1][1][2:4])[0]))
        return found

    last = steps((many, one), 130, (many.reset(seed=5)[0], one.reset(seed=5)[0]))[-1]
    others = copied(many), copied(one)
    ways = [[*steps(both, 100, last), (both[0].reset()[0], both[1].reset()[0])] for both in ((many, one), others)]
    for a, b in zip(*ways, strict=True):
        np.testing.assert_array_equal(a[0], b[0])
        np.testing.assert_array_equal(a[0][0], a[1])
        np.testing.assert_array_equal(a[1], b[1])


@pytest.mark.parametrize("threads", [1, 2])
def test_a_vector_may_be_closed_twice_and_says_so_afterwards(threads: int) -> None:
    env = BeamVectorEnv(3, "he2017", overrides=FEW, threads=threads)
    env.reset()
    env.close()
    env.close()
    for again in (env.reset, lambda: env.step(np.zeros((3, 2)))):
        with pytest.raises(gymnasium.error.ClosedEnvironmentError, match="have been closed"):
            again()


def test_more_than_the_memory_should_hold_is_refused() -> None:
    with pytest.raises(dampen.ArgumentError, match="`num_envs` must be smaller"):
        BeamVectorEnv(40_000, "he2017", overrides=FEW)


def test_without_gymnasium_one_line_says_what_to_install() -> None:
    code = "import sys; sys.modules['gymnasium'] = None; import dampen.gym"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stderr.splitlines()[-1]
    assert told == "ImportError: `dampen.gym` needs gymnasium: pip install 'dampen[gym]'."


def test_a_few_generations_find_gains_that_beat_no_control() -> None:
    sys.path.insert(0, str(Path(__file__).parents[1] / "examples"))
    try:
        import gym_policy
    finally:
        sys.path.pop(0)
    without, found, gains = gym_policy.search(generations=4, trials=2)
    assert found > without + 1.0, gains
    rms = [gym_policy.error_of(g, trials=2) for g in (np.zeros(4), gains)]
    assert rms[1] < 0.5 * rms[0]
