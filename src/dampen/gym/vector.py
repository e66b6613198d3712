"""Many environments that step in one compiled call."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
from gymnasium.error import ClosedEnvironmentError
from gymnasium.utils.seeding import np_random
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from dampen.component import ArgumentError, wrong
from dampen.controllers.base import Array
from dampen.gym.course import Course, Outcome
from dampen.gym.scaling import EFFORT, ByPort, Scaling
from dampen.simulation.scenario import Scenario


class BeamVectorEnv(VectorEnv[Array, Array, Array]):
    """`num_envs` times :class:`dampen.gym.environment.BeamEnv`, each with its own clock, on `threads` threads.

    gymnasium.make_vec("dampen/Beam-v0", num_envs=64, vectorization_mode="vector_entry_point", scenario="he2017"). With the
    seed s, environment i is the single one with the seed s + i. `info` holds one array for each key, a row an environment.

    autoreset_mode: NEXT_STEP (the step after an episode's last begins the next, its action unused), SAME_STEP (the last step
    returns the first observation of the next, and its own as `info["final_obs"]`), or DISABLED (`reset` with
    `options={"reset_mask": ...}` begins those that are over).
    """

    def __init__(
        self,
        num_envs: int = 1,
        scenario: Scenario | str | Path = "he2017",
        *,
        overrides: Sequence[str] = (),
        period: float | None = None,
        command_limit: ByPort | None = None,
        error_scale: ByPort | None = None,
        effort_weight: float = EFFORT,
        threads: int = 1,
        autoreset_mode: AutoresetMode = AutoresetMode.NEXT_STEP,
        render_mode: None = None,
    ):
        if render_mode is not None:
            raise wrong("render_mode", "be left out for a vector", render_mode)
        self.course = Course(
            scenario, num_envs, threads, overrides=overrides, period=period, command_limit=command_limit,
            error_scale=error_scale, effort_weight=effort_weight,
        )  # fmt: skip
        self.num_envs, self.render_mode, self.spec = num_envs, None, None
        try:
            self.autoreset_mode = AutoresetMode(autoreset_mode)
        except ValueError:
            known = ", ".join(mode.value for mode in AutoresetMode)
            raise wrong("autoreset_mode", f"be one of {known}", autoreset_mode) from None
        self.metadata = {"autoreset_mode": self.autoreset_mode, "render_modes": []}
        self.single_action_space, self.single_observation_space = self.course.action_space, self.course.observation_space
        self.action_space: gymnasium.Space[Array] = batch_space(self.single_action_space, num_envs)
        self.observation_space: gymnasium.Space[Array] = batch_space(self.single_observation_space, num_envs)
        self._random: list[np.random.Generator | None] = [None] * num_envs
        self._over = np.ones(num_envs, bool)
        self._begun = False

    @property
    def scaling(self) -> Scaling:
        """By port, what counts as 1 in actions and observations."""
        return self.course.scaling

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Array, dict[str, Any]]:
        """All environments, or those in the option `reset_mask` (num_envs,), back to the beginning of trial 0."""
        self._open()
        mask = np.asarray((options or {}).get("reset_mask", np.ones(self.num_envs, bool)), bool)
        if mask.shape != (self.num_envs,):
            raise wrong("options.reset_mask", f"have {self.num_envs} entries", list(mask.shape))
        if not (self._begun or mask.all()):
            raise ArgumentError("All environments must be begun with `reset` before some of them.")
        seeds = [None] * self.num_envs if seed is None else seed
        seeds = [int(seeds) + i for i in range(self.num_envs)] if isinstance(seeds, int | np.integer) else seeds
        if not (isinstance(seeds, Sequence | np.ndarray) and len(seeds) == self.num_envs):
            raise wrong("seed", f"be one whole number or {self.num_envs}", seeds)
        for i in np.flatnonzero(mask):
            one = seeds[int(i)]
            self._random[i] = self._random[i] if one is None else np_random(int(one))[0]
        self._begun = True
        return self._begin(mask), self._info(np.zeros(self.num_envs, bool))

    def step(self, actions: Array) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """Hold actions (num_envs, ports) for a sample period."""
        self._open()
        if not self._begun:
            raise ArgumentError("The episodes must be begun with `reset` before a `step`.")
        over = self._over.copy()
        if over.any() and self.autoreset_mode is AutoresetMode.DISABLED:
            raise ArgumentError("Episodes that are over must be begun anew with `reset`: `autoreset_mode` is DISABLED.")
        outcome = self.course.step(actions, ~over)
        self._over = outcome.terminated | outcome.truncated
        observation = outcome.observation
        info = self._info(outcome.trial_ended)
        if over.any():  # only where the mode is NEXT_STEP
            observation = self._begin(over)
            info = self._info(outcome.trial_ended)
        if self._over.any() and self.autoreset_mode is AutoresetMode.SAME_STEP:
            observation, info = self._same_step(outcome)
        return observation, outcome.reward, outcome.terminated, outcome.truncated, info

    def close_extras(self, **kwargs: Any) -> None:
        """Let go of the threads."""
        self.course.stepper.close()

    def _open(self) -> None:
        if self.closed:
            raise ClosedEnvironmentError("The environments have been closed: `reset` and `step` need them open.")

    def _begin(self, which: Array) -> Array:
        """Begin new episodes where `which` is true; the observations of all."""
        for i in np.flatnonzero(which):
            self.course.reset(int(i), self._random[i])
        self._over[which] = False
        return self.course.observe(which)

    def _same_step(self, outcome: Outcome) -> tuple[Array, dict[str, Any]]:
        """The next episodes begun, with what the last ones ended on as `final_obs` and `final_info`."""
        over = self._over.copy()
        final = np.empty(self.num_envs, object)
        for i in np.flatnonzero(over):
            final[i] = outcome.observation[i].copy()
        last = {name: values for name, values in self._info(outcome.trial_ended).items() if not name.startswith("_")}
        observation = self._begin(over)
        return observation, {**self._info(outcome.trial_ended), "final_obs": final, "_final_obs": over, "final_info": last,
                             "_final_info": over.copy()}  # fmt: skip

    def _info(self, trial_ended: Array) -> dict[str, Any]:
        """One array for each key, and which rows count: all."""
        told = {**self.course.told(), "trial_ended": trial_ended.copy()}
        return told | {f"_{name}": np.ones(self.num_envs, bool) for name in told}
