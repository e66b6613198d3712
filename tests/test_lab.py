"""The lab's server: its pictures are the API's numbers, and nothing that a browser sends reaches code or files."""

from __future__ import annotations

import copy
import io
import json
import os
import signal
import socket
import subprocess
import sys
import time
import urllib.request
import zipfile
from pathlib import Path

import netCDF4
import numpy as np
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

import dampen
from dampen.component import ArgumentError
from dampen.lab.frames import framed, unframed
from dampen.lab.handed_in import attach
from dampen.lab.limits import check_cost
from dampen.lab.picture import BUCKETS, POINTS, bucketed, largest_in, overview, selected
from dampen.lab.tables import Trust, scenario_of
from dampen.scenarios.kinds import KINDS
from dampen.scenarios.read import build, laid_over, shipped, table_of
from dampen.scenarios.schema import schema
from dampen.simulation.bench import Bench
from dampen.simulation.stores import FileStore
from dampen.simulation.trials import simulate
from tests.lab import Page, lab_process


def quick(name: str = "he2017", trials: int = 3) -> dict:
    table = table_of(name)
    table["task"]["trials"] = trials
    return table


@pytest.fixture(scope="module")
def address():
    with lab_process() as (address, _):
        yield address


@pytest.fixture
def page(address):
    page = Page(address)
    yield page
    page.close()


# frames and pictures


def test_a_frame_comes_back_as_it_was():
    arrays = {"y": np.arange(6.0).reshape(2, 3), "peaks": np.array([0.1]), "empty": np.zeros((0, 2))}
    header, found = unframed(framed({"say": "picture", "text": "φ"}, arrays))
    assert header["text"] == "φ"
    assert found["peaks"].dtype == np.float64
    assert found["y"].dtype == np.float32
    for name, values in arrays.items():
        assert found[name].shape == values.shape
        np.testing.assert_array_equal(found[name], values.astype(found[name].dtype))


@pytest.mark.parametrize("length", [1, 7, 60, 2001])
def test_buckets_lose_no_peak_and_keep_its_order(length):
    values = np.random.default_rng(1).standard_normal((3, 2001, 2))
    found = bucketed(values, length)
    assert found.shape == (3, -(-2001 // length), 2, 2)
    np.testing.assert_array_equal(found.min(axis=(1, 2)), values.min(axis=1))
    np.testing.assert_array_equal(found.max(axis=(1, 2)), values.max(axis=1))
    rising = np.broadcast_to(np.arange(2001.0)[None, :, None], values.shape)
    assert np.all(bucketed(rising, length)[:, :, 0] <= bucketed(rising, length)[:, :, 1])
    assert np.all(bucketed(-rising, length)[:, :, 0] >= bucketed(-rising, length)[:, :, 1])


def test_a_thinned_field_keeps_its_largest_values_with_their_sign():
    values = np.random.default_rng(2).standard_normal((2, 21, 5))
    found = largest_in(values, 8)
    for column, block in enumerate((values[:, :8], values[:, 8:16], values[:, 16:])):
        at = np.abs(block).argmax(axis=1)
        np.testing.assert_array_equal(found[:, column], np.take_along_axis(block, at[:, None], axis=1)[:, 0])


@pytest.mark.parametrize("count", [2, 51, 68, 101, 102, 202, 500, 5000])
def test_points_that_are_shown_are_even_enough_and_keep_both_ends(count):
    points = selected(count)
    assert (points[0], points[-1]) == (0, count - 1)
    assert len(points) == min(count, POINTS)
    assert np.ptp(np.diff(points)) <= 1


def test_the_overview_covers_the_run_within_its_buckets():
    result = dampen.simulate(scenario_of(quick(), Trust(Path())))
    found = overview(result)
    assert 3 * found["all.y"].shape[1] <= BUCKETS + 3
    np.testing.assert_array_equal(found["all.y"].max(axis=(0, 1, 2)), result["y"].max(axis=(0, 1)))
    np.testing.assert_array_equal(found["peaks"], np.abs(result["y"]).max(axis=1))


@pytest.mark.parametrize("name", list(shipped()))
def test_every_shipped_scenario_is_shown_with_the_numbers_of_the_api(page, name):
    opened = page.get(f"/scenario/{name}")
    opened["table"].setdefault("task", {})["trials"] = 2
    answers = page.run(opened["table"], trial=1)
    ((header, arrays),) = answers.pictures
    scenario = dampen.read_scenario(name, ["task.trials=2"])
    result = dampen.simulate(scenario)
    assert [port["name"] for port in header["ports"]] == list(scenario.ports)
    assert (header["trials"], header["trial"], header["source"]) == (2, 1, "run")
    from dampen.analysis.metrics import error_peaks

    np.testing.assert_array_equal(arrays["peaks"], np.stack([error_peaks(result, p) for p in scenario.ports], axis=1))
    for name in ("y", "command", "delivered", "energy", *dict(scenario.plant.fields)):
        exact = np.asarray(result[name][1], np.float32)
        if name in dict(scenario.plant.fields):
            exact = exact[:, selected(exact.shape[1])]
        np.testing.assert_array_equal(arrays[name], exact)
        np.testing.assert_array_equal(answers.trials[0][name].shape, arrays[name].shape)
    assert answers.end == "complete"
    assert answers.of("review")["audit"]


def test_a_review_says_what_the_command_line_says(page):
    answers = page.run(table_of("he2017"))
    scenario = dampen.read_scenario("he2017")
    result, free = dampen.simulate(scenario), dampen.simulate(scenario.uncontrolled())
    claims = {claim.id: claim.verdict for claim in dampen.check_claims(result, free)}
    findings = {one.id: one.verdict for one in dampen.audit(result, refine=False).findings}
    review = answers.of("review")
    assert {row["id"]: row["verdict"] for row in review["claims"]} == claims
    assert {row["id"]: row["verdict"] for row in review["findings"]} == findings
    assert set(answers.trials) == set(range(1, 25))


def test_payload_base_and_search_ranges_come_from_the_code(page):
    ((header, _),) = page.run(quick()).pictures
    assert header["tip"] == {"mass": 0.1, "inertia": 0.1}
    assert header["clamped"] == "clamped"
    assert header["sliders"]["controller.alpha_4"]["log"]
    ((header, _),) = page.run(quick("string-tip-mass")).pictures
    assert (header["clamped"], header["tip"]["mass"]) == ("pinned", 5.0)


# the schema


def test_the_schema_knows_every_kind_and_parameter():
    found = schema()
    for family, classes in KINDS.items():
        assert [kind["kind"] for kind in found["kinds"][family]] == [cls.kind for cls in classes]
    assert json.loads(json.dumps(found)) == found
    law = next(kind for kind in found["kinds"]["controller"] if kind["kind"] == "dual-loop-ailc")
    gain = next(p for p in law["parameters"] if p["name"] == "alpha_4")
    assert (gain["type"], gain["unit"], gain["range"]) == ({"is": "number"}, "N s/m", {"gt": 0.0})


def test_defaults_of_the_schema_are_those_of_the_code():
    """A component made of nothing but the schema's own defaults is the component that leaves everything out."""
    from dampen.scenarios.read import Builder

    found = schema()["kinds"]
    checked = 0
    for family in ("plant", "controller", "actuator", "disturbance"):
        for kind in found[family]:
            if any(p["required"] for p in kind["parameters"]) or kind["kind"] in ("assembled", "recorded", "function"):
                continue
            given = {p["name"]: p["default"] for p in kind["parameters"] if "default" in p}
            builder = Builder(Path())
            own, bare = (builder.of_kind(family, {"kind": kind["kind"], **values}, family) for values in (given, {}))
            assert own == bare, kind["kind"]
            checked += 1
    assert checked > 15


# what is refused


@pytest.mark.parametrize(
    ("change", "at", "words"),
    [
        ({"controller": {"kind": "os:system"}}, "controller.kind", "code of your own"),
        ({"plant": {"kind": "timoshenko", "bending_stiffness": "os:getcwd"}}, "plant.bending_stiffness", "code of your own"),
        ({"disturbance": {"kind": "function", "highest_frequency": 1.0, "force": {"tip_w": "os:abort"}}}, "force", "code of"),
        ({"plant": {"kind": "assembled", "file": "/etc/passwd"}}, "plant.file", "'passwd' is none"),
        ({"plant": {"kind": "assembled", "file": "../../secret.npz"}}, "plant.file", "must name an attachment"),
        ({"plant": {"kind": "assembled", "mass": "/dev/zero"}}, "plant.mass", "must name an attachment"),
        (
            {"disturbance": {"kind": "recorded", "file": "/etc/hosts", "columns": {"tip_w": "a"}}},
            "disturbance.file",
            "attachment",
        ),
        (
            {"task": {"reference": {"tip_w": {"kind": "recorded", "file": "a.csv", "column": "b"}}}},
            "task.reference",
            "attachment",
        ),
        ({"task": {"trials": 100_000}}, "numerics.step", "smaller run for the lab"),
        ({"numerics": {"discretisation": "finite-difference", "points": 1001, "modes": 500}}, "numerics.step", "smaller run"),
        ({"output": {"points": 5000, "every": 1}}, "task.trials", "MiB"),
        ({"controller": {"kind": "dual-loop-ailc", "alpha_4": -1}}, "controller.alpha_4", "must be > 0"),
        ({"controller": {"kind": "dual-loop-ailc", "alfa": 1}}, "controller.alfa", "is not known"),
        ({"actuator": {"all": {"chain": [{"kind": "backlash", "slope": -1}]}}}, "actuator.all.chain[0].slope", "must be > 0"),
    ],
)
def test_a_fault_is_told_at_its_field_and_the_lab_goes_on(page, change, at, words):
    table = laid_over(table_of("he2017"), change)
    answers = page.run(table)
    assert not answers.pictures
    assert any(fault["at"].startswith(at) or at in fault["at"] for fault in answers.faults), answers.faults
    assert any(words in fault["text"] for fault in answers.faults), answers.faults
    assert page.run(quick()).pictures


def test_code_and_files_that_a_browser_names_are_never_touched(tmp_path, monkeypatch):
    trap = tmp_path / "trap.py"
    trap.write_text("raise SystemExit('imported')\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(str(tmp_path))
    (tmp_path / "attachments").mkdir()
    for table, key, value in (
        ("plant", "tip_mass", "trap:x"),
        ("plant", "shear_stiffness", "trap:x"),
        ("controller", "kind", "trap:Law"),
        ("disturbance", "kind", "trap:Noise"),
    ):
        changed = copy.deepcopy(table_of("he2017"))
        changed[table][key] = value
        with pytest.raises(ArgumentError, match="code of your own"):
            scenario_of(changed, Trust(tmp_path / "attachments"))
    assert "trap" not in sys.modules


def test_tables_without_end_are_refused():
    table: dict = {}
    for _ in range(40):
        table = {"kind": "sum", "terms": [table]}
    with pytest.raises(ArgumentError, match="deeper than"):
        scenario_of({**quick(), "disturbance": table}, Trust(Path()))


def test_predicted_cost_is_within_a_factor_of_what_it_takes():
    from dampen.simulation.cost import predicted_bytes, predicted_seconds

    scenario = scenario_of(table_of("he2017"), Trust(Path()))
    check_cost(scenario)
    result = dampen.simulate(scenario)
    kept = sum(np.asarray(result[name]).nbytes for name in result.layout.variables)
    loads = 25 * 2000 * 80 * 8
    assert 0.7 < predicted_bytes(scenario) / (kept + loads) < 1.5
    assert 0.01 < predicted_seconds(scenario) < 1


NO_MESSAGES = [
    *("", "{", "[]", "null", "7", '"run"', "{}", '{"do":"run"}', '{"do":"go","id":1}', "[" * 100_000),
    *('{"do":"run","id":-1}', '{"do":"run","id":"a"}', '{"do":"run","id":true,"table":{}}', '{"do":"run","id":1,"table":7}'),
    *('{"do":"run","id":1,"trial":-1,"table":{}}', '{"do":"run","id":1,"table":{"plant":[1]}}'),
    '{"do":"open","id":1,"token":"../../etc/passwd"}',
]


@pytest.mark.parametrize("message", NO_MESSAGES)
def test_a_message_that_is_none_gets_an_answer(page, message):
    said = json.loads(page.exchange(message))
    assert said["say"] == "refused"
    assert said["faults"][0]["text"]


def test_a_message_that_is_too_large_closes_its_own_line_only(address, page):
    other = Page(address)
    with pytest.raises(ConnectionClosed):
        other.exchange("x" * 2**20)
    assert page.run(quick()).pictures


# who may speak


@pytest.mark.parametrize(
    "headers",
    [
        {"Host": "evil.example"},
        {"Host": "127.0.0.1.evil.example"},
        {"Origin": "http://evil.example"},
        {"Origin": "null"},
        {"Origin": "http://["},
        {"Origin": None},
        {"X-Dampen": None},
    ],
)
def test_only_the_labs_own_page_is_listened_to(page, headers):
    status, body, _ = page.post("/download/toml", json.dumps({"table": quick()}).encode(), **headers)
    assert status == 403, body


def test_a_foreign_host_gets_no_page_and_a_foreign_page_no_line(address):
    request = urllib.request.Request(f"{address}/schema", headers={"Host": "evil.example"})
    with pytest.raises(urllib.error.HTTPError, match="403"):
        urllib.request.urlopen(request, timeout=30)
    line = address.replace("http", "ws") + "/ws"
    for origin in ("http://evil.example", None):
        with pytest.raises((InvalidStatus, ConnectionClosed)), connect(line, origin=origin, open_timeout=30):
            pass


def test_the_lab_is_bound_to_loopback(address):
    port = int(address.rsplit(":", 1)[1])
    with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as other:
        other.settimeout(5)
        with pytest.raises(OSError, match=r"refused|unreachable|timed out"):
            other.connect(("127.0.0.2", port))


def test_every_answer_forbids_framing_sniffing_and_foreign_sources(address):
    with urllib.request.urlopen(f"{address}/", timeout=30) as answer:
        policy = answer.headers["content-security-policy"]
        assert "default-src 'self'" in policy
        assert "unsafe-eval" not in policy
        assert answer.headers["x-frame-options"] == "DENY"
        assert answer.headers["x-content-type-options"] == "nosniff"


@pytest.mark.parametrize(
    "path", ["/../pyproject.toml", "/%2e%2e/lab.py", "/..%2flab.py", "/etc/passwd", "/scenario/..%2f..", "/lab.py"]
)
def test_no_path_leads_out_of_the_page(address, path):
    host, port = address.removeprefix("http://").split(":")
    with socket.create_connection((host, int(port)), timeout=30) as line:
        line.sendall(f"GET {path} HTTP/1.1\r\nHost: {host}:{port}\r\nConnection: close\r\n\r\n".encode())
        assert line.recv(4096).split(b" ")[1] in (b"404", b"400", b"307")


# handing in and taking away


def test_a_scenario_taken_away_and_handed_in_is_the_same(page):
    table = quick()
    table["controller"]["alpha_4"] = 3.25
    status, text, headers = page.post("/download/toml", json.dumps({"table": table}).encode())
    assert status == 200
    assert headers["content-disposition"] == 'attachment; filename="he2017.toml"'
    status, body, _ = page.post("/read?name=mine.toml", text)
    assert status == 200, body
    again = json.loads(body)["table"]
    assert again["controller"]["alpha_4"] == 3.25
    assert scenario_of(again, Trust(Path())) == scenario_of(table, Trust(Path()))


def test_a_result_taken_away_is_a_result_file_and_shows_the_same_again(page, tmp_path):
    table = quick()
    status, content, _ = page.post("/download/netcdf", json.dumps({"table": table}).encode())
    assert status == 200
    (tmp_path / "result.nc").write_bytes(content)
    result = dampen.load(tmp_path / "result.nc")
    np.testing.assert_array_equal(result["y"][:], dampen.simulate(scenario_of(table, Trust(Path())))["y"])
    status, body, _ = page.post("/read?name=result.nc", content)
    opened = json.loads(body)
    assert status == 200, body
    answers = page.answers(page.send(do="open", token=opened["token"], trial=2))
    ((header, arrays),) = answers.pictures
    assert (header["source"], header["trial"]) == ("file", 2)
    np.testing.assert_array_equal(arrays["peaks"], page.run(table).pictures[0][1]["peaks"])


def test_figures_and_report_are_those_of_the_command_line(page):
    body = json.dumps({"table": quick(trials=2)}).encode()
    status, content, _ = page.post("/download/figures", body)
    assert status == 200
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        assert {"energy.png", "energy.svg"} <= set(archive.namelist())
    status, content, headers = page.post("/download/report", body)
    assert status == 200
    assert b"<html" in content[:200].lower()
    assert headers["content-disposition"].startswith("attachment")
    assert headers["content-type"] == "application/octet-stream"


def test_a_scenario_with_files_travels_with_them(page):
    opened = page.get("/scenario/assembled-from-fe")
    status, content, headers = page.post("/download/toml", json.dumps({"table": opened["table"]}).encode())
    assert status == 200
    assert headers["content-disposition"].endswith('.zip"')
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        text = archive.read("scenario.toml").decode()
        (wing,) = [name for name in archive.namelist() if name.endswith(".npz")]
        assert f'"{wing}"' in text
        assert "/" not in next(line for line in text.splitlines() if line.startswith("file"))


def test_an_attached_record_shakes_the_beam(page):
    t = np.linspace(0, 2, 201)
    text = "t,f\n" + "\n".join(f"{a:.6g},{0.1 * np.sin(6 * a):.6g}" for a in t)
    status, body, _ = page.post("/attach?name=my%20gust.csv", text.encode())
    assert status == 200, body
    name = json.loads(body)["attachment"]
    assert name.startswith("my-gust-")
    table = quick()
    table["disturbance"] = {"kind": "recorded", "file": name, "columns": {"tip_w": "f"}, "time": "t"}
    answers = page.run(table)
    assert answers.pictures, answers.said
    other = {**quick(), "disturbance": {"kind": "none"}}
    assert not np.array_equal(answers.pictures[0][1]["y"], page.run(other).pictures[0][1]["y"])


def test_an_attached_netcdf_record_is_copied_without_what_else_it_holds(page, tmp_path):
    path, t = tmp_path / "record.nc", np.linspace(0, 2, 201)
    with netCDF4.Dataset(path, "w") as file:
        file.createDimension("row", len(t))
        file.createVariable("t", "f8", ("row",))[:] = t
        file.createVariable("f", "f4", ("row",))[:] = 0.1 * np.sin(6 * t)
        file.createVariable("table", "f8", ("row", "row"))
    name = json.loads(page.post("/attach?name=record.nc", path.read_bytes())[1])["attachment"]
    table = quick()
    table["disturbance"] = {"kind": "recorded", "file": name, "columns": {"tip_w": "f"}, "time": "t"}
    found = page.run(table).pictures[0][1]["peaks"]
    own = laid_over(quick(), {})
    own["disturbance"] = {"kind": "recorded", "file": str(path), "columns": {"tip_w": "f"}, "time": "t"}
    np.testing.assert_array_equal(found, overview(dampen.simulate(build(own)))["peaks"])


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("x.exe", b"MZ", "must be one of"),
        ("x.py", b"raise SystemExit", "must be one of"),
        ("../../x.csv", b"", None),
        ("a.npz", None, "unfold"),
    ],
)
def test_attachments_are_named_by_the_lab_and_bounded(tmp_path, name, content, words):
    if content is None:
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("mass.npy", bytes(100 * 2**20))
        content = packed.getvalue()
    folder = tmp_path / "attachments"
    folder.mkdir()
    if words is None:
        assert (folder / attach(content, name, Trust(folder))).parent == folder
    else:
        with pytest.raises(ArgumentError, match=words):
            attach(content, name, Trust(folder))
        assert not list(folder.iterdir())
    assert list(tmp_path.iterdir()) == [folder]


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.toml", b"\xff\xfe", "not UTF-8"),
        ("a.toml", b"plant = [", "not valid TOML"),
        ("a.toml", b"x = 1", "must be given"),
        ("a.toml", b'based_on = "/etc/passwd"', "whole scenarios"),
        ("a.toml", b'[plant]\nkind = "os:system"', "code of your own"),
        ("a.nc", b"\x89HDF\r\n\x1a\n" + bytes(500), "cannot be read"),
        ("a.nc", b"CDF\x01" + bytes(100), "not a dampen result"),
    ],
)
def test_a_broken_upload_is_told_as_one(page, name, content, words):
    status, body, _ = page.post(f"/read?name={name}", content)
    assert status == 400
    assert any(words in fault["text"] for fault in json.loads(body)["faults"]), body


def test_a_result_that_names_code_or_lies_about_its_shape_is_refused(page, tmp_path):
    table = quick(trials=2)
    _, content, _ = page.post("/download/netcdf", json.dumps({"table": table}).encode())
    for change in ("own code", "shape"):
        path = tmp_path / f"{change}.nc"
        path.write_bytes(content)
        with netCDF4.Dataset(path, "a") as file:
            text = file.getncattr("scenario")
            if change == "own code":
                text = text.replace('kind = "dual-loop-ailc"', 'kind = "os:system"')
            else:
                text = text.replace("points = 51", "points = 26")
            file.setncattr("scenario", text)
        status, body, _ = page.post("/read?name=a.nc", path.read_bytes())
        assert status == 400, change
        assert json.loads(body)["faults"][0]["text"]
    assert page.run(quick()).pictures


def stored_result(tmp_path, trials=2):
    """A small result file, and its content."""
    path = tmp_path / "result.nc"
    simulate(dampen.read_scenario("he2017", [f"task.trials={trials}"]), store=FileStore(path)).arrays.file.close()
    return path


@pytest.mark.parametrize("way", ["external storage", "external link", "virtual"])
def test_a_result_that_points_into_another_file_is_refused(page, tmp_path, way):
    import h5py

    secret = tmp_path / "secret"
    secret.write_bytes(b"s" * 2**20)
    other = tmp_path / "other.h5"
    path = stored_result(tmp_path)
    with h5py.File(path) as file:
        shape, kind = file["y"].shape, file["y"].dtype
    with h5py.File(other, "w") as file:
        file.create_dataset("y", data=np.ones(shape))
    with h5py.File(path, "a") as file:
        del file["y"]
        if way == "external storage":
            size = int(np.prod(shape)) * 8
            file.create_dataset("y", shape, kind, external=[(str(secret), 0, size)])
        elif way == "external link":
            file["y"] = h5py.ExternalLink(str(other), "y")
        else:
            layout = h5py.VirtualLayout(shape, kind)
            layout[...] = h5py.VirtualSource(str(other), "y", shape)
            file.create_virtual_dataset("y", layout, fillvalue=7.0)
    status, body, _ = page.post("/read?name=a.nc", path.read_bytes())
    if way == "virtual":  # HDF5 puts the fill value where it finds no source
        ((_, arrays),) = page.answers(page.send(do="open", token=json.loads(body)["token"])).pictures
        assert np.all(arrays["y"] == 7.0)
    else:
        assert status == 400, body
    assert page.run(quick()).pictures


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("trials_finished", 60_000),
        ("trials_finished", -1),
        ("trials_finished", "two"),
        ("status", "all is well"),
        ("scenario", 7),
    ],
)
def test_a_result_is_not_believed_about_itself(page, tmp_path, name, value):
    path = stored_result(tmp_path)
    with netCDF4.Dataset(path, "a") as file:
        file.setncattr(name, value)
    status, body, _ = page.post("/read?name=a.nc", path.read_bytes())
    assert status == 400, body
    assert json.loads(body)["faults"][0]["text"]


def test_an_opened_result_is_given_back_as_it_was(page, tmp_path):
    content = stored_result(tmp_path).read_bytes()
    opened = json.loads(page.post("/read?name=a.nc", content)[1])
    body = json.dumps({"table": opened["table"], "token": opened["token"]}).encode()
    assert page.post("/download/netcdf", body)[1] == content


@pytest.mark.parametrize("what", ["toml", "netcdf"])
def test_a_scenario_with_attachments_comes_back_in_another_lab(page, what):
    t = np.linspace(0, 2, 201)
    text = "t,f: N\n" + "\n".join(f"{a:.6g},{0.1 * np.sin(6 * a):.6g}" for a in t)
    name = json.loads(page.post("/attach?name=gust.csv", text.encode())[1])["attachment"]
    assert json.loads(page.post(f"/attach?name={name}", text.encode())[1])["attachment"] == name
    table = quick()
    table["disturbance"] = {"kind": "recorded", "file": name, "columns": {"tip_w": "f: N"}, "time": "t"}
    peaks = page.run(table).pictures[0][1]["peaks"]
    status, content, headers = page.post(f"/download/{what}", json.dumps({"table": table}).encode())
    assert status == 200, content
    assert headers["content-disposition"].endswith('.zip"')
    with lab_process() as (elsewhere, _):
        other = Page(elsewhere)
        status, body, _ = other.post("/read?name=mine.zip", content)
        assert status == 200, body
        opened = json.loads(body)
        id = other.send(do="open", token=opened["token"]) if what == "netcdf" else other.send(do="run", table=opened["table"])
        np.testing.assert_array_equal(other.answers(id).pictures[0][1]["peaks"], peaks)
        other.close()


DEAR = {
    "norm-optimal over long trials": (
        "flexible-arm-point-to-point",
        {"task": {"trials": 2, "trial_duration": 100.0}, "numerics": {"modes": 10}},
    ),
    "lqg of many modes": ("he2017-sampled", {"controller": {"kind": "lqg", "modes": 800}, "numerics": {"modes": 800}}),
    "very many trials": ("string-tip-mass", {"task": {"trials": 100_000, "trial_duration": 0.01}, "output": {"every": 10}}),
    "very many moving loads": (
        "he2017",
        {
            "disturbance": {"kind": "sum", "terms": [{"kind": "moving-load", "force": 0.01, "speed": 0.3}] * 300},
            "numerics": {"modes": 200},
            "task": {"trial_duration": 10.0, "trials": 5},
        },
    ),
}


@pytest.mark.parametrize("name", DEAR)
def test_what_would_take_too_long_is_refused_before_it_starts(page, name):
    base, change = DEAR[name]
    began = time.monotonic()
    answers = page.run(laid_over(table_of(base), change))
    assert any("smaller run for the lab" in fault["text"] for fault in answers.faults), answers.faults
    assert time.monotonic() - began < 10


@pytest.mark.parametrize("form", ["npz", "mtx"])
def test_a_sparse_matrix_that_unfolds_without_end_is_refused(tmp_path, form):
    import scipy.io
    import scipy.sparse

    folder, path = tmp_path / "attachments", tmp_path / f"m.{form}"
    folder.mkdir()
    matrix = scipy.sparse.identity(20_000, format="csr" if form == "npz" else "coo")
    scipy.sparse.save_npz(path, matrix) if form == "npz" else scipy.io.mmwrite(path, matrix)
    with pytest.raises(ArgumentError, match="unfold"):
        attach(path.read_bytes(), path.name, Trust(folder))


def test_uploads_are_bounded_as_they_come(page):
    status, body, _ = page.post("/attach?name=a.csv", bytes(17 * 2**20))
    assert status == 400
    assert "at most 16 MiB" in json.loads(body)["faults"][0]["text"]


def test_a_quick_errand_does_not_wait_for_a_slow_one(page):
    import threading

    slow = threading.Thread(target=page.post, args=("/download/report", json.dumps({"table": table_of("he2017")}).encode()))
    slow.start()
    time.sleep(1.0)
    began = time.monotonic()
    assert page.post("/read?name=a.toml", b"x = 1")[0] == 400
    quick_one = time.monotonic() - began
    assert slow.is_alive()
    slow.join()
    assert quick_one < 4


def test_downloads_leave_nothing_behind(tmp_path, monkeypatch):
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    with lab_process() as (address, _):
        page = Page(address)
        for table in (quick(), {"plant": 7}):
            page.post("/download/netcdf", json.dumps({"table": table}).encode())
        page.post("/download/nosuch", b"{}")
        time.sleep(0.3)
        (folder,) = tmp_path.glob("dampen-lab-*")
        assert [path.name for path in folder.iterdir()] == ["attachments"]
        page.close()


def test_no_code_is_taken_from_the_folder_that_the_lab_is_started_in(tmp_path):
    (tmp_path / "queue.py").write_text("raise SystemExit('taken')\n")
    command = [str(Path(sys.executable).parent / "dampen"), "lab", "--no-browser", "--port", "0"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, text=True) as process:
        page = Page(process.stdout.readline().split()[1].rstrip("/"))
        assert page.run(quick()).end == "complete"
        page.close()
        process.send_signal(signal.SIGINT)


# the newest wins, and nothing stays behind


def test_of_many_changes_the_last_is_answered_and_the_others_are_left(page):
    table = quick(trials=25)
    last = 0
    for alpha in range(1, 41):
        table["controller"]["alpha_4"] = float(alpha)
        last = page.send(do="run", table=table)
    answers = page.answers(last)
    assert answers.end == "complete"
    scenario = dampen.read_scenario("he2017", ["controller.alpha_4=40.0"])
    np.testing.assert_array_equal(answers.pictures[0][1]["y"], dampen.simulate(scenario)["y"][0].astype(np.float32))


def test_a_long_run_is_left_for_a_newer_one(page):
    long = quick(trials=1000)
    page.send(do="run", table=long)
    time.sleep(0.6)
    began = time.monotonic()
    assert page.run(quick()).pictures
    assert time.monotonic() - began < 15


def test_a_worker_that_dies_is_replaced(tmp_path):
    with lab_process() as (address, process):
        page = Page(address)
        assert page.run(quick()).end == "complete"
        workers = Path(f"/proc/{process.pid}/task/{process.pid}/children")
        if not workers.exists():
            pytest.skip("needs /proc to find the worker")
        (worker,) = map(int, workers.read_text().split())
        os.kill(worker, signal.SIGKILL)
        answers = [page.run(quick()) for _ in range(2)]
        assert [one.end for one in answers] == ["complete", "complete"]
        page.close()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_the_lab_ends_in_good_order_and_leaves_nothing(tmp_path, monkeypatch, number):
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    with lab_process() as (address, process):
        page = Page(address)
        page.send(do="run", table=quick())
        process.send_signal(number)
        assert process.wait(timeout=30) == 0
    assert not list(tmp_path.iterdir())


def test_a_result_file_opens_as_it_was_written(tmp_path):
    folder = tmp_path / "run"
    command = [sys.executable, "-m", "dampen.cli", "run", "he2017", "--set", "task.trials=2", "--no-report", "--out", str(folder)]
    subprocess.run(command, check=True, capture_output=True)
    with lab_process(str(folder / "result.nc")) as (address, _):
        page = Page(address)
        start = page.get("/start")
        ((header, arrays),) = page.answers(page.send(do="open", token=start["token"])).pictures
        assert header["source"] == "file"
        assert start["table"]["task"]["trials"] == 2
        np.testing.assert_array_equal(arrays["y"], np.asarray(dampen.load(folder / "result.nc")["y"][0], np.float32))
        page.close()


def test_a_scenario_with_classes_of_the_users_own_runs_when_the_command_names_it():
    examples = Path(__file__).parent.parent / "examples"
    with lab_process(str(examples / "own_pieces.toml")) as (address, _):
        page = Page(address)
        table = page.get("/start")["table"]
        assert page.run(table).pictures
        table["disturbance"] = {"kind": "os:system"}
        assert "code of your own" in page.run(table).faults[0]["text"]
        page.close()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("nosuch",), "neither a shipped scenario nor a file"),
        (("--port", "99999"), "must be a port that is free"),
        (("--host", "203.0.113.7"), "must be a port that is free on"),
    ],
)
def test_bad_arguments_get_one_line(arguments, words):
    command = [sys.executable, "-m", "dampen.cli", "lab", "--no-browser", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 2
    assert words in done.stderr
    assert done.stderr.count("\n") == 1


def test_importing_dampen_loads_no_web_stack():
    code = "import dampen, dampen.cli, sys; print({'starlette', 'uvicorn', 'websockets', 'matplotlib'} & set(sys.modules))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout.strip() == "set()"


def test_a_bench_is_shared_only_by_what_it_can_serve():
    from dampen.lab.desk import Desk

    desk = Desk(lambda said: None, lambda: False)
    first = dampen.read_scenario("he2017")
    same = dampen.read_scenario("he2017", ["controller.alpha_4=2.0", "actuator.all.chain=[]"])
    other = dampen.read_scenario("he2017", ["plant.tip_mass=0.2"])
    assert desk.bench(first) is desk.bench(same)
    assert desk.bench(other) is not desk.bench(first)
    np.testing.assert_array_equal(
        dampen.simulate(same, bench=desk.bench(first))["y"], dampen.simulate(same, bench=Bench(same))["y"]
    )
