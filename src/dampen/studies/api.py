"""Studies from Python: the commands' names, with scenarios as objects; each gives back a :class:`Study`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from dampen.simulation.scenario import Scenario
from dampen.studies.definition import Definition, robust_of, sweep_of, tune_of
from dampen.studies.engines import Cluster, Cores, Engine
from dampen.studies.study import Progress, Study, new_study, open_study
from dampen.toml import literal

Ranges = Mapping[str, str | Sequence[Any]] | Sequence[str]


def sweep(
    scenario: Scenario,
    vary: Ranges,
    *,
    folder: str | Path | None = None,
    engine: Engine | int | str | None = None,
    progress: Progress | None = None,
) -> Study:
    """Run a scenario over a grid.

    vary:     by path, a range "LOW:HIGH:COUNT" or "LOW:HIGH:log:COUNT", or a list of values; or texts "PATH=RANGE".
    folder:   a new folder for the study, so that it can be gone on with by `resume`; left out: in memory.
    engine:   an Engine, a number of processes, or the address of a `dask.distributed` scheduler; left out: all cores.
    progress: called with (rows done, rows in all, rows that failed).

    Raises ArgumentError for a path or range that is not one.
    """
    return _run(sweep_of(scenario, _texts(vary)), folder, engine, progress)


def robust(
    scenario: Scenario,
    uncertain: Ranges,
    *,
    samples: int = 1000,
    sampler: str = "sobol",
    seed: int = 0,
    folder: str | Path | None = None,
    engine: Engine | int | str | None = None,
    progress: Progress | None = None,
) -> Study:
    """Run a scenario over what is uncertain, in the Saltelli design of at least `samples` runs; see `robustness`.

    uncertain: by path, "+-30%", "0.1+-30%", "0.1+-0.02" (any with ":normal"), "LOW:HIGH" or "LOW:HIGH:log".
    sampler:   "sobol" (scrambled, the design's base a power of two) or "latin".
    The rest as for `sweep`.
    """
    return _run(robust_of(scenario, _texts(uncertain), samples, sampler, seed), folder, engine, progress)


def tune(
    scenario: Scenario,
    search: Ranges,
    objective: str | Sequence[str] = "peak",
    *,
    budget: int = 2000,
    population: int | None = None,
    robust_over: Ranges = (),
    robust_samples: int = 16,
    seed: int = 0,
    folder: str | Path | None = None,
    engine: Engine | int | str | None = None,
    progress: Progress | None = None,
) -> Study:
    """Search for better parameters: CMA-ES for one objective, NSGA-II for several, the constraint kept; see `best_scenario`.

    search:      by path, "LOW:HIGH" or "LOW:HIGH:log".
    objective:   figures of merit to be made small (margin: large), such as "peak", "residual.tip_w", "effort".
    budget:      candidates at most, in generations of `population`.
    robust_over: what each candidate has to hold over, as for `robust`; the worst of `robust_samples` samples counts.
    The rest as for `sweep`.
    """
    names = (objective,) if isinstance(objective, str) else tuple(objective)
    over = _texts(robust_over)
    return _run(
        tune_of(scenario, _texts(search), names, budget, population, seed, over, robust_samples), folder, engine, progress
    )


def resume(folder: str | Path, *, engine: Engine | int | str | None = None, progress: Progress | None = None) -> Study:
    """Go on with a study from where it was left. Raises ArgumentError for a folder that holds none."""
    return open_study(folder).run(_engine(engine), progress)


def _run(definition: Definition, folder: str | Path | None, engine: Any, progress: Progress | None) -> Study:
    return new_study(definition, None if folder is None else Path(folder)).run(_engine(engine), progress)


def _engine(given: Engine | int | str | None) -> Engine | None:
    if isinstance(given, str):
        return Cluster(given)
    return Cores(given) if isinstance(given, int) else given


def _texts(ranges: Ranges) -> Sequence[str]:
    if not isinstance(ranges, Mapping):
        return [ranges] if isinstance(ranges, str) else list(ranges)
    written = {path: r if isinstance(r, str) else ",".join(literal(value) for value in r) for path, r in ranges.items()}
    return [f"{path}={text}" for path, text in written.items()]
