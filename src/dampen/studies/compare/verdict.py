"""What a comparison says, in sentences: who is best, whom the paper's law loses to, what the numbers cannot carry."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dampen.analysis.merits import merit, merit_unit
from dampen.controllers.dual_loop_ailc import DualLoopAILC
from dampen.simulation.scenario import Scenario
from dampen.studies.compare.comparison import Contender

EFFORT = "effort"
SENSITIVE = 2.0  # a factor between two numerics from which on a reader is told


def verdict(scenario: Scenario, contenders: Sequence[Contender], objective: str, budget: int = 0) -> tuple[str, ...]:
    """Sentences: the best in the objective, the own law and the paper's law against the others, who lost the constraint, whose
    figures depend on the numerics.

    A contender is better than another one only if it is so in every pair of their figures, at the experiment's numerics and at
    finer ones; else the two are not told apart. Who did not hold the constraint is not ranked.
    """
    held = [one for one in contenders if holds(one)]
    searched = f"With {budget} candidates for each that is tuned: " if budget else ""
    sentences = [first_up(searched + best(scenario, held, objective))] if held else ["No contender holds the constraint."]
    for i, one in enumerate(contenders):
        if i == 0:
            sentences += of_law(scenario, one, contenders, objective)
        elif one.kind == DualLoopAILC.kind:
            sentences += losses(scenario, one, contenders, objective)
    if len(held) > 1 and objective != EFFORT:
        names = [one.label for one in front(held, objective)]
        sentences.append(f"Of those that hold it nobody is better in both {words(objective)} and effort than {listed(names)}.")
    sentences += lost(contenders)
    sentences += [sensitive(scenario, one, objective) for one in held if is_sensitive(one, objective)]
    return tuple(sentences)


def lost(contenders: Sequence[Contender]) -> list[str]:
    """Who is not ranked, and at which numerics the constraint was lost."""
    here = [one.label for one in contenders if not one.held]
    finer = [one for one in contenders if one.held and not holds(one)]
    sentences = []
    if here and len(here) < len(contenders):
        do, are = ("does", "is") if len(here) == 1 else ("do", "are")
        sentences.append(f"{listed(here)} {do} not hold the constraint, and {are} not ranked.")
    for one in finer:
        sentences.append(f"{one.label} holds the constraint here, but not at {numerics(one)}, and is not ranked.")
    return sentences


def holds(one: Contender) -> bool:
    """Whether a contender's run can be ranked: it held at both numerics."""
    finer_too = one.refined is None or (one.refined.status == "complete" and one.refined.merits["unsettled"] == 0)
    return one.held and finer_too


def beats(one: Contender, other: Contender, objective: str) -> bool:
    """Whether one is better than the other by more than the numerics carry."""
    (low, high), (least, most) = one.span(objective), other.span(objective)
    return low > most if merit(objective).better == "high" else high < least


def front(held: Sequence[Contender], objective: str) -> list[Contender]:
    """Who is not bettered by anybody in one of objective and effort, and equalled in the other; by effort."""
    sign = -1 if merit(objective).better == "high" else 1
    order = sorted(held, key=lambda one: (one.merits[EFFORT], sign * one.merits[objective]))
    kept: list[Contender] = []
    for one in order:
        if not kept or sign * one.merits[objective] < sign * kept[-1].merits[objective]:
            kept.append(one)
    return kept


def best(scenario: Scenario, held: Sequence[Contender], objective: str) -> str:
    """The best, and who cannot be told apart from it."""
    sign = -1 if merit(objective).better == "high" else 1
    first = min(held, key=lambda one: sign * one.merits[objective])
    near = [one for one in held if one is not first and not beats(first, one, objective)]
    of = (
        " as a share of the constraint"
        if value(scenario, objective, 1.0) == "100 %" and objective in ("peak", "residual")
        else ""
    )
    text = f"best in {words(objective)}{of}: {first.label}, {both(scenario, first, objective)}"
    if near:
        text += f"; not told apart from it by these numerics: {', '.join(one.label for one in near)}"
    return text + "."


def of_law(scenario: Scenario, one: Contender, contenders: Sequence[Contender], objective: str) -> list[str]:
    """Whom a law loses to, by how much, whom it beats, and whom it is not told apart from."""
    others = rivals(one, contenders)
    if not holds(one) or not others:
        return []  # who does not hold is told elsewhere
    none = f"{one.label} loses to none of the {len(others)} others that hold the constraint."
    sentences = losses(scenario, one, contenders, objective) or [none]
    beaten = [o.label for o in others if beats(one, o, objective)]
    even = [o.label for o in others if not beats(one, o, objective) and not beats(o, one, objective)]
    if beaten:
        sentences.append(f"{one.label} beats {listed(beaten)} in {words(objective)}.")
    if even:
        sentences.append(f"{one.label} is not told apart from {listed(even)}: the numerics do not carry the difference.")
    return sentences


def losses(scenario: Scenario, one: Contender, contenders: Sequence[Contender], objective: str) -> list[str]:
    """Whom a law loses to, by how much; [] where to nobody, or where it is not ranked."""
    sign = -1 if merit(objective).better == "high" else 1
    winners = [o for o in rivals(one, contenders) if holds(one) and beats(o, one, objective)]
    if not winners:
        return []
    winners = sorted(winners, key=lambda o: sign * o.merits[objective])
    to = [f"{o.label} ({value(scenario, objective, o.merits[objective])}{factor(one, o, objective)})" for o in winners]
    return [f"{one.label} loses in {words(objective)} ({value(scenario, objective, one.merits[objective])}) to {listed(to)}."]


def rivals(one: Contender, contenders: Sequence[Contender]) -> list[Contender]:
    """All others that hold."""
    return [other for other in contenders if holds(other) and other is not one]


def factor(one: Contender, other: Contender, objective: str) -> str:
    """By what factor at least a law loses, over both numerics."""
    (low, _), (_, most) = one.span(objective), other.span(objective)
    if merit(objective).better == "high" or not most > 0:
        return ""
    return f", by a factor of at least {float(f'{low / most:.2g}'):g}"


def is_sensitive(one: Contender, objective: str) -> bool:
    """Whether a figure differs so much between two numerics that a reader is told."""
    low, high = one.span(objective)
    return bool(low > 0 and high > SENSITIVE * low)


def sensitive(scenario: Scenario, one: Contender, objective: str) -> str:
    """What a reader is told of it."""
    assert one.refined is not None
    fine = value(scenario, objective, one.refined.merits[objective])
    what = "its gains are tuned to their numerics" if one.tuned else "its figures depend on the numerics"
    coarse = value(scenario, objective, one.merits[objective])
    return f"{one.label}: {what}, its {words(objective)} is {coarse} here, but {fine} at {numerics(one)}."


def both(scenario: Scenario, one: Contender, objective: str) -> str:
    """A contender's figure at both numerics."""
    text = value(scenario, objective, one.merits[objective])
    if one.refined is None:
        return text
    return f"{text} ({value(scenario, objective, one.refined.merits[objective])} at {numerics(one)})"


def numerics(one: Contender) -> str:
    """The finer numerics of a contender, in words."""
    assert one.refined is not None
    return f"{one.refined.modes} modes and {1e3 * one.refined.step:g} ms"


def value(scenario: Scenario, name: str, number: float) -> str:
    """A figure with its unit; shares in percent."""
    kind, _, port = name.partition(".")
    if not np.isfinite(number):
        return "diverged"
    if kind in ("margin", "stuck") or (kind in ("peak", "residual") and not port and scenario.task.constraint):
        return f"{100 * number:.3g} %"
    unit = merit_unit(name, scenario)
    return f"{number:.3g} {unit if ', ' not in unit else ''}".strip()


def words(name: str) -> str:
    """A figure of merit in a sentence."""
    kind, _, port = name.partition(".")
    return f"{kind} at {port}" if port else kind


def first_up(text: str) -> str:
    """With a capital."""
    return text[0].upper() + text[1:]


def listed(names: Sequence[str]) -> str:
    """Names in a sentence."""
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"
