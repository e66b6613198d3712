"""Reaching a controller: start its program or find it at its port, and see whether it belongs to the scenario."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from dampen.component import ArgumentError, wrong
from dampen.sil.counterpart import Counterpart
from dampen.sil.line import Line
from dampen.sil.pipe import Pipe
from dampen.sil.program import Program
from dampen.sil.udp import Udp, check_port, free_port
from dampen.simulation.scenario import Scenario

LONGEST = 86400.0  # s


@contextmanager
def reached(
    scenario: Scenario,
    controller: str | Sequence[str] | None,
    *,
    udp: bool = False,
    port: int | None = None,
    drive: bool = False,
    timeout: float = 5.0,
) -> Iterator[Counterpart]:
    """The controller, having said hello; see :func:`dampen.software_in_the_loop` for the arguments. Afterwards it is ended.

    Raises ArgumentError for a scenario without samples, and where there is no controller for it.
    """
    if not scenario.sampled:
        raise ArgumentError(
            'Argument `numerics.mode` must be "sampled" for software in the loop, but is "continuous". '
            "Try `--set numerics.mode=sampled`."
        )
    if not 0 < timeout <= LONGEST:
        raise wrong("timeout", f"be > 0 s and at most {LONGEST:g} s", timeout)
    if (controller is None) == (port is None):
        raise ArgumentError("Argument `controller` must be a program to start, or `port` where one listens already: one of them.")
    if os.name != "posix":
        raise ArgumentError("Software in the loop needs a POSIX system.")
    line = line_to(controller, udp, port, timeout)
    try:
        counterpart = Counterpart(line, scenario, drive)
        counterpart.greet()
        yield counterpart
    finally:
        line.hang_up()


def line_to(controller: str | Sequence[str] | None, udp: bool, port: int | None, timeout: float) -> Line:
    """The line, with the program started that it goes to."""
    if controller is None:
        assert port is not None
        return Udp(check_port(port), None, timeout)
    if not udp:
        return Pipe(Program(controller), timeout)
    own = free_port()
    return Udp(own, Program(controller, ("--udp", str(own)), pipe=False), timeout)
