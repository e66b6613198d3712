"""The review in words, as a colleague would write it: what holds, what does not, and why."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dampen.analysis.audit.audit import Audit
from dampen.analysis.audit.finding import Finding
from dampen.analysis.credit import Credit, Variant
from dampen.analysis.limit.curve import Limit
from dampen.analysis.limit.standing import Standing
from dampen.component import listed
from dampen.report.style import TIMES, number, percent, quantity

ALIKE = 0.1  # residuals closer than this share, or than the resolution, are alike
HELD = ("frequencies held", "no control, frequencies held")
HEADINGS = {
    "energy": "Energy",
    "resolution": "Resolution",
    "assumptions": "Assumptions",
    "residual": "What is left",
    "boundedness": "Boundedness",
    "composite energy": "Composite energy",
    "gain conditions": "Gain conditions",
    "rates": "Rates",
    "bounds": "A-priori bounds",
}


def sentence(audit: Audit) -> str:
    """The outcome in one sentence."""
    judged = [finding for finding in audit.findings if finding.verdict in ("PASS", "FAIL")]
    held = sum(finding.verdict == "PASS" for finding in judged)
    if held == len(judged):
        return f"All {held} findings of the audit hold."
    sections = listed(list(dict.fromkeys(HEADINGS[f.section].lower() for f in audit.failed)))
    return f"{held} of {len(judged)} findings of the audit hold; what does not is about {sections}."


def holding(audit: Audit) -> list[str]:
    """What holds, section by section."""
    lines = []
    for section, findings in audit.sections.items():
        held = [finding for finding in findings if finding.verdict == "PASS"]
        if held:
            lines.append(f"{HEADINGS[section]}: {_held(section, held, findings)}.")
    return lines


def _held(section: str, held: Sequence[Finding], findings: Sequence[Finding]) -> str:
    """A section's good news in a line."""
    if section == "energy":
        account = [f"the account closes to {f.measured} of the largest energy" for f in held if f.id == "energy.account"]
        dissipated = ["its dissipation is what quadrature gives" for f in held if f.id == "energy.dissipated"]
        return "; ".join([*account, *dissipated, *("the control takes energy" for f in held if f.id == "energy.control-takes")])
    if section == "boundedness":
        margins = [f for f in held if f.id.startswith("margin.")]
        kept = [f"{f.id.removeprefix('margin.')} keeps its constraint ({f.measured.split(';')[0]})" for f in margins]
        signals = len(held) - len(margins)
        return "; ".join([*([f"{signals} signals do not grow along the trials"] if signals else []), *kept])
    if section == "composite energy":
        return f"E_j(T_b) falls from trial to trial at lambda = {listed([f.id.partition('=')[2] for f in held])} 1/s"
    if section == "gain conditions":
        return f"{listed(list(dict.fromkeys(f.id.split('.')[1] for f in held)))} are large enough on this run"
    if section == "rates":
        told = {"rates.slowest": "every motion of the loop decays", "rates.spillover": "no mode that the law left out grows"}
        return "; ".join(f"{told[f.id]} ({f.measured})" for f in held)
    if section == "bounds":
        return f"kept ({held[0].measured})"
    if section == "residual":
        return " ".join(f.meaning if f.id.endswith("energy") else f"{_subject(f)} it moves." for f in held).rstrip(".")
    if section == "assumptions":
        return "; ".join(dict.fromkeys(_assumed(f) for f in held))
    names = listed([f.id.partition(".")[2] for f in held])
    return f"all {len(held)} figures of merit are settled" if len(held) == len(findings) else f"settled are {names}"


def _assumed(finding: Finding) -> str:
    """An assumption that held, in a few words."""
    _, kind, *port = finding.id.split(".")
    return {
        "alignment": "trials are aligned",
        "equal-starts": "starts are equal",
        "repetition": "disturbance and reference repeat",
        "bound": f"{finding.criterion.split(' <=')[0]} stays within its stated bound",
        "moving": f"{'.'.join(port)} never stands still for a trial",
    }.get(kind, finding.criterion)


def _subject(finding: Finding) -> str:
    """What a row about the residual is about."""
    return "Energy" if finding.id.endswith("energy") else f"At {finding.id.removeprefix('residual.offset.')}"


def failing(audit: Audit) -> list[str]:
    """What does not hold, each with what it means; what is of one kind together."""
    together = ("resolution", "composite energy", "residual")
    lines = [f"Asked: {f.criterion}. Found: {f.measured}. {f.meaning}" for f in audit.failed if f.section not in together]
    rising = [f for f in audit.failed if f.section == "composite energy"]
    if rising:
        told = [f"{f.id.partition('=')[2]} 1/s ({f.measured.partition('rises: ')[2]})" for f in rising]
        terms = "; ".join(f.meaning.removeprefix("What rises: ").rstrip(".") for f in rising).split("; ")
        what = listed(list(dict.fromkeys(terms)))
        lines.append(f"E_j(T_b) rises from one trial to the next at lambda = {listed(told)}. What rises: {what}.")
    frozen = [_subject(f).removeprefix("At ") for f in audit.failed if f.section == "residual" and not f.id.endswith("energy")]
    if frozen:
        lines.append(f"The residual at {listed(frozen)} is no vibration: it is an offset, held by ports that stick.")
    lines += ["The energy that is left is trapped." for f in audit.failed if f.id == "residual.trapped-energy"]
    loose = [f for f in audit.failed if f.section == "resolution"]
    if loose:
        told = [f"{f.id.removeprefix('resolution.')} ({f.measured.partition('; ')[2]})" for f in loose]
        lines.append(f"Not settled by modes and step, and good to no more than this: {'; '.join(told)}.")
    return lines


def reasons(audit: Audit | None, credit: Credit | None) -> list[str]:
    """Why: what is trapped, and what each part of the law is worth."""
    lines = []
    if audit is not None:
        lines += [f"{_subject(f)}: {f.measured}. {f.meaning}" for f in audit.failed if f.section == "residual"]
    return lines + ([] if credit is None else credited(credit, audit))


def credited(credit: Credit, audit: Audit | None = None) -> list[str]:
    """For each port: what it comes to, with and without control, and what each part of the law is worth there; and what keeps
    the constraint."""
    if not credit.whole.ports or not all(np.isfinite(one.residual) for one in credit.whole.ports):
        return [f"The run itself is {credit.whole.status}: there is nothing to compare parts with."]
    lines = [line for one in credit.whole.ports for line in _at_port(credit, one.port, _alike(audit, one.port)) if line]
    broken = [v for v in _left_out(credit) if v.status != credit.whole.status]
    if broken:
        lost = [f"{_part(v)} ({v.status.replace('_', ' ')})" for v in broken]
        lines.append(f"What the run cannot do without: {listed(lost)}.")
    return lines


def _alike(audit: Audit | None, port: str) -> float:
    """How close two residuals must be to be told as alike: not what twice the modes or half the step change."""
    row = next(
        (f for f in (audit.findings if audit else ()) if f.id == f"resolution.RMS error of the last trial at {port}"), None
    )
    if row is None:
        return ALIKE
    own = row.values["as it is"].value
    others = [row.values[name].value for name in ("twice the modes", "half the step")]
    moves = [
        abs(other - own) / max(abs(own), abs(other), 1e-300)
        for other in others
        if isinstance(other, float) and isinstance(own, float)
    ]
    return max([ALIKE, *(2 * move for move in moves)])


def _at_port(credit: Credit, port: str, alike: float) -> list[str]:
    own, unit = credit.whole.at(port).residual, credit.whole.at(port).motion_unit

    def told(name: str) -> float | None:
        variant = credit.get(name)
        return variant.at(port).residual if variant is not None and variant.ports else None

    names = ("no control", "damping only", "ideal actuator", "damping only, ideal actuator")
    free, damped, ideal, bare = map(told, names)
    text = f"{port}: the RMS error at the end is {quantity(own, unit)}"
    text += f", {percent(own / free)} of the {quantity(free, unit)} without control" if free else ""
    if damped is not None:
        text += f"; damping alone comes to {quantity(damped, unit)}" + (", which is less" if damped < (1 - alike) * own else "")
    if ideal is not None:
        text += f"; through an ideal actuator it would be {quantity(ideal, unit)}"
        text += f", and {quantity(bare, unit)} by damping alone" if bare is not None else ""
    return [f"{text}.", _worth(credit, port, own, alike), _growth(port, own, free, *map(told, HELD))]


def _worth(credit: Credit, port: str, own: float, alike: float) -> str:
    """Which parts help at a port, and which harm: of those that the run could do without."""
    if own == 0:
        return ""
    parts = [(v, v.at(port).residual / own) for v in _left_out(credit) if v.status == credit.whole.status]
    worth = sorted(((v, r) for v, r in parts if r > 1 + alike), key=lambda pair: -pair[1])
    harm = sorted(((v, r) for v, r in parts if r < 1 - alike), key=lambda pair: pair[1])
    helps = f"What helps at {port}: {listed([_told(credit, v, r) for v, r in worth])}." if worth else ""
    harms = f"What harms at {port}: {listed([_told(credit, v, r) for v, r in harm])}." if harm else ""
    return f"{helps} {harms}".strip()


def _growth(port: str, own: float, free: float | None, held: float | None, held_free: float | None) -> str:
    """What the growth of the disturbance's frequencies does."""
    if not held or not free or not held_free:
        return ""
    controlled, alone = (f"{TIMES}{number(ratio, 2)}" for ratio in (own / held, free / held_free))
    return f"That the frequencies grow changes the residual at {port} by {controlled}, and by {alone} without control."


def _left_out(credit: Credit) -> list[Variant]:
    """The variants without a part of the law; of those that come to the very same, the first."""
    found: dict[tuple[float, ...], Variant] = {}
    for v in credit.variants:
        if v.ports and (v.name.startswith("without ") or v.name == "nothing learned"):
            found.setdefault(tuple(getattr(one, name) for one in v.ports for name in ("residual", "effort")), v)
    return list(found.values())


def _part(variant: Variant) -> str:
    return "learning" if variant.name == "nothing learned" else variant.name.removeprefix("without ").removeprefix("all ")


def _told(credit: Credit, variant: Variant, ratio: float) -> str:
    """A part, by what the residual is multiplied without it, and the energy where that says something else."""
    energy = variant.energy / credit.whole.energy if credit.whole.energy else 1.0
    other = (ratio < 1 and energy > 1 + ALIKE) or (ratio > 1 and energy < 1 - ALIKE)
    return f"{_part(variant)} ({TIMES}{number(ratio, 2)} without{f', energy {TIMES}{number(energy, 2)}' if other else ''})"


def limited(limits: Sequence[Limit], standings: Sequence[Standing]) -> list[str]:
    """Where a run lies against each limit, in words."""
    return [_against(limit, at) for limit, at in zip(limits, standings, strict=True)]


def _against(limit: Limit, at: Standing) -> str:
    own, least, reached = (quantity(value, at.unit) for value in (at.rms, at.bound, at.reached))
    text = f"{at.of}: the run's RMS is {own} at an effort of {quantity(at.effort, 'N')}. "
    text += "It lies BELOW the limit, which cannot be: do not trust this run. " if at.below else ""
    if at.bound:
        text += f"No forces of that effort at the same ports get below {least}, whatever they know of the disturbance; "
    else:
        text += f"From {quantity(limit.cancelled, 'N')} on the disturbance can be cancelled: there is no bound there; "
    text += f"some {'get' if at.bound else 'forces of its effort get'} to {reached}. "
    text += f"The run is {number(at.ratio, 3)} times above the bound. " if at.ratio else ""
    nearest = min(limit.points, key=lambda point: abs(point.effort - at.effort))
    text += (
        f"Peaks, which this does not bound: {quantity(at.peak, at.unit)} in the run, {quantity(nearest.peak, at.unit)} under the "
    )
    return text + f"best forces of about the same effort. Duality gap at most {max(point.gap for point in limit.points):.0e}."
