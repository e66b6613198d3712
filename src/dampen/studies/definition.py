"""What a study is: a scenario, what varies, and how much of it; written down as study.toml beside scenario.toml."""

from __future__ import annotations

import hashlib
import itertools
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

import numpy as np

from dampen.analysis.merits import columns
from dampen.component import ArgumentError, suggestion, wrong
from dampen.release import version
from dampen.scenarios.read import build, parse
from dampen.simulation.scenario import Scenario
from dampen.studies.samples import latin, saltelli, sampled
from dampen.studies.variation import Axis, Option, read_axis
from dampen.toml import literal, to_toml

Kind = Literal["sweep", "robust", "tune"]
OPTION: dict[str, Option] = {"sweep": "vary", "robust": "uncertain", "tune": "search"}
MEMBERS_AT_MOST = 10_000_000


@dataclass(frozen=True)
class Definition:
    """A study.

    axes:         what varies: the grid's axes, what is uncertain, or what is searched.   seed: of samples and of the search.
    base, sampler: robust: rows of each of the Saltelli design's matrices, and where they come from, "sobol" or "latin".
    objectives:   tune: figures of merit to be made small (margin: large).   budget: candidates at most, in generations of
                  `population`.   robust_axes, robust_samples: what each candidate has to hold over, and how many samples of it.
    home:         folder in which modules that the scenario names are looked for.
    """

    kind: Kind
    scenario: Scenario
    axes: tuple[Axis, ...]
    seed: int = 0
    base: int = 0
    sampler: Literal["sobol", "latin"] = "sobol"
    objectives: tuple[str, ...] = ()
    budget: int = 0
    population: int = 0
    robust_axes: tuple[Axis, ...] = ()
    robust_samples: int = 0
    home: Path = Path()

    def __post_init__(self) -> None:
        names = [path for axis in (*self.axes, *self.robust_axes) for path in axis.paths]
        twice = next((name for name in names if names.count(name) > 1), None)
        if twice:
            raise ArgumentError(
                f"Option `--{OPTION[self.kind]} {twice}` must be given once, but is given {names.count(twice)} times."
            )
        if not self.axes:
            raise ArgumentError(f"Option `--{OPTION[self.kind]}` must be given at least once.")
        if self.members > MEMBERS_AT_MOST:
            raise ArgumentError(f"This study would have {self.members:,} members; at most {MEMBERS_AT_MOST:,} can be had.")

    @property
    def members(self) -> int:
        """How many rows the study's table has in the end."""
        if self.kind == "sweep":
            return int(np.prod([len(axis.values) for axis in self.axes], dtype=float))
        return self.base * (len(self.axes) + 2) if self.kind == "robust" else self.budget

    @cached_property
    def design(self) -> Sequence[Mapping[str, Any]]:
        """What every member's axes take, in the members' order; a tuning's members are not known beforehand."""
        names = [axis.name for axis in self.axes]
        if self.kind == "sweep":
            return [dict(zip(names, point, strict=True)) for point in itertools.product(*(axis.values for axis in self.axes))]
        if self.kind == "robust":
            return sampled(self.axes, saltelli(self.base, len(self.axes), self.sampler, self.seed))
        return ()

    @cached_property
    def robust_design(self) -> Sequence[Mapping[str, Any]]:
        """What the robust axes take, for each candidate of a tuning alike."""
        if not self.robust_axes:
            return ()
        return sampled(self.robust_axes, latin(self.robust_samples, len(self.robust_axes), self.seed))

    def generations(self) -> list[range]:
        """The members of each generation of a tuning."""
        starts = range(0, self.budget, self.population)
        return [range(start, min(start + self.population, self.budget)) for start in starts]

    def to_toml(self) -> str:
        """study.toml: the options as they are given on the command line."""
        rows: dict[str, Any] = {"kind": self.kind, "version": version(), "home": str(self.home)}
        rows[OPTION[self.kind]] = [axis.text for axis in self.axes]
        rows["seed"] = self.seed
        if self.kind == "robust":
            rows |= {"base": self.base, "sampler": self.sampler}
        if self.kind == "tune":
            rows |= {"objective": list(self.objectives), "budget": self.budget, "population": self.population}
        if self.robust_axes:
            rows |= {"robust_over": [axis.text for axis in self.robust_axes], "robust_samples": self.robust_samples}
        about = "# A study by dampen of scenario.toml beside it: `dampen resume` goes on with it, `dampen plot` draws it again.\n"
        return about + "".join(f"{key} = {literal(value)}\n" for key, value in rows.items())

    @cached_property
    def fingerprint(self) -> str:
        """Tells this study's rows from those of any other; where its modules are looked for does not count."""
        told = [line for line in self.to_toml().splitlines() if not line.startswith(("home =", "version ="))]
        return hashlib.sha256("\n".join([*told, to_toml(self.scenario)]).encode()).hexdigest()


def sweep_of(scenario: Scenario, vary: Sequence[str], home: Path = Path()) -> Definition:
    """A grid."""
    return Definition("sweep", scenario, read_axes("vary", vary, scenario), home=home)


def robust_of(
    scenario: Scenario, uncertain: Sequence[str], samples: int, sampler: str = "sobol", seed: int = 0, home: Path = Path()
) -> Definition:
    """At least `samples` runs, in the Saltelli design; its base is a power of two for Sobol points."""
    axes = read_axes("uncertain", uncertain, scenario)
    if sampler not in ("sobol", "latin"):
        raise wrong("sampler", 'be "sobol" or "latin"', sampler)
    if whole("samples", samples, 1) > MEMBERS_AT_MOST:
        raise wrong("samples", f"be <= {MEMBERS_AT_MOST}", samples)
    whole("seed", seed, 0)
    base = -(-samples // (len(axes) + 2))
    base = 1 << (base - 1).bit_length() if sampler == "sobol" else base
    return Definition("robust", scenario, axes, seed, max(base, 2), sampler, home=home)  # type: ignore[arg-type]


def tune_of(
    scenario: Scenario,
    search: Sequence[str],
    objective: Sequence[str],
    budget: int = 2000,
    population: int | None = None,
    seed: int = 0,
    robust_over: Sequence[str] = (),
    robust_samples: int = 16,
    home: Path = Path(),
) -> Definition:
    """A search for the best of what `search` ranges over."""
    axes = read_axes("search", search, scenario)
    check_objectives(objective, scenario)
    if population is None:
        population = 16 + int(6 * np.log(len(axes) + 1)) if len(objective) == 1 else 40  # large: the ground is rugged
    limits = (("budget", budget, 1), ("population", population, 4), ("robust_samples", robust_samples, 1), ("seed", seed, 0))
    for name, value, least in limits:
        whole(name, value, least)
    over = read_axes("uncertain", robust_over, scenario)
    return Definition(
        "tune", scenario, axes, seed, objectives=tuple(objective), budget=budget, population=population, robust_axes=over,
        robust_samples=robust_samples if over else 0, home=home,
    )  # fmt: skip


def check_objectives(objective: Sequence[str], scenario: Scenario) -> None:
    """Raise ArgumentError unless each is a figure of merit of the scenario, and named once."""
    known = columns(scenario)
    for name in objective:
        if name not in known:
            raise ArgumentError(f"Argument `objective` must be a figure of merit, but is {name!r}{suggestion(name, known)}")
    if not objective or len(set(objective)) < len(objective):
        raise ArgumentError("Argument `objective` must name each figure of merit once, and at least one.")


def whole(name: str, value: Any, least: int) -> int:
    """`value`, if it is a whole number that is large enough. Raises ArgumentError."""
    if not isinstance(value, int) or isinstance(value, bool) or value < least:
        raise wrong(name, f"be a whole number >= {least}", value)
    return value


def read_axes(option: Option, texts: Sequence[str], scenario: Scenario) -> tuple[Axis, ...]:
    """All axes of an option."""
    if not isinstance(scenario, Scenario):
        raise wrong("scenario", "be a Scenario, as `read_scenario` gives it", scenario)
    return tuple(read_axis(option, text, scenario) for text in texts)


def read_definition(folder: Path) -> Definition:
    """The study that a folder holds. Raises ArgumentError for any other folder."""
    try:
        text, scenario = ((folder / name).read_text(encoding="utf-8") for name in ("study.toml", "scenario.toml"))
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "not UTF-8 text"
        what = f"study.toml and scenario.toml cannot be read: {reason}."
        if (folder / "result.nc").is_file() and not (folder / "study.toml").exists():
            page = folder / "report.html"
            what = f"it holds a run, whose report is `{page}`." if page.is_file() else "it holds a run."
        raise ArgumentError(f"Study folder `{folder}` is not a study: {what}") from None
    try:
        table = tomllib.loads(text)
        kind, home = table["kind"], Path(table["home"])
        case = build(parse(scenario, str(folder / "scenario.toml")), home)
        axes = read_axes(OPTION[kind], table[OPTION[kind]], case)
        own = {
            name: table[name] for name in ("seed", "base", "sampler", "budget", "population", "robust_samples") if name in table
        }
        over = read_axes("uncertain", table.get("robust_over", []), case)
        objectives = tuple(table.get("objective", []))
        return Definition(kind, case, axes, objectives=objectives, robust_axes=over, home=home, **own)
    except ArgumentError:
        raise
    except (ValueError, KeyError, TypeError) as error:
        raise ArgumentError(
            f"Study file `{folder / 'study.toml'}` is not one of dampen's: {type(error).__name__}, {error}."
        ) from None
