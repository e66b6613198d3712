"""The page: one HTML file that opens anywhere, without a network."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined, Template
from markupsafe import Markup, escape

from dampen.analysis.claims import Claim, verdict_sentence
from dampen.analysis.sampling_cost import METRICS, Cost
from dampen.report.facts import account_rows, cost_row, facts, gains, status_sentence
from dampen.report.figures import Drawn, Job
from dampen.report.glossary import WORDS
from dampen.report.joined import uncontrolled
from dampen.report.review.parts import Parts
from dampen.report.style import typeset
from dampen.scenarios.claims import legend
from dampen.simulation.result import Result
from dampen.simulation.trials import LOST
from dampen.toml import to_toml

MIME = {"svg": "image/svg+xml", "png": "image/png"}
ONE_COLUMN = 4.0


def write_page(
    path: Path,
    result: Result,
    baseline: Result | None,
    claims: list[Claim],
    figures: Sequence[Drawn[Job]],
    note: str = "",
    costs: Sequence[Cost] = (),
    review: Parts | None = None,
) -> Path:
    """Write the page; `figures` are embedded in the format that makes the smaller page. costs: what sampling costs.
    review: what the audit found."""
    kind = smaller_format(figures)
    shown = [embedded(drawn, kind) for drawn in figures]
    key = key_figure(figures)
    text = template().render(
        title=result.scenario.title or result.scenario.name,
        verdict=verdict(claims, figures, key),
        status=status_sentence(result, baseline),
        facts=facts(result),
        claims=claims,
        failed=[claim for claim in claims if claim.holds is False],
        legend=legend(result),
        words=WORDS.items(),
        key=None if key is None else shown[key],
        figures=[f for f in shown if f["name"] != "energy"],
        energy=next((f for f in shown if f["name"] == "energy"), None),
        account=account_rows(result, baseline),
        review=review,
        costs=[(*cost_row(cost), METRICS[cost.metric]) for cost in costs],
        warnings=[line for line in result.warnings if not line.startswith(LOST)],
        gains=gains(result),
        note=note,
        toml=to_toml(result.scenario),
        version=result.version,
    )
    path.write_text(text, encoding="utf-8")
    return path


def smaller_format(figures: Sequence[Drawn[Any]]) -> str:
    """The format in which all figures together take less space."""
    sizes = {kind: sum(d.files[kind].stat().st_size for d in figures) for kind in MIME if all(kind in d.files for d in figures)}
    if not sizes:
        raise ValueError(f"Argument `figures` must all be there as one of {', '.join(MIME)}.")
    return min(sizes, key=sizes.__getitem__)


def embedded(drawn: Drawn[Any], kind: str) -> dict[str, Any]:
    """What the template needs of a figure."""
    name = re.sub(r"^fig0*(\d+)$", r"Fig. \1", drawn.job.name)
    return {
        "name": drawn.job.name,
        "label": name if name != drawn.job.name else "",
        "caption": drawn.job.caption,
        "sentence": drawn.sentence,
        "wide": drawn.size[0] > ONE_COLUMN,
        "width": round(96 * drawn.size[0]),
        "height": round(96 * drawn.size[1]),
        "uri": f"data:{MIME[kind]};base64,{b64encode(drawn.files[kind].read_bytes()).decode()}",
    }


def key_figure(figures: Sequence[Drawn[Job]]) -> int | None:
    """The one figure of the first screen: a port that follows or moves under control, else a port, else whatever comes first."""
    ports = [i for view in ("tracking", "port") for i, d in enumerate(figures) if d.job.view == view]
    controlled = [i for i in ports if not uncontrolled(figures[i].job.run)]
    return next(iter([*controlled, *ports, *range(len(figures))]), None)


def verdict(claims: list[Claim], figures: Sequence[Drawn[Job]], key: int | None) -> str:
    """The outcome in one sentence: of the claims, or else of the key figure."""
    if claims:
        return verdict_sentence(claims)
    return "" if key is None else figures[key].sentence


def typeset_html(text: str) -> Markup:
    """Plain text as HTML: Greek letters and signs as `typeset` writes them, lowered indices such as u_0."""
    return Markup(re.sub(r"\b(\w)_(\w+)\b", r"\1<sub>\2</sub>", str(escape(typeset(text)))))


@cache
def template(name: str = "page.html.j2") -> Template:
    """A page's template, with its one filter."""
    environment = Environment(
        loader=PackageLoader("dampen.report", "."),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["typeset"] = typeset_html
    return environment.get_template(name)
