"""Every public function and component, given what it cannot take: the error names the argument, and nothing else is raised."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import MISSING, fields
from functools import cache
from inspect import isabstract, isclass, signature
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dampen
from dampen.component import Component, parameters
from dampen.simulation.bench import Bench
from tests.conftest import scenario
from tests.synthetic import Defined, StandIn

PUBLIC = {
    name: getattr(dampen, name)
    for name in re.findall(r"import \w+ as (\w+)$", Path(dampen.__file__).with_suffix(".pyi").read_text(), re.MULTILINE)
}
WRONG: tuple[Any, ...] = (
    *(
        None,
        "",
        "x",
        b"x",
        "\0",
        True,
        object(),
        [],
        (),
        {},
        [None],
        ["x", 1],
        {"a": object()},
        {1: 2},
        {"nosuch": 1.0},
        -1,
        -1.5,
        0,
    ),
    *(float("nan"), float("inf"), -float("inf"), 1e300, 1e-300, 10**400, 1j, np.zeros(0), np.zeros((2, 3)), np.array([np.nan])),
    *(np.array(["x"]), [[1.0], [1.0, 2.0]], int, print, lambda: None, Path("nowhere"), range(3), {1.0}, "nowhere:nothing"),
)
COMPONENTS = {name: c for name, c in PUBLIC.items() if isclass(c) and issubclass(c, Component) and not isabstract(c)}
GIVEN: dict[str, dict[str, Any]] = {  # what has no default
    "Harmonics": {"frequencies": (1.0,), "force": {"tip_w": (1.0,)}},
    "BandNoise": {"rms": {"tip_w": 1.0}, "low": 1.0, "high": 2.0},
    "Impulse": {"duration": 0.1},
    "MovingLoad": {"force": 1.0, "speed": 1.0},
    "FunctionDisturbance": {"highest_frequency": 1.0},
    "Sum": {"terms": ()},
    "MinimumJerk": {"target": 1.0, "duration": 1.0},
    "Sinusoid": {"amplitude": 1.0, "frequency": 1.0},
    "Decay": {"start": 1.0, "final": 0.5},
    "Constraint": {"high": 1.0},
    "AssembledPort": {"name": "end"},
    "AssembledShape": {"name": "w", "x": (0.0, 1.0), "values": ((1.0,), (1.0,))},
    "Assembled": {"mass": [[1.0]], "stiffness": [[1.0]], "port_vectors": [[1.0]], "port": (dampen.AssembledPort("end"),)},
    "Scenario": {"plant": dampen.String(), "controller": dampen.NoControl(), "disturbance": dampen.NoDisturbance()},
}
TRUTHS = ("refine", "single", "build", "residual", "udp", "drive", "compare", "compile")
FROM_FILES = ("Recorded", "RecordedSignal")


@cache
def case() -> dampen.Scenario:
    return scenario("task.trials=1", "task.trial_duration=0.02", "numerics.modes=4", "output.every=1", "controller.kind=none")


@cache
def result() -> dampen.Result:
    return dampen.simulate(case(), compile=False)


def study() -> StandIn:
    return StandIn(Defined("sweep", case(), ()), 0, {"member": []})


FUNCTIONS: dict[str, Callable[[], dict[str, Any]]] = {  # arguments that will do
    "audit": lambda: {"result": result(), "refine": False, "bench": Bench(case())},
    "bounds": lambda: {"result": result(), "bench": Bench(case())},
    "credit": lambda: {"scenario": case(), "progress": print},
    "limit": lambda: {"scenario": case(), "of": "w", "weights": [1.0], "bench": None, "progress": None, "threads": 1},
    "limits": lambda: {"scenario": case(), "weights": [1.0], "bench": None, "progress": None, "threads": 1},
    "standing": lambda: {"limit": dampen.limit(case(), "w", [1.0]), "result": result()},
    "rates": lambda: {"scenario": case(), "bench": Bench(case())},
    "sampling_cost": lambda: {"sampled": result(), "continuous": result()},
    "export_c": lambda: {"scenario": case(), "folder": "c", "single": False, "guards": None},
    "export_fmu": lambda: {"scenario": case(), "file": "x.fmu", "what": "plant", "guards": None, "build": False},
    "state_space": lambda: {
        "scenario": case(), "modes": 2, "inputs": ["ports"], "rates": False, "residual": False, "balanced": None,
        "discrete": False,
    },
    "version": dict,
    "check_claims": lambda: {"result": result(), "baseline": None},
    "read_scenario": lambda: {"source": "he2017", "overrides": ()},
    "load": lambda: {"path": "missing.nc"},
    "software_in_the_loop": lambda: {
        "scenario": case(), "controller": "missing", "udp": False, "port": None, "drive": False, "timeout": 1.0,
        "compare": False, "store": None, "progress": None, "bench": None,
    },
    "simulate": lambda: {"scenario": case(), "store": None, "progress": None, "bench": None, "compile": False},
    "resume": lambda: {"folder": "missing", "engine": 1, "progress": None},
    "sweep": lambda: {"scenario": case(), "vary": {"plant.nosuch": "1:2:2"}, "folder": None, "engine": 1, "progress": None},
    "robust": lambda: {
        "scenario": case(), "uncertain": ["plant.nosuch=+-30%"], "samples": 4, "sampler": "sobol", "seed": 0, "folder": None,
        "engine": 1, "progress": None,
    },
    "tune": lambda: {
        "scenario": case(), "search": ["plant.nosuch=1:2"], "objective": "peak", "budget": 4, "population": 4, "robust_over": (),
        "robust_samples": 2, "seed": 0, "folder": None, "engine": 1, "progress": None,
    },
    "best_scenario": lambda: {"study": study(), "objective": "peak"},
    "compare": lambda: {
        "scenario": case(), "contenders": ["nosuch"], "budget": 0, "searches": 1, "objective": "residual", "seed": 0,
        "as_given": (), "folder": None, "engine": 1, "progress": None,
    },
    "open_comparison": lambda: {"folder": "missing"},
    "robustness": lambda: {"study": study()},
    "open_study": lambda: {"folder": "missing"},
}  # fmt: skip


def test_the_table_is_complete() -> None:
    functions = {name for name, f in PUBLIC.items() if not isclass(f)}
    assert set(FUNCTIONS) == functions
    assert all(set(signature(PUBLIC[name]).parameters) == set(make()) for name, make in FUNCTIONS.items())
    required = {n for n, c in COMPONENTS.items() if any(f.default is MISSING and f.default_factory is MISSING for f in fields(c))}
    assert required | {"Assembled"} == set(GIVEN) | set(FROM_FILES)


@pytest.mark.parametrize("name", [name for name in COMPONENTS if name not in FROM_FILES])
def test_components_refuse_what_they_cannot_hold(name: str) -> None:
    cls, given = COMPONENTS[name], GIVEN.get(name, {})
    cls(**given)
    refused = 0
    for parameter in parameters(cls):
        for wrong in WRONG:
            try:
                cls(**{**given, parameter.name: wrong})
            except dampen.ArgumentError as error:
                refused += 1
                assert any(parameter.name in line for line in error.lines), (parameter.name, wrong, error.lines)
                assert all(line.isprintable() and len(line) <= 1000 for line in error.lines)
    assert refused >= 10 * len(parameters(cls))
    with pytest.raises(TypeError):
        cls(**given, nosuch=1)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_refuse_what_they_cannot_take(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    function, good = PUBLIC[name], FUNCTIONS[name]()
    for argument in good:
        for wrong in WRONG:
            if fits(name, argument, wrong):
                continue
            try:
                function(**{**good, argument: wrong})
            except dampen.ArgumentError as error:
                assert any(argument in line for line in error.lines), (argument, wrong, error.lines)
            else:
                raise AssertionError((argument, wrong))
    with pytest.raises(TypeError):
        function(**good, nosuch=1)
    assert not list(tmp_path.iterdir())


def fits(function: str, argument: str, value: Any) -> bool:
    """Whether this wrong value will do here after all, or is told by what it names."""
    texts = isinstance(value, str) or (isinstance(value, list | tuple) and all(isinstance(v, str) for v in value))
    named = isinstance(value, str | Path) and value != "\0"
    whole = isinstance(value, int) and not isinstance(value, bool) and value >= 0
    return value is None or {
        "source": named, "path": named, "folder": named, "file": named,
        "objective": texts, "of": isinstance(value, str), "controller": texts, "sampler": isinstance(value, str),
        "engine": isinstance(value, str), "what": isinstance(value, str), "progress": callable(value),
        "overrides": isinstance(value, list | tuple) and texts, "inputs": texts, "as_given": texts, "contenders": texts,
        "vary": texts or isinstance(value, dict), "uncertain": texts or isinstance(value, dict),
        "search": texts or isinstance(value, dict), "robust_over": texts or isinstance(value, dict),
        "seed": whole and value < 10**9, "budget": whole and value < 10**9,
        "rates": isinstance(value, bool), "discrete": isinstance(value, bool),
    }.get(argument, isinstance(value, bool) and argument in TRUTHS)  # fmt: skip
