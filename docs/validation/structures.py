"""Evidence about structures: frequencies, limits, decay rates."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from kit import Evidence, about, at_most, canvas, slope
from scipy.linalg import expm
from scipy.optimize import brentq

import dampen


def frequencies() -> Evidence:
    """The beam of the paper against the roots of its characteristic equation, integrated from the clamp."""
    beam = dampen.TimoshenkoBeam()
    a = np.zeros((4, 4))  # of w, phi, shear force, moment
    a[0, 1:3], a[1, 3], a[3, 2] = (1, 1 / beam.shear_stiffness), 1 / beam.bending_stiffness, -1

    def residual(omega: float) -> float:
        a[2, 0], a[3, 1] = -beam.mass_per_length * omega**2, -beam.rotary_inertia * omega**2
        w, phi, q, m = expm(a * beam.length)[:, 2:]
        return float(np.linalg.det([q - beam.tip_mass * omega**2 * w, m - beam.tip_inertia * omega**2 * phi]))

    grid = np.linspace(0.1, 100, 3000)
    values = [residual(omega) for omega in grid]
    ends = [pair for pair, (f, g) in zip(pairwise(grid), pairwise(values), strict=True) if f * g < 0]
    exact = np.array([brentq(residual, *pair, xtol=1e-13, rtol=1e-14) for pair in ends])
    ways = {"spectral": None, "101 grid points": 101, "51 grid points": 51}
    off = {name: np.abs(beam.modes(len(exact), points).omega / exact - 1) for name, points in ways.items()}
    figure, (axes,) = canvas()
    for (name, error), mark in zip(off.items(), "os^", strict=True):
        axes.semilogy(1 + np.arange(len(exact)), np.maximum(error, 1e-16), mark, ms=3, label=name)
    axes.set(xlabel="mode", ylabel="frequency off by, relative", ylim=(1e-17, 10))
    axes.legend()
    ratio = np.log2(off["51 grid points"][:6] / off["101 grid points"][:6])
    return Evidence(
        (
            at_most(f"largest of {len(exact)} modes, spectral", off["spectral"].max(), 1e-11),
            about("order of finite differences, lowest six", np.mean(ratio), 2, 0.1),
        ),
        figure,
    )


def timoshenko_to_euler_bernoulli() -> Evidence:
    """Shear flexibility and rotary inertia made small: the frequencies go to those of the simpler theory, at first order."""
    same = {"bending_stiffness": 2.0, "tip_inertia": 0.01}
    exact = dampen.EulerBernoulliBeam(mass_per_length=1.0, **same).modes(60).omega[:3]
    small = 2.0 ** -np.arange(5)
    ways = {
        "shear flexibility": [{"rotary_inertia": 1e-9, "shear_stiffness": 4e4 / s} for s in small],
        "rotary inertia": [{"rotary_inertia": 1e-4 * s, "shear_stiffness": 1e8} for s in small],
    }
    figure, both = canvas(2, height=2.4)
    numbers = []
    for axes, (name, beams) in zip(both, ways.items(), strict=True):
        error = np.array([1 - dampen.TimoshenkoBeam(**same, **beam).modes(60).omega[:3] / exact for beam in beams])
        for mode, mark in enumerate("os^"):
            axes.loglog(small, error[:, mode], mark, ms=3, label=f"mode {mode + 1}")
        slope(axes, (small[-1], small[0]), error[-1, 2] * 2, 1, "first order")
        axes.set(xlabel=f"{name}, relative", ylabel="lower than Euler-Bernoulli by")
        axes.legend()
        numbers.append(about(f"order in the {name}", np.log2(error[0] / error[-1]).mean() / 4, 1, 0.02))
    return Evidence(tuple(numbers), figure)


def decay_rates() -> Evidence:
    """A string with a damper at its end decays at c/(2 L) ln |(1 + k)/(1 - k)|, every mode alike: rates, and a run."""
    string, kappa = dampen.String(tip_mass=0.0), 0.5
    impedance, speed = np.sqrt(string.tension * string.mass_per_length), np.sqrt(string.tension / string.mass_per_length)
    exact = speed / (2 * string.length) * np.log((1 + kappa) / (1 - kappa))
    scenario = dampen.Scenario(
        plant=dampen.String(tip_mass=0.0, initial=dampen.Deflection(w=(0, 0.01))),
        controller=dampen.BoundaryDamping(damping={"tip_w": kappa * impedance}),
        disturbance=dampen.NoDisturbance(),
        task=dampen.Task(trials=1, trial_duration=0.1),
        numerics=dampen.Numerics(modes=128, step=2e-5),
    )
    rates = np.array([mode.rate for mode in dampen.rates(scenario).modes[:24]])
    run = dampen.simulate(scenario)
    energy = run["energy"][0]
    laps = round(2 * string.length / speed / scenario.numerics.step)  # what comes back after a lap is smaller by one factor
    seen = np.log(energy[laps] / energy[2 * laps]) / (2 * laps * scenario.numerics.step)
    figure, (left, right) = canvas(2, height=2.4)
    left.plot(1 + np.arange(24), rates, "o", ms=3, label="dampen.rates, 128 modes")
    left.axhline(exact, color="k", lw=0.7, ls="--", label="exact")
    left.set(xlabel="mode", ylabel="decay rate [1/s]", ylim=(0, 1.3 * exact))
    left.legend(loc="lower left")
    right.semilogy(run.time, energy, label="a run")
    right.semilogy(run.time, energy[0] * np.exp(-2 * exact * run.time), "k--", lw=0.7, label="exact rate")
    right.set(xlabel="time [s]", ylabel="energy [J]")
    right.legend()
    return Evidence(
        (
            at_most("first eight rates off by", np.abs(rates[:8] / exact - 1).max(), 3e-3),
            at_most("rate of the run off by", abs(seen / exact - 1), 0.02),
        ),
        figure,
    )


ALL = (frequencies, timoshenko_to_euler_bernoulli, decay_rates)
