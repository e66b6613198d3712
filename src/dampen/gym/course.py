"""Episodes of many runs: commands in, observations, rewards, endings and what there is to know beside them out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from gymnasium.spaces import Box

from dampen.component import ArgumentError, is_whole, wrong
from dampen.controllers.base import Array
from dampen.gym.scaling import EFFORT, FARTHEST, ByPort, scaling_of
from dampen.gym.stepper import Stepper
from dampen.scenarios.read import read_scenario
from dampen.simulation.scenario import Scenario
from dampen.simulation.seat import seated


@dataclass(frozen=True)
class Outcome:
    """What a step brought, a row for each run; see :class:`dampen.gym.environment.BeamEnv`."""

    observation: Array
    reward: Array
    terminated: Array
    truncated: Array
    trial_ended: Array


class Course:
    """`count` episodes side by side; the arguments are those of the environments."""

    def __init__(
        self,
        scenario: Scenario | str | Path,
        count: int = 1,
        threads: int = 1,
        *,
        overrides: Sequence[str] = (),
        period: float | None = None,
        command_limit: ByPort | None = None,
        error_scale: ByPort | None = None,
        effort_weight: float = EFFORT,
    ):
        for name, number in (("num_envs", count), ("threads", threads)):
            if not (is_whole(number) and number >= 1):
                raise wrong(name, "be a whole number >= 1", number)
        if not isinstance(scenario, Scenario | str | Path):
            raise wrong("scenario", "be a Scenario, the name of a shipped one or the path of a file", scenario)
        if isinstance(overrides, str):
            raise wrong("overrides", "be a list of KEY=VALUE", overrides)
        if not isinstance(scenario, Scenario):
            scenario = read_scenario(scenario, overrides)
        elif overrides:
            raise ArgumentError("Argument `overrides` must be left out where `scenario` is a Scenario already.")
        self.scenario = seated(scenario, period)
        self.stepper = Stepper(self.scenario, count, threads)
        self.scaling = scaling_of(self.scenario, self.stepper.setting, command_limit, error_scale, effort_weight)
        self.references = bool(self.scenario.task.reference)
        ports, duration = len(self.scenario.ports), self.scenario.task.trial_duration
        self.share = self.scenario.sampling.period / duration  # of a trial, in a step
        self.count = count
        self.action_space = Box(-1.0, 1.0, (ports,), np.float64)
        wide = np.full((3 if self.references else 2) * ports, FARTHEST)
        self.observation_space = Box(np.append(-wide, 0.0), np.append(wide, 1.0), dtype=np.float64)

    def reset(self, i: int, random: np.random.Generator | None) -> None:
        """Run i back to the beginning; its sensors are read by the next `observe`."""
        self.stepper.reset(i, random)

    def observe(self, which: Array) -> Array:
        """Read the sensors of some runs, (count,) true, anew; (count, numbers) of all."""
        self.stepper.look(which)
        return self.observation()

    def observation(self) -> Array:
        """(count, numbers): errors, their rates, references if there are any, and the share of the trial that is over."""
        fleet, bank, scale = self.stepper.fleet, self.stepper.bank, self.scaling
        parts = [fleet.seen_error / scale.error, fleet.seen_rate / scale.rate]
        if self.references:
            parts.append(bank.reference[fleet.row, fleet.at] / scale.error)
        parts.append(np.minimum(fleet.at * self.share, 1.0)[:, None])
        known = np.minimum(np.maximum(np.concatenate(parts, axis=1), -FARTHEST), FARTHEST)
        return np.nan_to_num(known) if (fleet.crossed > 1).any() else known

    def step(self, actions: Any, which: Array) -> Outcome:
        """Move some runs, (count,) true, by a sample period under actions (count, ports) in [-1, 1]; others rest."""
        stepper, fleet = self.stepper, self.stepper.fleet
        actions = self.checked(actions, which)
        fleet.command[which] = (np.minimum(np.maximum(actions, -1.0), 1.0) * self.scaling.command)[which]
        stepper.move(which)
        reward = np.where(which, -self.share * self.scaling.cost(fleet.square, fleet.effort), 0.0)
        terminated, ended = which & (fleet.crossed > 0), which & stepper.ended()
        truncated = ended & ~terminated & (stepper.trial == stepper.trials - 1)
        if terminated.any():
            reward = np.where(terminated, self.of_the_lost(reward), reward)
        again = ended & ~terminated & ~truncated
        if again.any():
            for i in np.flatnonzero(again):
                stepper.next_trial(int(i))
            stepper.look(again)
        return Outcome(self.observation(), reward, terminated, truncated, ended)

    def checked(self, given: Any, which: Array) -> Array:
        """Actions (count, ports), those that count finite."""
        shape = self.stepper.fleet.command.shape
        must = f"be {shape[1]} finite numbers for every environment"
        try:
            actions = np.asarray(given, float)
        except (TypeError, ValueError):
            raise wrong("action", must, given) from None
        if actions.shape != shape or not np.isfinite(actions[which]).all():
            raise wrong("action", must, actions.tolist())
        return actions

    def of_the_lost(self, reward: Array) -> Array:
        """(count,) rewards of steps that end at the constraint: all that was left of the episode counts as spent at the limits.

        A motion that stopped being finite has no cost of its own for the last step.
        """
        stepper, fleet = self.stepper, self.stepper.fleet
        left = stepper.trials - stepper.trial - fleet.at * self.share
        diverged = fleet.crossed > 1
        return np.asarray(np.where(diverged, 0.0, reward) - (left + diverged * self.share) * self.scaling.worst)

    def told(self) -> dict[str, Array]:
        """What there is to know of all runs beside the observation, (count, ...)."""
        stepper, fleet = self.stepper, self.stepper.fleet
        along = stepper.bank.along[fleet.row, fleet.at * stepper.gear.period]
        period = self.scenario.sampling.period
        return {
            "trial": stepper.trial.copy(), "time": fleet.at * period, "displacement": fleet.y + along, "error": fleet.y.copy(),
            "command": fleet.command.copy(), "energy": fleet.energy.copy(), "crossed": fleet.crossed > 0,
        }  # fmt: skip

    def one(self, i: int) -> dict[str, Any]:
        """The same of run i alone."""
        told = {name: values[i] for name, values in self.told().items()}
        return {name: value.item() if np.ndim(value) == 0 else value for name, value in told.items()}
