"""Generated scenario files: each is run, with an account that closes, or refused in words; nothing else happens."""

from __future__ import annotations

import os
import re
import time
import warnings
from pathlib import Path

import numpy as np
import pytest

import dampen
from dampen.analysis.audit.energetics import ROUND_OFF, trial_errors
from dampen.analysis.energy import energy_account
from dampen.scenarios.read import build, parse
from dampen.simulation.bench import Bench
from dampen.toml import to_toml
from tests.generated import Generator

FILES = int(os.environ.get("DAMPEN_FUZZ_SCENARIOS", "300"))  # a release is held against 20,000
SECONDS = 10.0  # of processor time, in plain Python: some hundred times slower than compiled
WAIT = 30.0  # s by the clock, which other processes share: waiting for nothing shows here alone
CLEAR = re.compile(r"(Argument|Option|Scenario|An? |This |`|[\w.]+:).{5,600}", re.DOTALL)


def outcome(path: Path) -> str:
    """What becomes of a scenario file."""
    try:
        scenario = dampen.read_scenario(path)
        assert build(parse(to_toml(scenario), "written"), path.parent) == scenario
        if scenario.steps * scenario.task.trials > 500:
            return "long"
        bench = Bench(scenario)
        result = dampen.simulate(scenario, bench=bench, compile=False)
    except dampen.ArgumentError as error:
        for line in error.lines:
            assert CLEAR.fullmatch(line), line
            assert line.isprintable(), line
        return "refused"
    for name in result.layout.variables:
        if name != "barrier_energy":
            assert np.all(np.isfinite(result[name][: result.trials])), name
    if not result.broke_off and not any("did not settle" in line for line in result.warnings):
        account = energy_account(result)
        worst = max(account.error * account.largest, *trial_errors(result))
        works = abs(account.control) + abs(account.disturbance) + abs(account.load) + account.dissipated
        assert worst <= ROUND_OFF * (account.largest + works) + lost_in_motion(result, bench), (worst, account)
    return result.status


def lost_in_motion(result: dampen.Result, bench: Bench) -> float:
    """What works lose [J] because a motion is the difference of two displacements, each a double: not seen in usual units."""
    force, y = (np.abs(np.asarray(result[name])) for name in ("delivered", "y"))
    if "reference" in result.layout.variables:  # what is kept in the run is the distance from it
        y = y + 2 * np.abs(np.asarray(result["reference"]))
    pushed = force + np.abs(np.asarray(result["disturbance"]))
    free = np.diag(bench.step.g) * bench.step.dt * pushed  # what these forces alone would move, where others hold them
    return float(1e-15 * np.sum(pushed * (y[:, 1:] + y[:, :-1] + free)))


def test_generated_scenarios_run_or_are_refused_in_words(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    home = tmp_path / "home"
    home.mkdir()
    monkeypatch.chdir(home)
    counts: dict[tuple[str, str], int] = {}
    first = int(os.environ.get("DAMPEN_FUZZ_FIRST", "0"))
    for seed in range(first, first + FILES):
        what, content = Generator(seed).file()
        path = home / "scenario.toml"
        path.write_bytes(content)
        begun, clock = time.process_time(), time.monotonic()
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            try:
                end = outcome(path)
            except BaseException as error:
                error.add_note(f"scenario file of seed {seed}, {what}: {content[:3000]!r}")
                raise
        assert time.process_time() - begun < SECONDS, (seed, time.process_time() - begun)
        assert time.monotonic() - clock < WAIT, (seed, time.monotonic() - clock)
        counts[what, end] = counts.get((what, end), 0) + 1
    assert [p.name for p in tmp_path.rglob("*")] == ["home", "scenario.toml"]
    valid = {end: n for (what, end), n in counts.items() if what == "valid"}
    assert valid.get("complete", 0) + valid.get("constraint_lost", 0) > 0.6 * sum(valid.values()), counts
