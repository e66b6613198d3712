"""What was recorded, or computed elsewhere."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal

from typing_extensions import Doc

from dampen.component import InFile
from dampen.recording import Recording, pin, read_recording
from dampen.signals.base import Array, Signal


@dataclass(frozen=True)
class RecordedSignal(Signal):
    """A column of a CSV or NetCDF file, with straight lines between rows.

        r(t) = scale c(t)

    A CSV file has a line of names, then numbers; a NetCDF file has variables of one dimension. Before the record's first time
    and after its last one the signal is held, or the record comes again. `sha256` pins the content: left out, it is filled
    in; given, a file with another content is refused when the signal is sampled, and until then need not be there.
    """

    kind: ClassVar[str] = "recorded"

    file: Annotated[str, InFile(), Doc("the record, CSV or NetCDF")]
    column: Annotated[str, Doc("name of the column with the values")]
    time: Annotated[str, Doc("name of the column with the times [s]")] = "time"
    scale: Annotated[float, Doc("factor on the column: what a 1 in the file means")] = 1.0
    outside: Annotated[Literal["hold", "repeat"], Doc("what there is outside the record")] = "hold"
    sha256: Annotated[str, Doc("SHA-256 of the file's content")] = ""

    def __post_init__(self) -> None:
        super().__post_init__()
        pin(self)

    def recording(self) -> Recording:
        """The record, read once. Raises ArgumentError where file, content or column are not what they should be."""
        return read_recording(self.file, self.sha256, [("time", self.time), ("column", self.column)])

    def sample(self, t: Array, trial: int) -> Array:
        return self.scale * self.recording().at(self.column, t, self.outside)
