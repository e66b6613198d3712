"""`dampen export`: the plant, the controller and results for other tools."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from dampen.cli.terminal import ScenarioArgument, SetOption, out

STATESPACE_HELP = (
    "Write the plant as a state-space model: forces at the ports in, displacements at the ports out, as A, B, C, D with names, "
    "units and the scenario, to a .mat file (MATLAB, Octave) or an .npz file (NumPy). From Python: dampen.state_space.\n\n"
    "Examples:\n\n  dampen export statespace he2017 --out beam.mat\n\n"
    "  dampen export statespace he2017 --modes 6 --residual --out beam.mat\n\n"
    "  dampen export statespace he2017 --discrete --step 0.002 --out beam.npz\n\nExit status: 0, or 2 for bad input."
)
RESULT_HELP = (
    "Write a result to a .mat file, or an .npz file: every variable, (trial, ...), with dimensions, units and the scenario.\n\n"
    "Example:\n\n  dampen export result runs/he2017/result.nc --out he2017.mat\n\nExit status: 0, or 2 for bad input."
)

app = typer.Typer(no_args_is_help=True, rich_markup_mode=None, help="Write plant, controller or results for other tools.")
FileOption = Annotated[Path, typer.Option("--out", metavar="FILE", help="where to write: a file ending in .mat or .npz")]


@app.command(help=STATESPACE_HELP)
def statespace(
    scenario: ScenarioArgument,
    file: FileOption,
    modes: Annotated[int | None, typer.Option("--modes", metavar="N", help="the lowest N modes (default: all)")] = None,
    residual: Annotated[bool, typer.Option("--residual", help="static compliance of all other modes as feedthrough")] = False,
    balanced: Annotated[
        int | None, typer.Option("--balanced", metavar="N", help="reduce to N states by balanced truncation")
    ] = None,
    rates: Annotated[bool, typer.Option("--rates", help="the ports' rates as outputs too")] = False,
    base: Annotated[bool, typer.Option("--base", help="the base's acceleration as an input too")] = False,
    discrete: Annotated[bool, typer.Option("--discrete", help="in discrete time, exact for held inputs")] = False,
    step: Annotated[
        float | None, typer.Option("--step", metavar="S", help="with --discrete: its time step [s] (default: the scenario's)")
    ] = None,
    set_: SetOption = None,
) -> None:
    """`dampen export statespace`."""
    from dampen.component import ArgumentError
    from dampen.export.files import check_ending, write_model
    from dampen.export.statespace import plant_model
    from dampen.scenarios.read import read_scenario

    check_ending(file)
    if step is not None and not (discrete and step > 0):
        raise ArgumentError("Option `--step` must be > 0 s and go with `--discrete`.")
    experiment = read_scenario(scenario, set_ or ())
    model = plant_model(
        experiment,
        modes,
        inputs=("ports", "base") if base else ("ports",),
        rates=rates,
        residual=residual,
        balanced=balanced,
        discrete=step if step is not None else discrete,
    )
    write_model(file, model, experiment)
    size = f"{len(model.states)} states, {len(model.inputs)} inputs, {len(model.outputs)} outputs"
    out.print(f"State space: {file} ({size}, {f'dt = {model.dt:g} s' if model.dt else 'continuous'})", markup=False)


@app.command(help=RESULT_HELP)
def result(
    source: Annotated[Path, typer.Argument(metavar="RESULT.nc", help="a result that `dampen run` has written")], file: FileOption
) -> None:
    """`dampen export result`."""
    from dampen.export.files import check_ending, write_result
    from dampen.scenarios.results import load

    check_ending(file)
    write_result(file, load(source))
    out.print(f"Result: {file}", markup=False)
