"""A user's own pieces: the examples run, and a mistake in a piece is reported with its class and line."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

import dampen
from dampen.analysis.energy import energy_account
from dampen.scenarios.read import build, parse
from dampen.toml import to_toml

EXAMPLES = Path(__file__).parents[1] / "examples"
MINE = str(EXAMPLES / "own_pieces.toml")


def test_own_plant_actuator_disturbance_and_learning_law_run_together() -> None:
    result = dampen.simulate(dampen.read_scenario(MINE))
    assert result.status == "complete"
    rms = np.sqrt(np.mean(result["y"] ** 2, axis=(1, 2)))
    assert rms[-1] < rms[0] / 4
    account = energy_account(result)
    assert account.error < 1e-12
    assert account.dissipated > 0


def test_own_sampled_law_holds_what_it_computes() -> None:
    """The law, computed again from the readings that the result keeps."""
    settings = ["numerics.mode=sampled", "controller.kind=own_sampled_law:DigitalPID", "task.trials=2", "sampling.period=0.004"]
    result = dampen.simulate(dampen.read_scenario(MINE, settings))
    y, rate = result["reading"][0][:, 0], result["rate_estimate"][0][:, 0]
    np.testing.assert_allclose(result["issued"][0][:, 0], -10 * y - rate - 20 * 0.004 * np.cumsum(y), atol=1e-13)
    np.testing.assert_array_equal(result["command"][0][:, 0], np.repeat(result["issued"][0][:, 0], 4))


def test_a_scenario_of_own_pieces_reads_back() -> None:
    scenario = dampen.read_scenario(MINE)
    assert build(parse(to_toml(scenario), "again"), EXAMPLES) == scenario


@pytest.mark.parametrize("piece", sorted(EXAMPLES.glob("own_*.py")), ids=lambda p: p.stem)
def test_examples_of_own_pieces_are_short(piece: Path) -> None:
    assert len(piece.read_text(encoding="utf-8").splitlines()) < 30


STAGE = (
    "\n\n@dataclass(frozen=True)\nclass Mine(dampen.Stage):\n    gain = 1.0\n    step = staticmethod(step)\n"
    "    def row(self, dt):\n        return (1.0,)\n"
)

MISTAKES = {
    "raises": (
        "plant",
        "class Mine(dampen.Plant):\n    ports = (dampen.Port('second', '', 1.0),)\n    def modes(self, count):\n"
        "        return dampen.Modes(omega=np.zeros(2), b=undefined, ports=self.ports)\n",
        r"mistake_raises:Mine.modes failed: NameError: name 'undefined' is not defined \(mistake_raises.py, line 9\)",
    ),
    "shape": (
        "plant",
        "class Mine(dampen.Plant):\n    ports = (dampen.Port('second', '', 1.0),)\n    def modes(self, count):\n"
        "        return dampen.Modes(omega=np.ones(2), b=np.ones(2), ports=self.ports)\n",
        r"mistake_shape:Mine.modes must give `b` of shape \(1, 2\), but gives \(2,\)",
    ),
    "learn": (
        "controller",
        "class Mine(dampen.Controller):\n    def law(self, memory, setting):\n"
        "        return dampen.PortLaw(np.zeros((setting.steps, 1)))\n"
        "    def learn(self, memory, trial, setting):\n        return {'u': trial.nonsense}\n",
        r"mistake_learn:Mine.learn failed: AttributeError: .*nonsense.*\(mistake_learn.py, line 10\)",
    ),
    "memory": (
        "controller",
        "class Mine(dampen.Controller):\n    def law(self, memory, setting):\n"
        "        return dampen.PortLaw(np.zeros((setting.steps, 1)))\n"
        "    def learn(self, memory, trial, setting):\n        return {'u': trial.v}\n",
        r"mistake_memory:Mine.learn must keep the memories \{\}, but returns \{'u': \(2000, 1\)\}",
    ),
    "negative": (
        "controller",
        "class Mine(dampen.Controller):\n    def law(self, memory, setting):\n"
        "        return dampen.PortLaw(np.zeros((setting.steps, 1)), damping=np.array([-1.0]))\n",
        "mistake_negative:Mine.law must give `damping` >= 0, but the least is -1",
    ),
    "step": (
        "actuator.second.chain.0",
        "def step(command, state, parameters, new_state):\n    return command + state[0].nonsense\n" + STAGE,
        r"mistake_step:Mine.step failed: AttributeError: .*nonsense.*\(mistake_step.py, line 6\)",
    ),
    "compile": (
        "actuator.second.chain.0",
        "def step(command, state, parameters, new_state):\n    return sorted([command, {}.get(1, 0.0)])[0]\n" + STAGE,
        r"mistake_compile:Mine.step cannot be compiled: .*mistake_compile.py, line [56]\)",
    ),
    "forgotten": (
        "controller",
        "class Mine(dampen.Controller):\n    def law(self, memory, setting):\n        pass\n",
        "mistake_forgotten:Mine.law must return a PortLaw, but returns None",
    ),
    "falling": (
        "actuator.second.chain.0",
        "def step(command, state, parameters, new_state):\n    return -command\n" + STAGE,
        "mistake_falling:Mine.step must not fall as its command rises",
    ),
    "not a number": (
        "actuator.second.chain.0",
        "def step(command, state, parameters, new_state):\n    return command * float('nan')\n" + STAGE,
        "mistake_not_a_number:Mine.step must give finite numbers, but gives nan",
    ),
    "abstract": (
        "plant",
        "class Mine(dampen.Plant):\n    ports = (dampen.Port('second', '', 1.0),)\n",
        "must name a complete class, but 'mistake_abstract:Mine' does not define modes",
    ),
    "syntax": ("plant", "class Mine(dampen.Plant:\n", r"cannot be loaded: SyntaxError: .*"),
}


@pytest.mark.parametrize("mistake", list(MISTAKES))
def test_a_mistake_is_reported_with_its_class_and_line(mistake: str, tmp_path: Path) -> None:
    key, body, words = MISTAKES[mistake]
    mistake = mistake.replace(" ", "_")
    head = "import dampen\nimport numpy as np\nfrom dataclasses import dataclass\n\n"
    code = head + (body if body.startswith("def") else f"@dataclass(frozen=True)\n{body}")
    (tmp_path / f"mistake_{mistake}.py").write_text(code)
    text = (EXAMPLES / "own_pieces.toml").read_text(encoding="utf-8")
    (tmp_path / "mine.toml").write_text(text)
    for piece in EXAMPLES.glob("own_*.py"):
        (tmp_path / piece.name).write_text(piece.read_text(encoding="utf-8"))
    try:
        with pytest.raises(dampen.ArgumentError, match=words) as error:
            dampen.simulate(dampen.read_scenario(tmp_path / "mine.toml", [f"{key}.kind=mistake_{mistake}:Mine", "task.trials=2"]))
        assert len(error.value.lines) == 1
    finally:
        sys.modules.pop(f"mistake_{mistake}", None)
