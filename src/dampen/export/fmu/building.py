"""A unit's sources as a shared library for the machine that this runs on."""

from __future__ import annotations

import os
import platform
import shlex
import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from dampen.component import ArgumentError

FLAGS = ("-std=c99", "-O2", "-fPIC", "-shared", "-fvisibility=hidden", "-ffp-contract=off")


def platform_folder() -> str:
    """What FMI 2.0 calls this platform, such as linux64."""
    system = {"linux": "linux", "darwin": "darwin", "win32": "win"}.get(sys.platform, sys.platform)
    return f"{system}{64 if sys.maxsize > 2**32 else 32}"


def library_ending() -> str:
    """How a shared library's name ends here."""
    return {"darwin": ".dylib", "win32": ".dll"}.get(sys.platform, ".so")


def compiler() -> list[str] | None:
    """A C compiler, with arguments of its own: what the environment variable CC says, or the first that is found."""
    named = os.environ.get("CC", "").strip()
    if not named:
        return next(([found] for name in ("cc", "gcc", "clang") if (found := shutil.which(name))), None)
    try:
        words = [named] if shutil.which(named) else shlex.split(named)
    except ValueError:  # quotes without an end
        words = [named]
    found = shutil.which(words[0])
    if found is None:
        raise ArgumentError(f"Environment variable `CC` must name a C compiler, but is {named!r}, which is not found.")
    return [found, *words[1:]]


def library(sources: dict[str, str], identifier: str) -> bytes | None:
    """The library; None where there is no compiler. Raises ArgumentError, with what it said, where the compiler fails."""
    cc = compiler()
    if cc is None:
        return None
    try:
        with TemporaryDirectory() as folder:
            return built(cc, sources, Path(folder), f"{identifier}{library_ending()}")
    except OSError as error:
        raise ArgumentError(f"The unit cannot be built by `{shlex.join(cc)}`: {error}.") from None


def built(cc: list[str], sources: dict[str, str], folder: Path, name: str) -> bytes:
    """The library of that name, built in a folder."""
    for file, text in sources.items():
        (folder / file).write_text(text, encoding="utf-8")
    files = [file for file in sources if file.endswith(".c")]
    math = [] if platform.system() == "Windows" else ["-lm"]
    done = subprocess.run([*cc, *FLAGS, *files, "-o", name, *math], cwd=folder, capture_output=True, check=False)
    if done.returncode != 0:
        said = done.stderr.decode(errors="replace").strip().splitlines() or ["nothing"]
        worst = next((line for line in said if "error" in line.lower()), said[0])
        raise ArgumentError(f"The C compiler `{shlex.join(cc)}` could not build the unit; it said: {worst}")
    return (folder / name).read_bytes()
