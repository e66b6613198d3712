"""Studies from Python: the commands' names, with scenarios as objects; each gives back a :class:`Study`."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from dampen.arguments import ENGINE, FOLDER, NOTHING, PATH, PROGRESS, RANGES, SCENARIO, TEXT, TEXTS, count, takes
from dampen.component import ArgumentError, is_number, plain_value, shown
from dampen.simulation.scenario import Scenario
from dampen.studies.definition import Definition, robust_of, sweep_of, tune_of, whole
from dampen.studies.engines import Cluster, Cores, Engine
from dampen.studies.study import Progress, Study, new_study, open_study
from dampen.studies.variation import FORMS
from dampen.toml import literal, to_toml

Ranges = Mapping[str, str | Sequence[Any]] | Sequence[str]
OPTION = re.compile(r"Option `--(?P<name>[\w-]+)(?: (?P<path>[^`]+))?`")


@contextmanager
def for_python(**others: str) -> Iterator[None]:
    """Complaints about a command's options become complaints about a function's arguments; others: of other names."""
    others = {"scheduler": "engine", **others}

    def argument(option: re.Match[str]) -> str:
        name = others.get(option["name"], option["name"].replace("-", "_"))
        return f"Argument `{name}`" + (f", for `{option['path']}`," if option["path"] else "")

    try:
        yield
    except ArgumentError as error:
        raise ArgumentError([OPTION.sub(argument, line, count=1) for line in error.lines]) from None


@takes(scenario=SCENARIO, vary=RANGES, folder=FOLDER, engine=ENGINE, progress=PROGRESS)
@for_python()
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
    return _run(sweep_of(scenario, _texts("vary", vary), home_of(scenario)), folder, engine, progress)


@takes(
    scenario=SCENARIO,
    uncertain=RANGES,
    sampler=TEXT,
    folder=FOLDER,
    engine=ENGINE,
    progress=PROGRESS,
    samples=count(1),
    seed=count(),
)
@for_python()
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
    return _run(
        robust_of(scenario, _texts("uncertain", uncertain), samples, sampler, seed, home_of(scenario)), folder, engine, progress
    )


@takes(
    scenario=SCENARIO,
    search=RANGES,
    objective=TEXT | TEXTS,
    robust_over=RANGES,
    folder=FOLDER,
    engine=ENGINE,
    progress=PROGRESS,
    budget=count(1),
    population=count(4) | NOTHING,
    robust_samples=count(1),
    seed=count(),
)
@for_python(uncertain="robust_over")
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
    over = _texts("robust_over", robust_over)
    return _run(
        tune_of(scenario, _texts("search", search), names, budget, population, seed, over, robust_samples, home_of(scenario)),
        folder,
        engine,
        progress,
    )


@takes(folder=PATH, engine=ENGINE, progress=PROGRESS)
@for_python()
def resume(folder: str | Path, *, engine: Engine | int | str | None = None, progress: Progress | None = None) -> Study:
    """Go on with a study from where it was left. Raises ArgumentError for a folder that holds none."""
    return open_study(folder).run(engine_of(engine), progress)


def _run(definition: Definition, folder: str | Path | None, engine: Any, progress: Progress | None) -> Study:
    study = new_study(definition, None if folder is None else Path(folder))
    try:
        return study.run(engine_of(engine), progress)
    except ArgumentError:
        study.discard()
        raise


def home_of(scenario: Scenario) -> Path:
    """The folder of the module from which a scenario has its first class of the user's own; the current one without any."""
    text = to_toml(scenario) if isinstance(scenario, Scenario) else ""
    for module in re.findall(r'"([A-Za-z_][\w.]*):[A-Za-z_]\w*"', text):
        file = getattr(sys.modules.get(module), "__file__", None)
        if file and module != "__main__":
            return Path(file).resolve().parents[module.count(".")]
    return Path().resolve()


def engine_of(given: Engine | int | str | None) -> Engine | None:
    """An engine from what callers may give: itself, a number of processes, or a scheduler's address."""
    if isinstance(given, str):
        return Cluster(given)
    if isinstance(given, int):
        return Cores(whole("engine", given, 1))
    return given


def _texts(argument: str, ranges: Ranges) -> Sequence[str]:
    if not isinstance(ranges, Mapping):
        return [ranges] if isinstance(ranges, str) else list(ranges)
    return [f"{path}={_written(argument, path, given)}" for path, given in ranges.items()]


def _written(argument: str, path: str, given: Any) -> str:
    """A range as the command line has it."""
    if isinstance(given, str):
        return given
    values = plain_value(given)
    several = isinstance(values, tuple) and len(values) > 0
    if argument == "vary" and several:
        return ",".join(literal(value) for value in values)
    if argument == "vary":
        form = ", or a list of values"
    elif several and len(values) == 2 and all(map(is_number, values)):
        form = f' like "{values[0]:g}:{values[1]:g}"'
    else:
        form = f" like {FORMS['search' if argument == 'search' else 'uncertain']}"
    raise ArgumentError(f"Argument `{argument}`, for `{path}`, must have a range as text{form}, but has {shown(given)}.")
