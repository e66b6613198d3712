"""Forces and accelerations from a record."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, ClassVar, Literal

from annotated_types import Unit
from typing_extensions import Doc

from dampen.component import ArgumentError, InFile
from dampen.disturbances.base import Array, Content, columns, in_dict
from dampen.disturbances.clock import Clocked, Trials
from dampen.port import Site
from dampen.recording import Recording, pin, read_recording


@dataclass(frozen=True)
class Recorded(Clocked):
    """Forces at ports, or the acceleration of the base, from columns of a CSV or NetCDF file, with straight lines between rows.

        d_p(t) = scale r_p(t),    a(t) = scale r_base(t)

    A CSV file has a line of names, then numbers; a NetCDF file has variables of one dimension. The clock is the record's: what
    lies before its first time or after its last is 0, or the record again. `sha256` pins the content: left out, it is filled
    in; given, a file with another content is refused when the disturbance is sampled, and until then need not be there.
    """

    kind: ClassVar[str] = "recorded"

    file: Annotated[str, InFile(), Doc("the record, CSV or NetCDF")]
    columns: Annotated[dict[str, str], Doc("for each port the name of its column")] = field(default_factory=dict)
    base: Annotated[str, Doc("name of the column with the base's acceleration; left out, the base is at rest")] = ""
    time: Annotated[str, Doc("name of the column with the times [s]")] = "time"
    scale: Annotated[float, Unit("N, N m, m/s^2"), Doc("factor on all columns: what a 1 in the file means")] = 1.0
    outside: Annotated[Literal["zero", "repeat"], Doc("what there is outside the record")] = "zero"
    sha256: Annotated[str, Doc("SHA-256 of the file's content")] = ""
    trials: Trials = "repeat"

    def __post_init__(self) -> None:
        super().__post_init__()
        pin(self)

    def recording(self) -> Recording:
        """The record, read once. Raises ArgumentError where file, content or columns are not what they should be."""
        wanted = [("time", self.time), *((f"columns.{port}", name) for port, name in self.columns.items())]
        return read_recording(self.file, self.sha256, [*wanted, *([("base", self.base)] if self.base else [])])

    def ports_named(self) -> Mapping[str, str]:
        return in_dict("columns", self.columns)

    def at_ports(self, trial: int, t: Array, site: Site) -> Array:
        t = self.clock(trial, t, site)
        return columns(site, t, {port: self._signal(name, t) for port, name in self.columns.items()})

    def base_acceleration(self, trial: int, t: Array, site: Site) -> Array | None:
        return self._signal(self.base, self.clock(trial, t, site)) if self.base else None

    def content(self, trial: int, site: Site) -> Content:
        """Frequencies below which 99.9 % of the variance lies."""
        try:
            record = self.recording()
        except ArgumentError as error:
            raise error.under("disturbance") from None
        heard = {port: record.highest_frequency(name) for port, name in self.columns.items()}
        return Content(
            port_frequency=tuple(heard.get(port.name, 0.0) for port in site.ports),
            load_frequency=record.highest_frequency(self.base) if self.base else 0.0,
        )

    def _signal(self, name: str, t: Array) -> Array:
        return self.scale * self.recording().at(name, t, self.outside)
