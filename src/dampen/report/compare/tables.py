"""The table of a comparison, a row for each contender: for the page, and narrower for a terminal."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from dampen.analysis.merits import merit
from dampen.report.study.names import math_unit, port_words
from dampen.report.study.tables import Grid
from dampen.report.style import DASH, MINUS
from dampen.studies.compare.comparison import Comparison, Contender, went_well

Cell = Callable[[Contender], str]


@dataclass(frozen=True)
class Column:
    """One column: its heading, its unit, what it says of a contender, and whether it is about what that costs."""

    head: str
    unit: str
    cell: Cell
    costs: bool = False

    @property
    def title(self) -> str:
        return f"{self.head} [{self.unit}]" if self.unit else self.head


def columns_of(found: Comparison) -> list[Column]:
    """Peak, RMS, settling, margin, effort, stuck, variation of the command, energy; and the objective at both numerics."""
    pushed = [p for p in found.ports if any(c.merits[f"effort.{p}"] > 0 for c in found.contenders)]
    together = {unit for p in pushed for unit in [found.ports[p][1]]}
    unit = together.pop() if len(together) == 1 else "N, N m" if together else ""
    columns = [Column(objective_head(found), objective_unit(found), lambda c: objective_value(found, c.merits))]
    if any(len(c.searches) > 1 for c in found.contenders):
        columns.append(Column("over searches", "", lambda c: searches_range(found, c)))
    columns.append(Column("the same, finer", "", lambda c: objective_value(found, c.refined.merits) if c.refined else DASH))
    for name, words, ports, which in (("peak", "peak", found.ports, 0), ("residual", "RMS", found.ports, 0)):
        columns += [of_port(name, words, port, found.ports[port][which]) for port in ports]
    columns.append(Column("settles in trial", "", lambda c: DASH if c.settling is None else str(c.settling)))
    if any("margin" in c.merits for c in found.contenders):
        columns.append(Column("margin", "", lambda c: share(c.merits["margin"])))
    columns += [of_port("effort", "effort", port, found.ports[port][1], costs=True) for port in pushed]
    columns.append(Column("stuck", "", lambda c: share(c.merits["stuck"]), costs=True))
    columns.append(Column("variation", unit, lambda c: short(c.merits["chatter"]), costs=True))
    columns.append(Column("energy", "J", lambda c: short(c.merits["energy"]), costs=True))
    return columns


def of_port(name: str, words: str, port: str, unit: str, costs: bool = False) -> Column:
    """A merit at one port."""
    return Column(f"{words} {port_words(port)}", math_unit(unit), lambda c: short(c.merits[f"{name}.{port}"]), costs)


def table(found: Comparison) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Headings and rows for the page; the first two columns are words."""
    columns = columns_of(found)
    heads = ("Contender", "Gains", *(column.title for column in columns))
    return heads, [(c.label, how(c), *(column.cell(c) for column in columns)) for c in found.contenders]


def terminal_tables(found: Comparison) -> list[tuple[list[str], list[list[str]]]]:
    """Headings and rows of two tables that fit a terminal: errors, and what they cost."""
    columns = columns_of(found)
    errors = [column for column in columns if column.costs is False]
    halves = [errors, [column for column in columns if column.costs]]
    tables = []
    for half, own in zip(halves, (("Contender", "Gains"), ("Contender",)), strict=True):
        words = [[c.label, how(c)][: len(own)] for c in found.contenders]
        rows = [[*text, *(column.cell(c) for column in half)] for text, c in zip(words, found.contenders, strict=True)]
        tables.append(([*own, *(column.title for column in half)], rows))
    return tables


def how(c: Contender) -> str:
    """How its gains came about, and what there is to say of its run."""
    words = "as given" if c.gains or c.source != "kind" else GIVEN[c.kind == "none"]
    if c.tuned:
        words = f"tuned from {BEGUN.get(c.source, 'its own gains')}, {tries(c)}"
    elif c.untuned:
        words = f"as it is: {c.untuned}, so it was not tuned"
    extras = [*(["through samples"] if c.sampled else []), *([STATUS[c.status]] if c.status in STATUS else [])]
    extras += ["forces did not settle"] if c.merits["unsettled"] > 0 else []
    return "; ".join([words, *extras])


def tries(c: Contender) -> str:
    """How many candidates it had, in how many searches."""
    count = len(c.searches)
    return f"{count} x {c.candidates // count}" if count > 1 else str(c.candidates)


def searches_range(found: Comparison, c: Contender) -> str:
    """The objective over a contender's searches; how many of them held, if not all."""
    held = sum(map(went_well, c.searches))
    few = f"{held} of {len(c.searches)} hold" if held < len(c.searches) else ""
    ends = c.over_searches(found.objective)
    if ends is None:
        return few or DASH
    low, high = (objective_value(found, {**c.merits, found.objective: end}) for end in ends)
    text = low if low == high else f"{low.removesuffix(' %')} to {high}"
    return f"{text}; {few}" if few else text


BEGUN = {"scenario": "the scenario's gains", "kind": "mid-range gains"}
GIVEN = {True: "none", False: "middle of its ranges"}
STATUS = {"constraint_lost": "constraint lost", "diverged": "diverged"}


def about(found: Comparison) -> str:
    """What the columns mean, with this comparison's numbers."""
    limits = ", ".join(f"{value:.3g} {found.ports[port][0]} at {port_words(port)}" for port, value in found.thresholds.items())
    finer = next((c.refined for c in found.contenders if c.refined is not None), None)
    text = "Peak, RMS (the residual) and mean energy are of the last five trials; effort is the RMS of the delivered force, "
    text += (
        "variation the total variation of the command, stuck the share of steps in which a port stuck, all over the whole run. "
    )
    text += f"A contender has settled from the first trial on from which the largest |error| stays within {limits} (5 % of "
    text += "the least room that the constraint leaves; without one 5 % of the largest error of all). "
    if finer is not None:
        text += f"Finer: the same gains on a fresh set of {finer.modes} modes with a step of {1e3 * finer.step:g} ms. "
    if any(len(c.searches) > 1 for c in found.contenders):
        text += "Over searches: the objective of the best of each search; the best of these is the row. "
    if any(c.tuned and c.source == "kind" for c in found.contenders):
        text += "Mid-range gains: the middle of the ranges that a kind of controller says. "
    return f"{text}Tuned: by CMA-ES for the {found.objective}, {budget_words(found)}, the constraint kept."


def budget_words(found: Comparison) -> str:
    """How much every contender that is tuned was searched for."""
    if found.searches == 1:
        return f"{found.budget} candidates each in one search, seed {found.seed}"
    seeds = f"seeds {found.seed} to {found.seed + found.searches - 1}"
    return f"{found.budget} candidates each in each of {found.searches} searches, {seeds}"


def objective_head(found: Comparison) -> str:
    """The objective's name as a heading."""
    return f"{found.objective.replace('.', ' ').replace('_', ' ')}"


def objective_unit(found: Comparison) -> str:
    """The unit of the objective's column, all units where ports differ in it; "" for shares, which carry it."""
    kind, _, port = found.objective.partition(".")
    unit = merit(kind).unit
    if is_share(found, found.contenders[0].merits) or unit not in ("motion", "effort"):
        return "" if unit not in ("J", "steps") else unit
    among = [port] if port else found.counted if unit == "motion" else found.ports
    return math_unit(", ".join(dict.fromkeys(found.ports[p][unit == "effort"] for p in among)))


def is_share(found: Comparison, merits: dict[str, float]) -> bool:
    """Whether the objective is a share."""
    kind, _, port = found.objective.partition(".")
    return kind in ("margin", "stuck") or (kind in ("peak", "residual") and not port and "margin" in merits)


def objective_value(found: Comparison, merits: dict[str, float]) -> str:
    """The objective: shares in percent."""
    value = merits[found.objective]
    return share(value) if is_share(found, merits) else short(value)


def share(value: float) -> str:
    """A share in percent, three digits."""
    return DASH if not math.isfinite(value) else f"{float(f'{100 * value:.3g}'):g} %".replace("-", MINUS)


def short(value: float) -> str:
    """Two or three digits, in as few letters as a narrow column has."""
    if not math.isfinite(value):
        return DASH
    if value == 0:
        return "0"
    if 0.01 <= abs(value) < 1e4:
        return f"{float(f'{value:.3g}'):g}".replace("-", MINUS)
    mantissa, power = f"{value:.1e}".split("e")
    return f"{mantissa}e{int(power)}".replace("-", MINUS)


def found_table(found: Comparison) -> Grid:
    """What each search began from and came to."""
    rows: list[tuple[str, ...]] = []
    for c in found.contenders:
        start = DASH if c.start is None else objective_value(found, {**c.merits, found.objective: c.start})
        gains = ", ".join(f"{name} {value:.4g}" for name, value in c.gains.items()) or DASH
        kept = f"{c.kept} of {c.candidates}" if c.tuned else DASH
        rows.append(
            (c.label, gains, "; ".join(c.notes) or DASH, start, objective_value(found, c.merits), kept, f"{c.seconds:.0f}")
        )
    text = f"The {found.objective} with the gains that the search began from (those of the scenario, or the middle of the ranges "
    text += "that a kind of controller says), and with those it came to; how many candidates kept the constraint."
    heads = ("Contender", "Gains that were searched", "Notes", "start", "found", "kept", "time [s]")
    return Grid("What was searched", text, heads, rows, 3)
