"""The command line: arguments in, functions called, messages out."""

from __future__ import annotations

import codecs
import gc
import os
import sys
from collections.abc import Sequence
from typing import Annotated, Any

import typer

from dampen.cli import bundle, compare, export, lab, review, run, sil, studies
from dampen.cli.terminal import BROKE_OFF, COMPLETED, ScenarioArgument, WithListing, WithOverview, complain, err, out
from dampen.component import ArgumentError, placed

KIND_HELP = 'a kind, such as backlash or "module:Class" of your own, or a table, such as plant; left out: all'
TYPER_INTERRUPTED = 130  # what typer makes of a KeyboardInterrupt that no command has caught
SPACED = "; leave out the spaces around =, or quote the whole: --set 'KEY = VALUE'."

# One function a command; heavy packages are imported where they are used, so that --help is quick.
app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"]},
    help="Design, simulate, check and tune boundary control and iterative learning control of vibrating structures.\n\n"
    "Begin with `dampen run he2017`: the experiment of He et al. 2017, with and without control, its figures and a verdict on "
    "each of its claims. Then `dampen show he2017 > mine.toml`, change it, and `dampen run mine.toml`.\n\n"
    "`dampen audit he2017` says what holds in it, what does not and why, and what each part of the law is worth; `dampen limit` "
    "how far it is from the best possible.\n\n"
    "One run proves little: `dampen compare` holds controllers against each other, and `sweep`, `robust` and `tune` make "
    "thousands of runs.",
)
app.command(cls=WithOverview, help=run.HELP)(run.run)
app.command(help=lab.HELP)(lab.lab)
app.command(help=review.AUDIT_HELP)(review.audit)
app.command(help=review.CREDIT_HELP)(review.credit)
app.command(help=review.LIMIT_HELP)(review.limit)
app.command(help=compare.HELP)(compare.compare)
app.command(help=studies.SWEEP_HELP)(studies.sweep)
app.command(help=studies.ROBUST_HELP)(studies.robust)
app.command(help=studies.TUNE_HELP)(studies.tune)
app.command(help=studies.RESUME_HELP)(studies.resume)
app.command(help=studies.PLOT_HELP)(studies.plot)
app.command(help=sil.HELP)(sil.sil)
app.command(help=bundle.BUNDLE_HELP)(bundle.bundle)
app.command(help=bundle.RERUN_HELP)(bundle.rerun)
app.add_typer(export.app, name="export")


@app.callback(invoke_without_command=True)
def version(show: Annotated[bool, typer.Option("--version", help="Show the version and exit.")] = False) -> None:
    """Only carries --version."""
    if show:
        from dampen.release import version as installed

        out.print(f"dampen {installed()}")
        raise typer.Exit


@app.command("list", cls=WithListing, help="List the shipped scenarios, and every kind with its parameters, units and defaults.")
def list_(
    kind: Annotated[str | None, typer.Argument(help=KIND_HELP)] = None,
) -> None:
    """`dampen list`."""
    from dampen.listing import listing

    out.print(listing(kind), markup=False)


@app.command(help="Print a scenario file, to copy: `dampen show he2017 > mine.toml`.")
def show(scenario: ScenarioArgument) -> None:
    """`dampen show`."""
    from dampen.scenarios.read import source_text

    sys.stdout.write(source_text(scenario))


def in_utf8() -> None:
    """Where the locale knows ASCII alone, begin again in UTF-8: names of files, titles and reports have other letters too."""
    if os.name == "posix" and codecs.lookup(sys.getfilesystemencoding()).name == "ascii":
        os.execve(sys.executable, sys.orig_argv, {**os.environ, "PYTHONUTF8": "1"})


def is_spaced(words: Sequence[str]) -> bool:
    """Whether the shell has taken a setting apart at the spaces around its =."""
    return any(word.startswith("=") or word.endswith("=") for word in words)


def as_setting(error: Any, words: Sequence[str]) -> str:
    """A hint for an option that is not there, where a command that takes settings was to set a parameter of a scenario."""
    option, command = getattr(error, "option_name", ""), getattr(getattr(error, "ctx", None), "command", None)
    at = next((i for i, word in enumerate(words) if option and word.partition("=")[0] == option), None)
    if at is None or not any("--set" in parameter.opts for parameter in getattr(command, "params", ())):
        return ""
    from dampen.scenarios.read import every_table

    value = words[at].partition("=")[2] or next(iter(words[at + 1 :]), "VALUE")
    return placed(option.lstrip("-").replace("-", "_"), every_table(), f"--set {{}}={value}")


def main() -> None:
    """Entry point: bad input is one clear line and exit status 2."""
    in_utf8()
    gc.set_threshold(200_000)  # a command makes many objects and few cycles: a tenth of its time
    try:
        status = app(standalone_mode=False) or COMPLETED
        if status == TYPER_INTERRUPTED:
            raise KeyboardInterrupt
    except ArgumentError as error:
        status = complain(error.lines)
    except (typer.Abort, KeyboardInterrupt):
        err.print("Interrupted.", markup=False)
        status = BROKE_OFF
    except (BrokenPipeError, SystemExit):  # whoever read the output has gone; click then wants to exit by itself
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        status = COMPLETED
    except OSError as error:  # a full disk, a folder without permission: what is written before is kept
        place = f" `{error.filename}`" if error.filename else ""
        complain([f"The system refuses to write or read{place}: {error.strerror or error}."])
        status = BROKE_OFF
    except Exception as error:
        if not hasattr(error, "format_message"):  # usage errors, whose class typer keeps to itself
            raise
        hint = SPACED if is_spaced(sys.argv) else as_setting(error, sys.argv)
        status = complain([error.format_message() + hint])
    if status == BROKE_OFF:
        exec("")  # else `python -m` ends by SIGINT, not with this status, where Ctrl-C came in code that a library made of text
    sys.exit(status)
