"""Which figures a run is shown in: a plan that the report draws."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

View = Literal["field", "port", "peaks", "delivered", "error", "tracking", "loop", "samples"]


@dataclass(frozen=True)
class FigurePlan:
    """One figure. view: "field" and "peaks" show the field `of`, all others the port `of`.

    controlled: False shows the run without control instead.
    """

    name: str
    view: View
    of: str
    caption: str
    controlled: bool = True
