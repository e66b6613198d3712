"""Several disturbances at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated, ClassVar

from typing_extensions import Doc

from dampen.disturbances.base import Disturbance


@dataclass(frozen=True)
class Sum(Disturbance):
    """Several disturbances at once: forces, loads and accelerations add up.

    A term may itself be a sum; `parts` has them all in one row, and is what is sampled.
    """

    kind: ClassVar[str] = "sum"

    terms: Annotated[tuple[Disturbance, ...], Doc("the disturbances, each with its `kind`")]

    @property
    def parts(self) -> tuple[Disturbance, ...]:
        return tuple(part for term in self.terms for part in term.parts)

    def ports_named(self) -> Mapping[str, str]:
        return {f"terms[{i}].{name}": port for i, term in enumerate(self.terms) for name, port in term.ports_named().items()}

    def same_as(self, trial: int) -> int:
        """The first trial in which every term was what it is in `trial`: not before the latest of their first ones."""
        firsts = [term.same_as(trial) for term in self.terms]
        candidates = range(max(firsts, default=0), trial)
        return next((j for j in candidates if [term.same_as(j) for term in self.terms] == firsts), trial)

    @property
    def by_chance(self) -> bool:
        return any(term.by_chance for term in self.terms)

    def held(self) -> Sum:
        return replace(self, terms=tuple(term.held() for term in self.terms))
