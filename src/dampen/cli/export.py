"""`dampen export`: what leaves the house."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from dampen.cli.terminal import ScenarioArgument, SetOption, err, free_folder, out, show_table, working
from dampen.component import ArgumentError

HELP = "Take a controller or a structure elsewhere: C for a microcontroller."
C_HELP = (
    "Write a scenario's sampled controller as C99, for a microcontroller: no dynamic memory, nothing but math.h, fixed tables; "
    "with guards, a self-test, a Makefile and a README that tells how to wire it.\n\nExamples:\n\n"
    "  dampen export c he2017-sampled --out firmware\n\n"
    "  dampen export c he2017-tuned --float --set numerics.mode=sampled "
    "--set 'sampling.command_limit={tip_w=5.0,tip_phi=5.0}'\n\n"
    "Exit status: 0, or 2 for bad input and for what cannot be exported."
)

app = typer.Typer(no_args_is_help=True, rich_markup_mode=None, help=HELP)


@app.callback()
def export() -> None:
    """Makes `export` a group, with one command in it too."""


@app.command("c", help=C_HELP)
def c(
    scenario: ScenarioArgument,
    folder: Annotated[
        Path | None, typer.Option("--out", metavar="DIR", help="where to write (default: a new folder in runs/)")
    ] = None,
    single: Annotated[bool, typer.Option("--float/--double", help="in float, or in double")] = False,
    set_: SetOption = None,
    believed: Annotated[
        list[str] | None,
        typer.Option("--range", metavar="PORT=LOW:HIGH", help="readings that are believed (default: twice the constraint)"),
    ] = None,
    patience: Annotated[
        int, typer.Option("--patience", min=0, help="readings in a row that may be replaced before the controller stops")
    ] = 5,
    keep_going: Annotated[bool, typer.Option("--keep-going", help="do not stop where the constraint is crossed")] = False,
) -> None:
    """`dampen export c`."""
    from dampen.export.c.blueprint import Guards
    from dampen.export.c.write import export_c
    from dampen.scenarios.read import read_scenario

    guards = Guards(ranges(believed or []), patience, not keep_going)
    case = read_scenario(scenario, set_ or ())
    with working("Recording what the self-test replays"):
        done = export_c(case, free_folder(folder, f"{case.name}-c"), single, guards)
    cost = done.footprint
    rows = [("memory (RAM)", f"{cost.memory:,} bytes"), ("tables (flash)", f"{cost.tables:,} bytes")]
    rows += [(f"{kind} in a step", f"{number:,}") for kind, number in cost.step.items()]
    show_table(("Footprint", "at most"), rows, ("at most",))
    if single:
        bounds = zip(case.plant.ports, done.bound, strict=True)
        told = ", ".join(f"{bound:.2g} {port.effort_unit} at {port.name}" for port, bound in bounds)
        out.print(f"Commands within {told} of the simulation's, on the same readings.", markup=False)
    if any(port not in case.sampling.command_limit for port in case.ports):
        err.print("Note: without `sampling.command_limit` for every port, commands are numbers of any size.", markup=False)
    out.print(f"Controller: {done.folder}   (try `make test` there)", markup=False)


def ranges(given: list[str]) -> dict[str, tuple[float, float]]:
    """PORT=LOW:HIGH, taken apart."""
    found = {}
    for text in given:
        port, _, ends = text.partition("=")
        low, _, high = ends.partition(":")
        try:
            found[port] = float(low), float(high)
            fine = -1e30 < found[port][0] < found[port][1] < 1e30
        except ValueError:
            fine = False
        if not fine:
            raise ArgumentError(f"Option `--range` must look like PORT=LOW:HIGH with LOW < HIGH, but is {text!r}.")
    return found
