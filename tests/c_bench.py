"""A bench for controllers that were exported as C: compiled into a library, or into a program under the compilers' checks."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from dampen.export.c.blueprint import Guards, blueprint
from dampen.export.c.recording import Recorded, record
from dampen.export.c.source import source_of
from dampen.export.c.write import bound_of
from dampen.simulation.bench import Bench
from dampen.simulation.scenario import Scenario

COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)]
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-ffp-contract=off")
CHECKED = ("-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
SHIM = """
#include "controller.h"
static dampen_controller c;
void bench_start(void) { dampen_init(&c); }
int bench_step(const double *readings, double *commands, double *drives)
{
    dampen_real reading[DAMPEN_PORTS], command[DAMPEN_PORTS];
    for (int p = 0; p < DAMPEN_PORTS; p++) reading[p] = (dampen_real)readings[p];
    const dampen_status status = dampen_step(&c, reading, command);
    for (int p = 0; p < DAMPEN_PORTS; p++) commands[p] = drives[p] = command[p];
#ifdef DRIVEN
    dampen_real drive[DAMPEN_PORTS];
    dampen_drive(&c, command, drive);
    for (int p = 0; p < DAMPEN_PORTS; p++) drives[p] = drive[p];
#endif
    return status;
}
int bench_end_trial(const double *readings)
{
    dampen_real reading[DAMPEN_PORTS];
    for (int p = 0; p < DAMPEN_PORTS; p++) reading[p] = (dampen_real)readings[p];
    return dampen_end_trial(&c, reading);
}
void bench_restart(void) { dampen_restart(&c); }
int bench_replaced(void) { return (int)c.replaced; }
unsigned long bench_size(void) { return sizeof c; }
int bench_trial(int count, const double *readings, double *commands, double *drives)
{
    int worst = 0;
    for (int i = 0; i < count; i++) {
        const int status = bench_step(readings + i * DAMPEN_PORTS, commands + i * DAMPEN_PORTS, drives + i * DAMPEN_PORTS);
        worst = status > worst ? status : worst;
    }
    const int status = bench_end_trial(readings + count * DAMPEN_PORTS);
    return status > worst ? status : worst;
}
"""


@dataclass(frozen=True)
class Bare:
    """A controller as a library; arrays are (ports,) of double, whatever it computes in."""

    library: Any
    ports: int

    def start(self) -> None:
        self.library.bench_start()

    def step(self, reading: np.ndarray) -> tuple[int, np.ndarray, np.ndarray]:
        """Status, commands, drives."""
        command, drive = np.zeros(self.ports), np.zeros(self.ports)
        status = self.library.bench_step(pointer(reading), pointer(command), pointer(drive))
        return status, command, drive

    def end_trial(self, reading: np.ndarray) -> int:
        return int(self.library.bench_end_trial(pointer(reading)))

    def trial(self, readings: np.ndarray) -> tuple[int, np.ndarray, np.ndarray]:
        """A trial and its end: the worst status, commands and drives."""
        commands, drives = np.zeros((len(readings) - 1, self.ports)), np.zeros((len(readings) - 1, self.ports))
        status = self.library.bench_trial(len(commands), pointer(readings), pointer(commands), pointer(drives))
        return status, commands, drives


def pointer(array: np.ndarray) -> Any:
    assert array.flags.c_contiguous
    assert array.dtype == float
    return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


def written(case: Scenario, folder: Path, single: bool = False, guards: Guards | None = None, bench: Bench | None = None) -> Any:
    """The two files of a controller; its source."""
    source = source_of(blueprint(case, single, guards, bench))
    for name in ("controller.h", "controller.c"):
        (folder / name).write_text(source.file(name))
    return source


def built(case: Scenario, folder: Path, single: bool = False, guards: Guards | None = None, bench: Bench | None = None) -> Bare:
    """The controller as a library."""
    source = written(case, folder, single, guards, bench)
    (folder / "shim.c").write_text(SHIM)
    name = folder / f"controller-{'float' if single else 'double'}.so"
    driven = ("-DDRIVEN",) if source.stages else ()
    compile_c(COMPILERS[0], ("-O2", "-shared", "-fPIC", *driven), [folder / "controller.c", folder / "shim.c"], name)
    library = ctypes.CDLL(str(name))
    library.bench_size.restype = ctypes.c_ulong
    library.bench_start()
    return Bare(library, len(case.ports))


def compile_c(compiler: str, flags: tuple[str, ...], files: list[Path], out: Path) -> None:
    library = () if "-c" in flags else ("-lm",)
    done = subprocess.run(
        [compiler, *STRICT, *flags, *map(str, files), "-o", str(out), *library], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr


@cache
def recorded(case_key: str, case: Any) -> tuple[Bench, tuple[Recorded, ...]]:
    """A run's trials and its bench, once for all tests of a process."""
    bench = Bench(case())
    return bench, tuple(record(case(), bench))


def stated_bound(case: Scenario, trials: tuple[Recorded, ...], bench: Bench) -> np.ndarray:
    """The stated bound in float, from the first two trials, as an export has it."""
    return bound_of(blueprint(case, True, None, bench), trials[:2])
