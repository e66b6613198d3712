"""The mark: a clamped beam, bent in its second mode, with its payload; behind it the same beam at rest."""

from __future__ import annotations

import math
from pathlib import Path

from dampen.report.style import PALETTES

BETA = 4.694091  # cos b cosh b = -1, the second root


def shape(x: float) -> float:
    """The second mode of a cantilever, 1 at its tip in size."""
    ratio = (math.cosh(BETA) + math.cos(BETA)) / (math.sinh(BETA) + math.sin(BETA))
    return (math.cosh(BETA * x) - math.cos(BETA * x) - ratio * (math.sinh(BETA * x) - math.sin(BETA * x))) / 2


def logo(scheme: str) -> str:
    """The picture as SVG, 96 by 64."""
    colours = PALETTES[scheme]
    points = [(14 + 64 * i / 40, 32 + 20 * shape(i / 40)) for i in range(41)]
    bent = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    tip = points[-1]
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 96 64" width="96" height="64" role="img" aria-label="dampen">'
        f'<path d="M14 32H80" stroke="{colours["uncontrolled"]}" stroke-width="1.5" stroke-dasharray="4 3"/>'
        f'<path d="M14 8V56" stroke="{colours["ink"]}" stroke-width="4" stroke-linecap="round"/>'
        f'<polyline points="{bent}" fill="none" stroke="{colours["displacement"]}" stroke-width="5" stroke-linejoin="round"/>'
        f'<rect x="{tip[0] - 6:.1f}" y="{tip[1] - 6:.1f}" width="12" height="12" rx="2" fill="{colours["rotation"]}"/></svg>\n'
    )


def write_logos(folder: Path) -> None:
    """Both marks into `folder`, touched only where they change."""
    for scheme, name in (("light", "logo.svg"), ("dark", "logo-dark.svg")):
        file, text = folder / name, logo(scheme)
        if not file.exists() or file.read_text(encoding="utf-8") != text:
            file.write_text(text, encoding="utf-8")
