"""Members of a batch in step: their arrays, stacked for the compiled call that takes them all through a trial."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from dampen.controllers.base import Controller, Setting
from dampen.controllers.pointwise import PointwiseLearning
from dampen.simulation.bench import Bench
from dampen.simulation.compose import compiled_members
from dampen.simulation.digital_side import idle
from dampen.simulation.kernel import COEFFICIENTS, PORT, STAGE, Step
from dampen.simulation.members import Desk, Given, Members
from dampen.simulation.memory import begun
from dampen.simulation.passes import law_of
from dampen.simulation.records import aligned, empty_record, modal_record, port_records
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import of_trial, setting_of
from dampen.simulation.tally import BY_PORT, WHOLE

Array = np.ndarray


def in_step(scenario: Scenario) -> bool:
    """Whether a scenario can be a member: its law acts continuously, and learns point by point or not at all."""
    law = type(scenario.controller)
    hooks = ("begin", "law", "terms", "learn")
    pointwise = issubclass(law, PointwiseLearning) and all(getattr(law, n) is getattr(PointwiseLearning, n) for n in hooks)
    return not scenario.sampled and (pointwise or law.learn is Controller.learn)


def kind_of_member(scenario: Scenario, bench: Bench) -> tuple[Any, ...]:
    """Members that agree in this go through one compiled call: stages, law, trials, numerics, and whether modes are damped."""
    stages = tuple(tuple(map(type, scenario.chain(p))) for p in range(len(scenario.ports)))
    task, law = scenario.task, scenario.controller
    times = task.trials, task.trial_duration, task.start
    return stages, type(law), law.barrier_shape, times, scenario.numerics, bench.modes.damped


class Lockstep:
    """Members of one kind, each with its bench; one thread's work."""

    def __init__(self, scenarios: Sequence[Scenario], benches: Sequence[Bench]):
        self.scenarios, self.benches, self.first = scenarios, benches, scenarios[0]
        self.count, self.ports, self.bench = len(scenarios), len(self.first.ports), benches[0]
        self.steady = all(scenario.task.steady for scenario in scenarios)
        self.settings = self._settings()
        self.kernel = kernel_of(self.first, self.bench)
        self.members, self.desk = self._stacked(), self._desk()
        self.loads = np.zeros((0 if self._share_a_bench else self.count, self.first.steps, self.bench.modes.count + self.ports))
        self._limits: tuple[Array, Array, Array] | None = None

    def trials(self) -> Iterator[tuple[Array, Array]]:
        """Trial after trial, the members' figures: (members, ports, BY_PORT) and (members, WHOLE)."""
        sampler, steps = idle(self.ports), self.first.steps
        for j in range(self.first.task.trials):
            begins = j == 0 or self.first.task.start == "reset"
            if begins:
                self._put_back(j)
            if begins or not self.steady:
                self._write_laws(j)
            by_port, whole = np.zeros((self.count, self.ports, len(BY_PORT))), np.zeros((self.count, len(WHOLE)))
            self.kernel(self.members, self._given(j), self.desk, sampler, steps, by_port, whole)
            yield by_port, whole

    def _settings(self) -> list[Setting]:
        """One for each member; reference and limits are there once where the task is the first one's."""
        first = setting_of(self.first, bench=self.bench)
        return [
            setting_of(scenario, bench=bench, like=first if scenario.task == self.first.task else None)
            for scenario, bench in zip(self.scenarios, self.benches, strict=True)
        ]

    def _stacked(self) -> Members:
        """The members' arrays, empty where each trial or each start writes them."""
        m, steps, ports, modes = self.count, self.first.steps, self.ports, self.bench.modes.count
        held = [self.bench] if self._share_a_bench else self.benches
        learner = isinstance(self.first.controller, PointwiseLearning)
        rows = [self._learning_row(i) for i in range(m)] if learner else [np.zeros((ports, 1))]
        stages = max(1, sum(len(self.first.chain(p)) for p in range(ports)))
        fixed, learned = (m, steps, ports), (m if learner else 1, steps, ports)
        return Members(
            coefficients=np.stack([coefficients(bench) for bench in held]),
            b=np.stack([bench.step.b for bench in held]),
            g=np.stack([bench.step.g for bench in held]),
            q=np.zeros((m, modes)),
            rate=np.zeros((m, modes)),
            ports=np.zeros((m, ports), PORT),
            stages=np.zeros((m, stages), STAGE),
            feedforward=np.zeros(fixed),
            coulomb=np.zeros(fixed),
            learned_feedforward=np.zeros(learned),
            learned_coulomb=np.zeros(learned),
            row=np.stack(rows),
            before=np.zeros((m, ports)),
            alive=np.ones(m),
        )

    @property
    def _share_a_bench(self) -> bool:
        return all(bench is self.bench for bench in self.benches)

    def _learning_row(self, i: int) -> Array:
        law = self.scenarios[i].controller
        assert isinstance(law, PointwiseLearning)
        return np.ascontiguousarray(law.learning_row(self.settings[i]).T, float)

    def _desk(self) -> Desk:
        bench, steps = self.bench, self.first.steps
        rest = np.zeros(bench.modes.count)
        step = Step(bench.step.dt, bench.step.per_dt, *map(aligned, bench.step[2:]))
        record = empty_record(steps, self.ports, bench.modes.count, steps)
        modal = modal_record(bench.modes, bench.motion, step, rest, rest)
        return Desk(modal, step, record, np.zeros((steps, self.ports)), np.zeros((steps, self.ports)))

    def _put_back(self, trial: int) -> None:
        """All members as a trial begins that starts from the initial state."""
        members, (_, classes) = self.members, self.bench.composition(self.first)
        for i, (scenario, bench) in enumerate(zip(self.scenarios, self.benches, strict=True)):
            members.q[i], members.rate[i] = bench.state(trial)
            chains = [scenario.chain(p) for p in range(self.ports)]
            members.ports[i], members.stages[i] = port_records(chains, bench.step, classes)
        members.before[:] = np.nan

    def _write_laws(self, trial: int) -> None:
        """The members' laws without what they have learned, which is all of a law that may change with the trial."""
        members = self.members
        for i, scenario in enumerate(self.scenarios):
            self.settings[i] = setting = of_trial(self.settings[i], scenario, trial) if trial else self.settings[i]
            law = law_of(scenario, begun(scenario, setting), setting)
            members.feedforward[i], members.coulomb[i] = law.feedforward, law.coulomb
            for name in ("damping", "stiffness", "barrier"):
                members.ports[name][i] = getattr(law, name)

    def _given(self, trial: int) -> Given:
        """What the trial brings: once for all members where it is the same for all."""
        reference, low, high = self._limited(trial)
        if self._share_a_bench:
            disturbance, load, drift = (part[None] for part in self.bench.shaking(trial))
        else:
            load = self.loads
            shaken = [bench.shaking(trial, into) for bench, into in zip(self.benches, load, strict=True)]
            disturbance, drift = (np.stack([of_one[i] for of_one in shaken]) for i in (0, 2))
        if np.any(reference):
            drift = drift - np.diff(reference, axis=1) / self.bench.step.dt
        return Given(disturbance, load, drift, low, high, np.ascontiguousarray(reference[:, 0]))

    def _limited(self, trial: int) -> tuple[Array, Array, Array]:
        """Reference and limits of the error, (members or 1, steps + 1, ports)."""
        if self._limits is None or not self.steady:
            alike = all(scenario.task == self.first.task for scenario in self.scenarios)
            scenarios = self.scenarios[:1] if alike else self.scenarios
            reference = np.stack([scenario.reference(trial) for scenario in scenarios])
            low, high = (np.stack(side) for side in zip(*(scenario.limits(trial) for scenario in scenarios), strict=True))
            self._limits = reference, low - reference, high - reference
        return self._limits


def kernel_of(scenario: Scenario, bench: Bench) -> Any:
    """The compiled call for members of the scenario's kind."""
    law = scenario.controller
    relearn = type(law).relearn if isinstance(law, PointwiseLearning) else None
    composition, _ = bench.composition(scenario)
    return compiled_members(composition, relearn)


def coefficients(bench: Bench) -> Array:
    """(rows, modes) of the modal record, as `members.take` reads them."""
    record = bench.modal_record()
    return np.stack([record[name][0, : bench.modes.count] for name in COEFFICIENTS])
