"""Actuators, disturbances, controllers, barrier and claims, each alone."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import dampen
from dampen.analysis.claims import Claim, verdict_sentence
from dampen.analysis.composite_energy import composite_energy
from dampen.controllers.base import Setting, Trial
from dampen.controllers.inner_loop import AssumedBacklash, FlankInverse
from dampen.port import Site
from dampen.scenarios.he2017.claims import _trend
from dampen.simulation.log_barrier import EDGE, carried, fresh, gradient
from dampen.simulation.setting import setting_of
from dampen.stage import Stage
from tests.conftest import READINGS, scenario

STAGES: list[Stage] = [dampen.Ideal(), dampen.Backlash(), FlankInverse(AssumedBacklash())]
SITE = Site(scenario().plant.ports, 1.0, 2.0)
commands = st.lists(st.floats(-5, 5), min_size=2, max_size=40)


def respond(stage: Stage, inputs: list[float]) -> list[float]:
    """Outputs of a stage, step by step, as plain Python."""
    state, row, out = np.zeros(max(1, stage.states)), np.array(stage.row(1e-3)), []
    for u in inputs:
        new_state = state.copy()
        out.append(type(stage).step(u, state, row, new_state))
        state = new_state
    return out


@pytest.mark.parametrize("stage", STAGES, ids=lambda s: type(s).__name__)
@given(u=commands, more=st.floats(0, 3))
def test_no_stage_decreases_with_its_input(stage: Stage, u: list[float], more: float) -> None:
    assert respond(stage, [*u[:-1], u[-1] + more])[-1] >= respond(stage, u)[-1]


@pytest.mark.parametrize("stage", STAGES, ids=lambda s: type(s).__name__)
@given(u=commands)
def test_trial_commands_leave_the_state_alone(stage: Stage, u: list[float]) -> None:
    state = np.full(max(1, stage.states), 0.1)
    kept = state.copy()
    for command in u:
        type(stage).step(command, state, np.array(stage.row(1e-3)), np.empty_like(state))
    np.testing.assert_array_equal(state, kept)


@given(u=commands)
def test_backlash_is_rate_independent(u: list[float]) -> None:
    """Commands repeated, or passed through on the way, change nothing."""
    slower = [v for a, b in pairwise(u) for v in (a, (a + b) / 2, b, b)]
    assert respond(dampen.Backlash(), slower)[-1] == pytest.approx(respond(dampen.Backlash(), u)[-1], abs=1e-12)


@given(u=commands)
def test_backlash_stays_within_its_gap(u: list[float]) -> None:
    play = dampen.Backlash(slope=0.5, right=0.3, left=-0.1)
    for command, delivered in zip(u, respond(play, u), strict=True):
        assert -0.5 * 0.3 - 1e-12 <= delivered - 0.5 * command <= 0.5 * 0.1 + 1e-12


@given(u=commands)
def test_a_vanishing_gap_of_unit_slope_is_ideal(u: list[float]) -> None:
    play = dampen.Backlash(slope=1.0, right=0.0, left=-1e-12)
    np.testing.assert_allclose(respond(play, u), respond(dampen.Ideal(), u), atol=2e-12)


@given(u=commands)
def test_flank_inverse_then_backlash_is_the_paper_s_designed_reading(u: list[float]) -> None:
    eta = respond(FlankInverse(AssumedBacklash()), u)
    expected, b = [], 0.0
    for xi in u:
        b = min(max(b, xi - 0.3 * 0.3), xi)
        expected.append(b)
    np.testing.assert_allclose(respond(dampen.Backlash(), eta), expected, atol=1e-12)


@given(y=st.floats(-0.9999, 0.9999), y_new=st.floats(-0.9999, 0.9999))
def test_barrier_gradient_is_the_quotient_of_its_potential(y: float, y_new: float) -> None:
    def v(s: float) -> np.longdouble:
        s = np.longdouble(s)
        return np.log1p(-s * s) ** 2 / 4

    exact = float((v(y_new) - v(y)) / (np.longdouble(y_new) - np.longdouble(y))) if abs(y_new - y) > 1e-4 else None
    got = gradient(y, y_new, fresh(y, 1.0), 1.0)
    if exact is not None:
        assert got == pytest.approx(exact, rel=1e-10, abs=1e-13)
    middle = (y + y_new) / 2
    if abs(y - y_new) < 1e-7 and abs(middle) < 0.99:
        assert got == pytest.approx(middle / (1 - middle**2) * fresh(middle, 1.0), rel=1e-6, abs=1e-15)


@given(y=st.floats(-1.5, 1.5), a=st.floats(-1.5, 1.5), b=st.floats(-1.5, 1.5))
def test_barrier_gradient_does_not_decrease_even_beyond_the_limit(y: float, a: float, b: float) -> None:
    log_y = fresh(y, 1.0) if abs(y) <= EDGE else 0.0
    low, high = (gradient(y, s, log_y, 1.0) for s in (min(a, b), max(a, b)))
    assert math.isfinite(low)
    assert high >= low - 1e-9 * abs(low)


@given(path=st.lists(st.floats(-0.999, 0.999), min_size=2, max_size=50))
def test_carried_logarithm_equals_the_fresh_one(path: list[float]) -> None:
    log_y = fresh(path[0], 1.0)
    for y, y_new in pairwise(path):
        log_y = carried(y_new, y, log_y, 1.0)
    assert log_y == pytest.approx(fresh(path[-1], 1.0), rel=1e-12, abs=1e-14)


def test_disturbances_are_equations_26_to_28() -> None:
    t, x, j = np.linspace(0, 2, 7), np.linspace(0, 1, 5), 3
    a = (j + 1) * np.pi * t
    source = dampen.HarmonicFamilies()
    np.testing.assert_allclose(source.at_ports(j, t, SITE)[:, 0], 0.1 * sum(np.cos(k * a) for k in (1, 2, 3)))
    np.testing.assert_allclose(source.at_ports(j, t, SITE)[:, 1], 0.1 * sum(np.cos(k * a) for k in (2, 4, 6)))
    f = 0.05 * sum(np.sin(k * np.outer(a, x)) for k in (1, 2, 3))
    np.testing.assert_allclose(source.load(j, t, x, SITE), f, atol=1e-14)


def test_stated_content_is_the_fastest_and_shortest_there_is() -> None:
    content = dampen.HarmonicFamilies().content(24, SITE)
    assert content.port_frequency == (37.5, 75.0)
    assert content.load_frequency == pytest.approx(37.5)
    assert content.load_wave == pytest.approx(1 / 75)


def test_frozen_frequencies_repeat_one_trial() -> None:
    source, t = dampen.HarmonicFamilies(frozen_at=2), np.linspace(0, 2, 9)
    np.testing.assert_array_equal(source.at_ports(7, t, SITE), dampen.HarmonicFamilies().at_ports(2, t, SITE))
    assert source.same_as(7) == source.same_as(0)


def test_learning_is_equations_15_to_18() -> None:
    law = dampen.DualLoopAILC(alpha_4=2.0, alpha_7=3.0, alpha_8=0.5, alpha_9=0.7)
    setting = setting_of(scenario("task.trial_duration=0.004", "output.every=1"))
    v = np.array([[-1.0, 0.5], [0.0, 0.0], [0.01, -0.01], [1.0, 1.0]])
    memory = {"zeta": np.full((4, 2), 0.05), "d_hat": np.full((4, 2), 0.2)}
    after = law.learn(memory, Trial(0, np.zeros((5, 2)), v, np.zeros((4, 2))), setting)
    xi = 0.05 - np.array([2.0, 3.0]) * v
    dead = np.where(xi <= 0, xi, np.where(xi < 0.09, 0.0, xi - 0.09))
    np.testing.assert_allclose(after["zeta"], dead)
    np.testing.assert_allclose(after["d_hat"], 0.2 + np.array([0.5, 0.7]) * np.abs(v))
    port_law = law.law(memory, setting)
    np.testing.assert_allclose(port_law.coulomb[0], [0.2 + 2 * 0.15 + 0.3, 0.2 + 0.3])
    np.testing.assert_allclose(port_law.damping, [2.5, 3.7])


def test_a_law_that_pushes_the_wrong_way_is_refused() -> None:
    class Backwards(dampen.NoControl):
        def law(self, memory: object, setting: Setting) -> dampen.PortLaw:
            nothing = np.zeros((setting.steps, 2))
            return dampen.PortLaw(nothing, nothing - 1.0, np.zeros(2), np.zeros(2))

    with pytest.raises(dampen.ArgumentError, match="give `coulomb` >= 0"):
        dampen.simulate(scenario("task.trials=1").with_controller(Backwards()))


def test_every_claim_of_the_paper_is_a_row_with_a_verdict(paper_runs: tuple[dampen.Result, dampen.Result]) -> None:
    claims = dampen.check_claims(*paper_runs)
    assert [c.id for c in claims] == [*(f"F{i}" for i in range(5, 17)), "T1", "T2a", "T2b", "T2c", "T2d"]
    assert all(c.measured and c.criterion and c.verdict in ("PASS", "FAIL") for c in claims)
    assert {c.id for c in claims if c.verdict == "PASS"} >= {f"F{i}" for i in range(5, 17)} | {"T1", "T2c"}


@pytest.mark.parametrize("reading", READINGS)
def test_figures_5_to_16_hold_in_both_readings(reading: str, paper_runs: tuple[dampen.Result, dampen.Result]) -> None:
    result = dampen.simulate(scenario(READINGS[reading]))
    claims = dampen.check_claims(result, paper_runs[1])
    assert all(c.holds for c in claims if c.id.startswith("F")), [c for c in claims if not c.holds]


def test_a_claim_can_fail(paper_runs: tuple[dampen.Result, dampen.Result]) -> None:
    """Without control the claims about the controlled run do not hold."""
    verdicts = {c.id: c.verdict for c in dampen.check_claims(paper_runs[1], paper_runs[1])}
    assert {verdicts[i] for i in ("F9", "F10", "F11", "F13", "F14", "T2c", "T2d")} == {"FAIL"}
    assert verdicts["T2a"] == "n/a"


def test_too_few_trials_leave_a_claim_open() -> None:
    short = scenario("task.trials=2")
    claims = dampen.check_claims(dampen.simulate(short), dampen.simulate(short.with_controller(dampen.NoControl())))
    assert {c.id for c in claims if c.verdict == "n/a"} == {"F13", "F14", "F15", "F16", "T1"}


def test_composite_energy_with_its_jump_is_the_integral_itself(run: Callable[..., dampen.Result]) -> None:
    """Against a plain evaluation of (20)-(25) for one trial, and (46) against its own sum."""
    result, j, decay = run(), 3, 0.5
    t, dt = np.asarray(result.layout.coordinates["step"][1]), 1e-3
    weight = np.exp(-decay * t) * dt
    y = result["y"][j][-1]
    e3 = sum(0.1 / 4 * math.log(0.04 / (0.04 - s * s)) ** 2 for s in y)
    xi = result["zeta"][j - 1] - result["v"][j]
    e4 = (weight[:, None] * xi**2).sum() / 2
    e5 = (weight[:, None] * (0.09 - result["d_hat"][j]) ** 2).sum() / (2 * 0.1)
    both = composite_energy(result, (decay,))
    assert both is not None
    expected = math.exp(-decay * 2) * (result["energy"][j][-1] + e3) + e4 + e5
    assert both.total[j, 0] == pytest.approx(expected, rel=1e-12)
    at_zero = composite_energy(result, (0.0,))
    assert at_zero is not None
    no_weight = at_zero.printed - at_zero.total
    np.testing.assert_allclose(no_weight, 0, atol=1e-9)


def test_a_trend_from_nothing_is_growth() -> None:
    assert _trend(np.array([0.0] * 5 + [1, 2, 3, 4, 5])) == (5.0, math.inf)
    assert _trend(np.zeros(10)) == (0.0, 1.0)


def test_at_rest_nothing_divides_by_zero() -> None:
    rest = scenario("disturbance.kind=none", "plant.initial={}", "task.trials=2")
    result, baseline = dampen.simulate(rest), dampen.simulate(rest.with_controller(dampen.NoControl()))
    assert len(dampen.check_claims(result, baseline)) == 17
    assert not np.any(result["energy"])


def test_the_verdict_names_what_fails() -> None:
    rows = [Claim("A", "", "", "", True), Claim("B", "", "", "", False), Claim("C", "", "", "", None)]
    assert verdict_sentence(rows) == "1 of 3 claims hold in this run; B does not; C cannot be judged in it."
