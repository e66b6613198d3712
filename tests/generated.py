"""Scenario files made by chance from the schema: valid ones of every kind, nearly valid ones, hostile ones; by seed."""

from __future__ import annotations

import copy
import random
from collections.abc import Callable
from typing import Any

import numpy as np

from dampen.scenarios.read import source_text
from dampen.scenarios.schema import schema
from dampen.toml import bare, literal

Table = dict[str, Any]
SCHEMA = schema()
KINDS = {family: {one["kind"]: one for one in known} for family, known in SCHEMA["kinds"].items()}
PORTS = {"string": ("tip_w",), "flexible-arm": ("hub", "tip_w"), "assembled": ("end", "middle")}
FIELDS = {"string": ("w",), "assembled": ()}
FILES = ("recorded", "function")  # what names something beside the scenario
WRONG: tuple[Any, ...] = (
    *(None, [], {}, "", "x", "os:system", "../x", "é\u202e\x7f", "9" * 400, True, [[[]]], {"a": {"b": 1}}, ["a", 1], [1, [2]]),
    *(float("nan"), float("inf"), -1e308, 1e308, 1e-320, 1e-300, 1e300, 1e60, 1e-60, 1e20, 1e-20, 0, 0.0, -0.0, -1, -1.5, 10**30),
    *(-(10**30), 10**400, 1e9, 2**31, 2**63, 2**64, {"kind": "sum", "terms": [{"kind": "sum"}]}, {"kind": "hold"}, "/dev/zero"),
    *({"kind": "nowhere:Nothing"}, {"kind": ":"}, {"kind": "\x00:x"}, {"kind": "dampen.cli:main"}, [0.0] * 3000, "/", "file.csv"),
)
KEYS = ("", "nosuch", "é", "a" * 300, "__class__", "kind", "tip_w", "all", "f", "..", "\x00", "chain")
INSTEAD = (b"\xff", b"==", b"= -", b"= 1e999")
NAMES = ("../../x", "/etc/x", "a/b", "..", "", "x" * 10_000, "con")
BASES = ("../x", "/dev/zero", "scenario.toml", "he2017", "/", "", 3)
SCALES = (1e-300, 1e-160, 1e-80, 1e-40, 1e-20, 1e-10, 1e-6, 1e6, 1e10, 1e20, 1e40, 1e80, 1e160, 1e300)


def as_file(table: Table) -> str:
    """A table as a scenario file."""
    return "".join(f"{bare(key)} = {literal(value)}\n" for key, value in table.items() if value is not None)


class Generator:
    """A scenario after the other, by chance."""

    def __init__(self, seed: int):
        self.chance = random.Random(seed)

    def file(self) -> tuple[str, bytes]:
        """What it is ("valid", "nearly", "scaled", "hostile"), and its content."""
        way = self.chance.choices(["valid", "nearly", "scaled", "hostile"], [45, 35, 10, 10])[0]
        if way == "hostile":
            return way, self.hostile()
        table = self.table()
        if way == "nearly":
            self.spoil(table)
        if way == "scaled":
            self.scale(table)
        return way, as_file(table).encode("utf-8", "replace")

    def maybe(self, share: float = 0.5) -> bool:
        return self.chance.random() < share

    def number(self, low: float = 0.1, high: float = 1.0) -> float:
        """Of any size between two, as likely in each decade."""
        return float(low * (high / low) ** self.chance.random())

    def table(self) -> Table:
        """A scenario that can be run."""
        c = self.chance
        kind = c.choice(list(KINDS["plant"]))
        self.ports, self.fields = PORTS.get(kind, ("tip_w", "tip_phi")), FIELDS.get(kind, ("w", "phi"))
        self.steps, self.duration = c.choice([8, 12, 24]), self.number(0.01, 2.0)
        law = c.choice(list(KINDS["controller"]))
        while law in ("adaptive-boundary", "dual-loop-ailc") and kind not in ("timoshenko", "euler-bernoulli"):
            law = c.choice(list(KINDS["controller"]))
        self.sampled = law == "lqg" or self.maybe(0.3)
        self.start = c.choice(["chained", "reset"])
        table: Table = {"plant": self.plant(kind), "task": self.task(law), "numerics": self.numerics(kind)}
        table["controller"] = {"kind": law, **self.controller(law)}
        table["output"] = {"points": c.randint(2, 9), "every": c.choice([1, 2, 4])}
        table["bounds"] = {"f": self.number(), **{port: self.number() for port in self.ports}}
        if self.maybe(0.8):
            table["disturbance"] = self.disturbance()
        if self.maybe():
            table["sampling"] = self.sampling()
        elif self.sampled:
            table["sampling"] = {"period": self.duration / 4}
        for name, share in (("actuator", 0.6), ("compensation", 0.2)):
            if self.maybe(share):
                where = ["all"] if self.maybe() else [port for port in self.ports if self.maybe(0.7)]
                table[name] = {port: {"chain": [self.stage(name) for _ in range(c.randint(0, 3))]} for port in where}
        if self.maybe(0.3):
            table["title"] = c.choice(["", "Träger", "a\tb\n\x01\x7f", "振動 " * 20, '"quoted" \\ $x$ _{ ^ {', "\u202eback"])
            table["name"] = c.choice(["x", "Ärger-1.0", "a" * 60])
        return table

    def plant(self, kind: str) -> Table:
        """A plant near its defaults, or matrices."""
        if kind == "assembled":
            n = self.chance.choice([2, 3, 6])
            root = np.array([[self.chance.gauss(0, 1) for _ in range(n)] for _ in range(n)])
            ports = np.eye(n)[[0, n // 2]]
            return {
                "kind": kind, "mass": np.eye(n).tolist(), "stiffness": (50 * (root @ root.T + np.eye(n))).tolist(),
                "port_vectors": ports.tolist(), "port": [{"name": name} for name in self.ports],
                "translation": [1.0] * n, **({"damping": self.damping()} if self.maybe() else {}),
            }  # fmt: skip
        plant: Table = {"kind": kind}
        for p in KINDS["plant"][kind]["parameters"]:
            default = p.get("default")
            if isinstance(default, float) and self.maybe(0.7):
                plant[p["name"]] = default * self.number(0.3, 3.0)
                if p["type"]["is"] == "any" and self.maybe(0.2):
                    plant[p["name"]] = [plant[p["name"]], 0.1 * plant[p["name"]]]
        if self.maybe():
            plant["damping"] = self.damping()
        if self.maybe():
            plant["initial"] = {name: [0.0, 0.0, 0.01 * self.number()] for name in ("w", "w_rate") if self.maybe()}
        if kind == "euler-bernoulli" and self.maybe(0.3):
            plant |= {"tension": self.number(1, 100), "base": self.chance.choice(["clamped", "pinned"])}
        return plant

    def damping(self) -> Table:
        ratio = self.number(1e-3, 0.1)
        return {
            "ratio": ratio if self.maybe() else [ratio, 0.0],
            "kelvin_voigt": self.number(1e-6, 1e-3),
            "viscous": self.number(),
        }

    def task(self, law: str) -> Table:
        task: Table = {"trials": self.chance.randint(1, 3), "trial_duration": self.duration, "start": self.start}
        if self.start == "reset" and self.maybe():
            task["reset_error"] = {port: self.number(1e-6, 1e-4) for port in self.ports}
        if self.maybe(0.4):
            task["reference"] = {port: self.signal(0.1) for port in self.ports if self.maybe(0.7)}
        task["constraint"] = {port: self.limit() for port in self.ports}
        if law not in ("adaptive-boundary", "dual-loop-ailc", "boundary-damping") and self.maybe(0.3):
            del task["constraint"]
        return task

    def limit(self) -> Any:
        wide = self.number(1.0, 5.0)
        moving = {"kind": "decay", "start": 2 * wide, "final": wide, "time_constant": self.number()}
        return self.chance.choice([wide, [-wide, 2 * wide], {"high": wide, "on": "error"}, {"high": moving, "low": -wide}])

    def signal(self, size: float) -> Table:
        kind = self.chance.choice([k for k in KINDS["signal"] if k not in FILES])
        numbers = {"hold": ("value",), "minimum-jerk": ("target",), "sinusoid": ("amplitude",), "decay": ("start", "final")}[kind]
        more: Table = {"minimum-jerk": {"duration": self.duration / 2}, "sinusoid": {"frequency": 0.5 / self.duration}}.get(
            kind, {}
        )
        return {"kind": kind, **{name: size * self.number() for name in numbers}, **more}

    def numerics(self, kind: str) -> Table:
        modes = {"assembled": 2}.get(kind, self.chance.choice([1, 2, 4, 8] if kind == "string" else [2, 4, 8]))
        numerics: Table = {"modes": modes, "step": self.duration / self.steps}
        if kind in ("timoshenko", "string") and self.maybe(0.3):
            numerics |= {"discretisation": "finite-difference", "points": self.chance.choice([9, 11, 21])}
        return {**numerics, "mode": "sampled"} if self.sampled else numerics

    def sampling(self) -> Table:
        step = self.duration / self.steps
        sampling: Table = {"period": step * self.chance.choice([1, 2, 4]), "delay": step * self.chance.choice([0, 0, 1, 2, 5])}
        for p in SCHEMA["tables"]["sampling"]["parameters"]:
            if p["type"]["is"] == "table" and self.maybe(0.4):
                sampling[p["name"]] = {port: self.number(1e-4, 1e-2) for port in self.ports if self.maybe(0.8)}
            if p["type"]["is"] == "choice" and self.maybe():
                sampling[p["name"]] = self.chance.choice(p["type"]["of"])
        return sampling

    def by_port(self, low: float, high: float) -> Table:
        return {port: self.number(low, high) for port in self.ports if self.maybe(0.8)}

    def controller(self, law: str) -> Table:
        """Parameters of a law, for what it has."""
        found: Table = {}
        for p in KINDS["controller"][law]["parameters"]:
            name, kind = p["name"], p["type"]["is"]
            if not self.maybe(0.6):
                continue
            if name in ("feedforward", "command"):
                found[name] = {port: self.signal(1.0) for port in self.ports}
            elif kind == "table":
                found[name] = self.by_port(0.01, 10.0)
            elif kind == "choice":
                found[name] = self.chance.choice(p["type"]["of"])
            elif kind == "boolean":
                found[name] = self.maybe()
            elif kind == "number" and isinstance(p.get("default"), float) and p["default"] > 0:
                found[name] = max(p["default"] * self.number(0.3, 3.0), p["range"].get("ge", 0.0))
        if law == "lqg":
            found["modes"] = 1
        return found

    def stage(self, family: str) -> Table:
        kind = self.chance.choice([k for k in KINDS[family] if self.sampled or k != "bouc-wen"])
        near = {p["name"]: p.get("default") for p in KINDS[family][kind]["parameters"]}
        stage: Table = {name: d * self.number(0.5, 2.0) for name, d in near.items() if isinstance(d, float) and self.maybe()}
        if kind in ("lag", "rate-limit"):
            stage = {name: self.number(0.01, 100.0) for name in near}
        if kind == "effectiveness":
            stage = {
                "times": [0.0, self.duration / 2, self.duration],
                "values": [1.0, self.number(), self.chance.choice([0.0, 1.0])],
            }
        return {"kind": kind, **stage}

    def disturbance(self, depth: int = 0) -> Table:
        c, slow = self.chance, 0.5 / self.duration
        unfit = () if self.fields else ("he2017", "moving-load")
        kind = c.choice([k for k in KINDS["disturbance"] if k not in (*FILES, *unfit)])
        place = {"x": 0.1, "field": c.choice(self.fields)} if self.fields else {}
        if kind == "sum":
            return {"kind": kind, "terms": [] if depth else [self.disturbance(1) for _ in range(c.randint(0, 3))]}
        band: Table = {"low": 0.9 / self.duration, "high": 1.1 / self.duration}
        made: dict[str, Callable[[], Table]] = {
            "none": dict,
            "he2017": lambda: {"base_frequency": slow / 50},
            "harmonics": lambda: {"frequencies": [0.0, 0.8 * slow], "force": {p: [self.number(), 0.1] for p in self.ports}},
            "band-noise": lambda: {"rms": self.by_port(0.01, 1), "seed": c.randint(0, 99), **band},
            "impulse": lambda: {"duration": self.duration, "impulse": self.by_port(0.01, 1), "blow": 0.1 * bool(place), **place},
            "constant": lambda: {"force": self.by_port(0.01, 1), **({"load_density": 1.0, **place} if place else {})},
            "moving-load": lambda: {"force": 1.0, "speed": 0.01 / self.duration, **place},
            "base-shaking": lambda: {
                "frequencies": [slow],
                "amplitudes": [self.number()],
                **({"rms": 1.0, **band} if self.maybe() else {}),
            },
        }
        found = made[kind]()
        if kind in ("constant", "moving-load"):
            found.pop("x", None)
        trials = next((p["type"]["of"] for p in KINDS["disturbance"][kind]["parameters"] if p["name"] == "trials"), None)
        return {"kind": kind, **found, **({"trials": c.choice(trials)} if trials else {})}

    def spoil(self, table: Table) -> None:
        """Make one thing of a table wrong: a value, a key too many, a key missing."""
        path = self.chance.choice(spots(table))
        inside: Any = table
        for key in path[:-1]:
            inside = inside[key]
        way = self.chance.random()
        if way < 0.15 and isinstance(inside, dict):
            inside[self.chance.choice(KEYS)] = self.chance.choice(WRONG)
        elif way < 0.25:
            del inside[path[-1]]
        elif way < 0.4 and isinstance(inside[path[-1]], int | float) and not isinstance(inside[path[-1]], bool):
            inside[path[-1]] = -inside[path[-1]]
        else:
            inside[path[-1]] = copy.deepcopy(self.chance.choice(WRONG))

    def scale(self, table: Table) -> None:
        """Make one to three numbers of a table very large or very small."""
        numbers = [path for path in spots(table) if isinstance(at(table, path), float)]
        for path in self.chance.sample(numbers, min(len(numbers), self.chance.randint(1, 3))):
            at(table, path[:-1])[path[-1]] = at(table, path) * self.chance.choice(SCALES)

    def hostile(self) -> bytes:
        """What is no scenario at all, or was made to do harm."""
        c, whole = self.chance, as_file(self.table()).encode()
        ways: tuple[Callable[[], bytes], ...] = (
            lambda: c.randbytes(c.randrange(300)),
            lambda: whole[: c.randrange(len(whole))],
            lambda: whole + whole,
            lambda: b"x = " + b"[" * c.randrange(100_000),
            lambda: b"[" + b".".join([b"a"] * c.randrange(1, 3000)) + b"]\nx = 1",
            lambda: whole + b"x = [" + b"0," * c.randrange(300_000) + b"]",
            lambda: whole + f'name = "{c.choice(NAMES)}"\n'.encode(),
            lambda: whole + f'based_on = {literal(c.choice(BASES))}\n'.encode(),
            lambda: source_text("he2017").encode().replace(b"=", c.choice(INSTEAD), c.randrange(1, 9)),
            lambda: bytes(b if c.random() > 0.01 else c.randrange(256) for b in whole),
            lambda: whole + f"[plant.damping]\nratio = {'9' * c.randrange(1, 9000)}\n".encode(),
            lambda: whole.replace(b"kind = \"", b"kind = \"nowhere.at_all:", 1),
        )  # fmt: skip
        return c.choice(ways)()


def spots(table: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Paths of all values in a table."""
    inner = table.items() if isinstance(table, dict) else enumerate(table) if isinstance(table, list) else ()
    return [*([path] if path else []), *(spot for key, value in inner for spot in spots(value, (*path, key)))]


def at(table: Any, path: tuple[Any, ...]) -> Any:
    """The value at a path."""
    for key in path:
        table = table[key]
    return table
