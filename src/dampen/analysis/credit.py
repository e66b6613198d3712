"""Credit: the same experiment with one part left out at a time, to see what each part is worth."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from dampen.actuators.backlash import Backlash
from dampen.analysis.merits import merits
from dampen.arguments import PROGRESS, SCENARIO, takes
from dampen.component import ArgumentError
from dampen.controllers.base import SampledFeedback
from dampen.controllers.none import NoControl
from dampen.controllers.partial import PartialLaw, taken_apart
from dampen.simulation.batch import Batch, Tally, alone
from dampen.simulation.memory import begun
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import setting_of
from dampen.simulation.tally import MEAN_SQUARE

Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class AtPort:
    """What a variant comes to at a port. first, residual: RMS error of trial 0 and of the last five trials [m, rad].   largest:
    largest |error| of the run.   effort: RMS of the delivered force [N, N m].   stuck: share of the steps in which it stuck."""

    port: str
    motion_unit: str
    effort_unit: str
    first: float
    residual: float
    largest: float
    effort: float
    stuck: float


@dataclass(frozen=True)
class Variant:
    """One ablation. name, meaning: what was left out, and how.   status: as a run's, or "refused".   margin: 1 - largest share of
    the constraint that was used; nan without one.   energy: mean energy in the last five trials [J]."""

    name: str
    meaning: str
    status: str
    margin: float
    energy: float
    ports: tuple[AtPort, ...]

    def at(self, port: str) -> AtPort:
        return next(one for one in self.ports if one.port == port)


@dataclass(frozen=True)
class Credit:
    """All variants of a scenario, the whole one first."""

    scenario: str
    variants: tuple[Variant, ...]

    @property
    def whole(self) -> Variant:
        return self.variants[0]

    def get(self, name: str) -> Variant | None:
        """The variant of this name; None where it was not run."""
        return next((variant for variant in self.variants if variant.name == name), None)


@takes(scenario=SCENARIO, progress=PROGRESS)
def credit(scenario: Scenario, progress: Progress | None = None) -> Credit:
    """Run a scenario and its ablations: what do learning, observer, barrier, Sgn, disturbance and actuator contribute?

    progress: called with (variants done, variants in all) after each.

    Raises ArgumentError for a scenario without control: there is nothing to take apart.
    """
    refuse_without_control(scenario)
    planned, batch = list(variants(scenario)), Batch(scenario)
    done = []
    for name, meaning, case in planned:
        done.append(judged(name, meaning, case, outcome(batch, case)))
        if progress:
            progress(len(done), len(planned))
    return Credit(scenario.name, tuple(done))


def refuse_without_control(scenario: Scenario) -> None:
    """Raise ArgumentError for a scenario without control."""
    if isinstance(scenario.controller, NoControl):
        raise ArgumentError('Argument `controller.kind` must not be "none": without control there is nothing to take apart.')


def outcome(batch: Batch, case: Scenario) -> Tally | ArgumentError:
    """A variant's figures, by the kernel of a single run: that is compiled already where the scenario has been run."""
    try:
        return alone(case, batch.bench_of(case))
    except ArgumentError as error:
        return error


def variants(scenario: Scenario) -> Iterator[tuple[str, str, Scenario]]:
    """Name, meaning and scenario of every ablation that there is for this one."""
    free, law = scenario.uncontrolled(), scenario.controller
    yield "as it is", "the scenario as it is", scenario
    yield "no control", "no forces at the ports", free
    terms = terms_of(scenario)
    others = tuple(name for name in terms if name != "damping") if "damping" in terms else ()
    if others:
        yield "damping only", f"of the law only its damping; without {', '.join(others)}", without(scenario, *others)
    if not isinstance(law, SampledFeedback):
        yield from _of_the_law(scenario, terms)
    held = scenario.disturbance.held()
    if held != scenario.disturbance:
        what = "the disturbance keeps the frequencies of trial 0"
        yield "frequencies held", what, replace(scenario, disturbance=held)
        yield "no control, frequencies held", f"{what}, and nobody pushes", replace(free, disturbance=held)
    ideal = ideal_actuators(scenario)
    if ideal is not None:
        what = "linear actuators of the same slope, without gap, limit, lag or compensation"
        yield "ideal actuator", what, ideal
        if others:
            yield "damping only, ideal actuator", f"of the law only its damping, and {what}", without(ideal, *others)


def _of_the_law(scenario: Scenario, terms: Sequence[str]) -> Iterator[tuple[str, str, Scenario]]:
    if begun(scenario, setting_of(scenario)):
        yield "nothing learned", "the memories are wiped after every trial", without(scenario, forget=True)
    for name in terms:
        if len(terms) > 1:
            yield f"without {name}", f"the law without its term {name}", without(scenario, name)
    switching = tuple(name for name in terms if name in ("Sgn on bounds", "observer"))
    if len(switching) == 2:
        what = f"the law without all that multiplies Sgn: {' and '.join(switching)}"
        yield "without all Sgn terms", what, without(scenario, *switching)


def terms_of(scenario: Scenario) -> list[str]:
    """Names of the terms of a law, those included that it has to learn first; none of one through samples by its own function."""
    law, setting = scenario.controller, setting_of(scenario)
    if isinstance(law, SampledFeedback):
        return []
    learned = {name: np.ones_like(value) for name, value in begun(scenario, setting).items()}
    return list(taken_apart(law, learned, setting))


def without(scenario: Scenario, *leave_out: str, forget: bool = False) -> Scenario:
    """The scenario without some terms of its law, or without what it carries from trial to trial."""
    law = scenario.controller
    if isinstance(law, PartialLaw):
        return scenario.with_controller(replace(law, leave_out=(*law.leave_out, *leave_out), forget=law.forget or forget))
    return scenario.with_controller(PartialLaw(law, leave_out, forget))


def ideal_actuators(scenario: Scenario) -> Scenario | None:
    """The scenario with a linear actuator of the same slope in full motion at each port; None where it has that already."""
    if not any(scenario.chain(p) for p in range(len(scenario.ports))):
        return None
    chains = {}
    for p, port in enumerate(scenario.ports):
        slope = math.prod(stage.gain for stage in scenario.chain(p))
        chains[port] = (
            () if slope == 1 else (Backlash(slope=slope, right=0.0, left=0.0),) if slope else scenario.actuators.get(port, ())
        )
    bare = PartialLaw(scenario.controller, bare=True)
    law = scenario.controller if isinstance(scenario.controller, SampledFeedback) else bare
    return replace(scenario, actuators=chains, compensation={}, controller=law)


def judged(name: str, meaning: str, case: Scenario, outcome: Tally | ArgumentError) -> Variant:
    """The figures of a variant; of one that cannot be run, why."""
    if isinstance(outcome, ArgumentError):
        return Variant(name, f"{meaning}: {outcome.lines[0]}", "refused", np.nan, np.nan, ())
    found = merits(outcome)
    ports = []
    for p, port in enumerate(case.plant.ports):
        first = float(np.sqrt(outcome.by_port[0, p, MEAN_SQUARE]))
        own = (found[f"{merit}.{port.name}"] for merit in ("residual", "largest", "effort", "stuck"))
        ports.append(AtPort(port.name, port.motion_unit, port.effort_unit, first, *own))
    return Variant(name, meaning, outcome.status, found.get("margin", np.nan), found["energy"], tuple(ports))
