"""Folders that commands write to and read from: what is replaced, what is refused, what a failed run leaves."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

import dampen
from dampen.cli import main
from dampen.cli.run import output_folder
from dampen.studies.study import open_study

QUICK = ("task.trials=1", "task.trial_duration=0.05", "numerics.modes=4", "output.every=10")
LAW = """
from dataclasses import dataclass
import dampen
import numpy as np


@dataclass(frozen=True)
class Law(dampen.Controller):
    def begin(self, setting):
        return {"MEMORY": np.zeros((setting.steps, len(setting.ports)))}

    def law(self, memory, setting):
        return dampen.PortLaw(memory["MEMORY"])
"""


def command(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["dampen", *arguments])
    with pytest.raises(SystemExit) as status:
        main()
    return int(status.value.code or 0)


def left_in(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()} if folder.exists() else set()


def a_run_in(folder: Path) -> None:
    with output_folder(folder, "x"):
        (folder / "scenario.toml").write_text("of the run")
        (folder / "result.nc").write_text("of the run")
        (folder / "report.html").write_text("of the run")


def test_a_run_that_fails_leaves_nothing_and_its_correction_is_taken(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "bad_law.py").write_text(LAW.replace("MEMORY", "command"))
    (tmp_path / "good_law.py").write_text(LAW.replace("MEMORY", "u"))
    settings = [part for setting in QUICK for part in ("--set", setting)]
    try:
        bad = ["run", "he2017", *settings, "--set", "controller.kind=bad_law:Law", "--no-report", "--out", "o"]
        assert command(monkeypatch, *bad) == 2
        errors = capfd.readouterr().err.splitlines()
        assert len(errors) == 1
        assert errors[0].startswith("bad_law:Law.begin gives a memory `command`, which is a name that results use themselves")
        assert not (tmp_path / "o").exists()
        good = [word.replace("bad_law", "good_law") for word in bad]
        assert command(monkeypatch, *good) == 0
        errors = capfd.readouterr().err
        assert "Note: good_law:Law defines no `learn`: its memory `u` never changes." in errors
        assert "replaced" not in errors
        assert command(monkeypatch, *bad) == 2
        assert dampen.load(tmp_path / "o" / "result.nc").trials == 1
    finally:
        for name in ("bad_law", "good_law"):
            sys.modules.pop(name, None)


def test_a_run_that_ends_before_its_result_leaves_what_was_there(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")

    def fail(folder: Path) -> None:
        (folder / "scenario.toml").write_text("begun")
        (folder / "exchanges.parquet").write_text("begun")
        raise dampen.ArgumentError("It went badly.")

    with pytest.raises(dampen.ArgumentError, match="badly"), output_folder(tmp_path, "x") as folder:
        fail(folder)
    assert left_in(tmp_path) == {"notes.txt"}


def test_an_earlier_run_is_replaced_with_a_note(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    a_run_in(tmp_path / "o")
    assert "Note" not in capfd.readouterr().err
    with output_folder(tmp_path / "o", "x") as folder:
        assert left_in(folder) == {"scenario.toml"}
        (folder / "result.nc").write_text("")
    assert capfd.readouterr().err == f"Note: the earlier run in `{tmp_path / 'o'}` is replaced.\n"


@pytest.mark.parametrize("name", ["report.html", "scenario.toml", "result.nc", "audit.json", "figures"])
def test_what_no_run_has_left_there_is_not_replaced(name: str, tmp_path: Path) -> None:
    if name == "figures":
        (tmp_path / name).mkdir()
    else:
        (tmp_path / name).write_text("mine")
    words = f"must be another one: it holds {name}, and no run that could be replaced"
    with pytest.raises(dampen.ArgumentError, match=words), output_folder(tmp_path, "x"):
        pass
    assert left_in(tmp_path) == {name}


def test_a_folder_that_is_given_for_a_file_or_a_study_is_told_as_what_it_is(tmp_path: Path) -> None:
    with pytest.raises(dampen.ArgumentError, match=r"it is a folder, without a result.nc"):
        dampen.load(tmp_path)
    a_run_in(tmp_path / "o")
    with pytest.raises(dampen.ArgumentError, match=r"it is a folder; did you mean `.*o.result\.nc`\?"):
        dampen.load(tmp_path / "o")
    with pytest.raises(dampen.ArgumentError, match=r"o` is not a study: it holds a run, whose report is `.*report\.html`"):
        open_study(tmp_path / "o")
    (tmp_path / "o" / "report.html").unlink()
    with pytest.raises(dampen.ArgumentError, match="is not a study: it holds a run"):
        open_study(tmp_path / "o")
