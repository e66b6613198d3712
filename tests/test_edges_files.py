"""Files that are not what they seem: results cut, foreign, edited; study folders with parts missing; texts for --set."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import dampen
from dampen.simulation.stores import FileStore
from dampen.toml import to_toml
from tests.conftest import scenario

SMALL = ("task.trials=2", "task.trial_duration=0.05", "numerics.modes=4", "output.every=10", "controller.kind=none")


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("good") / "good.nc"
    dampen.simulate(scenario(*SMALL), store=FileStore(path), compile=False)
    return path


def refusal(read: Callable[..., Any], *arguments: Any) -> str:
    """The one line with which something is refused."""
    with pytest.raises(dampen.ArgumentError) as error:
        read(*arguments)
    assert len(error.value.lines) == 1
    assert error.value.lines[0].isprintable()
    return error.value.lines[0]


def test_a_result_cut_anywhere_is_refused(good: Path, tmp_path: Path) -> None:
    content, path = good.read_bytes(), tmp_path / "cut.nc"
    for size in (0, 1, 7, 8, 100, *range(500, len(content), 3001), len(content) - 1):
        path.write_bytes(content[:size])
        assert "is not a dampen result" in refusal(dampen.load, path)


def test_foreign_files_are_refused(tmp_path: Path) -> None:
    import netCDF4

    text, classic, other = tmp_path / "text.nc", tmp_path / "classic.nc", tmp_path / "other.nc"
    text.write_text("Hello.")
    with netCDF4.Dataset(classic, "w", format="NETCDF3_CLASSIC") as file:
        file.scenario = "x"
    with netCDF4.Dataset(other, "w") as file:
        file.createDimension("x", 3)
    for path in (text, classic, other, tmp_path, Path("/dev/zero"), Path("a" * 3000)):
        assert refusal(dampen.load, path).startswith("Result file")


EDITS: dict[str, Callable[[Any], None]] = {
    **{f"no {n}": lambda file, n=n: file.delncattr(n) for n in ("scenario", "status", "dampen_version", "warnings")},
    **{f"{n} odd": lambda file, n=n: file.setncattr(n, np.arange(3)) for n in ("scenario", "status", "trials_finished")},
    "status": lambda file: file.setncattr("status", "fine\x1b[31m"),
    "trials": lambda file: file.setncattr("trials_finished", 7),
    "trials below": lambda file: file.setncattr("trials_finished", -1),
    "no scenario at all": lambda file: file.setncattr("scenario", "plant = 3"),
    "scenario of other points": lambda file: file.setncattr("scenario", to_toml(scenario(*SMALL, "output.points=7"))),
    "scenario of other steps": lambda file: file.setncattr("scenario", to_toml(scenario(*SMALL, "task.trial_duration=0.1"))),
    "scenario through samples": lambda file: file.setncattr("scenario", to_toml(scenario(*SMALL, "numerics.mode=sampled"))),
    "no field": lambda file: file.renameVariable("w", "x_w"),
    "no signal": lambda file: file.renameVariable("energy", "power"),
}


@pytest.mark.parametrize("edit", EDITS)
def test_an_edited_result_is_refused(edit: str, good: Path, tmp_path: Path) -> None:
    import netCDF4

    path = tmp_path / "edited.nc"
    shutil.copy(good, path)
    with netCDF4.Dataset(path, "a") as file:
        EDITS[edit](file)
    if edit == "no scenario at all":
        with pytest.raises(dampen.ArgumentError):
            dampen.load(path)
        return
    refusal(dampen.load, path)


def test_a_result_of_another_version_is_read(good: Path, tmp_path: Path) -> None:
    import netCDF4

    path = tmp_path / "older.nc"
    shutil.copy(good, path)
    with netCDF4.Dataset(path, "a") as file:
        file.dampen_version = "0.0.1"
    assert dampen.load(path).version == "0.0.1"


keys = st.text("abkind._-0 \"'ü\n\x00=[]{}", max_size=12) | st.sampled_from(
    ["plant.tip_mass", "task", "actuator.all.chain.0.right"]
)
values = st.text(max_size=30) | st.sampled_from(
    ["1", "nan", "{kind='none'}", "[1", "'''", '"\\ud800"', "1\n2", "x" * 5000, "[" * 3000]
)


@settings(max_examples=300, deadline=None)
@given(key=keys, value=values, equals=st.sampled_from(["=", "", "==", " = "]))
@example("plant.tip_mass", "1\nplant={}", "=")
@example("task.constraint", "{" * 20_000, "=")
@example("actuator.all.chain.99999999999999999999", "1", "=")
@example("actuator.all.chain.²", "1", "=")
def test_any_text_for_set_is_taken_or_refused_in_words(key: str, value: str, equals: str) -> None:
    try:
        dampen.read_scenario("he2017", [f"{key}{equals}{value}"])
    except dampen.ArgumentError as error:
        for line in error.lines:
            assert line.isprintable()
            assert len(line) <= 1000
            assert line.startswith(("Argument", "Option"))


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("study") / "study"
    dampen.sweep(scenario(*SMALL), {"plant.tip_mass": "0.1:0.2:2"}, folder=folder, engine=1)
    return folder


def spoil(path: Path, content: bytes) -> Callable[[Path], None]:
    return lambda folder: (folder / path).write_bytes(content)  # type: ignore[return-value]


def test_a_study_folder_with_parts_missing_or_edited_is_refused(study: Path, tmp_path: Path) -> None:
    part = next((study / "rows").glob("part-*.parquet")).relative_to(study)
    whole = {path: (study / path).read_bytes() for path in (Path("study.toml"), Path("scenario.toml"), part)}
    seen = []
    for path, content in whole.items():
        for spoilt in (None, b"", b"\xff\xfe", content[: len(content) // 2], content[:-13], b"kind = 3\n", content + b"\x00"):
            folder = tmp_path / f"study-{len(seen)}"
            shutil.copytree(study, folder)
            (folder / path).unlink()
            if spoilt is not None:
                (folder / path).write_bytes(spoilt)
            try:
                dampen.open_study(folder)
                seen.append((path.suffix, spoilt, "read"))
            except dampen.ArgumentError as error:
                assert all(line.isprintable() for line in error.lines)
                seen.append((path.suffix, spoilt, error.lines[0]))
    read = [(suffix, spoilt) for suffix, spoilt, end in seen if end == "read"]
    assert read == [(".parquet", None)]  # rows that are gone are run again


@pytest.mark.parametrize("content", ["", "{}", "[]", "3", '{"comparison": 3, "scenario": []}', "\udcff", "{" * 50_000])
def test_a_comparison_that_is_none_is_refused(content: str, tmp_path: Path) -> None:
    (tmp_path / "comparison.json").write_bytes(content.encode("utf-8", "surrogateescape"))
    refusal(dampen.open_comparison, tmp_path)


def test_a_file_counts_the_trial_in_which_the_motion_broke_off_as_begun_and_not_as_finished(tmp_path: Path) -> None:
    """Before it is closed, too: a run may be killed in between."""

    class Watched(FileStore):
        def close(self, status: str, trials: int) -> dampen.Result:
            counted.append(int(self.file.getncattr("trials_finished")))
            return super().close(status, trials)

    counted: list[int] = []
    blow = dampen.Impulse(impulse={"tip_w": 1e30}, duration=0.005, at=0.0, trial=1)
    case = dampen.read_scenario(
        "he2017", ["task.trials=3", "task.trial_duration=0.01", "numerics.modes=4", "output.every=10", "controller.kind=none"]
    )
    result = dampen.simulate(replace(case, disturbance=blow), store=Watched(tmp_path / "r.nc"), compile=False)
    assert (result.status, result.trials, counted) == ("diverged", 1, [1])
    for name, variable in result.layout.variables.items():
        kept = result[name]
        assert (getattr(kept, "units", ""), kept.long_name, kept.dtype) == (variable.unit, variable.meaning, variable.kind)
