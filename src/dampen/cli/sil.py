"""`dampen sil`: a controller that runs as a program of its own, in the loop with the simulated structure."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from dampen.cli.run import OutOption, compile_ahead, output_folder
from dampen.cli.terminal import BROKE_OFF, ScenarioArgument, SetOption, err, out, progress_line, show_table, working
from dampen.component import ArgumentError

if TYPE_CHECKING:
    from dampen.sil.agreement import Agreement
    from dampen.sil.exchanges import Exchanges
    from dampen.sil.loop import InTheLoop
    from dampen.simulation.bench import Bench

HELP = (
    "Run a sampled scenario with a controller that is a program of its own, such as `make sil` builds in a folder of "
    "`dampen export c`: in lock step, over a pipe or loopback UDP, every exchange timed. Commands act sampling.delay after the "
    "reading, as in the sampled run; the time that the program takes is measured, not simulated.\n\nExamples:\n\n"
    "  dampen export c he2017-sampled --out firmware && make -C firmware sil\n\n"
    "  dampen sil he2017-sampled --controller firmware/sil\n\n"
    "  dampen sil he2017-sampled --controller 'python3 mine.py' --timeout 1 --no-report\n\n"
    "  dampen sil he2017-sampled --controller firmware/sil --udp --drive\n\n"
    "Exit status: 0; 2 for bad input and a controller that cannot be started, does not answer the hello or is made for something "
    "else; 3 when the run broke off, since the controller died, fell silent or sent what is no answer, with what it has saved."
)


def sil(
    scenario: ScenarioArgument,
    controller: Annotated[
        str | None, typer.Option("--controller", metavar="COMMAND", help="the program to start, with its arguments")
    ] = None,
    set_: SetOption = None,
    folder: OutOption = None,
    udp: Annotated[
        bool, typer.Option("--udp", help="over loopback UDP: the program is started with `--udp PORT` behind")
    ] = False,
    port: Annotated[
        int | None, typer.Option("--port", metavar="PORT", help="UDP port of this machine where a program listens already")
    ] = None,
    drive: Annotated[
        bool, typer.Option("--drive", help="the program's own inverse of the actuators is in the loop, too")
    ] = False,
    timeout: Annotated[float, typer.Option("--timeout", metavar="S", help="how long an answer may take [s]")] = 5.0,
    compare: Annotated[bool, typer.Option("--compare/--no-compare", help="with the run under the scenario's own law")] = True,
    report: Annotated[bool, typer.Option("--report/--no-report", help="figures and report.html of the run")] = True,
) -> None:
    """`dampen sil`."""
    from dampen.scenarios.read import read_scenario
    from dampen.sil.agreement import Agreement
    from dampen.sil.loop import in_the_loop
    from dampen.sil.reach import reached
    from dampen.simulation.bench import Bench
    from dampen.simulation.seat import seated
    from dampen.simulation.stores import FileStore
    from dampen.toml import to_toml

    if (controller is None) == (port is None):
        raise ArgumentError("One of `--controller` and `--port` must be given: a program to start, or where one listens already.")
    case = read_scenario(scenario, set_ or ())
    bench = Bench(case)
    with (
        reached(case, controller, udp=udp, port=port, drive=drive, timeout=timeout) as counterpart,
        output_folder(folder, f"{case.name}-sil") as folder,
    ):
        (folder / "scenario.toml").write_text(to_toml(case), encoding="utf-8")
        compile_ahead(seated(case, inverts=drive), bench)
        if compare and Agreement.possible(case):
            compile_ahead(case, bench)
        try:
            with progress_line("Trials", case.task.trials) as update:
                store = FileStore(folder / "result.nc")
                done = in_the_loop(case, counterpart, bench, store, compare, lambda finished, trials: update(advance=1))
        finally:
            counterpart.exchanges.write(folder / "exchanges.parquet")
        show(done, folder, report, bench)


def show(done: InTheLoop, folder: Path, report: bool, bench: Bench) -> None:
    """What came of it, where everything is, and the exit status."""
    from dampen.report.exchange_times import draw_exchange_times

    result = done.result
    for line in result.warnings:
        if line != done.failure:
            err.print(f"Note: {line}", markup=False)
    show_times(done.exchanges)
    if done.agreement is not None and done.agreement.trials:
        show_agreement(done.agreement)
    page = None
    if len(done.exchanges.steps):
        with working("Drawing figures"):
            draw_exchange_times(done.exchanges.steps, done.exchanges.period, folder / "figures")
    if report and result.trials:
        page = written_report(done, folder, bench)
    out.print(f"Report: {page}" if page else f"Results: {folder / 'result.nc'}, exchanges.parquet", markup=False)
    if done.failure:
        err.print(done.failure, markup=False)
    if result.broke_off:
        err.print(f"The run broke off after {result.trials} of {result.scenario.task.trials} trials.", markup=False)
        raise typer.Exit(BROKE_OFF)


def written_report(done: InTheLoop, folder: Path, bench: Bench) -> Path:
    """The ordinary report of a run by itself."""
    from dampen.report.write import report_of
    from dampen.studies.experiment import Runs, own_review
    from dampen.studies.record import write_record

    with working("Drawing figures"):
        record = own_review(bench, done.result)
        write_record(folder, record)
        return report_of(Runs(done.result, None, None), folder, record)


def show_times(exchanges: Exchanges) -> None:
    """Round trips of the samples, and how many times faster than real time that is."""
    summary, period = exchanges.summary(), exchanges.period
    if not len(exchanges.steps):
        return
    rows = [
        (name, f"{1e6 * summary[name]:,.1f} µs", f"{period / summary[name]:,.3g} x real time")
        for name in ("median", "99 %", "largest")
    ]
    show_table(
        ("Round trip", "of a sample", f"period {1e6 * period:,.0f} µs"), rows, ("of a sample", f"period {1e6 * period:,.0f} µs")
    )
    told = f"{len(exchanges.steps):,} samples, {summary['late']:,.0f} of them took longer than the sample period"
    again = f"; requests sent again: {exchanges.repeats:,}" if exchanges.repeats else ""
    out.print(f"{told}{again}.", markup=False)


def show_agreement(agreement: Agreement) -> None:
    """How far it is from the sampled run."""
    rows = []
    for p, port in enumerate(agreement.scenario.plant.ports):
        command = f"{agreement.command[p]:.3g} of {agreement.largest_command[p]:.3g} {port.effort_unit}"
        rows.append((port.name, command, f"{agreement.displacement[p]:.3g} {port.motion_unit}"))
    headings = ("Against the sampled run", "commands differ by at most", "displacements by")
    show_table(headings, rows, headings[1:])
    if agreement.parted is None:
        out.print(f"All commands of {agreement.trials} trials are the sampled run's, bit for bit.", markup=False)
    else:
        trial, sample = agreement.parted
        out.print(f"Commands first differ at sample {sample} of trial {trial}.", markup=False)
