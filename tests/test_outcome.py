"""What a run says at its end: how the structure vibrates, how its ports moved, with what forces; and which claims fail."""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import dampen
from dampen.analysis.at_limit import ends_of, share_at_limit, share_of_command
from dampen.analysis.claims import Claim
from dampen.cli import main
from dampen.report.glossary import WORDS
from dampen.report.motion import in_words
from dampen.report.write import write_report
from dampen.scenarios.claims import legend, note
from tests.conftest import scenario

SHORT = ("task.trials=2", "task.trial_duration=0.2", "numerics.modes=6")


def rope(stiffness: float) -> dampen.Scenario:
    return dampen.Scenario(
        plant=dampen.String(initial=dampen.plants.deflection.Deflection(w=(0.0, 0.05))),
        controller=dampen.BoundaryDamping(damping={"tip_w": 1.0}, stiffness={"tip_w": stiffness}),
        disturbance=dampen.NoDisturbance(),
        task=dampen.Task(trials=2, trial_duration=0.5, constraint={"tip_w": 0.2}),
        numerics=dampen.Numerics(modes=4, step=0.01),
        output=dampen.Output(every=10),
    )


def test_the_sentences_have_the_run_s_own_numbers() -> None:
    run = dampen.simulate(rope(1.0), compile=False)
    free = dampen.simulate(rope(1.0).uncontrolled(), compile=False)
    frequencies, motion, force = in_words(run, free, (1.25, 3.5, 6.0, 9.0))
    y, delivered = np.abs(run["y"][:, :, 0]), np.asarray(run["delivered"][:, :, 0])
    assert frequencies == "Lowest frequencies: 1.25, 3.50, 6.00 Hz."
    assert f"{y[0].max():#.3g} m in trial 0" in motion
    assert f"the margin is {100 * (1 - y.max() / 0.2):.0f} %" in motion
    assert f"Without control it is {np.abs(free['y'][1]).max():#.3g} m in trial 1" in motion
    rms, largest = math.sqrt(np.mean(delivered**2)), np.abs(delivered).max()
    assert force == f"Delivered force at tip_w: {rms:#.3g} N RMS, {largest:#.3g} N at most."


def test_how_often_an_actuator_stood_at_its_limit_is_counted_and_told() -> None:
    limit = dampen.Saturation(slope=2.0, low=-0.4, high=0.3)
    run = dampen.simulate(replace(rope(1.0), actuators={"tip_w": (limit,)}), compile=False)
    delivered = [float(force) for trial in run["delivered"][:] for force in trial[:, 0]]
    share = sum(force in (-0.4, 0.3) for force in delivered) / len(delivered)
    assert 0.1 < share < 1
    assert share_at_limit(run, "tip_w") == share
    assert in_words(run, None, (1.0,))[-1].endswith(f" N at most, at its limit in {100 * share:.0f} % of the steps.")
    wide = replace(rope(1.0), actuators={"tip_w": (replace(limit, low=-50.0, high=50.0),)})
    assert in_words(dampen.simulate(wide, compile=False), None, (1.0,))[-1].endswith(" N at most, never at its limit.")
    assert share_at_limit(dampen.simulate(rope(1.0), compile=False), "tip_w") is None


def test_a_limit_is_followed_through_what_stands_behind_it_as_far_as_that_has_no_memory() -> None:
    limit, none = dampen.Saturation(low=-1.0, high=2.0), (-math.inf, math.inf)
    assert ends_of((limit,), 0.01) == (-1.0, 2.0)
    assert ends_of((dampen.Backlash(), limit, dampen.Ideal()), 0.01) == (-1.0, 2.0)
    assert ends_of((limit, dampen.DeadZone(slope=2.0, right=0.5, left=-0.25)), 0.01) == (-1.5, 3.0)
    assert ends_of((limit, dampen.Saturation(slope=3.0, low=-4.0, high=4.0)), 0.01) == (-3.0, 4.0)
    assert ends_of((limit, dampen.FirstOrderLag()), 0.01) == none
    assert ends_of((), 0.01) == none


def test_how_often_a_sampled_law_s_command_stood_at_its_limit_is_told() -> None:
    numerics = replace(rope(1.0).numerics, mode="sampled")
    sampling = dampen.Sampling(period=0.01, command_limit={"tip_w": 0.3})
    run = dampen.simulate(replace(rope(1.0), numerics=numerics, sampling=sampling), compile=False)
    share = float(np.mean(np.abs(run["command"][:, :, 0]) == 0.3))
    assert 0.1 < share < 1
    assert share_of_command(run, "tip_w") == share
    assert in_words(run, None, (1.0,))[-1].endswith(f", its command at its limit in {100 * share:.0f} % of the steps.")


def test_ports_that_nothing_drives_have_no_force() -> None:
    assert len(in_words(dampen.simulate(rope(1.0).uncontrolled(), compile=False), None, (1.0,))) == 2


def test_a_run_of_one_s_own_prints_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    settings = [word for one in SHORT for word in ("--set", one)]
    monkeypatch.setattr(sys, "argv", ["dampen", "run", "string-tip-mass", "--no-report", *settings])
    with pytest.raises(SystemExit):
        main()
    told = capsys.readouterr().out
    assert told.startswith("Lowest frequencies: ")
    assert "Delivered force at tip_w: " in told
    assert "The largest |w(L, t)|" in told


def test_the_page_begins_with_the_claims_that_fail_and_ends_with_what_words_mean(tmp_path: Path) -> None:
    run = dampen.simulate(rope(1.0), compile=False)
    claims = [Claim("A1", "holds", "c", "m", True), Claim("A2", "the tip is still", "c", "0.3 m", False)]
    page = write_report(tmp_path, run, None, claims, None).read_text(encoding="utf-8")
    assert "<b>A2 does not hold:</b> the tip is still. Measured: 0.3 m." in page
    assert "A1 does not hold" not in page
    assert page.index("A2 does not hold") < page.index("<th>Claim</th>")
    assert page.count("<dt>") > len(WORDS)


def test_the_paper_s_gains_are_spoken_of_where_its_law_runs_only() -> None:
    def said(*changes: str) -> str:
        return note(dampen.simulate(scenario("task.trials=1", "task.trial_duration=0.01", *changes), compile=False))

    assert "gains are lost" in said()
    assert "gains are lost" not in said("controller={kind='boundary-damping', damping={tip_w=1.0}}")
    assert "are ours" in said("controller={kind='boundary-damping', damping={tip_w=1.0}}")


def test_only_claims_of_a_paper_have_a_legend() -> None:
    assert legend(dampen.simulate(rope(1.0), compile=False)) == ""
