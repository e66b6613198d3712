"""Runs at the edges: very small and very large structures, costs that are refused, folders and disks that are taken."""

from __future__ import annotations

import os
import shutil
import sys
from collections import namedtuple
from pathlib import Path

import numpy as np
import pytest

import dampen
from dampen.cli.run import output_folder
from dampen.simulation import cost
from dampen.simulation.bench import Bench
from dampen.simulation.stores import FileStore
from tests.conftest import scenario
from tests.test_scenarios import dampen_command

SMALL = ("task.trials=2", "task.trial_duration=0.05", "numerics.modes=4", "output.every=10", "controller.kind=none")


def test_a_cantilever_of_ten_micrometres() -> None:
    """Silicon, 10 x 1 x 0.2 um: the frequencies are those of the closed form, and a run closes its account."""
    rho, ei, length = 2330 * 0.2e-12, 170e9 * 1e-6 * (0.2e-6) ** 3 / 12, 10e-6
    beam = dampen.EulerBernoulliBeam(
        mass_per_length=rho, length=length, bending_stiffness=ei, tip_mass=0.0, tip_inertia=0.0,
        initial=dampen.plants.deflection.Deflection(w=(0.0, 0.0, 1e2)),
    )  # fmt: skip
    roots = np.array([1.8751040687119611, 4.694091132974175, 7.854757438237613])
    case = dampen.Scenario(
        beam, dampen.NoControl(), dampen.NoDisturbance(), dampen.Task(trials=2, trial_duration=2e-6),
        numerics=dampen.Numerics(modes=8, step=1e-8), output=dampen.Output(points=5, every=10),
    )  # fmt: skip
    exact = roots**2 * np.sqrt(ei / rho) / length**2
    np.testing.assert_allclose(Bench(case).modes.omega[:3], exact, rtol=1e-10)
    result = dampen.simulate(case, compile=False)
    finding = next(f for f in dampen.audit(result, refine=False).findings if f.id == "energy.account")
    assert finding.verdict == "PASS"


def test_a_riser_of_a_kilometre() -> None:
    """A taut line with periods of half a minute: frequencies of the closed form."""
    line = dampen.String(mass_per_length=700.0, length=1000.0, tip_mass=0.0, tension=3e6)
    case = dampen.Scenario(
        line, dampen.NoControl(), dampen.Harmonics((0.05,), {"tip_w": (1e4,)}), dampen.Task(trials=2, trial_duration=120.0),
        numerics=dampen.Numerics(modes=12, step=0.5), output=dampen.Output(points=5, every=4),
    )  # fmt: skip
    exact = (np.arange(4) + 0.5) * np.pi * np.sqrt(3e6 / 700.0) / 1000.0
    np.testing.assert_allclose(Bench(case).modes.omega[:4], exact, rtol=1e-10)
    assert dampen.simulate(case, compile=False).status == "complete"


def test_what_takes_too_long_is_refused_with_the_figure(tmp_path: Path) -> None:
    done = dampen_command("run", "he2017", "--hours", "1e-9", "--out", "x", cwd=tmp_path)
    assert done.returncode == 2
    assert "hours, and more than 1e-09 are refused" in done.stderr
    assert not (tmp_path / "x").exists()
    with pytest.raises(dampen.ArgumentError, match="predicted to take"):
        cost.check_time(scenario("task.trials=100000", "numerics.step=1e-6", "output.every=1000"), 1.0, 24.0)


def test_what_does_not_fit_is_refused_with_the_figure(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    case = scenario(*SMALL)
    monkeypatch.setattr(cost, "memory_free", lambda: 1000.0)
    with pytest.raises(dampen.ArgumentError, match=r"`numerics.step` must be larger: this would need about .* GiB of memory"):
        dampen.simulate(case)
    monkeypatch.undo()
    disk = namedtuple("disk", "total used free")
    monkeypatch.setattr(shutil, "disk_usage", lambda path: disk(1, 1, 1000))
    with pytest.raises(dampen.ArgumentError, match=r"`task.trials` must be smaller: this would need about .* GiB of disk"):
        dampen.simulate(case, store=FileStore(tmp_path / "r.nc"), compile=False)


@pytest.mark.skipif(sys.platform == "win32", reason="locks are the system's own there")
def test_a_folder_in_which_another_run_is_writing_is_refused(tmp_path: Path) -> None:
    refused = pytest.raises(dampen.ArgumentError, match="another process is writing there")
    with output_folder(tmp_path / "x", "x"), refused, output_folder(tmp_path / "x", "x"):
        pass
    with output_folder(tmp_path / "x", "x"):
        pass


@pytest.mark.skipif(os.name != "posix", reason="other systems speak UTF-8")
def test_names_beyond_ascii_in_a_locale_of_ascii(tmp_path: Path) -> None:
    """Also without a home, a screen, or a folder for what is passing."""
    poor = {"PATH": os.environ["PATH"], "LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0", "TMPDIR": "/nowhere"}
    poor |= {name: os.environ[name] for name in ("PYTHONPATH", "NUMBA_CACHE_DIR") if name in os.environ}
    (tmp_path / "ü.toml").write_bytes(dampen_command("show", "he2017", cwd=tmp_path).stdout.encode())
    few = [part for setting in (*SMALL, 'title="Träger 振動"') for part in ("--set", setting)]
    done = dampen_command("run", "ü.toml", *few, "--no-report", "--out", "aus ü", cwd=tmp_path, env=poor, encoding="utf-8")
    assert done.returncode == 0, done.stderr
    assert dampen.load(tmp_path / "aus ü" / "result.nc").scenario.title == "Träger 振動"


def test_a_reader_that_goes_away_and_a_full_disk_behind_the_output(tmp_path: Path) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("no device that is always full")
    with Path("/dev/full").open("w") as full:
        import subprocess

        done = subprocess.run(
            [sys.executable, "-m", "dampen.cli", "list"], stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    assert done.returncode == 3
    assert done.stderr.startswith("The system refuses")
    assert len(done.stderr.splitlines()) == 1
