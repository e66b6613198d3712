"""A unit's sources as a shared library for the machine that this runs on."""

from __future__ import annotations

import os
import platform
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


def compiler() -> str | None:
    """A C compiler: what the environment variable CC says, or the first that is found."""
    named = os.environ.get("CC")
    candidates = [named] if named else ["cc", "gcc", "clang"]
    return next((found for name in candidates if (found := shutil.which(name))), None)


def library(sources: dict[str, str], identifier: str) -> bytes | None:
    """The library; None where there is no compiler. Raises ArgumentError, with what it said, where the compiler fails."""
    cc = compiler()
    if cc is None:
        return None
    with TemporaryDirectory() as folder:
        for name, text in sources.items():
            (Path(folder) / name).write_text(text, encoding="utf-8")
        out = Path(folder) / f"{identifier}{library_ending()}"
        files = [name for name in sources if name.endswith(".c")]
        math = [] if platform.system() == "Windows" else ["-lm"]
        done = subprocess.run(
            [cc, *FLAGS, *files, "-o", str(out), *math], cwd=folder, capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            said = (done.stderr.strip().splitlines() or ["nothing"])[0]
            raise ArgumentError(f"The C compiler `{cc}` could not build the unit; it said: {said}")
        return out.read_bytes()
