"""`dampen export`: the plant, the controller and results for other tools."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from dampen.cli.terminal import ScenarioArgument, SetOption, err, free_folder, out, show_table, working
from dampen.component import ArgumentError

C_HELP = (
    "Write a scenario's sampled controller as C99, for a microcontroller: no dynamic memory, nothing but math.h, fixed tables; "
    "with guards, a self-test, a Makefile and a README that tells how to wire it.\n\nExamples:\n\n"
    "  dampen export c he2017-sampled --out firmware\n\n"
    "  dampen export c he2017-tuned --float --set numerics.mode=sampled "
    "--set 'sampling.command_limit={tip_w=5.0,tip_phi=5.0}'\n\n"
    "Exit status: 0, or 2 for bad input and for what cannot be exported."
)
FMU_HELP = (
    "Write a scenario's plant, its sampled controller, or both in closed loop as a functional mock-up unit (FMI 2.0, "
    "co-simulation) for Simulink, OpenModelica, FMPy and their like: C inside, built for this machine where there is a C "
    "compiler, with its sources for others.\n\nExamples:\n\n"
    "  dampen export fmu he2017-sampled --what plant --out plant.fmu\n\n"
    "  dampen export fmu he2017-sampled --what controller --out controller.fmu\n\n"
    "  dampen export fmu he2017-sampled --out loop.fmu\n\n"
    "Exit status: 0, or 2 for bad input and for what cannot be exported."
)
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
RangeOption = Annotated[
    list[str] | None,
    typer.Option("--range", metavar="PORT=LOW:HIGH", help="readings that are believed (default: twice the constraint)"),
]
PatienceOption = Annotated[
    int, typer.Option("--patience", min=0, help="readings in a row that may be replaced before the controller stops")
]
KeepGoingOption = Annotated[bool, typer.Option("--keep-going", help="do not stop where the constraint is crossed")]


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
    from dampen.export.files import check_ending, write_model
    from dampen.export.statespace import plant_model
    from dampen.scenarios.read import read_scenario

    check_ending(file)
    if step is not None and not (discrete and 0 < step < float("inf")):
        raise ArgumentError(
            f"Option `--step` must be > 0 s and go with `--discrete`, but is {step:g}{'' if discrete else ' alone'}."
        )
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


@app.command("c", help=C_HELP)
def c(
    scenario: ScenarioArgument,
    folder: Annotated[
        Path | None, typer.Option("--out", metavar="DIR", help="where to write (default: a new folder in runs/)")
    ] = None,
    single: Annotated[bool, typer.Option("--float/--double", help="in float, or in double")] = False,
    set_: SetOption = None,
    believed: RangeOption = None,
    patience: PatienceOption = 5,
    keep_going: KeepGoingOption = False,
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


@app.command(help=FMU_HELP)
def fmu(
    scenario: ScenarioArgument,
    file: Annotated[Path, typer.Option("--out", metavar="FILE", help="where to write: a file ending in .fmu")],
    what: Annotated[str, typer.Option("--what", metavar="WHAT", help="plant, controller or loop: both")] = "loop",
    sources_only: Annotated[bool, typer.Option("--sources-only", help="build nothing; whoever imports it does")] = False,
    set_: SetOption = None,
    believed: RangeOption = None,
    patience: PatienceOption = 5,
    keep_going: KeepGoingOption = False,
) -> None:
    """`dampen export fmu`."""
    from typing import get_args

    from dampen.export.c.blueprint import Guards
    from dampen.export.fmu.write import What, export_fmu
    from dampen.scenarios.read import read_scenario

    if what not in get_args(What):
        raise ArgumentError(f"Option `--what` must be plant, controller or loop, but is {what!r}.")
    if file.suffix != ".fmu":
        raise ArgumentError(f"Output file `{file}` must end in .fmu.")
    if what == "plant" and believed:
        raise ArgumentError("Option `--range` is for a controller, but with `--what plant` there is none.")
    guards = Guards(ranges(believed or []), patience, not keep_going)
    case = read_scenario(scenario, set_ or ())
    with working("Writing down what trials bring, and compiling"):
        unit = export_fmu(case, file, what, guards, not sources_only)  # type: ignore[arg-type]  # it has been looked at
    roles = [("inputs", "INPUT"), ("outputs", "OUTPUT"), ("parameters", ""), ("to be seen", "LOCAL")]
    known = {"INPUT", "OUTPUT", "LOCAL"}
    counts = [(name, sum(v.role == role if role else v.role not in known for v in unit.variables)) for name, role in roles]
    show_table(("Variables", "number"), [(name, str(count)) for name, count in counts], ("number",))
    out.print(unit.timing, markup=False)
    if not unit.built:
        reason = "as asked for" if sources_only else "no C compiler was found here, CC names one"
        err.print(f"Note: the unit has its sources, but no library built for this machine: {reason}.", markup=False)
    out.print(f"Unit: {unit.file}   ({unit.file.stat().st_size / 1e6:.2g} MB)", markup=False)


def ranges(given: list[str]) -> dict[str, tuple[float, float]]:
    """PORT=LOW:HIGH, taken apart."""
    found: dict[str, tuple[float, float]] = {}
    for text in given:
        port, _, ends = text.rpartition("=")
        low, _, high = ends.partition(":")
        if port in found:
            raise ArgumentError(f"Option `--range` must be given once for a port, but is given again as {text!r}.")
        try:
            found[port] = float(low), float(high)
            fine = found[port][0] < found[port][1]
        except ValueError:
            fine = False
        if not fine:
            raise ArgumentError(f"Option `--range` must look like PORT=LOW:HIGH with LOW < HIGH, but is {text!r}.")
    return found
