"""Every script of the gallery runs, is short, draws one figure, and comes to the number that it came to."""

from __future__ import annotations

import runpy
from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import pytest

GALLERY = Path(__file__).parents[1] / "examples" / "gallery"
# A number of each script, and how far it may move, relative: round-off where it is exact, a little more where Sgn holds a tip.
NUMBERS = {
    "arm": ("gained", 637.716, 1e-3),
    "backlash_loop": ("off", 0.06, 1e-9),
    "barrier": ("room", 0.00381031, 1e-4),
    "base_shaking": ("ratio", 0.491149, 1e-4),
    "bode": ("few", 0.0156034, 1e-4),
    "decay_rates": ("slow", 0.191442, 1e-4),
    "gain_landscape": ("least", 0.00448892, 1e-2),
    "gym_policy": ("ratio", 0.542603, 1e-3),
    "heat_map": ("ratio", 0.205371, 1e-3),
    "hysteresis": ("off", 0.0376837, 1e-5),
    "learning_curves": ("ratio", 1.52444, 1e-2),
    "limit_curve": ("ratio", 1.35202, 1e-3),
    "moving_load": ("kept", 0.615621, 1e-4),
    "own_disturbance": ("peak", 48.5487, 1e-3),
    "own_learning_law": ("ratio", 0.743498, 1e-3),
    "paper_run": ("left", 0.00290373, 1e-3),
    "payloads": ("middle", 0.000701223, 2e-2),
    "switching": ("ratio", 0.133010, 2e-2),
    "timoshenko_euler": ("third", 0.703807, 1e-5),
    "uncertain_learning": ("spread", 5.60810, 2e-2),
}


def test_there_is_a_number_for_every_script() -> None:
    assert set(NUMBERS) == {script.stem for script in GALLERY.glob("*.py")}


@pytest.mark.filterwarnings("ignore:FigureCanvasAgg is non-interactive")
@pytest.mark.parametrize("name", NUMBERS)
def test_a_script_of_the_gallery_comes_to_its_number(name: str) -> None:
    matplotlib.use("agg")
    plt.close("all")
    with matplotlib.rc_context():
        left = runpy.run_path(str(GALLERY / f"{name}.py"))
        assert len(plt.get_fignums()) == 1
    plt.close("all")
    variable, value, tolerance = NUMBERS[name]
    assert float(left[variable]) == pytest.approx(value, rel=tolerance)
    assert len((GALLERY / f"{name}.py").read_text(encoding="utf-8").splitlines()) <= 60
