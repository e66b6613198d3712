"""Forces that do not change."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, ClassVar

import numpy as np
from annotated_types import Unit
from typing_extensions import Doc

from dampen.disturbances.base import Array, Content, Disturbance, columns, in_dict
from dampen.port import Site


@dataclass(frozen=True)
class ConstantLoad(Disturbance):
    """Constant forces at ports and a uniform load along the structure: a weight, a steady wind.

    d_p(t) = F_p,    f(x, t) = f_0
    """

    kind: ClassVar[str] = "constant"

    force: Annotated[dict[str, float], Unit("N, N m"), Doc("for each port the force F")] = field(default_factory=dict)
    load_density: Annotated[float, Unit("N/m"), Doc("uniform load f_0")] = 0.0
    field: Annotated[str, Doc("field that the load acts on")] = "w"

    def ports_named(self) -> Mapping[str, str]:
        return in_dict("force", self.force)

    def at_ports(self, trial: int, t: Array, site: Site) -> Array:
        return columns(site, t, {port: np.full(len(t), force) for port, force in self.force.items()})

    @property
    def load_field(self) -> str | None:
        return self.field if self.load_density else None

    def load(self, trial: int, t: Array, x: Array, site: Site) -> Array:
        return np.full((len(t), len(x)), self.load_density)

    def content(self, trial: int, site: Site) -> Content:
        return Content()

    def same_as(self, trial: int) -> int:
        return 0
