"""The README's moving picture: the paper's beam in four of its trials, under the law and without it.

    python docs/moving_beam.py            # writes docs/images/beam.gif

Drawn to scale: deflections as they are, cross-sections turned by phi, not by w'.
"""

from __future__ import annotations

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.patches import Polygon, Rectangle

import dampen
from dampen.report.style import CONSTRAINT, DISPLACEMENT, FAINT, INK, UNCONTROLLED

TRIALS = (0, 1, 2, 24)
EVERY, HEIGHT, WALL = 40, 0.05, 0.2  # steps from frame to frame; m
OUT = Path(__file__).parent / "images" / "beam.gif"


def outline(x: np.ndarray, w: np.ndarray, phi: np.ndarray) -> np.ndarray:
    """(2 points, 2) of the beam's edges: each cross-section stands across the beam, turned by phi."""
    across = HEIGHT / 2 * np.column_stack([-np.sin(phi), np.cos(phi)])
    middle = np.column_stack([x, w])
    return np.vstack([middle + across, (middle - across)[::-1]])


def payload(tip: float, angle: float) -> np.ndarray:
    """(4, 2) corners of the block at the tip."""
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    corners = np.array([[0, -1], [1.3, -1], [1.3, 1], [0, 1]]) * 0.055
    return corners @ turn.T + [1.0, tip]


def main() -> None:
    """Run, draw, write."""
    scenario = dampen.read_scenario("he2017", [f"output.every={EVERY}", "output.points=31"])
    held, free = dampen.simulate(scenario), dampen.simulate(scenario.with_controller(dampen.NoControl()))
    x = np.linspace(0, 1, 31)
    frames = [(j, k) for j in TRIALS for k in range(held["w"].shape[1])]
    fig, (stage, curve) = plt.subplots(1, 2, figsize=(8.2, 2.6), width_ratios=(2.8, 1), layout="constrained", dpi=100)
    stage.set(xlim=(-0.08, 1.16), ylim=(-0.31, 0.31), aspect="equal")
    stage.axis("off")
    stage.add_patch(Rectangle((-0.06, -0.16), 0.06, 0.32, facecolor="none", edgecolor=INK, hatch="////", linewidth=0))
    stage.plot([0, 0], [-0.16, 0.16], color=INK, lw=1.2)
    for side in (1, -1):
        stage.add_patch(
            Rectangle(
                (0.88, side * WALL - (0 if side > 0 else 0.05)),
                0.26,
                0.05,
                facecolor="none",
                edgecolor=CONSTRAINT,
                hatch="//////",
                lw=0,
            )
        )
        stage.plot([0.88, 1.14], [side * WALL] * 2, color=CONSTRAINT, lw=1.4)
    parts = {}
    for name, colour, fill in (("free", UNCONTROLLED, "none"), ("held", DISPLACEMENT, "#cfe3f0")):
        style = {
            "facecolor": fill,
            "edgecolor": colour,
            "lw": 1.3 if name == "held" else 1.0,
            "ls": "-" if name == "held" else "--",
        }
        parts[name] = [stage.add_patch(Polygon(np.zeros((3, 2)), **style)) for _ in range(2)]
    label = stage.text(0.0, 0.29, "", fontsize=11, va="top")
    stage.text(0.0, -0.30, "blue: dual-loop adaptive learning     grey: no control", fontsize=8, color=FAINT)
    peaks = {name: np.abs(result["y"][:, :, 0]).max(axis=1) for name, result in (("held", held), ("free", free))}
    curve.semilogy(peaks["free"], color=UNCONTROLLED, lw=1, ls="--")
    curve.semilogy(peaks["held"], color=DISPLACEMENT, lw=1, alpha=0.25)
    (done,) = curve.semilogy([], [], color=DISPLACEMENT, lw=1.6)
    (now,) = curve.semilogy([], [], "o", color=DISPLACEMENT, ms=5)
    curve.axhline(WALL, color=CONSTRAINT, lw=1, ls="--")
    curve.set_xlabel("trial", fontsize=8)
    curve.set_title("largest |w(L, t)| of the trial [m]", fontsize=8, loc="left")
    curve.tick_params(labelsize=8)
    curve.spines[["top", "right"]].set_visible(False)

    def draw(frame: tuple[int, int]) -> None:
        j, k = frame
        for name, result in (("free", free), ("held", held)):
            w, phi = result["w"][j, k], result["phi"][j, k]
            parts[name][0].set_xy(outline(x, w, phi))
            parts[name][1].set_xy(payload(w[-1], phi[-1]))
        label.set_text(f"trial {j}    t = {k * EVERY * scenario.numerics.step:.2f} s")
        done.set_data(np.arange(j + 1), peaks["held"][: j + 1])
        now.set_data([j], [peaks["held"][j]])

    FuncAnimation(fig, draw, frames).save(OUT, PillowWriter(fps=25))
    print(f"{OUT.name}: {OUT.stat().st_size / 1e6:.2f} MB, {len(frames)} frames")


if __name__ == "__main__":
    main()
