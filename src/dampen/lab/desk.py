"""Where a worker's answers are made: a table in, a picture out, then the other trials and the review."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from dampen.analysis.claims import Claim, verdict_sentence
from dampen.component import ArgumentError
from dampen.controllers.none import NoControl
from dampen.lab.picture import picture, trial_frame
from dampen.lab.tables import Trust, faults, scenario_of
from dampen.report.style import typeset
from dampen.simulation.bench import Bench
from dampen.simulation.compose import is_ready
from dampen.simulation.result import Result
from dampen.simulation.scenario import Scenario
from dampen.simulation.trials import simulate

if TYPE_CHECKING:
    from dampen.analysis.audit.audit import Audit

Say = Callable[[bytes | Mapping[str, Any]], None]
BENCHES = 4
SET_UP = ("plant", "disturbance", "task", "sampling", "numerics", "output")  # what a bench depends on
REST, TICK = 0.2, 0.01  # seconds
STREAMED = 32 * 2**20  # bytes of trials that follow a picture; the page asks for others as it needs them
COMPILING = "Compiling the simulation kernel for this kind of experiment: once, some ten seconds."


class Left(Exception):
    """Something newer is waiting: what is being done is left."""


class Desk:
    """Answers requests one after the other. Set-ups of the last few experiments are kept, so that a gain costs only its run.

    say:    takes what is to be said: a message, or the bytes of a frame.
    newer:  whether something newer is waiting.
    """

    def __init__(self, say: Say, newer: Callable[[], bool]):
        self.say, self.newer = say, newer
        self.benches: list[Bench] = []  # the latest last

    def run(self, id: int, table: object, trial: int, trust: Trust) -> None:
        """Run a scenario and show it."""
        try:
            scenario = scenario_of(table, trust)
            bench = self.bench(scenario)
            kernel, _ = bench.kernel(scenario)
            if not is_ready(kernel):
                self.say({"say": "note", "id": id, "text": COMPILING})
                simulate(replace(scenario, task=replace(scenario.task, trials=1)), bench=bench)
            began = time.perf_counter()
            result = simulate(scenario, bench=bench, progress=self.unless_newer)
        except ArgumentError as error:
            self.say({"say": "refused", "id": id, "faults": faults(error)})
            return
        self.show(id, result, bench, trial, "run", time.perf_counter() - began)

    def open(self, id: int, result: Result, trial: int) -> None:
        """Show a stored result."""
        self.show(id, result, self.bench(result.scenario), trial, "file", 0.0)

    def show(self, id: int, result: Result, bench: Bench, trial: int, source: str, seconds: float) -> None:
        """The picture, then the other trials and the review, as long as nothing newer waits."""
        if not result.trials:
            self.say({"say": "failed", "id": id, "text": f"The first trial did not end: {result.status}. The gains do not hold."})
            return
        about = {"id": id, "source": source, "seconds": seconds}
        self.say(picture(result, trial, bench, about))
        self.breathe()
        sent = 0
        for j in (*range(trial + 1, result.trials), *range(min(trial, result.trials))):
            self.unless_newer()
            frame = trial_frame(result, j, id)
            sent += len(frame)
            if sent > STREAMED:
                break
            self.say(frame)
        self.say(self.review(id, result, bench))
        self.say({"say": "complete", "id": id})

    def review(self, id: int, result: Result, bench: Bench) -> dict[str, Any]:
        """What holds in the run and what does not."""
        from dampen.analysis.audit.audit import audit  # not before the first picture is out
        from dampen.report.review.words import sentence
        from dampen.scenarios.claims import check_claims

        claims: list[Claim] = []
        if result.scenario.claims:
            self.unless_newer()
            controlled = not isinstance(result.scenario.controller, NoControl)
            free = simulate(result.scenario.uncontrolled(), bench=bench, progress=self.unless_newer) if controlled else result
            claims = check_claims(result, free)
        self.unless_newer()
        found = audit(result, refine=False, bench=bench)
        return {
            "say": "review",
            "id": id,
            "verdict": verdict_sentence(claims) if claims else "",
            "claims": [claim_row(claim) for claim in claims],
            "audit": typeset(sentence(found)),
            "findings": finding_rows(found),
        }

    def bench(self, scenario: Scenario) -> Bench:
        """The set-up for a scenario: one that differs in its controller and actuators only has it ready."""
        found = next((bench for bench in self.benches if serves(bench.scenario, scenario)), None)
        if found is None:
            found = Bench(scenario)
        else:
            self.benches.remove(found)
        self.benches = [*self.benches[-BENCHES + 1 :], found]
        found.check_start(scenario)
        return found

    def breathe(self) -> None:
        """Let the page draw: what follows comes when the hand on the slider rests."""
        end = time.monotonic() + REST
        while time.monotonic() < end:
            self.unless_newer()
            time.sleep(TICK)

    def unless_newer(self, done: int = 0, trials: int = 0) -> None:
        """Leave what is being done if something newer waits."""
        if self.newer():
            raise Left


def serves(one: Scenario, other: Scenario) -> bool:
    """Whether the set-up of one scenario is that of the other."""
    return all(getattr(one, part) == getattr(other, part) for part in SET_UP)


def claim_row(claim: Claim) -> dict[str, str]:
    """A claim as the page lists it."""
    return row("claims", claim.id, claim.statement, claim.criterion, claim.measured, claim.verdict)


def finding_rows(found: Audit) -> list[dict[str, str]]:
    """The audit's rows, section by section."""
    return [
        row(section, one.id, one.criterion, one.meaning, one.measured, one.verdict)
        for section, findings in found.sections.items()
        for one in findings
    ]


def row(section: str, id: str, statement: str, criterion: str, measured: str, verdict: str) -> dict[str, str]:
    """A row in the words of a reader."""
    words = {"section": section, "statement": statement, "criterion": criterion, "measured": measured}
    return {**{name: typeset(text) for name, text in words.items()}, "id": id, "verdict": verdict}
