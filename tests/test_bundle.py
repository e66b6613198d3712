"""A run as one archive: whole, checked, and the same when it is made again."""

from __future__ import annotations

import json
import shutil
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest

import dampen
from dampen.cli import main
from dampen.simulation.stores import FileArrays, FileStore
from dampen.studies.bundle import MANIFEST, SCHEMA, pack, rerun
from dampen.toml import to_toml

SHORT = ["task.trials=2", "task.trial_duration=0.2", "numerics.modes=8", "output.every=20"]
OWN = '''"""A load of one's own."""

import numpy as np


def pushed(t):
    return 0.1 * np.sin(6 * t)
'''


def run_folder(folder: Path, changes: list[str], source: str | Path = "he2017") -> Path:
    """What a run leaves."""
    folder.mkdir()
    scenario = dampen.read_scenario(source, [*SHORT, *changes])
    (folder / "scenario.toml").write_text(to_toml(scenario))
    written = dampen.simulate(scenario, store=FileStore(folder / "result.nc")).arrays
    assert isinstance(written, FileArrays)
    written.file.close()
    return folder


def called(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["dampen", *arguments])
    with pytest.raises(SystemExit) as done:
        main()
    return int(done.value.code or 0)


def test_an_archive_is_the_folder_and_runs_again_to_the_last_bit(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    folder = run_folder(tmp_path / "mine", [])
    (folder / "figures").mkdir()
    (folder / "figures" / "one.svg").write_text("<svg/>")
    (folder / ".cache").mkdir()
    (folder / ".cache" / "junk").write_text("junk")
    assert called(monkeypatch, "bundle", "mine") == 0
    with zipfile.ZipFile("mine.zip") as packed:
        names = set(packed.namelist())
        manifest = json.loads(packed.read(f"mine/{MANIFEST}"))
    inside = ("README.md", MANIFEST, "requirements.txt", "result.nc", "scenario.toml", "figures/one.svg")
    assert names == {f"mine/{name}" for name in inside}
    assert manifest["schema"] == SCHEMA
    assert manifest["version"] == manifest["packages"]["dampen"] == dampen.version()
    assert manifest["packages"]["numpy"] == np.__version__
    shutil.rmtree(folder)
    assert called(monkeypatch, "rerun", "mine.zip") == 0
    assert "the same to the last bit" in capsys.readouterr().out


def test_records_and_modules_that_the_scenario_names_come_along(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    place = tmp_path / "elsewhere"
    place.mkdir()
    (place / "bundled_load.py").write_text(OWN)
    t = np.linspace(0, 1, 201)
    np.savetxt(place / "gust.csv", np.column_stack([t, np.sin(20 * t)]), delimiter=",", header="t,gust", comments="")
    (place / "own.toml").write_text(
        "\n".join(
            [
                'based_on = "he2017"',
                "[disturbance]",
                'kind = "sum"',
                "[[disturbance.terms]]",
                'kind = "recorded"',
                'file = "gust.csv"',
                'columns = { tip_w = "gust" }',
                'time = "t"',
                "[[disturbance.terms]]",
                'kind = "function"',
                'force = { tip_phi = "bundled_load:pushed" }',
                "highest_frequency = 1.0",
            ]
        )
    )
    folder = run_folder(tmp_path / "run", [], place / "own.toml")
    monkeypatch.chdir(place)
    archive = pack(folder, tmp_path / "run.zip")
    monkeypatch.chdir(tmp_path)
    shutil.rmtree(place)
    monkeypatch.delitem(sys.modules, "bundled_load", raising=False)
    found = rerun(archive)
    assert found.largest == 0
    assert found.status in ("complete", "constraint_lost")
    with zipfile.ZipFile(archive) as packed:
        assert str(tmp_path) not in packed.read("run/scenario.toml").decode()
        assert "run/bundled_load.py" in packed.namelist()


def test_a_run_that_was_another_one_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    folder = run_folder(tmp_path / "mine", [])
    (folder / "scenario.toml").write_text(to_toml(dampen.read_scenario("he2017", [*SHORT, "controller.alpha_4=2.0"])))
    pack(folder, tmp_path / "mine.zip")
    assert called(monkeypatch, "rerun", "mine.zip") == 0
    assert "The run DIFFERS" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("damaged", "`result.nc` is not what its manifest says"),
        ("cut", "cannot be read"),
        ("other", "none that `dampen bundle` wrote"),
    ],
)
def test_damaged_archives_are_refused(
    name: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    archive = pack(run_folder(tmp_path / "mine", []), tmp_path / "mine.zip")
    if name == "cut":
        archive.write_bytes(archive.read_bytes()[:-200])
    elif name == "other":
        with zipfile.ZipFile(archive, "w") as packed:
            packed.writestr("a/manifest.json", "[]")
    else:
        with zipfile.ZipFile(archive) as packed:
            content = {n: packed.read(n) for n in packed.namelist()}
        with zipfile.ZipFile(archive, "w") as packed:
            for n, data in content.items():
                packed.writestr(n, data[:-1] if n.endswith("result.nc") else data)
    assert called(monkeypatch, "rerun", "mine.zip") == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1
    assert said in lines[0]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["bundle", "nowhere"], "Folder `nowhere`"),
        (["bundle", "."], "has no scenario.toml"),
        (["bundle", ".", "--out", "mine.tar"], "ending in .zip"),
        (["rerun", "nowhere.zip"], "cannot be read: No such file or directory"),
    ],
)
def test_bad_input_is_one_line(
    arguments: list[str], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert called(monkeypatch, *arguments) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1
    assert said in lines[0]
    assert list(tmp_path.iterdir()) == []
