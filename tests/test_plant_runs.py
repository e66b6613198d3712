"""Whole runs of every plant: the energy closes, and the learning law holds a light beam."""

from __future__ import annotations

import numpy as np
import pytest

import dampen
from dampen import Deflection, EulerBernoulliBeam
from dampen.analysis.energy import energy_account
from dampen.plants.base import Plant
from tests.test_plants import PLANTS


def task(**constraint: float) -> dict[str, object]:
    return {
        "task": dampen.Task(trials=3, trial_duration=1.0, constraint=constraint),
        "numerics": dampen.Numerics(modes=40, step=1e-3),
    }


@pytest.mark.parametrize("plant", PLANTS, ids=lambda p: type(p).__name__)
def test_energy_closes_without_control(plant: Plant) -> None:
    result = dampen.simulate(dampen.Scenario(plant, dampen.NoControl(), dampen.NoDisturbance(), **task()))  # type: ignore[arg-type]
    assert result.status == "complete"
    assert energy_account(result).error < 1e-11
    assert np.max(np.abs(result["y"])) > 0.005


class Push(dampen.Disturbance):
    """A force at the first port, and a load along w."""

    def at_ports(self, trial: int, t: np.ndarray, site: object) -> np.ndarray:
        return np.outer(np.sin(5 * t), np.eye(len(site.ports))[0])  # type: ignore[attr-defined]

    @property
    def load_field(self) -> str | None:
        return "w"

    def load(self, trial: int, t: np.ndarray, x: np.ndarray, site: object) -> np.ndarray:
        return np.outer(np.cos(3 * t), x)


@pytest.mark.parametrize("plant", PLANTS, ids=lambda p: type(p).__name__)
def test_energy_closes_under_forces_and_loads(plant: Plant) -> None:
    result = dampen.simulate(dampen.Scenario(plant, dampen.NoControl(), Push(), **task()))  # type: ignore[arg-type]
    assert energy_account(result).error < 1e-11


def test_the_learning_law_holds_a_light_beam_within_its_constraint() -> None:
    beam = EulerBernoulliBeam(tip_mass=0.02, tip_inertia=1e-5, initial=Deflection(w=(0, 0, 0.05)))
    law = dampen.DualLoopAILC(compensate=False)
    bounds = {"f": 0.1, "tip_w": 0.1, "tip_phi": 0.1}
    case = dampen.Scenario(beam, law, dampen.NoDisturbance(), bounds=bounds, **task(tip_w=0.1, tip_phi=0.2))  # type: ignore[arg-type]
    result = dampen.simulate(case)
    assert result.status == "complete"
    assert not result.warnings
    assert energy_account(result).error < 1e-11
    assert np.all(np.abs(result["y"]) < [0.1, 0.2])
    assert result["energy"][2][-1] < result["energy"][0][0]
