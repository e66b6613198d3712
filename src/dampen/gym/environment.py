"""One scenario as a Gymnasium environment."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np

from dampen.component import ArgumentError, wrong
from dampen.controllers.base import Array
from dampen.gym.course import Course
from dampen.gym.scaling import EFFORT, ByPort, Scaling
from dampen.simulation.scenario import Scenario


class BeamEnv(gymnasium.Env[Array, Array]):
    """A policy in place of a scenario's law: `gymnasium.make("dampen/Beam-v0", scenario="he2017")`.

    The simulation is the library's own, one sample period a step. A policy's action is the command; between it and the structure
    stand what the scenario has there: the law's compensation of the actuators, delay, command limits, actuators, disturbances.

    action:       (ports,) in [-1, 1], times `command_limit` [N, N m].
    observation:  by port the tracking error as a controller reads it (noise, quantiser) over its scale; by port its estimated
                  rate over its scale; then, where the task has a reference, by port the reference over the error's scale; then
                  the share of the trial that is over, 0 to 1. At most 100 in size. The scales are in the attribute `scaling`.
    reward:       -(period/T_b) sum over ports of  mean (e/scale)^2 + effort_weight mean (u/limit)^2,  the means over the period
                  and the true error: a trial's return is minus its mean cost.
    terminated:   a port left its constraint; the reward then counts error and effort at their limits for all the time
                  that was left, so that crossing never pays.
    truncated:    the last trial is over.
    info:         trial, time in it [s], trial_ended (the step was the last of its trial; `trial` and observation are then
                  the next one's), true displacement and error at the ports [m, rad], command as it was handed in [N, N m],
                  energy [J], crossed.

    scenario:      a Scenario, the name of a shipped one, or the path of a file; `overrides` as on the command line.
    period:        [s] between actions; left out: the scenario's sample period, or its time step where the law is continuous,
                   whose sensors are exact.
    command_limit: what an action of 1 means, one number or by port [N, N m]; left out: `sampling.command_limit`, else the static
                   force that bends the structure by the error's scale.
    error_scale:   what an error of 1 means [m, rad]; left out: the room between reference and constraint.

    Every episode is the scenario's own, with its seeds, until `reset` is given a seed: from then on the seeds of noise, reset
    errors and disturbances are drawn. Double precision throughout, so that a run can be replayed.
    """

    metadata: dict[str, Any] = {  # noqa: RUF012  (as Gymnasium declares it)
        "render_modes": ["rgb_array"],
        "render_fps": 50,
    }

    def __init__(
        self,
        scenario: Scenario | str | Path = "he2017",
        *,
        overrides: Sequence[str] = (),
        period: float | None = None,
        command_limit: ByPort | None = None,
        error_scale: ByPort | None = None,
        effort_weight: float = EFFORT,
        render_mode: str | None = None,
    ):
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise wrong("render_mode", 'be "rgb_array" or left out', render_mode)
        self.render_mode = render_mode
        self.course = Course(
            scenario, overrides=overrides, period=period, command_limit=command_limit, error_scale=error_scale,
            effort_weight=effort_weight,
        )  # fmt: skip
        self.action_space, self.observation_space = self.course.action_space, self.course.observation_space
        self._on = np.ones(1, bool)
        self._seeded = self._going = False

    @property
    def scaling(self) -> Scaling:
        """By port, what counts as 1 in actions and observations."""
        return self.course.scaling

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        """Back to the beginning of trial 0; see the class for what a seed does."""
        super().reset(seed=seed)
        self._seeded |= seed is not None
        self.course.reset(0, self.np_random if self._seeded else None)
        self._going = True
        return self.course.observe(self._on)[0], {**self.course.one(0), "trial_ended": False}

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """Hold an action for a sample period."""
        if not self._going:
            raise ArgumentError("The episode must be begun with `reset` before a `step`.")
        outcome = self.course.step([action], self._on)
        terminated, truncated = bool(outcome.terminated[0]), bool(outcome.truncated[0])
        self._going = not (terminated or truncated)
        info = {**self.course.one(0), "trial_ended": bool(outcome.trial_ended[0])}
        return outcome.observation[0], float(outcome.reward[0]), terminated, truncated, info

    def render(self) -> Any:
        """The structure as it is, (height, width, 3) bytes, where `render_mode` is "rgb_array"."""
        if self.render_mode is None:
            return None
        from dampen.gym.picture import picture

        return picture(self.course)
