"""The controller as the plant knows it: what is asked of it, with every answer checked and every exchange timed."""

from __future__ import annotations

import math
import time
from contextlib import suppress

import numpy as np

from dampen.component import ArgumentError
from dampen.sil.exchanges import NO_ANSWER, NO_TRIAL, Exchanges
from dampen.sil.line import Line, Lost
from dampen.sil.packets import BYE, DRIVE, END, HELLO, ROUND, STEP, STOPPED, Answer, Garbage, Request, answer_to, status_text
from dampen.simulation.scenario import Scenario

Array = np.ndarray
GOODBYE = 0.5  # s that the last answer may take


class Counterpart:
    """A controller at the other end of a line, for a scenario.

    drives: it inverts the actuators itself.   notes: what was remarkable about its statuses, one line for each kind.
    """

    def __init__(self, line: Line, scenario: Scenario, drives: bool):
        self.line, self.scenario, self.drives = line, scenario, drives
        self.samples, self.period = scenario.law_grid
        self.exchanges = Exchanges(self.period)
        self.described = line.described + (", its own inverse of the actuators included" if drives else "")
        self.notes: list[str] = []
        self.number, self.seen = 0, {0}
        ports, limits = scenario.ports, scenario.sampling.command_limit
        self.limits = np.array([limits.get(port, np.inf) for port in ports])

    def greet(self) -> None:
        """See whether this is a controller for the scenario. Raises ArgumentError."""
        try:
            answer = self._ask("the hello", HELLO, NO_TRIAL, self.samples, self.period)
        except Lost as error:
            raise ArgumentError(f"Argument `controller` must answer as docs/how-to/sil.md says: {error}") from None
        ports = len(self.scenario.ports)
        same = answer.ports == ports and answer.sample == self.samples and math.isclose(answer.seconds, self.period, rel_tol=1e-6)
        if not same:
            raise ArgumentError(
                f"Argument `controller` must be made for {ports} ports and {self.samples} samples of {self.period:g} s in a "
                f"trial, as the scenario has them, but {self.line.name} is for {answer.ports} ports and {answer.sample} samples "
                f"of {answer.seconds:g} s."
            )

    def step(self, trial: int, sample: int, reading: Array) -> tuple[Array, Array]:
        """Commands and what the actuators get for them, (ports,) each, that follow from readings (ports,).

        Raises Lost where there are none that could be used.
        """
        where = f"sample {sample} of trial {trial}"
        answer = self._ask(where, DRIVE if self.drives else STEP, trial, sample, sample * self.period, reading)
        self._note(answer.status, where)
        command = answer.numbers[: len(reading)]
        return command, answer.numbers[-len(reading) :]

    def end_trial(self, trial: int, reading: Array) -> None:
        """Tell it that the trial is over, and what the sensors show then."""
        where, reset = f"the end of trial {trial}", int(self.scenario.task.start == "reset")
        answer = self._ask(where, END, trial, self.samples, self.samples * self.period, reading, reset)
        self._note(answer.status, where)

    def leave(self) -> None:
        """Say goodbye; nothing hangs on the answer."""
        self.line.timeout = min(self.line.timeout, GOODBYE)
        with suppress(Lost):
            self._ask("the goodbye", BYE, NO_TRIAL, 0, 0.0)

    def _ask(
        self, where: str, kind: int, trial: int, sample: int, seconds: float, reading: Array | None = None, status: int = 0
    ) -> Answer:
        """One exchange."""
        request = Request(kind, self.number, len(self.scenario.ports), status, sample, seconds, reading)
        self.number = (self.number + 1) % ROUND
        trip, code, begun = math.nan, NO_ANSWER, time.perf_counter()
        try:
            data = self.line.ask(request)
            took = time.perf_counter() - begun
            answer = answer_to(request, data)
            if kind in (STEP, DRIVE):
                self._check(answer.numbers)
            trip, code = took, answer.status
        except Garbage as error:
            raise Lost(f"At {where} {self.line.name} sent {error}.") from None
        except Lost as error:
            raise Lost(f"At {where} {error}") from None
        finally:
            self.exchanges.add(trial, sample if kind != HELLO else 0, kind, trip, self.line.asked, code)
        return answer

    def _check(self, numbers: Array) -> None:
        """Commands must be numbers, and within their limits. Raises Garbage."""
        ports = self.scenario.ports
        if not np.isfinite(numbers).all():
            p = int(np.flatnonzero(~np.isfinite(numbers))[0])
            raise Garbage(f"{numbers[p]} as the {'drive' if p >= len(ports) else 'command'} of {ports[p % len(ports)]}")
        beyond = np.flatnonzero(np.abs(numbers[: len(ports)]) > self.limits)
        if len(beyond):
            p = beyond[0]
            unit, limit = self.scenario.plant.ports[p].effort_unit, f"{self.limits[p]:g}"
            told = f"{numbers[p]:.9g} {unit} as the command of {ports[p]}"
            raise Garbage(f"{told}, beyond its `sampling.command_limit` of {limit} {unit}")

    def _note(self, status: int, where: str) -> None:
        """Write down a status when it first comes."""
        if status not in self.seen:
            self.seen.add(status)
            stopped = "; it has stopped, and its commands are 0 from then on" if status in STOPPED else ""
            self.notes.append(f"At {where} the controller said: {status_text(status)}{stopped}.")
