"""The review as it is written: audit.json and its schema, the page, the terminal."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from html import unescape
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import dampen
from dampen.analysis.audit.audit import audit
from dampen.analysis.audit.finding import Quantity
from dampen.analysis.credit import credit
from dampen.report.review import words
from dampen.scenarios.read import shipped
from dampen.studies.record import FILE, SCHEMA, plain, record, schema, write_record
from tests.test_scenarios import dampen_command

SHORT = ("--set", "task.trials=3", "--set", "numerics.modes=20", "--set", "numerics.step=0.002", "--set", "output.every=10")


@pytest.mark.parametrize("name", list(shipped()))
def test_every_shipped_scenario_can_be_audited_and_its_record_follows_the_schema(name: str, tmp_path: Path) -> None:
    scenario = dampen.read_scenario(name, ["task.trials=2"])
    result = dampen.simulate(scenario)
    found = record(scenario, audit=audit(result, refine=False), credit=credit(scenario))
    written = json.loads(write_record(tmp_path, found).read_text(encoding="utf-8"), parse_constant=pytest.fail)
    jsonschema.Draft202012Validator(schema()).validate(written)
    assert written["schema"] == SCHEMA
    assert written["version"] == dampen.version()
    assert len(written["audit"]["findings"]) == len(audit(result, refine=False).findings)
    assert not words.credited(credit(scenario)) or words.sentence(audit(result, refine=False))


def test_the_schema_refuses_what_is_not_a_record() -> None:
    scenario = dampen.read_scenario("he2017", ["task.trials=1"])
    good = plain(record(scenario, audit=audit(dampen.simulate(scenario), refine=False)))
    validator = jsonschema.Draft202012Validator(schema())
    validator.validate(good)
    good["audit"]["findings"][0]["verdict"] = "fine"
    with pytest.raises(jsonschema.ValidationError):
        validator.validate(good)
    with pytest.raises(jsonschema.ValidationError):
        validator.validate({"schema": SCHEMA})


def test_what_is_not_finite_is_null() -> None:
    assert json.loads(json.dumps(plain(record(dampen.read_scenario("he2017")))))["audit"] is None
    odd = audit(dampen.simulate(dampen.read_scenario("he2017", ["task.trials=1"])), refine=False)
    odd.findings[0].values["closing error"] = Quantity((np.nan, np.inf, 1.0))  # type: ignore[index]
    written = plain(record(dampen.read_scenario("he2017"), audit=odd))
    assert written["audit"]["findings"][0]["values"]["closing error"]["value"] == [None, None, 1.0]


def test_audit_from_the_command_line_writes_everything_beside_the_result(tmp_path: Path) -> None:
    done = dampen_command("audit", "he2017", *SHORT, "--out", "a", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    names = {path.name for path in (tmp_path / "a").iterdir()}
    assert names == {FILE, "report.html", "result.nc", "uncontrolled.nc", "scenario.toml", "figures"}
    written = json.loads((tmp_path / "a" / FILE).read_text(encoding="utf-8"))
    verdicts = [finding["verdict"] for finding in written["audit"]["findings"]]
    held, judged = verdicts.count("PASS"), verdicts.count("PASS") + verdicts.count("FAIL")
    assert re.search(rf"\b{held} (of {judged} )?findings of the audit hold", done.stdout)
    page = unescape(re.sub(r"<[^>]+>", "", (tmp_path / "a" / "report.html").read_text(encoding="utf-8")))
    assert page.count("FAIL") >= verdicts.count("FAIL")
    for heading in ("Review", "What holds", "What does not", "Why", "Credit", "Audit"):
        assert heading in page
    assert {p.name for p in (tmp_path / "a" / "figures").glob("*.svg")} >= {"sticking.svg", "credit.svg"}
    for variant in written["credit"]["variants"]:
        assert variant["name"] in page
    assert dampen.load(tmp_path / "a" / "result.nc").trials == 3


def test_credit_from_the_command_line(tmp_path: Path) -> None:
    done = dampen_command("credit", "string-tip-mass", "--set", "task.trials=2", "--no-report", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "without barrier" in done.stdout
    written = json.loads((tmp_path / "runs" / "string-tip-mass-credit" / FILE).read_text(encoding="utf-8"))
    assert written["audit"] is None
    assert [v["name"] for v in written["credit"]["variants"]][:2] == ["as it is", "no control"]


def test_bad_input_gets_one_line_and_leaves_nothing(tmp_path: Path) -> None:
    for command, says in (
        (("credit", "he2017", "--set", "controller.kind=none"), "nothing to take apart"),
        (("audit", "nowhere.toml"), "nowhere.toml"),
        (("audit", "he2017", "--set", "task.trials=0"), "task.trials"),
    ):
        done = dampen_command(*command, cwd=tmp_path)
        assert done.returncode == 2, done.stderr
        assert done.stdout == ""
        assert len(done.stderr.splitlines()) == 1
        assert says in done.stderr
    assert not list(tmp_path.iterdir())


def test_a_run_alone_is_audited_without_further_runs(tmp_path: Path) -> None:
    done = dampen_command("run", "he2017", *SHORT, "--no-report", cwd=tmp_path)
    assert "findings of the audit hold" in done.stdout
    written = json.loads((tmp_path / "runs" / "he2017" / FILE).read_text(encoding="utf-8"))
    assert {finding["section"] for finding in written["audit"]["findings"]} >= {"energy", "assumptions", "boundedness"}
    assert "resolution" not in {finding["section"] for finding in written["audit"]["findings"]}


def test_limit_from_the_command_line(tmp_path: Path) -> None:
    done = dampen_command("limit", "he2017", *SHORT, "--of", "phi", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    folder = tmp_path / "runs" / "he2017-limit"
    written = json.loads((folder / FILE).read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator(schema()).validate(written)
    (limit,), (at,) = written["limits"], written["standings"]
    assert (limit["of"], at["of"], at["below"]) == ("phi", "phi", False)
    assert "not bound" in done.stdout
    assert (folder / "figures" / "limit_phi.svg").exists()
    assert "The limit" in (folder / "report.html").read_text(encoding="utf-8")


def test_an_interrupted_review_keeps_what_it_has_and_says_so(tmp_path: Path) -> None:
    """Ctrl-C while the limit of phi is looked for: the run and the limit of w are there, and the exit status is 3."""
    program = (
        "import sys\n"
        "from dampen.analysis.limit import curve\n"
        "from dampen.cli import main\n"
        "whole = curve.limit\n"
        "def limit(scenario, of, **others):\n"
        "    if of == 'phi':\n"
        "        raise KeyboardInterrupt\n"
        "    return whole(scenario, of, **others)\n"
        "curve.limit = limit\n"
        f"sys.argv = ['dampen', 'limit', 'he2017', *{SHORT!r}, '--no-report', '--out', 'here']\n"
        "main()\n"
    )
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert done.returncode == 3, done.stderr
    assert "interrupted" in done.stderr
    written = json.loads((tmp_path / "here" / FILE).read_text(encoding="utf-8"))
    assert [limit["of"] for limit in written["limits"]] == ["w"]
    assert dampen.load(tmp_path / "here" / "result.nc").trials == 3


HARD = {
    "at rest": ("he2017", "disturbance={kind='none'}", "plant.initial={}", "task.trials=6"),
    "diverged": (
        "euler-bernoulli-payload",
        "controller={kind='boundary-damping', damping={tip_w=30.0}}",
        "actuator={}",
        "numerics.mode=sampled",
        "sampling={period=0.02, delay=0.02}",
    ),
    "own port alone": ("string-tip-mass", "task.trials=1", "task.constraint={}", "controller.barrier=none"),
    "reset": ("he2017", "task.start=reset", "task.trials=6", "numerics.modes=20"),
}


@pytest.mark.parametrize("case", list(HARD))
def test_hard_runs_are_audited_taken_apart_and_reported_all_the_same(case: str, tmp_path: Path) -> None:
    name, *sets = HARD[case]
    for command in ("audit", "credit"):
        options = [part for one in sets for part in ("--set", one)]
        done = dampen_command(command, name, *options, "--out", command, cwd=tmp_path)
        assert done.returncode == (3 if case == "diverged" else 0), done.stderr
        assert "Traceback" not in done.stderr
        assert "nan" not in done.stdout
        written = json.loads((tmp_path / command / FILE).read_text(encoding="utf-8"))
        jsonschema.Draft202012Validator(schema()).validate(written)
