"""Many runs of one scenario, each with its own clock, moved a sample period at a time by one compiled call."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from dampen.component import wrong
from dampen.controllers.base import Array, Setting
from dampen.gym.drawn import drawn
from dampen.simulation.bench import Bench
from dampen.simulation.compose import compiled_windows
from dampen.simulation.digital import Sampler
from dampen.simulation.digital_side import begin_again, prepare, sampler_of
from dampen.simulation.kernel import MODAL, PORT, STAGE, Step
from dampen.simulation.passes import law_of
from dampen.simulation.records import aligned, empty_record, on_cache_line, port_records
from dampen.simulation.scenario import LARGEST_TRIAL, Scenario
from dampen.simulation.setting import of_trial, setting_of
from dampen.simulation.windows import LOOK, MOVE, REST, Bank, Bay, Fleet, Gear

OWN_SAMPLER = ("e_hat", "v_hat", "state", "begun", "error", "rate", "issued")


class Stepper:
    """`count` runs of a scenario with a seat for a policy.

    fleet:  the runs' arrays; see :class:`dampen.simulation.windows.Fleet`.
    trial:  (count,) the trial that each is in.
    samples: of a trial.

    Rows of what trials bring are shared where every run meets the same and there are more runs than different trials.
    """

    def __init__(self, scenario: Scenario, count: int = 1, threads: int = 1):
        self.scenario, self.count = scenario, count
        self.bench = Bench(scenario)
        self.setting = setting_of(scenario, bench=self.bench)
        self.law = law_of(scenario, {}, self.setting)
        self.samples, self.trials = self.setting.steps, scenario.task.trials
        self.scenarios, self.benches = [scenario] * count, [self.bench] * count
        self.trial = np.zeros(count, int)
        composition, self.classes = self.bench.composition(scenario)
        self.kernel = compiled_windows(composition)
        self.chains = [scenario.chain(p) for p in range(len(scenario.ports))]
        plain = sampler_of(scenario, self.setting)
        self.gear, self.fleet = self._gear(plain), self._fleet(plain)
        self.samplers = [
            plain._replace(**{name: getattr(self.fleet, name)[i] for name in OWN_SAMPLER}) for i in range(count)
        ]  # fmt: skip
        self.alike = [self._alike(j) for j in range(self.trials)]
        fixed = drawn(scenario, np.random.default_rng()).disturbance == scenario.disturbance
        self.shared = fixed and len(set(self.alike)) <= count
        self.filled: dict[int, int] = {}
        rows = len(set(self.alike)) if self.shared else count
        size = (rows * scenario.steps * (self.bench.modes.count + 60) * 8 + count * MODAL.itemsize) / 2**30
        if size > LARGEST_TRIAL:
            raise wrong("num_envs", f"be smaller: so many would need {size:.3g} GiB", count)
        self.bank = self._bank(rows)
        self.bays = [self._bay() for _ in range(min(threads, count))]
        self.pool = ThreadPoolExecutor(len(self.bays)) if len(self.bays) > 1 else None

    def reset(self, i: int, random: np.random.Generator | None = None) -> None:
        """Run i back to the beginning of trial 0; with `random`, under seeds drawn from it."""
        self._seat(i, self.scenario if random is None else drawn(self.scenario, random))
        self.fleet.command[i], self.fleet.crossed[i] = 0.0, 0
        self._begin(i, 0)

    def __reduce__(self) -> tuple[Any, ...]:
        """Made anew and filled with what the arrays hold: kernel, benches and threads are not copied."""
        made = self.scenario, self.count, len(self.bays)
        return restored, (made, self.trial, self.scenarios, self.filled, tuple(self.fleet), tuple(self.bank))

    def _seat(self, i: int, found: Scenario) -> None:
        """Run i is of this scenario from now on."""
        base = self.scenario
        same = (found.disturbance, found.task) == (base.disturbance, base.task)
        self.scenarios[i], self.benches[i] = found, self.bench if same else Bench(found, self.bench.modes, keep=0)

    def advance(self) -> None:
        """Move every run that has MOVE in `fleet.todo`; those with LOOK only read their sensors."""
        ends = [self.count * n // len(self.bays) for n in range(len(self.bays) + 1)]

        def part(n: int) -> None:
            self.kernel(self.fleet, self.bank, self.gear, self.bays[n], ends[n], ends[n + 1])

        if self.pool is None:
            part(0)
        else:
            list(self.pool.map(part, range(len(self.bays))))

    def close(self) -> None:
        """Let go of the threads."""
        if self.pool is not None:
            self.pool.shutdown()

    def ended(self) -> Array:
        """(count,) runs that are at the end of a trial."""
        return self.fleet.at == self.samples

    def next_trial(self, i: int) -> None:
        """Run i from the end of a trial to the beginning of the next."""
        self._begin(i, int(self.trial[i]) + 1)

    def look(self, which: Array) -> None:
        """Let some runs, (count,) true, read their sensors anew."""
        self.fleet.todo[:] = np.where(which, LOOK, REST)
        self.advance()

    def move(self, which: Array) -> None:
        """Move some runs, (count,) true, a sample period on."""
        self.fleet.todo[:] = np.where(which, MOVE, REST)
        self.advance()

    def _begin(self, i: int, trial: int) -> None:
        """What a trial begins with: the state or what is left of it, noise, and all that shakes."""
        fleet, scenario, bench = self.fleet, self.scenarios[i], self.benches[i]
        self.trial[i], fleet.at[i] = trial, 0
        if trial == 0 or scenario.task.start == "reset":
            fleet.modal[i] = bench.modal_record(trial)[0]
            fleet.ports[i], fleet.stages[i] = port_records(self.chains, bench.step, self.classes)
            fleet.ports[i]["soft"] = 0.0
            begin_again(self.samplers[i])
        setting = of_trial(self.setting, scenario, trial)
        fleet.noise[i] = prepare(self.samplers[i], scenario, setting, self.law, trial).noise
        key = self.alike[trial]
        new = not (self.shared and key in self.filled)
        fleet.row[i] = self.filled.setdefault(key, len(self.filled)) if self.shared else i
        if new:
            self._fill(int(fleet.row[i]), scenario, bench, setting, trial)

    def _fill(self, row: int, scenario: Scenario, bench: Bench, setting: Setting, trial: int) -> None:
        """Write down what a trial brings."""
        inputs = bench.inputs(scenario, trial, self.law)
        for name in ("disturbance", "load", "drift", "low", "high"):
            getattr(self.bank, name)[row] = getattr(inputs, name)
        self.bank.along[row], self.bank.reference[row] = scenario.reference(trial), setting.reference

    def _alike(self, trial: int) -> int:
        """The first trial that brings the same."""
        return self.scenario.disturbance.same_as(trial) if self.scenario.task.steady else trial

    def _gear(self, plain: Sampler) -> Gear:
        ports = len(self.scenario.ports)
        return Gear(
            plain.period, plain.delay, plain.ahead, plain.seconds, plain.quantum, plain.gain_1, plain.gain_2, plain.ceiling,
            idle=np.zeros((plain.period, ports)), blank=np.zeros((1, ports)),
        )  # fmt: skip

    def _fleet(self, plain: Sampler) -> Fleet:
        n, ports, samples = self.count, len(self.scenario.ports), self.samples
        stages = max(1, sum(map(len, self.chains)))
        by_port = {name: np.zeros((n, ports)) for name in ("command", "seen_error", "seen_rate", "y", "square", "effort")}
        whole = {name: np.zeros(n, int) for name in ("todo", "row", "at", "crossed")}
        own = {name: np.zeros((n, *getattr(plain, name).shape)) for name in OWN_SAMPLER}
        return Fleet(
            modal=on_cache_line(n * MODAL.itemsize).view(MODAL),
            ports=np.zeros((n, ports), PORT),
            stages=np.zeros((n, stages), STAGE),
            noise=np.zeros((n, samples + 1, ports)),
            energy=np.zeros(n),
            **by_port,
            **whole,
            **own,
        )

    def _bank(self, rows: int) -> Bank:
        steps, ports = self.scenario.steps, len(self.scenario.ports)
        disturbance, drift, low, high = (np.zeros((rows, steps, ports)) for _ in range(4))
        load = np.zeros((rows, steps, self.bench.modes.count))
        times, at_samples = np.zeros((rows, steps + 1, ports)), np.zeros((rows, self.samples + 1, ports))
        return Bank(disturbance, load, drift, low, high, times, at_samples)

    def _bay(self) -> Bay:
        ports, step = len(self.scenario.ports), self.bench.step
        own = Step(step.dt, step.per_dt, step.b, step.g, aligned(step.g))
        record = empty_record(self.gear.period, ports, self.bench.modes.count, self.gear.period + 1)
        return Bay(own, record, np.zeros(ports), np.zeros(ports), np.zeros(1), np.zeros((1, ports)))


def restored(
    made: tuple[Scenario, int, int], trial: Array, scenarios: Sequence[Scenario], filled: Mapping[int, int],
    fleet: Sequence[Array], bank: Sequence[Array],
) -> Stepper:  # fmt: skip
    """A stepper as it was: the arrays are written into its own, which its parts share."""
    stepper = Stepper(*made)
    stepper.filled.update(filled)
    for i, scenario in enumerate(scenarios):
        stepper._seat(i, scenario)
    own = (stepper.trial, *stepper.fleet, *stepper.bank)
    for array, kept in zip(own, (trial, *fleet, *bank), strict=True):
        array[...] = kept
    return stepper
