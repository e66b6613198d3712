"""Who is compared: contenders by kind, from other scenarios or as objects, each made to fit the experiment or refused."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from dampen.component import ArgumentError, suggestion
from dampen.controllers.base import Controller
from dampen.controllers.none import NoControl
from dampen.controllers.open_loop import OpenLoop
from dampen.scenarios.kinds import KINDS, find_kind
from dampen.scenarios.read import read_scenario, shipped
from dampen.simulation.batch import alone
from dampen.simulation.bench import Bench
from dampen.simulation.scenario import NAME, Scenario
from dampen.studies.compare.ranges import Start, from_controller, from_kind, under
from dampen.toml import kind_of

Given = str | Path | Scenario | Controller
ALIKE = {
    "plant": "plant", "disturbance": "disturbance", "task": "task", "bounds": "bounds", "actuators": "actuator",
    "compensation": "compensation",
}  # fmt: skip


@dataclass(frozen=True)
class Entry:
    """A contender before it is tuned. names: what `as_given` may call it.   source: as in :class:`Contender`."""

    label: str
    source: str
    start: Start
    names: tuple[str, ...]

    @property
    def scenario(self) -> Scenario:
        return self.start.scenario


def entries_of(scenario: Scenario, given: Sequence[Given] | None, bench: Bench) -> tuple[list[Entry], dict[str, str]]:
    """The experiment's own law and all contenders; and of those that were not asked for by name, why they are left out.

    given: None for every shipped kind that can be run here.   Raises ArgumentError for one that cannot, if it was asked for.
    """
    own = Entry(name_of(scenario.controller), "scenario", from_controller(scenario, bench), (scenario.name,))
    entries, left_out = [own], dict[str, str]()
    if given is None:
        for kind in KINDS["controller"]:
            if kind.kind != own.label:
                try:
                    entries.append(entry_of(scenario, kind.kind, bench))
                except ArgumentError as error:
                    left_out[kind.kind] = reason(error, kind.kind)
    else:
        for one in given:
            entries.append(entry_of(scenario, one, bench))
    return distinct(entries), left_out


def entry_of(scenario: Scenario, given: Given, bench: Bench) -> Entry:
    """One contender, tried for a trial. Raises ArgumentError, one line, where it cannot be run."""
    known = {cls.kind for cls in KINDS["controller"]}
    if isinstance(given, Controller):
        start = from_controller(under(scenario, given), bench)
        entry = Entry(name_of(given), "object", start, (name_of(given),))
    elif isinstance(given, str) and (given in known or (":" in given and not given.endswith(".toml"))):
        entry = of_kind(scenario, given, bench)
    else:
        other = given if isinstance(given, Scenario) else read(given, known)
        start = from_controller(taken_from(scenario, other, given), bench)
        entry = Entry(other.name, other.name, start, (other.name, str(given) if not isinstance(given, Scenario) else other.name))
    try:
        alone(replace(entry.scenario, task=replace(scenario.task, trials=1)), Bench(entry.scenario, bench.modes))
    except ArgumentError as error:
        raise refused(entry.label, error) from None
    return entry


def of_kind(scenario: Scenario, given: str, bench: Bench) -> Entry:
    """A contender named by its kind."""
    kind = find_kind("controller", given, "contender", Path())
    assert issubclass(kind, Controller)
    try:
        if issubclass(kind, OpenLoop):
            raise ArgumentError("it has no commands: name a scenario that has.")
        start = from_kind(scenario, kind, bench)
    except ArgumentError as error:
        raise refused(given, error) from None
    if not start.search and kind is not NoControl and given in {cls.kind for cls in KINDS["controller"]}:
        raise refused(given, ArgumentError("no port has an actuator that could move it."))
    return Entry(given.rpartition(":")[2], "kind", start, (given,))


def read(given: Path | str, known: Iterable[str]) -> Scenario:
    """A scenario that was named as a contender."""
    try:
        return read_scenario(given)
    except ArgumentError as error:
        if len(error.lines) == 1 and "neither a shipped scenario" in error.lines[0]:
            near = suggestion(str(given), [*known, *shipped()])
            raise ArgumentError(f"Contender `{given}` is no kind of controller, no scenario and no file{near}") from None
        raise


def taken_from(scenario: Scenario, other: Scenario, given: Given) -> Scenario:
    """The experiment under another scenario's controller, through its samples if it has any. Raises ArgumentError where the
    other one is another experiment."""
    different = [table for field, table in ALIKE.items() if getattr(scenario, field) != getattr(other, field)]
    if different:
        name = given.name if isinstance(given, Scenario) else given
        raise ArgumentError(
            f"Contender `{name}` must be the same experiment as `{scenario.name}` under another controller, but differs in "
            f"{', '.join(different)}."
        )
    if not other.sampled:
        return under(scenario, other.controller)
    numerics = replace(scenario.numerics, mode="sampled")
    return replace(scenario, controller=other.controller, sampling=other.sampling, numerics=numerics)


def name_of(controller: Controller) -> str:
    """What a controller is called by itself: its kind, or its class."""
    return kind_of(controller).rpartition(":")[2] or type(controller).__name__


def distinct(entries: Sequence[Entry]) -> list[Entry]:
    """Entries whose labels differ, and can name a folder."""
    taken: list[Entry] = []
    for entry in entries:
        plain = entry.label if NAME.fullmatch(entry.label) else "contender"
        used = {other.label for other in taken}
        label = next(name for k in range(1, len(entries) + 2) if (name := plain if k == 1 else f"{plain}-{k}") not in used)
        taken.append(replace(entry, label=label, names=(*entry.names, label)))
    return taken


def refused(name: str, error: ArgumentError) -> ArgumentError:
    """The complaint that a contender cannot be run, with its first fault."""
    return ArgumentError(f"Contender `{name}` cannot be run here: {error.lines[0]}")


def reason(error: ArgumentError, name: str) -> str:
    """Why it was refused, without its name."""
    return error.lines[0].removeprefix(f"Contender `{name}` cannot be run here: ")
