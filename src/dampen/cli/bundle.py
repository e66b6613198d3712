"""`dampen bundle` and `dampen rerun`: a run as one archive, and the archive run again."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from dampen.cli.terminal import out, progress_line, show_table, working
from dampen.component import ArgumentError

BUNDLE_HELP = (
    "Put a run's or a study's folder into one archive that can be cited and run again: scenario and all files that it names, "
    "results, report, and the versions of everything that made them, with a digest of every file.\n\n"
    "Example:\n\n  dampen bundle runs/he2017\n\nExit status: 0, or 2 for bad input."
)
RERUN_HELP = (
    "Check the files of an archive that `dampen bundle` wrote, run its scenario again, and say how far the two are apart.\n\n"
    "Example:\n\n  dampen rerun he2017.zip\n\nExit status: 0 when it ran, whatever the difference is; 2 for bad input."
)
APART = 1e-9  # of a signal's largest value: more than rounding


def bundle(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="the folder of a run or a study")],
    archive: Annotated[
        Path | None, typer.Option("--out", metavar="FILE", help="where to write (default: DIR's name, .zip, in this folder)")
    ] = None,
) -> None:
    """`dampen bundle`."""
    from dampen.studies.bundle import pack

    archive = archive or Path(f"{folder.absolute().name}.zip")
    if archive.suffix != ".zip":
        raise ArgumentError(f"Option `--out` must name a file ending in .zip, but is {str(archive)!r}.")
    with working("Packing"):
        pack(folder, archive)
    out.print(
        f"Archive: {archive}   ({archive.stat().st_size / 1e6:.2g} MB; `dampen rerun {archive}` runs it again)", markup=False
    )


def rerun(archive: Annotated[Path, typer.Argument(metavar="FILE", help="an archive that `dampen bundle` wrote")]) -> None:
    """`dampen rerun`."""
    from dampen.studies.bundle import rerun

    with progress_line("Running it again") as news:
        found = rerun(archive, lambda done, total: news(completed=done, total=total))
    rows = [(name, f"{value:.1e}" if value else "0") for name, value in found.differences.items()]
    show_table(("Signal", "largest difference, of its largest value"), rows, ("largest difference, of its largest value",))
    told = [f"{key} {found.then[key]} then, {found.now[key]} now" for key in found.then if found.then[key] != found.now[key]]
    if told:
        out.print(f"Made elsewhere: {'; '.join(told)}.", markup=False)
    if found.largest == 0:
        verdict = "The run is the same to the last bit."
    elif found.largest <= APART:
        verdict = f"The run is the same but for rounding: {found.largest:.1e} at most."
    else:
        verdict = (
            f"The run DIFFERS, by {found.largest:.1e} at most. Other processors and versions round differently, and a law that "
            "switches makes more of it from trial to trial."
        )
    out.print(verdict, markup=False)
