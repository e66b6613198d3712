"""Software in the loop: the exported controller makes the sampled run, and whatever a program does, the run ends well."""

from __future__ import annotations

import json
import os
import re
import shlex
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st

import dampen
from dampen.export.c.blueprint import Guards
from dampen.export.c.recording import record
from dampen.export.c.write import export_c
from dampen.sil.packets import DRIVE, END, HEADER, HELLO, KINDS, STEP, Garbage, Request, answer_to
from dampen.simulation.bench import Bench
from dampen.simulation.stores import FileStore
from dampen.toml import to_toml
from tests.c_bench import CHECKED, COMPILERS

needs_c = pytest.mark.skipif(not COMPILERS, reason="no C compiler here")
SHORT = ("task.trials=3", "task.trial_duration=0.2", "sampling.command_limit={tip_w=2.0,tip_phi=4.0}")
SAMPLES = 200
FAULTY = Path(__file__).parent / "sil_program.py"
DOCS = Path(__file__).parents[1] / "docs" / "how-to" / "sil.md"


@cache
def case(*overrides: str, name: str = "he2017-sampled") -> dampen.Scenario:
    return dampen.read_scenario(name, overrides)


@cache
def bench(*overrides: str) -> Bench:
    return Bench(case(*overrides))


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory):
    """Builds the program of a scenario, once for each."""
    done: dict[tuple[dampen.Scenario, bool], Path] = {}

    def build(scenario: dampen.Scenario, single: bool = False) -> str:
        key = to_toml(scenario), single
        if key not in done:
            folder = tmp_path_factory.mktemp("a folder")
            export_c(scenario, folder, single, Guards(stop_at_constraint=False))
            subprocess.run(["make", "-s", "-C", str(folder), "sil"], check=True)
            done[key] = folder / "sil"
        return str(done[key])

    return build


def faulty(fault: str, at: int, note: Path | None = None) -> list[str]:
    return [sys.executable, str(FAULTY), fault, str(at), *([str(note)] if note else [])]


def gone(pid: int) -> bool:
    """Whether a process has ended and been reaped."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return True
    return False


def same_run(result: dampen.Result, other: dampen.Result, trials: int) -> None:
    """Every variable but the samples' estimates of the rate, to round-off; commands bit for bit."""
    np.testing.assert_array_equal(result["issued"][:trials], other["issued"][:trials])
    np.testing.assert_array_equal(result["reading"][:trials], other["reading"][:trials])
    for name in result.layout.variables:
        ours, theirs = np.asarray(result[name][:trials]), np.asarray(other[name][:trials])
        np.testing.assert_allclose(ours, theirs, rtol=1e-6 if ours.dtype == "f4" else 1e-11, atol=1e-12, err_msg=name)


@needs_c
def test_25_trials_over_the_pipe_reproduce_the_sampled_run(built, tmp_path: Path) -> None:
    """Commands bit for bit, since both read through the quantiser; all else to round-off."""
    scenario = case()
    done = dampen.software_in_the_loop(scenario, built(scenario), store=FileStore(tmp_path / "result.nc"), bench=bench())
    sampled = dampen.simulate(scenario, bench=bench())
    assert (done.failure, done.result.status, done.result.trials) == ("", "complete", 25)
    assert np.abs(sampled["issued"]).max() > 1
    same_run(done.result, sampled, 25)
    assert np.abs(done.result["y"][:] - sampled["y"]).max() <= 1e-14
    agreement = done.agreement
    assert agreement is not None
    assert (agreement.trials, agreement.parted) == (25, None)
    assert agreement.displacement.max() == np.abs(done.result["y"][:] - sampled["y"]).max()
    columns = done.exchanges.columns
    assert np.count_nonzero(np.array(columns["kind"]) == "step") == 25 * 2000
    assert len(done.exchanges.rows) == 25 * 2001 + 2
    assert np.all(columns["round_trip"] > 0)
    assert not columns["status"].any()


@needs_c
def test_the_command_writes_result_exchanges_figure_and_report_and_says_how_long_it_took(built, tmp_path: Path) -> None:
    scenario = case(*SHORT)
    (tmp_path / "mine.toml").write_text(to_toml(scenario))
    done = dampen_sil(tmp_path, "mine.toml", "--controller", shlex.quote(built(scenario)), "--out", "out", "--drive")
    assert done.returncode == 0, done.stderr
    assert "600 samples" in done.stdout
    assert "x real time" in done.stdout
    assert "All commands of 3 trials are the sampled run's, bit for bit." in done.stdout
    assert "not from the scenario's law" in done.stderr
    for name in ("report.html", "audit.json", "figures/exchanges.png", "figures/exchanges.svg", "scenario.toml"):
        assert (tmp_path / "out" / name).stat().st_size > 100
    result = dampen.load(tmp_path / "out" / "result.nc")
    assert result.commands_from == f"`{shlex.quote(built(scenario))}` over a pipe, its own inverse of the actuators included"
    assert result.dataset.attrs["commands_from"] == result.commands_from
    assert "not from the scenario&#39;s law" in (tmp_path / "out" / "report.html").read_text()
    assert to_toml(result.scenario) == to_toml(scenario)
    same_run(result, dampen.simulate(scenario, bench=bench(*SHORT)), 3)
    table = pd.read_parquet(tmp_path / "out" / "exchanges.parquet")
    assert list(table) == ["trial", "sample", "kind", "round_trip", "asked", "status"]
    assert table.kind.value_counts().to_dict() == {"drive": 600, "end": 3, "hello": 1, "bye": 1}
    steps = table[table.kind == "drive"]
    np.testing.assert_array_equal(steps["sample"], np.tile(np.arange(SAMPLES), 3))
    np.testing.assert_array_equal(steps["trial"], np.repeat(np.arange(3), SAMPLES))


@needs_c
@pytest.mark.parametrize("drive", [False, True])
def test_the_controllers_own_inverse_drives_the_actuators_as_the_simulations_does(built, drive: bool) -> None:
    """Two ways to the same run: the plant side inverts, or the program; also where samples are further apart than steps."""
    overrides = (*SHORT, "sampling.period=0.004", "sampling.delay=0.006", "output.every=8")
    scenario = case(*overrides)
    done = dampen.software_in_the_loop(scenario, built(scenario), drive=drive, bench=bench(*overrides))
    same_run(done.result, dampen.simulate(scenario, bench=bench(*overrides)), 3)
    assert len(done.result.scenario.chain(0)) == 2
    straight = case(*overrides, "controller.compensate=false")
    assert np.abs(dampen.simulate(straight)["delivered"] - done.result["delivered"]).max() > 0.01


@needs_c
def test_resets_references_and_sensors_without_a_quantiser_agree_to_rounding(built) -> None:
    arm = ("numerics.mode=sampled", "sampling.period=0.004", "sampling.delay=0.004", "task.trials=3")
    scenario = case(*arm, name="flexible-arm-point-to-point")
    assert scenario.task.start == "reset"
    done = dampen.software_in_the_loop(scenario, built(scenario))
    sampled = dampen.simulate(scenario)
    assert done.result.trials == 3
    assert np.abs(sampled["issued"][2] - sampled["issued"][0]).max() > 0.01
    np.testing.assert_allclose(done.result["issued"], sampled["issued"], atol=1e-8 * np.abs(sampled["issued"]).max())
    np.testing.assert_allclose(done.result["y"], sampled["y"], atol=1e-10)


@needs_c
def test_in_float_the_loop_is_near_and_says_so(built) -> None:
    scenario = case(*SHORT)
    done = dampen.software_in_the_loop(scenario, built(scenario, True), bench=bench(*SHORT))
    assert done.result.trials == 3
    assert done.agreement is not None
    assert done.agreement.parted is not None
    off = np.abs(done.result["issued"] - dampen.simulate(scenario, bench=bench(*SHORT))["issued"]).max(axis=(0, 1))
    np.testing.assert_array_equal(done.agreement.command, off)
    assert np.all(done.agreement.displacement > 0)
    assert np.all(done.agreement.displacement < 1e-3)


@needs_c
@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("single", [False, True])
@pytest.mark.parametrize("compensate", ["true", "false"])
def test_the_program_compiles_without_a_warning(compiler: str, single: bool, compensate: str, tmp_path: Path) -> None:
    export_c(case(*SHORT, f"controller.compensate={compensate}"), tmp_path, single)
    flags = "-O2 -Wconversion -Wshadow -Wstrict-prototypes"
    make = ["make", "-C", str(tmp_path), f"CC={compiler}", f"CFLAGS={flags}", "sil"]
    done = subprocess.run(make, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "warning" not in done.stderr


@needs_c
def test_the_program_is_clean_under_the_compilers_checks(tmp_path: Path) -> None:
    scenario = case(*SHORT)
    export_c(scenario, tmp_path, guards=Guards(stop_at_constraint=False))
    make = ["make", "-s", "-C", str(tmp_path), f"CFLAGS={' '.join(CHECKED)}", "sil"]
    subprocess.run(make, check=True)
    for udp in (False, True):
        done = dampen.software_in_the_loop(scenario, str(tmp_path / "sil"), udp=udp, drive=True, bench=bench(*SHORT))
        assert (done.failure, done.result.trials) == ("", 3)
        assert done.agreement is not None
        assert done.agreement.parted is None


@needs_c
def test_over_udp_lost_answers_and_requests_change_no_bit(built) -> None:
    """Behind a relay that loses and doubles datagrams in both directions: no step is made twice, none is left out."""
    scenario, port = case(*SHORT), free_port()
    program = subprocess.Popen([built(scenario), "--udp", str(port)])
    try:
        with relay(port, lost={5, 6, 40, 300}, doubled={60, 200}) as (entrance, told):
            done = dampen.software_in_the_loop(scenario, port=entrance, bench=bench(*SHORT))
        assert program.wait(5) == 0
    finally:
        program.kill()
    assert done.failure == ""
    same_run(done.result, dampen.simulate(scenario, bench=bench(*SHORT)), 3)
    assert told["lost"] == 8
    assert done.exchanges.repeats >= 8
    assert done.result.commands_from == f"the controller at UDP port {entrance}"


@needs_c
def test_over_udp_a_program_is_started_and_ended(built) -> None:
    scenario = case(*SHORT)
    done = dampen.software_in_the_loop(scenario, built(scenario), udp=True, bench=bench(*SHORT))
    assert done.agreement is not None
    assert (done.agreement.trials, done.agreement.parted) == (3, None)


@needs_c
def test_over_udp_a_program_that_dies_or_falls_silent_is_told(built) -> None:
    scenario, port = case(*SHORT), free_port()
    with pytest.raises(dampen.ArgumentError, match=r"At the hello controller `sh .*` ended with exit status 3"):
        dampen.software_in_the_loop(scenario, "sh -c 'sleep 0.2; exit 3'", udp=True, bench=bench(*SHORT))
    program = subprocess.Popen([built(scenario), "--udp", str(port)])
    done = dampen.software_in_the_loop(
        scenario, port=port, timeout=0.3, bench=bench(*SHORT), progress=lambda finished, trials: program.kill()
    )
    program.wait()
    assert done.failure == f"At sample 0 of trial 1 the controller at UDP port {port} sent no answer within 0.3 s."
    assert (done.result.status, done.result.trials) == ("controller_lost", 1)
    same_run(done.result, dampen.simulate(scenario, bench=bench(*SHORT)), 1)


def test_over_udp_noise_is_told() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as noisy:
        noisy.bind(("127.0.0.1", 0))

        def answer() -> None:
            _, peer = noisy.recvfrom(4096)
            noisy.sendto(b"hello", peer)

        thread = threading.Thread(target=answer)
        thread.start()
        with pytest.raises(dampen.ArgumentError, match="sent 'hello' where a packet must begin with DSIL"):
            dampen.software_in_the_loop(case(*SHORT), port=noisy.getsockname()[1], bench=bench(*SHORT))
        thread.join()


@needs_c
def test_the_program_refuses_noise_and_a_wrong_use(built, tmp_path: Path) -> None:
    program = built(case(*SHORT))
    for arguments, data in (([], b"x" * 100), (["--udp"], b""), (["--udp", "70000"], b""), (["fast"], b"")):
        done = subprocess.run([program, *arguments], input=data, capture_output=True, timeout=10, check=False)
        assert done.returncode == 1
        assert done.stderr
        assert not done.stdout
    assert subprocess.run([program], input=b"DSIL", timeout=10, check=False).returncode == 0


AT = 1 + (SAMPLES + 1) + 50  # the number of sample 50 of trial 1
FAULTS = {
    "exit": "ended with exit status 1. Its last words: warming up / sensor board not found",
    "killed": "was ended by SIGKILL.",
    "hang": "sent no answer within 0.3 s. Its last words: waiting for the bus",
    "stubborn": "sent no answer within 0.3 s.",
    "closes": "closed its output.",
    "text": "sent 'temperature 20 C, all is' ... where a packet must begin with DSIL.",
    "magic": "sent 'LISD",
    "version": "sent packets of version 2, where this is version 1.",
    "kind": "sent a packet of kind 5 as the answer to one of kind 2 (step).",
    "number": f"sent a packet with the number {AT + 7} as the answer to number {AT}.",
    "ports": "sent a packet for 3 ports, where there are 2.",
    "short": "sent no answer but 43 bytes",
    "more": "sent 3 bytes more than the answer has.",
    "nan": "sent nan as the command of tip_phi.",
    "beyond": "sent -2.5 N as the command of tip_w, beyond its `sampling.command_limit` of 2 N.",
}


@pytest.mark.parametrize("fault", list(FAULTS))
def test_what_a_controller_does_wrong_ends_the_run_with_one_line_and_the_data_so_far(fault: str, tmp_path: Path) -> None:
    scenario, note = case(*SHORT), tmp_path / "note"
    store = FileStore(tmp_path / "result.nc")
    done = dampen.software_in_the_loop(
        scenario, faulty(fault, AT, note), timeout=0.3, compare=False, store=store, bench=bench(*SHORT)
    )
    assert "\n" not in done.failure
    assert FAULTS[fault] in done.failure, done.failure
    later = fault in ("more",)  # may be seen only when the next answer is asked for
    assert re.match(r"At sample 5[01] of trial 1 controller `" if later else "At sample 50 of trial 1 controller `", done.failure)
    assert gone(int(note.read_text()))
    result = dampen.load(tmp_path / "result.nc")
    assert (result.status, result.trials) == ("controller_lost", 1)
    assert result.warnings[-1] == done.failure
    assert_right_up_to(result, 50 if not later else None)
    rows = done.exchanges.columns
    assert (rows["kind"][-1], rows["trial"][-1], rows["status"][-1]) == ("step", 1, -1)
    assert np.isnan(rows["round_trip"][-1])
    assert not np.isnan(rows["round_trip"][:-1]).any()


def assert_right_up_to(result: dampen.Result, sample: int | None) -> None:
    """Trial 0 whole, trial 1 to a sample: the controller's law u = -y/2, and the motion that a run without faults has."""
    scenario = result.scenario
    whole = dampen.software_in_the_loop(scenario, faulty("none", 0), compare=False, bench=bench(*SHORT)).result
    assert whole.status == "complete"
    np.testing.assert_array_equal(whole["issued"], -0.5 * whole["reading"])
    assert list(result["status"][:]) == [0, 1]
    for name in result.layout.variables:
        np.testing.assert_array_equal(result[name][0], whole[name][0], err_msg=name)
    if sample is not None:
        np.testing.assert_array_equal(result["y"][1][: sample + 1], whole["y"][1][: sample + 1])
        np.testing.assert_array_equal(result["delivered"][1][:sample], whole["delivered"][1][:sample])
        for name in ("y", "delivered", "command", "issued", "energy"):
            assert np.isnan(result[name][1][sample + 1 :]).all()


REFUSED = {
    "exit": "At the hello controller `.*` ended with exit status 1. Its last words: warming up / sensor board not found",
    "hang": "At the hello controller `.*` sent no answer within 0.3 s",
    "text": "At the hello controller `.*` sent 'temperature",
    "ports": r"must be made for 2 ports and 200 samples of 0.001 s .* is for 3 ports and 200 samples of 0.001 s\.",
    "samples": "is for 2 ports and 100 samples of 0.001 s",
    "period": "is for 2 ports and 200 samples of 0.002 s",
}


@pytest.mark.parametrize("fault", list(REFUSED))
def test_a_controller_that_is_none_or_another_one_is_refused_at_the_hello(fault: str, tmp_path: Path) -> None:
    note = tmp_path / "note"
    with pytest.raises(dampen.ArgumentError, match=REFUSED[fault]):
        dampen.software_in_the_loop(case(*SHORT), faulty(fault, 0, note), timeout=0.3, bench=bench(*SHORT))
    assert gone(int(note.read_text()))


def test_what_cannot_begin_is_one_line_and_leaves_no_file(tmp_path: Path) -> None:
    plain = tmp_path / "plain.txt"
    plain.write_text("no program")
    scenario, room = case(*SHORT), bench(*SHORT)
    for controller, told in (
        ("./not-here --fast", "`./not-here`: No such file"),
        (str(plain), "Permission denied"),
        ("'unclosed", "No closing quotation"),
        ("", "must be a command line, but is ''"),
    ):
        with pytest.raises(dampen.ArgumentError, match=re.escape(told)):
            dampen.software_in_the_loop(scenario, controller, bench=room)
    for arguments, told in (
        ({}, "or `port`"),
        ({"controller": "true", "port": 5}, "or `port`"),
        ({"port": 70000}, "from 1 to 65535, or None, but is 70000"),
        ({"controller": "true", "timeout": 0.0}, "`timeout` must be a number from 1e-50"),
        ({"controller": "true", "timeout": float("nan")}, "`timeout` must be a number from 1e-50"),
        ({"port": free_port(), "timeout": 0.2}, "the controller at UDP port .* sent no answer within 0.2 s"),
    ):
        with pytest.raises(dampen.ArgumentError, match=told):
            dampen.software_in_the_loop(scenario, bench=room, **arguments)
    with pytest.raises(dampen.ArgumentError, match=r'`numerics.mode` must be "sampled" .* "continuous"'):
        dampen.software_in_the_loop(case(name="he2017"), "true", bench=room)
    done = dampen_sil(tmp_path, "he2017-sampled", "--controller", "true", "--out", "out")
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert "ended with exit status 0" in done.stderr
    assert not (tmp_path / "out").exists()
    assert dampen_sil(tmp_path, "he2017-sampled").returncode == 2


def test_a_controller_that_reports_a_stop_is_noted_and_the_run_goes_on() -> None:
    scenario = case(*SHORT)
    done = dampen.software_in_the_loop(scenario, faulty("stop", AT), compare=False, bench=bench(*SHORT))
    assert (done.failure, done.result.trials) == ("", 3)
    told = "At sample 50 of trial 1 the controller said: status 5, a port has crossed its constraint; it has stopped"
    assert [line for line in done.result.warnings if line.startswith(told)]
    assert done.result["issued"][1][:50].any()
    assert not done.result["issued"][1][50:].any()
    for fault, words in (("replaced", "status 1, a reading was replaced by its prediction."), ("unheard-of", "status 17.")):
        done = dampen.software_in_the_loop(scenario, faulty(fault, AT), compare=False, bench=bench(*SHORT))
        assert sum(words in line for line in done.result.warnings) == 1


def test_requests_count_and_tell_sample_time_and_what_the_sensors_show(tmp_path: Path) -> None:
    reset = (*SHORT, "task.start=reset", "task.trials=2")
    done = dampen.software_in_the_loop(case(*reset), faulty("tell", 0, tmp_path / "asked"), compare=False, bench=bench(*reset))
    asked = json.loads((tmp_path / "asked").read_text())
    assert asked[0] == [HELLO, 0, 0, 2, SAMPLES, 0.001]
    assert [one[1] for one in asked] == list(range(len(asked)))
    assert [KINDS[one[0]] for one in asked] == ["hello", *(["step"] * SAMPLES + ["end"]) * 2, "bye"]
    steps = [one for one in asked if one[0] == STEP]
    np.testing.assert_allclose([one[5] for one in steps], 0.001 * np.array([one[4] for one in steps]), rtol=1e-15)
    np.testing.assert_array_equal([one[6:] for one in steps], done.result["reading"].reshape(-1, 2))
    assert [one[2:6] for one in asked if one[0] == END] == [[1, 2, SAMPLES, 0.2]] * 2


@needs_c
def test_the_readings_are_those_that_the_controller_reads_in_the_sampled_run(built) -> None:
    scenario = case(*SHORT)
    done = dampen.software_in_the_loop(scenario, built(scenario), bench=bench(*SHORT))
    for trial, one in enumerate(record(scenario, bench(*SHORT))):
        np.testing.assert_array_equal(done.result["reading"][trial], one.readings[:-1])


def test_the_controller_in_the_documentation_works_as_it_says(tmp_path: Path) -> None:
    [text] = re.findall(r"```\{file\} pd\.py\n(.*?)```", DOCS.read_text(), re.DOTALL)
    assert len(text.splitlines()) <= 32
    (tmp_path / "pd.py").write_text(text)
    scenario = case("task.trials=1")
    for drive in (False, True):
        program = [sys.executable, str(tmp_path / "pd.py")]
        done = dampen.software_in_the_loop(scenario, program, drive=drive, bench=bench("task.trials=1"))
        assert done.failure == ""
        reading = done.result["reading"][0]
        rate = np.diff(reading, axis=0, prepend=reading[:1]) / 0.001
        np.testing.assert_allclose(done.result["issued"][0], -reading - 0.5 * rate, rtol=1e-12, atol=1e-15)


def test_the_packets_in_the_documentation_are_those_of_the_code() -> None:
    text = DOCS.read_text()
    rows = re.findall(r"^\| (\d+) \| (\S+)[^|]* \| (\w+) \|", text, re.MULTILINE)
    sizes = {"4 bytes": 4, "uint16": 2, "uint32": 4, "int32": 4, "double": 8}
    fields = re.findall(r"^\| (\d+) \| (4 bytes|u?int\d+|double) \|", text, re.MULTILINE)
    ends = [int(offset) + sizes[kind] for offset, kind in fields]
    assert [int(offset) for offset, _ in fields] == [0, *ends[:-1]]
    assert ends[-1] == HEADER.size == 32
    assert {int(k): n for k, n in re.findall(r"^\| (\d) \| `(\w+)`", text, re.MULTILINE)} == KINDS
    assert rows


@given(st.binary(max_size=80), st.sampled_from([HELLO, STEP, DRIVE, END]), st.booleans())
def test_no_bytes_at_all_are_taken_for_an_answer_that_they_are_not(noise: bytes, kind: int, begins: bool) -> None:
    request = Request(kind, 7, 2, numbers=None)
    data = HEADER.pack(b"DSIL", 1, kind, 7, 0, 2, 0, 0.0) + noise if begins else noise
    try:
        answer = answer_to(request, data)
    except Garbage as error:
        assert str(error).isprintable()
    else:
        assert begins
        assert len(data) == request.answer_size
        assert answer.numbers.tobytes() == noise


def test_ctrl_c_keeps_what_there_is_and_ends_the_program(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(to_toml(case(*SHORT)))
    command = shlex.join(faulty("slow", AT, tmp_path / "note"))
    process = subprocess.Popen(
        [sys.executable, "-m", "dampen.cli", "sil", "mine.toml", "--controller", command, "--out", "out", "--no-report"],
        cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    wait_for(lambda: (tmp_path / "note.slow").exists() or process.poll() is not None)  # sample 50 of trial 1
    process.send_signal(signal.SIGINT)
    _, told = process.communicate(timeout=30)
    assert process.returncode == 3, told
    assert "The run broke off after 1 of 3 trials." in told
    assert gone(int((tmp_path / "note").read_text()))
    result = dampen.load(tmp_path / "out" / "result.nc")
    assert (result.status, result.trials) == ("interrupted", 1)
    done = pd.read_parquet(tmp_path / "out" / "exchanges.parquet")
    sample = int(done[done.kind == "step"]["sample"].iloc[-1])
    assert 49 < sample < SAMPLES
    assert_right_up_to(result, None)
    assert not np.isnan(result["y"][1][:50]).any()
    assert np.isnan(result["y"][1][sample + 2 :]).all()


def wait_for(condition, seconds: float = 60.0) -> None:
    until = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < until
        time.sleep(0.05)


def dampen_sil(folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "dampen.cli", "sil", *arguments], cwd=folder, capture_output=True, text=True, check=False
    )


def free_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as one:
        one.bind(("127.0.0.1", 0))
        return int(one.getsockname()[1])


@contextmanager
def relay(port: int, lost: set[int], doubled: set[int]) -> Iterator[tuple[int, dict[str, int]]]:
    """Passes datagrams on to a port and back; the packets with these numbers are lost, the first time in each direction, or sent
    twice."""
    entrance, exit_ = (socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(2))
    entrance.bind(("127.0.0.1", 0))
    entrance.settimeout(0.05)
    exit_.connect(("127.0.0.1", port))
    exit_.settimeout(0.05)
    told, over, peer = {"lost": 0}, threading.Event(), []
    dropped: dict[str, set[int]] = {"there": set(), "back": set()}

    def times(way: str, data: bytes) -> int:
        number = HEADER.unpack_from(data)[3]
        if number in lost and number not in dropped[way]:
            dropped[way].add(number)
            told["lost"] += 1
            return 0
        return 2 if number in doubled else 1

    def there() -> None:
        while not over.is_set():
            try:
                data, peer[:] = (got := entrance.recvfrom(4096))[0], [got[1]]
                for _ in range(times("there", data)):
                    exit_.send(data)
            except OSError:
                pass

    def back() -> None:
        while not over.is_set():
            try:
                data = exit_.recv(4096)
                for _ in range(times("back", data)):
                    entrance.sendto(data, peer[0])
            except OSError:
                pass

    threads = [threading.Thread(target=one) for one in (there, back)]
    for thread in threads:
        thread.start()
    try:
        yield entrance.getsockname()[1], told
    finally:
        over.set()
        for thread in threads:
            thread.join()
        entrance.close()
        exit_.close()
