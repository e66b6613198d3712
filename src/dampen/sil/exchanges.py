"""Every exchange with a controller, as a table, and what it says about its speed."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from dampen.component import ArgumentError
from dampen.sil.packets import DRIVE, KINDS, STEP

Array = np.ndarray
NO_TRIAL = -1  # of the hello and the bye
NO_ANSWER = -1  # as status: none came that could be used


@dataclass
class Exchanges:
    """What was asked, and how long the answer took; a row each.

    trial, sample: at which, -1 where none is on.   kind: of the packet.   round_trip: [s] from sending the request until the
    whole answer was there, nan where none came.   asked: how often it was sent.   status: the controller's, -1 without an answer.
    """

    period: float
    rows: list[tuple[int, int, int, float, int, int]] = field(default_factory=list)

    def add(self, trial: int, sample: int, kind: int, round_trip: float, asked: int, status: int) -> None:
        """One more."""
        self.rows.append((trial, sample, kind, round_trip, asked, status))

    @property
    def columns(self) -> dict[str, Any]:
        """The table, by column."""
        trial, sample, kind, round_trip, asked, status = zip(*self.rows, strict=True) if self.rows else ((),) * 6
        return {
            "trial": np.array(trial, np.int32), "sample": np.array(sample, np.int32), "kind": [KINDS[one] for one in kind],
            "round_trip": np.array(round_trip, float), "asked": np.array(asked, np.int32), "status": np.array(status, np.int32),
        }  # fmt: skip

    @property
    def steps(self) -> Array:
        """(steps,) round trips of the samples that were answered [s]."""
        return np.array([row[3] for row in self.rows if row[2] in (STEP, DRIVE) and row[5] != NO_ANSWER])

    @property
    def repeats(self) -> int:
        """Requests that had to be sent again."""
        return sum(row[4] - 1 for row in self.rows if row[4] > 1)

    def summary(self) -> dict[str, float]:
        """Of the samples' round trips [s]: median, 99 % and largest; late: how many took longer than a sample period."""
        trips = self.steps
        if not len(trips):
            return {"median": np.nan, "99 %": np.nan, "largest": np.nan, "late": 0}
        median, most = np.quantile(trips, [0.5, 0.99])
        return {"median": median, "99 %": most, "largest": trips.max(), "late": int((trips > self.period).sum())}

    def write(self, path: Path) -> None:
        """As a Parquet file."""
        import pyarrow
        from pyarrow import parquet

        try:
            parquet.write_table(pyarrow.table(self.columns), path)
        except OSError as error:
            raise ArgumentError(f"File `{path}` cannot be written: {error.strerror or error}.") from None
