"""What a comparison says, in sentences: who is best, whom the paper's law loses to, what the numbers cannot carry."""

from __future__ import annotations

from collections.abc import Sequence

from dampen.analysis.merits import merit
from dampen.component import listed
from dampen.simulation.scenario import Scenario
from dampen.studies.compare.comparison import Contender, Run, ends, went_well
from dampen.studies.compare.wording import figure, first_up, over_searches, words

EFFORT = "effort"
SENSITIVE = 2.0  # a factor between two numerics from which on a reader is told
EQUAL = 1.05  # a factor below which two figures are about equal


def verdict(
    scenario: Scenario, contenders: Sequence[Contender], objective: str, budget: int = 0, searches: int = 1
) -> tuple[str, ...]:
    """Sentences: the best in the objective, the own law and the paper's law against the others, who lost the constraint, whose
    figures depend on the numerics.

    A contender is better than another one only if it is so in every pair of their figures, over all searches, at the
    experiment's numerics and at finer ones; else the two are not told apart. What rests on one search of either is told as
    that. Who did not hold the constraint is not ranked.
    """
    held = [one for one in contenders if holds(one)]
    sentences = [first_up(effort_made(budget, searches) + best(scenario, held, objective))] if held else [nobody(scenario)]
    if len(held) > 1 and any(one.once for one in held):
        sentences.append("This rests on one search for each that is tuned, and proves nothing: another seed may turn it round.")
    for i, one in enumerate(contenders):
        if i == 0:
            sentences += of_law(scenario, one, contenders, objective)
        elif one.paper:
            sentences += losses(scenario, one, contenders, objective)
    if len(held) > 1 and objective != EFFORT:
        names = [one.label for one in front(held, objective)]
        who = "Of those that hold the constraint nobody" if scenario.task.constraint else "Nobody"
        sentences.append(f"{who} is better in both {words(objective)} and effort than {listed(names)}.")
    sentences += lost(scenario, contenders)
    sentences += [sensitive(scenario, one, objective) for one in held if is_sensitive(one, objective)]
    return tuple(sentences)


def effort_made(budget: int, searches: int) -> str:
    """How much every contender was searched for."""
    where = "one search" if searches == 1 else f"each of {searches} searches"
    return f"With {budget} candidates in {where} for each that is tuned: " if budget else ""


def nobody(scenario: Scenario) -> str:
    """That there is nobody to rank."""
    return "No contender holds the constraint." if scenario.task.constraint else "No contender runs to its end."


def lost(scenario: Scenario, contenders: Sequence[Contender]) -> list[str]:
    """Who is not ranked, and why; at which numerics."""
    sentences = []
    here: dict[str, list[str]] = {}
    for one in contenders:
        if not one.held:
            here.setdefault(failure(one), []).append(one.label)
        elif one.refined is not None and not went_well(one.refined):
            kept = "holds the constraint" if scenario.task.constraint else "runs to its end"
            how = "" if one.refined.status == "constraint_lost" else f": there it {failure(one.refined)}"
            sentences.append(f"{one.label} {kept} here, but not at {numerics(one)}{how}, and is not ranked.")
    some_hold = any(one.held for one in contenders)
    told = [
        f"{listed(names)} {how if len(names) == 1 else PLURAL[how]}, and {'is' if len(names) == 1 else 'are'} not ranked."
        for how, names in here.items()
        if some_hold or how != LOST  # else the first sentence says so
    ]
    unsteady = [one.label for one in contenders if holds(one) and not one.steady]
    if unsteady:
        sentences.append(f"Not every search for {listed(unsteady)} came to gains that hold at both numerics.")
    return told + sentences


LOST = "does not hold the constraint"
UNSETTLED, SHORT = "has forces that did not settle", "did not run to its end"
PLURAL = {LOST: "do not hold the constraint", "diverged": "diverged", UNSETTLED: "have forces that did not settle",
          SHORT: "did not run to their ends"}  # fmt: skip


def failure(run: Run) -> str:
    """What went wrong in a run."""
    if run.status == "complete":
        return UNSETTLED
    return {"constraint_lost": LOST, "diverged": "diverged"}.get(run.status, SHORT)


def holds(one: Contender) -> bool:
    """Whether a contender's run can be ranked: it held at both numerics."""
    return all(map(went_well, ends(one)))


def beats(one: Contender, other: Contender, objective: str) -> bool:
    """Whether one is better than the other by more than searches and numerics carry."""
    (low, high), (least, most) = one.span(objective), other.span(objective)
    return one.steady and (low > most if merit(objective).better == "high" else high < least)


def factor(one: Contender, other: Contender, objective: str) -> float | None:
    """By what factor at least one loses to the other, over searches and numerics; None where factors mean nothing."""
    (low, _), (_, most) = one.span(objective), other.span(objective)
    return None if merit(objective).better == "high" or not most > 0 else low / most


def clearly(one: Contender, other: Contender, objective: str) -> bool:
    """Whether one beats the other by a factor that is worth the word."""
    by = factor(other, one, objective)
    return beats(one, other, objective) and (by is None or by >= EQUAL)


def front(held: Sequence[Contender], objective: str) -> list[Contender]:
    """Who is not bettered by anybody in one of objective and effort, and equalled in the other; by effort."""
    sign = merit(objective).sign
    order = sorted(held, key=lambda one: (one.merits[EFFORT], sign * one.merits[objective]))
    kept: list[Contender] = []
    for one in order:
        if not kept or sign * one.merits[objective] < sign * kept[-1].merits[objective]:
            kept.append(one)
    return kept


def best(scenario: Scenario, held: Sequence[Contender], objective: str) -> str:
    """The best, and who cannot be told apart from it."""
    sign = merit(objective).sign
    first = min(held, key=lambda one: sign * one.merits[objective])
    near = [one for one in held if one is not first and not clearly(first, one, objective)]
    of = " as a share of the constraint" if scenario.task.constraint and objective in ("peak", "residual") else ""
    text = f"best in {words(objective)}{of}: {first.label}, {every(scenario, first, objective)}"
    if near:
        text += f"; not told apart from it by {carriers(held)}: {', '.join(one.label for one in near)}"
    return text + "."


def carriers(contenders: Sequence[Contender]) -> str:
    """What the ranges are over."""
    return "these searches and numerics" if any(len(one.searches) > 1 for one in contenders) else "these numerics"


def of_law(scenario: Scenario, one: Contender, contenders: Sequence[Contender], objective: str) -> list[str]:
    """Whom a law loses to, by how much, whom it beats, and whom it is not told apart from."""
    others = rivals(one, contenders)
    if not holds(one) or not others:
        return []  # who does not hold is told elsewhere
    sentences = losses(scenario, one, contenders, objective)
    ahead = [o for o in others if clearly(one, o, objective)]
    if ahead and len(others) > 1 and not sentences:
        sentences.append(undefeated(scenario, one, others))
    beaten, once = split(one, ahead)
    if beaten:
        sentences.append(f"{one.label} beats {names_of(beaten)} in {words(objective)}.")
    if once:
        sentences.append(f"{one.label} comes out ahead of {names_of(once)} in {words(objective)} in this one search.")
    level = [o for o in others if o not in ahead and not clearly(o, one, objective)]
    equal = [o for o in level if beats(one, o, objective) or beats(o, one, objective)]
    even = [o for o in level if o not in equal]
    if equal:
        sentences.append(f"{one.label} is about equal to {names_of(equal)} in {words(objective)}.")
    if even:
        what = carriers([one, *even]).removeprefix("these ")
        sentences.append(f"{one.label} is not told apart from {names_of(even)}: {what} do not carry the difference.")
    return sentences


def undefeated(scenario: Scenario, one: Contender, others: Sequence[Contender]) -> str:
    """That a law loses to nobody."""
    do = "hold the constraint" if scenario.task.constraint else "run to their ends"
    loses = "comes out behind" if any(o.once for o in (one, *others)) else "loses to"
    return f"{one.label} {loses} none of the {len(others)} others that {do}."


def losses(scenario: Scenario, one: Contender, contenders: Sequence[Contender], objective: str) -> list[str]:
    """Whom a law loses to, by how much; [] where to nobody, or where it is not ranked."""
    sign = merit(objective).sign
    winners = [o for o in rivals(one, contenders) if holds(one) and clearly(o, one, objective)]
    surely, once = split(one, sorted(winners, key=lambda o: sign * o.merits[objective]))
    own, sentences = f"in {words(objective)} ({figure(scenario, objective, one.merits)})", []
    if surely:
        to = listed([winner(scenario, one, o, objective, "a factor of at least") for o in surely])
        sentences.append(f"{one.label} loses {own} to {to}.")
    if once:
        to = listed([winner(scenario, one, o, objective, "a factor of") for o in once])
        sentences.append(f"{one.label} comes out behind {own} in this one search: {to}.")
    return sentences


def winner(scenario: Scenario, one: Contender, other: Contender, objective: str, by: str) -> str:
    """One that a law loses to, its figure, and the factor."""
    times = factor(one, other, objective)
    told = "" if times is None else f", by {by} {float(f'{times:.2g}'):g}"
    return f"{other.label} ({figure(scenario, objective, other.merits)}{told})"


def split(one: Contender, others: Sequence[Contender]) -> tuple[list[Contender], list[Contender]]:
    """Those against whom more than one search was made on both sides, or none had to be; and the rest."""
    once = [o for o in others if one.once or o.once]
    return [o for o in others if o not in once], once


def names_of(contenders: Sequence[Contender]) -> str:
    """Their labels in a sentence."""
    return listed([one.label for one in contenders])


def rivals(one: Contender, contenders: Sequence[Contender]) -> list[Contender]:
    """All others that hold."""
    return [other for other in contenders if holds(other) and other is not one]


def is_sensitive(one: Contender, objective: str) -> bool:
    """Whether a figure differs so much between two numerics that a reader is told."""
    low, high = sorted((one.merits[objective], (one.refined or one).merits[objective]))
    return bool(low > 0 and high > SENSITIVE * low)


def sensitive(scenario: Scenario, one: Contender, objective: str) -> str:
    """What a reader is told of it."""
    assert one.refined is not None
    fine = figure(scenario, objective, one.refined.merits)
    what = "its gains are tuned to their numerics" if one.tuned else "its figures depend on the numerics"
    coarse = figure(scenario, objective, one.merits)
    return f"{one.label}: {what}, its {words(objective)} is {coarse} here, but {fine} at {numerics(one)}."


def every(scenario: Scenario, one: Contender, objective: str) -> str:
    """A contender's figure at both numerics, and over its searches."""
    extras = [] if one.refined is None else [f"{figure(scenario, objective, one.refined.merits)} at {numerics(one)}"]
    spread = over_searches(scenario, one, objective)
    extras += [f"{spread} over {len(one.searches)} searches"] if spread else []
    return figure(scenario, objective, one.merits) + (f" ({'; '.join(extras)})" if extras else "")


def numerics(one: Contender) -> str:
    """The finer numerics of a contender, in words."""
    assert one.refined is not None
    return f"{one.refined.modes} modes and {1e3 * one.refined.step:g} ms"
