"""A thousand malformed messages and uploads: each is answered with an error, and the lab goes on."""

from __future__ import annotations

import copy
import json
import random
from typing import Any

import dampen
from dampen.scenarios.read import source_text, table_of
from dampen.simulation.stores import FileStore
from dampen.simulation.trials import simulate
from tests.lab import Page, lab_process

MESSAGES, UPLOADS = 800, 320
WRONG: tuple[Any, ...] = (
    *(None, [], {}, "", "x", "os:system", "../x", "\0", "\ud800", "9" * 400, True, [[[]]], {"a": {"b": 1}}, ["a", 1]),
    *(float("nan"), float("inf"), -1e308, 1e-320, -1, 10**30, -(10**30), 1e9, {"kind": "sum", "terms": [{"kind": "sum"}]}),
)


def spots(table: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Paths of all values in a table."""
    inner = table.items() if isinstance(table, dict) else enumerate(table) if isinstance(table, list) else ()
    return [*([path] if path else []), *(spot for key, value in inner for spot in spots(value, (*path, key)))]


def broken_table(chance: random.Random) -> Any:
    """A shipped scenario with one thing wrong: a value, a key too many, a table missing."""
    table = copy.deepcopy(table_of(chance.choice(["he2017", "he2017-sampled", "string-tip-mass", "flexible-arm-point-to-point"])))
    table["task"]["trials"] = 2
    path = chance.choice([spot for spot in spots(table) if spot not in (("title",), ("name",))])
    inside: Any = table
    for key in path[:-1]:
        inside = inside[key]
    way = chance.random()
    if way < 0.15 and isinstance(inside, dict):
        inside[chance.choice(["", "nosuch", "é", "a" * 300, "__class__"])] = chance.choice(WRONG)
    elif way < 0.2:
        table["plant"] = chance.choice(WRONG)
    else:
        inside[path[-1]] = chance.choice(WRONG)
    return table


def broken_message(chance: random.Random, id: int) -> str | bytes:
    """A message that is no JSON, no request, or a request for what cannot be."""
    whole = json.dumps({"do": "run", "id": id, "trial": 0, "table": table_of("he2017")})
    ways = (
        lambda: chance.randbytes(chance.randrange(200)),
        lambda: whole[: chance.randrange(len(whole))],
        lambda: "".join(chr(chance.randrange(32, 0x2FFF)) for _ in range(chance.randrange(100))),
        lambda: json.dumps({"do": chance.choice(["run", "open", "stop", 7]), "id": chance.choice(WRONG)}),
        lambda: json.dumps({"do": "open", "id": id, "token": chance.choice(WRONG)}),
        lambda: json.dumps({"do": "run", "id": id, "table": chance.choice(WRONG)}),
        lambda: "[" * chance.randrange(50_000),
    )
    if chance.random() < 0.35:
        return chance.choice(ways)()
    return json.dumps({"do": "run", "id": id, "trial": chance.choice([0, 1, 10**9]), "table": broken_table(chance)})


def answer(page: Page) -> str:
    """How a message was answered: what ends its answer, pictures of tables that turned out to be right included."""
    while True:
        message = page.socket.recv(timeout=120)
        if isinstance(message, str) and (said := json.loads(message)["say"]) in ("refused", "failed", "complete", "left"):
            return said


def broken_upload(chance: random.Random, result: bytes) -> bytes:
    """A scenario or a result that is cut off, has bytes changed, or is none."""
    content = bytearray(chance.choice([source_text("he2017").encode(), result, b"PK\x03\x04" + chance.randbytes(200)]))
    if chance.random() < 0.3:
        return bytes(content[: chance.randrange(len(content))])
    for _ in range(chance.randrange(1, 400)):
        content[chance.randrange(min(len(content), 6000))] = chance.randrange(256)
    return bytes(content)


def test_a_thousand_malformed_messages_and_uploads_are_answered_and_the_lab_goes_on(tmp_path):
    chance, errors = random.Random(2017), 0
    scenario = dampen.read_scenario("he2017", ["task.trials=2"])
    simulate(scenario, store=FileStore(tmp_path / "result.nc"))
    result = (tmp_path / "result.nc").read_bytes()
    with lab_process() as (address, process):
        page = Page(address)
        for id in range(MESSAGES):
            page.socket.send(broken_message(chance, id))
            errors += answer(page) in ("refused", "failed")
        for _ in range(UPLOADS):
            where = chance.choice(
                ["/read?name=a.toml", "/read?name=%00..%2fa.nc", "/attach?name=a.npz", "/download/toml", "/download/x"]
            )
            status, body, _ = page.post(where, broken_upload(chance, result))
            assert status in (200, 400), (where, status)
            if status == 400:
                assert json.loads(body)["faults"][0]["text"]
                errors += 1
        assert errors >= 1000, errors
        assert process.poll() is None
        table = table_of("he2017")
        assert page.run(table).end == "complete"
        page.close()
