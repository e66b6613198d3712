"""Evidence about motion: the energy account, the order in the step, sticking, play."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
from kit import Evidence, Number, about, at_most, canvas, slope, ticks

import dampen
from dampen.analysis.energy import energy_account


@cache
def paper_run() -> dampen.Result:
    """The shipped experiment, once."""
    return dampen.simulate(dampen.read_scenario("he2017"))


def energy() -> Evidence:
    """What went in, what came out: over all 25 trials of the paper's experiment, and at every step."""
    run, account = paper_run(), energy_account(paper_run())
    works = {
        "control": np.sum(run["work_control"], axis=2),
        "disturbance": np.sum(run["work_disturbance"], axis=2),
        "load": run["work_load"],
    }
    change = np.diff(run["energy"], axis=1)
    left = change - sum(works.values())
    figure, (above, below) = canvas(1, width=7.16, height=1.8, rows=2)
    time = np.arange(change.size) * run.scenario.numerics.step
    for name, work in works.items():
        above.plot(time, np.cumsum(work.ravel()), lw=0.7, label=f"work of {name}")
    above.plot(time, run["energy"][:, 1:].ravel(), "k", lw=0.5, label="energy of the beam")
    above.set(ylabel="[J]", xlim=(0, 50))
    above.legend(ncols=2)
    below.plot(time, np.cumsum(left.ravel()) / account.largest, lw=0.6)
    below.set(xlabel="time [s]", ylabel="account off by,\nshare of the largest energy", xlim=(0, 50))
    return Evidence(
        (
            at_most("account of the run off by, share of the largest energy", account.error, 1e-11),
            at_most("largest at one step [J]", np.abs(left).max(), 1e-14),
        ),
        figure,
    )


def order_in_the_step() -> Evidence:
    """Motion without control, and under damping and barrier, at the step and at its halves: second order."""
    free = dampen.read_scenario("he2017", ["controller.kind=none", "numerics.modes=24", "task.trials=1"])
    ports = ("tip_w", "tip_phi")
    law = dampen.BoundaryDamping(
        damping=dict(zip(ports, (1.0, 2.0), strict=True)), barrier="log", barrier_gain=dict.fromkeys(ports, 0.1)
    )
    smooth = dampen.Harmonics(frequencies=(1.0,), force={"tip_w": (0.3,), "tip_phi": (0.2,)}, phases=(-np.pi / 2,))
    start = dampen.BeamState(w=(0, 0.02), phi=(0, 0.02))

    def held(step: float) -> dampen.Scenario:
        return dampen.Scenario(
            plant=dampen.TimoshenkoBeam(damping=dampen.Damping(ratio=0.02, viscous=0.3), initial=start),
            controller=law, disturbance=smooth,
            task=dampen.Task(trials=1, trial_duration=0.8, constraint=dict.fromkeys(ports, 0.2)),
            numerics=dampen.Numerics(modes=8, step=step),
        )  # fmt: skip

    def unheld(step: float) -> dampen.Scenario:
        return dampen.Scenario(
            plant=free.plant,
            controller=free.controller,
            disturbance=free.disturbance,
            task=dampen.Task(trials=1),
            numerics=dampen.Numerics(modes=24, step=step),
        )

    figure, (axes,) = canvas()
    numbers = []
    for make, coarsest, name, mark in ((unheld, 0.008, "no control", "o"), (held, 0.001, "damping and barrier", "s")):
        steps = coarsest / np.array([1, 2, 4])
        motions = {step: dampen.simulate(make(step))["y"][0, :: round(coarsest / step)] for step in (*steps, coarsest / 64)}
        exact = motions[coarsest / 64]
        errors = np.array([np.abs(motions[step] - exact).max() for step in steps])
        axes.loglog(steps, errors, mark, ms=4, label=name)
        slope(axes, (steps[-1], steps[0]), errors[-1], 2, "second order")
        numbers.append(about(f"order, {name}", np.log2(errors[0] / errors[-1]) / 2, 2, 0.1))
    ticks(axes, [0.00025, 0.001, 0.004])
    axes.set(xlabel="step [s]", ylabel="motion of a port off by [m, rad]")
    axes.legend(loc="lower right")
    return Evidence(tuple(numbers), figure)


def sticking() -> Evidence:
    """A tip that Sgn holds stands still, exactly, under a force that does not zig-zag."""
    run = paper_run()
    stuck, force = np.concatenate(run["v"][:, :, 0] == 0), np.concatenate(run["delivered"][:, :, 0])
    within = stuck[2:] & stuck[1:-1] & stuck[:-2]  # the first two steps of a stick may still turn
    turn = np.diff(force)
    share = ((turn[1:] * turn[:-1] < 0) & within).sum() / within.sum()
    figure, (above, below) = canvas(1, width=7.16, height=1.5, rows=2)
    part = slice(4000, 4800)
    time = np.arange(stuck.size)[part] * run.scenario.numerics.step
    above.plot(time, 1000 * np.concatenate(run["v"][:, :, 0])[part], lw=0.8)
    above.fill_between(
        time, 0, 1, stuck[part], transform=above.get_xaxis_transform(), alpha=0.15, color="k", lw=0, label="sticks"
    )
    above.set_ylabel("velocity [mm/s]")
    above.legend(loc="upper right")
    below.plot(time, force[part], lw=0.8)
    below.set(xlabel="time [s]", ylabel="delivered force [N]")
    return Evidence(
        (
            Number("share of steps in which the tip sticks", float(stuck.mean()), 0.01, 1.0),
            at_most("of these, share in which the force turns round", share, 0.2),
        ),
        figure,
    )


def play() -> Evidence:
    """A backlash knows the path, not the time: the same path in one step a piece, or in a hundred."""
    stage = dampen.Backlash()
    corners = np.array([0, 1.2, -0.9, 0.6, -0.3, 1.0, 0.9, 1.0])

    def driven(each: int) -> tuple[np.ndarray, np.ndarray]:
        path = np.concatenate([[0.0], *(np.linspace(a, b, each + 1)[1:] for a, b in pairwise(corners))])
        state, out = np.array(stage.start()), []
        for command in path:
            new = state.copy()
            out.append(stage.step(command, state, np.array(stage.row(0.001)), new))
            state = new
        return path, np.array(out)

    coarse, fine = driven(1), driven(100)
    by_hand, delivered = [], 0.0
    for command in corners:
        delivered = min(max(delivered, stage.slope * (command - stage.right)), stage.slope * (command - stage.left))
        by_hand.append(delivered)
    figure, (axes,) = canvas()
    axes.plot(*fine, lw=0.8, label="a hundred steps a piece")
    axes.plot(*coarse, "o", ms=4, label="one step a piece")
    axes.plot(corners, by_hand, "kx", ms=5, label="equations (1) to (5), by hand")
    axes.set(xlabel="command [N]", ylabel="delivered [N]")
    axes.legend()
    return Evidence(
        (
            at_most("at the corners, one step or a hundred: apart by [N]", np.abs(fine[1][::100] - coarse[1]).max(), 1e-15),
            at_most("from the equations by hand [N]", np.abs(coarse[1] - by_hand).max(), 1e-15),
        ),
        figure,
    )


def other_units() -> Evidence:
    """The paper's experiment in other units of length, mass and time: the same run, but for the factor of each unit."""
    from tests.other_units import Units, difference, in_units

    short = ["task.trials=2", "task.trial_duration=0.5"]
    powers = np.array([-20, -13, -7, -2, 2, 7, 13, 20])
    figure, (axes,) = canvas()
    numbers = []
    for law, changes, mark, most in (
        ("without control", ["controller={kind='none'}"], "s", 1e-12),
        ("with the law", [], "o", 1e-6),
    ):
        scenario = dampen.read_scenario("he2017", [*short, *changes])
        run = dampen.simulate(scenario)
        off = []
        for power in map(float, powers):
            units = Units(2.0**power, 2.0 ** round(2.5 * power), 2.0 ** round(0.6 * power))
            off.append(difference(run, dampen.simulate(in_units(scenario, units)), units))
        axes.loglog(2.0**powers, np.maximum(off, 1e-17), mark, ms=4, label=law)
        numbers.append(at_most(f"{law}, largest relative difference", max(off), most))
    axes.set(xlabel="the beam's length, in the unit of the file", ylabel="apart by, of the largest", ylim=(5e-18, 1e-8))
    axes.legend()
    return Evidence(tuple(numbers), figure)


ALL = (energy, order_in_the_step, other_units, sticking, play)
