"""The structure with its sensors and actuators, moved from sample to sample under commands from outside.

The kernel is the ordinary one, called for a sample period at a time on slices of what the trial brings, of what it leaves and
of the sampler's tables. All state is in the records that the kernel carries from trial to trial anyway.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from dampen.simulation.bench import Bench
from dampen.simulation.digital import Sampler
from dampen.simulation.digital_side import begin_again, prepare, readings_of, sampler_of
from dampen.simulation.kernel import Inputs, Record
from dampen.simulation.passes import law_of
from dampen.simulation.records import empty_record, port_records
from dampen.simulation.scenario import Scenario
from dampen.simulation.seat import seated
from dampen.simulation.setting import of_trial, setting_of

Array = np.ndarray


class PlantSide:
    """A scenario without its law.

    setting:  of the current trial.   inputs, record, sampler, ports: its, as the kernel has them; what a trial that broke off
    never came to is NaN.   commands: like the sampler's `issued`, what the law's value was, which is the same unless the outside
    `inverts` the actuators.   at: the coming sample.   steps: done in this trial.   unsettled: steps whose forces did not settle.
    """

    def __init__(self, scenario: Scenario, bench: Bench, inverts: bool = False):
        self.scenario, self.bench, self.inverts = seated(scenario, inverts=inverts), bench, inverts
        self.kernel, self.classes = bench.kernel(self.scenario)
        self.chains = [self.scenario.chain(p) for p in range(len(scenario.ports))]
        self.setting = setting_of(self.scenario, bench=bench)
        self.gains = setting_of(scenario, bench=bench).gains
        self.law = law_of(self.scenario, {}, self.setting)
        self.sampler = sampler_of(self.scenario, self.setting)
        self.commands = np.zeros_like(self.sampler.issued)
        self.period, self.samples = self.sampler.period, self.setting.steps
        ports, modes = len(self.chains), bench.modes.count
        self.record = empty_record(scenario.steps, ports, modes, scenario.output.every)
        self.snapshots = np.zeros((self.period + 1, modes))  # q at every step of a window
        self.command, self.unsettled_now = np.zeros(ports), np.zeros(1)
        self.modal: Any = None
        self.ports: Any = None
        self.stages: Any = None

    def begin(self, trial: int) -> None:
        """To the beginning of a trial."""
        if trial == 0 or self.scenario.task.start == "reset":
            self.modal = self.bench.modal_record(trial)
            self.ports, self.stages = port_records(self.chains, self.bench.step, self.classes)
            self.ports.soft = 0.0
            begin_again(self.sampler)
            self.commands[...] = 0.0
        self.setting = of_trial(self.setting, self.scenario, trial)
        self.sampler = prepare(self.sampler, self.scenario, self.setting, self.law, trial)
        ahead = self.sampler.ahead
        self.commands[:ahead] = self.commands[self.samples :]
        self.inputs = self.bench.inputs(self.scenario, trial, self.law)
        self.along = np.array(self.scenario.reference(trial))
        self.at = self.steps = self.unsettled = 0
        for array in (*self.record, self.sampler.error, self.sampler.rate, self.sampler.issued[ahead:], self.commands[ahead:]):
            array[...] = np.nan

    def read(self) -> Array:
        """(ports,) what the sensors show at the coming sample; after the last one, at the end of the trial."""
        if self.at < self.samples:
            self._through(0)  # no steps: the kernel only reads the sensors
        rows = slice(self.at, self.at + 1)
        return np.asarray(readings_of(self.sampler.error[rows], self.setting.reference[rows])[0])

    def move(self, command: Array, drive: Array) -> bool:
        """Through a sample period; False where the motion has diverged. command (ports,): computed at its beginning; drive
        (ports,): what the actuators get for it where the outside inverts them, else the same."""
        self.command[:] = drive
        self.commands[self.sampler.ahead + self.at] = command
        done = self._through(self.period)
        self.steps += done
        self.at += 1
        self.unsettled += int(self.unsettled_now[0])
        return done == self.period

    def written(self) -> tuple[Record, Sampler, Any]:
        """Record, sampler and ports of the trial as they are where the law's value is the command: its inverses belong to
        what comes after it, whoever computes them."""
        if not self.inverts:
            return self.record, self.sampler, self.ports
        due = self.sampler.ahead + (np.arange(len(self.record.command)) - self.sampler.delay) // self.period
        held = self.commands[due]
        held[self.steps :] = np.nan
        ports = self.ports.copy()
        ports.gain = self.gains
        return self.record._replace(command=held), self.sampler._replace(issued=self.commands), ports

    def _through(self, steps: int) -> int:
        """The kernel on the slices of the coming sample, for so many steps: a period or none."""
        s, begin = self.at, self.at * self.period
        end = begin + steps
        given, held = self.inputs, slice(begin, max(end, begin + 1))
        inputs = Inputs(
            given.feedforward[begin:end], given.coulomb[begin:end], given.disturbance[begin:end], given.load[begin:end],
            given.drift[begin:end], given.low[held], given.high[held], self.along[begin],
        )  # fmt: skip
        known, ends, now = self.sampler, slice(s, s + (2 if steps else 1)), slice(s, s + (1 if steps else 0))
        sampler = known._replace(
            noise=known.noise[ends], reference=known.reference[ends], error=known.error[ends], feedforward=known.feedforward[now],
            coulomb=known.coulomb[now], low=known.low[now], high=known.high[now], rate=known.rate[now],
            issued=known.issued[s : s + known.ahead + 1], parameters=self.command,
        )  # fmt: skip
        left = self.record
        record = Record(
            left.y[begin : end + 1], left.slow[begin : end + 1], left.energy[begin : end + 1], left.v[begin:end],
            left.command[begin:end], left.delivered[begin:end], left.work_load[begin:end], left.dissipated[begin:end],
            self.snapshots, self.unsettled_now,
        )  # fmt: skip
        done = self.kernel(self.modal, self.bench.step, inputs, sampler, self.ports, self.stages, 1, record)
        self._keep_snapshots(begin, steps)
        return int(done)

    def _keep_snapshots(self, begin: int, steps: int) -> None:
        """Those of the window that the scenario asks for."""
        every = self.scenario.output.every
        first = -(-begin // every)
        last = (begin + steps) // every
        if first <= last:
            self.record.q[first : last + 1] = self.snapshots[first * every - begin : steps + 1 : every]
