"""One experiment in full: a scenario with and without control, and what belongs beside it, into the files of a folder."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from dampen.analysis.audit.audit import audit
from dampen.controllers.base import SampledFeedback
from dampen.controllers.none import NoControl
from dampen.simulation.bench import Bench
from dampen.simulation.result import Result
from dampen.simulation.scenario import Scenario
from dampen.simulation.stores import FileStore
from dampen.simulation.trials import simulate
from dampen.studies.record import Record, record
from dampen.toml import to_toml


@dataclass(frozen=True)
class Runs:
    """The run under the scenario's controller, the one without control, and of a sampled run the one under the continuous law.

    A scenario without control is its own baseline; what an interrupt has left out is None.
    """

    result: Result
    baseline: Result | None
    continuous: Result | None

    @property
    def interrupted(self) -> bool:
        """Whether any of them was."""
        return any(run is not None and run.status == "interrupted" for run in (self.result, self.baseline, self.continuous))


def beside(scenario: Scenario) -> dict[str, Scenario]:
    """What is run beside a scenario, by the name of its file."""
    if isinstance(scenario.controller, NoControl):
        return {}
    twin = continuous_twin(scenario)
    return {"uncontrolled": scenario.uncontrolled(), **({} if twin is None else {"continuous": twin})}


def continuous_twin(scenario: Scenario) -> Scenario | None:
    """A sampled scenario under the continuous law; None where there is none: the law needs samples, or its actuators do."""
    if not scenario.sampled or isinstance(scenario.controller, SampledFeedback | NoControl):
        return None
    chains = (scenario.chain(p) for p in range(len(scenario.ports)))
    return scenario.continuous() if all(stage.monotone for chain in chains for stage in chain) else None


def run_all(bench: Bench, folder: Path, advance: Callable[[], None] = lambda: None) -> Runs:
    """Run the bench's scenario and what belongs beside it, into `folder`, trial by trial; `advance` is called after each."""
    scenario, done = bench.scenario, {}
    (folder / "scenario.toml").write_text(to_toml(scenario), encoding="utf-8")
    for name, one in {"result": scenario, **beside(scenario)}.items():
        store = FileStore(folder / f"{name}.nc")
        done[name] = simulate(one, store=store, progress=lambda finished, trials: advance(), bench=bench)
        if done[name].status == "interrupted":
            break
    result = done["result"]
    baseline = result if isinstance(scenario.controller, NoControl) else done.get("uncontrolled")
    return Runs(result, baseline, done.get("continuous"))


def own_review(bench: Bench, result: Result) -> Record:
    """The audit of a run by itself: what needs no further run."""
    return record(result.scenario, audit=audit(result, refine=False, bench=bench) if result.trials else None)
