"""A batch: many parameter sets of one scenario, side by side, of which only figures of merit are kept.

Members go through the trials in step, some at a time: in each trial one compiled call takes them through the very kernel that a
single run uses, and lets them learn. What they share (modes, loads) is there once. A changed plant is put on the fixed
basis of the nominal one, which carries its loads. Laws that learn in Python, and sampled ones, go member by member.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

import numpy as np

from dampen.component import ArgumentError
from dampen.plants.fixed_basis import FixedBasis
from dampen.simulation.bench import Bench
from dampen.simulation.compiled import bind, compiled
from dampen.simulation.kernel import Record
from dampen.simulation.lockstep import Lockstep, in_step, kind_of_member
from dampen.simulation.passes import passes
from dampen.simulation.scenario import Scenario
from dampen.simulation.tally import BY_PORT, SHARE, STEPS, WHOLE, tally

Array = np.ndarray
PIECE = 16  # members that a thread takes through all trials: what they learn and are shaken by stays in its cache
SHARED = ("trials", "trial_duration", "start", "reset_error", "seed")  # of a task, what a bench relies on


@dataclass(frozen=True)
class Tally:
    """The figures of one member: by_port (trials, ports, BY_PORT) and whole (trials, WHOLE), of the trials that it began."""

    scenario: Scenario
    by_port: Array
    whole: Array

    @property
    def status(self) -> str:
        """ "complete", "constraint_lost" or "diverged"."""
        if np.any(self.whole[:, STEPS] < self.scenario.steps):
            return "diverged"
        return "constraint_lost" if np.any(self.by_port[:, :, SHARE] >= 1) else "complete"


Outcome = Tally | ArgumentError


class Batch:
    """The nominal scenario, set up, and what its members need beside it; kept from call to call."""

    def __init__(self, nominal: Scenario):
        self.nominal, self.bench = nominal, Bench(nominal)

    def run(self, members: Sequence[Scenario], threads: int = 1) -> list[Outcome]:
        """Run all members, in their order; one that cannot be run comes back as the ArgumentError that says why."""
        pieces = [members[i : i + PIECE] for i in range(0, len(members), PIECE)]
        with ThreadPoolExecutor(threads) as pool:
            return [outcome for outcomes in pool.map(self._piece, pieces) for outcome in outcomes]

    def bench_of(self, member: Scenario) -> Bench:
        """The nominal bench where the member differs in nothing that it holds; else one that it carries, or one of its own."""
        nominal = self.nominal
        same_times = all(getattr(member.task, name) == getattr(nominal.task, name) for name in SHARED)
        if member.disturbance != nominal.disturbance or member.numerics != nominal.numerics or not same_times:
            return Bench(member, keep=0)
        if member.plant == nominal.plant:
            return self.bench
        found = self._basis.reprojected(member.plant, member.numerics.modes) if self._basis else None
        return Bench(member, keep=0) if found is None else Bench(member, found[0], (self._carrier, found[1]))

    @cached_property
    def _basis(self) -> FixedBasis | None:
        return FixedBasis.of(self.nominal.plant, self.nominal.numerics.modes, self.bench.grid)

    @cached_property
    def _carrier(self) -> Bench:
        assert self._basis is not None
        return Bench(self.nominal, self._basis.carrier)

    def _piece(self, members: Sequence[Scenario]) -> list[Outcome]:
        """The outcomes of some members, kind by kind."""
        outcomes: dict[int, Outcome] = {}
        kinds: list[tuple[Any, dict[int, Bench]]] = []
        for i, member in enumerate(members):
            try:
                bench = self.bench_of(member)
                bench.check_start(member)
            except ArgumentError as error:
                outcomes[i] = error
                continue
            kind = kind_of_member(member, bench) if in_step(member) else i
            same = next((benches for other, benches in kinds if other == kind), None)
            kinds.append((kind, {i: bench})) if same is None else same.update({i: bench})
        for _, benches in kinds:
            try:
                outcomes |= of_one_kind({i: members[i] for i in benches}, benches)
            except ArgumentError as error:
                alone_in_it = len(benches) == 1  # of several, one spoils it for all: find out which
                outcomes |= {i: error if alone_in_it else self._piece([members[i]])[0] for i in benches}
        return [outcomes[i] for i in range(len(members))]


def of_one_kind(members: Mapping[int, Scenario], benches: Mapping[int, Bench]) -> dict[int, Outcome]:
    """The outcomes of members that can go in step; one that cannot is alone here."""
    scenarios = list(members.values())
    if not in_step(scenarios[0]):
        return {i: alone(scenario, benches[i]) for i, scenario in members.items()}
    figures = list(Lockstep(scenarios, list(benches.values())).trials())
    by_port, whole = (np.stack(side, axis=1) for side in zip(*figures, strict=True))
    return {i: began(scenarios[n], by_port[n], whole[n]) for n, i in enumerate(members)}


def began(scenario: Scenario, by_port: Array, whole: Array) -> Tally:
    """The figures of the trials that were begun: none after one that broke off."""
    broken = np.flatnonzero(whole[:, STEPS] < scenario.steps)
    count = broken[0] + 1 if len(broken) else len(whole)
    return Tally(scenario, by_port[:count], whole[:count])


def alone(scenario: Scenario, bench: Bench) -> Tally:
    """The figures of a single run."""
    rows = figures_of(scenario, ((p.trial, p.record, p.done) for p in passes(scenario, bench)))
    return Tally(scenario, *(np.stack(side) for side in zip(*rows, strict=True)))


def figures_of(scenario: Scenario, trials: Iterable[tuple[int, Record, int]]) -> list[tuple[Array, Array]]:
    """By_port (ports, BY_PORT) and whole (WHOLE,) of trials, each with its record and the steps that it did, up to the first that
    broke off."""
    ports, rows = len(scenario.ports), []
    before = np.full(ports, np.nan)
    for trial, record, done in trials:
        reference, (low, high) = scenario.reference(trial), scenario.limits(trial)
        by_port, whole = np.zeros((ports, len(BY_PORT))), np.zeros(len(WHOLE))
        if scenario.task.start == "reset":
            before[:] = np.nan
        compiled_tally(ports)(record, low - reference, high - reference, done, before, by_port, whole)
        rows.append((by_port, whole))
        if done < scenario.steps:
            break
    return rows


@cache
def compiled_tally(ports: int) -> Any:
    """`tally`, compiled for a number of ports."""
    return compiled(bind(tally, PORTS=ports))
