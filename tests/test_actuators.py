"""Actuators and compensations: each alone, in chains, inside the closure, and in the paper's scenario."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from decimal import Decimal
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

import dampen
from dampen import (
    Backlash,
    BacklashInverse,
    BoucWen,
    DeadZone,
    DeadZoneInverse,
    Effectiveness,
    FirstOrderLag,
    Ideal,
    PrandtlIshlinskii,
    PrandtlIshlinskiiInverse,
    RateLimit,
    Saturation,
)
from dampen.analysis.energy import energy_account
from dampen.controllers.inner_loop import AssumedBacklash, FlankInverse
from dampen.scenarios.kinds import KINDS
from dampen.scenarios.read import build, parse
from dampen.simulation import closure
from dampen.simulation.bench import Bench
from dampen.simulation.compiled import _key, bind, compiled
from dampen.simulation.kernel import PORT, STAGE, Step
from dampen.simulation.records import port_records
from dampen.stage import Stage
from dampen.toml import to_toml
from tests.conftest import scenario

DT = 0.01
INSTANTANEOUS: list[Stage] = [
    Ideal(),
    Backlash(),
    Saturation(slope=2.0, low=-0.5, high=1.5),
    Saturation(low=0.2, high=0.4),
    DeadZone(slope=0.7, right=0.4, left=-0.1),
    PrandtlIshlinskii(),
    PrandtlIshlinskii(linear=0.0, weights=(0.5, 0.0, 0.4), radii=(0.05, 0.3, 2.0)),
    PrandtlIshlinskii(linear=1.0, weights=(0.1,) * 15, radii=tuple(0.1 * i for i in range(1, 16))),
    *(BoucWen(exponent=n, beta=b, gamma=c) for n in (1, 2) for b, c in ((1.5, 0.5), (0.5, 1.5), (1.0, 1.0), (1.0, -0.4))),
    BoucWen(hysteresis=-0.6, exponent=2),
]
DYNAMIC: list[Stage] = [
    FirstOrderLag(0.05),
    FirstOrderLag(1e-6),
    FirstOrderLag(1e6),
    RateLimit(20.0),
    RateLimit(1e-3),
    Effectiveness((0.0, 0.1, 0.1, 0.3), (1.0, 0.5, 0.0, 0.7)),
    Effectiveness((0.0,), (0.0,)),
]
INVERSES: list[Stage] = [
    DeadZoneInverse(slope=0.7, right=0.4, left=-0.1),
    BacklashInverse(),
    PrandtlIshlinskiiInverse(),
    PrandtlIshlinskiiInverse(linear=0.5, weights=(0.1,) * 15, radii=tuple(0.1 * i for i in range(1, 16))),
]
STAGES = INSTANTANEOUS + DYNAMIC + INVERSES
SHIPPED: tuple[Any, ...] = KINDS["actuator"] + KINDS["compensation"]


def number(low: float, high: float) -> st.SearchStrategy[float]:
    """A number that a scenario may have: none between 0 and 1e-50 in size."""
    return st.floats(low, high).map(lambda value: value if abs(value) >= 1e-50 else 0.0)


commands = st.lists(st.floats(-5, 5), min_size=2, max_size=30)
each_stage = pytest.mark.parametrize("stage", STAGES, ids=repr)


def walk(stages: Stage | Sequence[Stage], inputs: Sequence[float], dt: float = DT) -> tuple[list[float], list[np.ndarray]]:
    """Outputs of a chain of stages, step by step as plain Python, and the states it ends in."""
    chain = [stages] if isinstance(stages, Stage) else list(stages)
    states = [np.array([*stage.start(), 0.0]) for stage in chain]
    rows, out = [np.array(stage.row(dt)) for stage in chain], []
    for u in inputs:
        value, new_states = u, [state.copy() for state in states]
        for stage, state, row, new_state in zip(chain, states, rows, new_states, strict=True):
            value = type(stage).step(value, state, row, new_state)
        states = new_states
        out.append(value)
    return out, states


def respond(stages: Stage | Sequence[Stage], inputs: Sequence[float], dt: float = DT) -> list[float]:
    return walk(stages, inputs, dt)[0]


# What every stage promises


@each_stage
@given(u=commands, more=st.floats(0, 10))
def test_no_stage_decreases_with_its_command_whatever_its_state(stage: Stage, u: list[float], more: float) -> None:
    low, high = respond(stage, u)[-1], respond(stage, [*u[:-1], u[-1] + more])[-1]
    assert high >= low - 4e-15 * (1 + abs(low) + abs(high))


@each_stage
@given(u=commands)
def test_trial_commands_leave_the_state_alone(stage: Stage, u: list[float]) -> None:
    state = walk(stage, u[:1])[1][0]
    kept = state.copy()
    for command in u:
        type(stage).step(command, state, np.array(stage.row(DT)), np.empty_like(state))
    np.testing.assert_array_equal(state, kept)


@each_stage
def test_slopes_are_positive_and_rows_fit_the_kernel(stage: Stage) -> None:
    for dt in (1e-9, 1e-3, 1.0):
        assert stage.feedthrough(dt) > 0
        assert len(stage.row(dt)) <= 32
    assert stage.gain > 0
    assert stage.states <= 16
    assert stage.monotone


@pytest.mark.parametrize("cls", SHIPPED, ids=lambda cls: cls.kind)
def test_compiled_equals_plain(cls: type[Stage]) -> None:
    fast = compiled(cls.step)
    u = np.cumsum(np.random.default_rng(1).normal(0, 0.5, 200))
    for stage in [s for s in STAGES if type(s) is cls]:
        state, row, out = np.array([*stage.start(), 0.0]), np.array(stage.row(DT)), []
        for command in u:
            new_state = state.copy()
            out.append(fast(command, state, row, new_state))
            state = new_state
        np.testing.assert_allclose(out, respond(stage, list(u)), rtol=1e-13, atol=1e-15)


@pytest.mark.parametrize("stage", INSTANTANEOUS + INVERSES, ids=repr)
@given(u=commands)
def test_only_the_path_counts_not_the_number_of_steps(stage: Stage, u: list[float]) -> None:
    slower = [v for a, b in pairwise([0.0, *u]) for v in (a, a + 0.3 * (b - a), (a + b) / 2, b, b)]
    assert respond(stage, slower)[-1] == pytest.approx(respond(stage, u)[-1], abs=2e-14)


@pytest.mark.parametrize("stage", [s for s in DYNAMIC if isinstance(s, FirstOrderLag | RateLimit)], ids=repr)
@given(u=commands)
def test_a_step_delivers_the_mean_of_its_parts_and_ends_where_they_end(stage: Stage, u: list[float]) -> None:
    """Exactness under a held command: each step is the sum of eight short ones."""
    out, state = walk(stage, u)
    parts, end = walk(stage, np.repeat(u, 8).tolist(), DT / 8)
    np.testing.assert_allclose(np.mean(np.reshape(parts, (-1, 8)), axis=1), out, rtol=0, atol=2e-14)
    np.testing.assert_allclose(end[0], state[0], rtol=0, atol=2e-14)


# Ideal, saturation, dead zone, play


@given(u=commands)
def test_a_chain_of_ideals_is_ideal(u: list[float]) -> None:
    wide, nothing = Saturation(low=-100.0, high=100.0), PrandtlIshlinskii(weights=(), radii=())
    chain = [Ideal(), wide, DeadZone(1.0, 0.0, 0.0), nothing, Effectiveness(), DeadZoneInverse(1.0, 0.0, 0.0)]
    assert respond(chain, u) == u


def test_saturation_and_dead_zone_are_their_polygons() -> None:
    u = [-3.0, -1.0, -0.25, 0.0, 0.25, 0.5, 1.0, 3.0]
    assert respond(Saturation(2.0, -1.0, 0.5), u) == [-1, -1, -0.5, 0, 0.5, 0.5, 0.5, 0.5]
    assert respond(DeadZone(2.0, 0.5, -0.25), u) == [-5.5, -1.5, 0, 0, 0, 0, 1, 5]


@given(u=commands, slope=st.floats(0.1, 3), radius=st.floats(0.01, 3))
def test_one_play_is_a_backlash_to_the_last_bit(u: list[float], slope: float, radius: float) -> None:
    play = PrandtlIshlinskii(linear=0.0, weights=(slope,), radii=(radius,))
    assert respond(play, u) == respond(Backlash(slope, radius, -radius), u)


def test_a_play_loop_runs_along_hand_computed_lines() -> None:
    """Slope w_0 after a turn, w_0 + w_1 once play 1 has crossed its gap 2 r_1, all three beyond 2 r_2."""
    stage = PrandtlIshlinskii(linear=1.0, weights=(2.0, 4.0), radii=(0.5, 1.0))
    u = [0.5, 1.0, 4.0, 3.5, 3.0, 2.0, 1.0, -4.0, -3.0, -2.0, 4.0]
    assert respond(stage, u) == [0.5, 2.0, 23.0, 22.5, 22.0, 19.0, 12.0, -23.0, -22.0, -19.0, 23.0]


# Bouc-Wen


def integrated(stage: BoucWen, path: Sequence[float]) -> list[float]:
    """z along a path of commands, by a general integrator."""
    z, out = 0.0, []
    for a, b in pairwise([0.0, *path]):
        way = math.copysign(1.0, b - a)

        def slope(s: float, z: np.ndarray, way: float = way) -> np.ndarray:
            return way * (stage.a - np.abs(z) ** stage.exponent * (stage.gamma + stage.beta * np.sign(z * way)))

        def zero(s: float, z: np.ndarray, way: float = way) -> float:
            return float(z[0])

        zero.terminal = True  # type: ignore[attr-defined]
        at, left = 0.0, abs(b - a)
        while at < left:  # the right side has a kink at z = 0: stop there, and go on
            crossing = zero if z * way < 0 else None
            found = solve_ivp(slope, (at, left), [z], method="DOP853", rtol=1e-13, atol=1e-15, events=crossing)
            at, z = found.t[-1], found.y[0, -1] if found.status == 0 else 0.0
        out.append(float(z))
    return out


BENDS = [(1.5, 0.5), (0.5, 1.5), (1.0, 1.0), (1.0, -0.4), (0.01, 2.0), (3.0, -2.9)]


@pytest.mark.parametrize("exponent", [1, 2])
@pytest.mark.parametrize(("beta", "gamma"), BENDS)
def test_bouc_wen_is_what_an_integrator_finds(exponent: Any, beta: float, gamma: float) -> None:
    stage = BoucWen(slope=1e-9, hysteresis=1.0, a=1.3, beta=beta, gamma=gamma, exponent=exponent)
    path = [0.3, -0.2, 0.9, 0.7, 0.75, -2.0, 0.1, 0.0, 1.5, 1.4, -0.3]
    z = np.array(respond(stage, path)) - 1e-9 * np.array(path)
    np.testing.assert_allclose(z, integrated(stage, path), rtol=0, atol=1e-10)


@pytest.mark.parametrize("exponent", [1, 2])
@pytest.mark.parametrize(("beta", "gamma"), BENDS)
def test_bouc_wen_tends_to_its_limit_and_comes_back(exponent: Any, beta: float, gamma: float) -> None:
    stage = BoucWen(slope=1.0, hysteresis=1.0, a=1.3, beta=beta, gamma=gamma, exponent=exponent)
    limit = (1.3 / (beta + gamma)) ** (1 / exponent)
    assert stage.limit == pytest.approx(limit, rel=1e-15)
    z = np.array(respond(stage, [1e4, -1e4])) - [1e4, -1e4]
    np.testing.assert_allclose(z, [limit, -limit], rtol=0, atol=4e-12)


@pytest.mark.parametrize("stage", [s for s in INSTANTANEOUS if isinstance(s, BoucWen | PrandtlIshlinskii)], ids=repr)
def test_the_major_loop_is_symmetric(stage: Stage) -> None:
    up = np.linspace(-40, 40, 201)
    out = np.array(respond(stage, [40.0, *-up[1:], *up[1:], *-up[1:]]))
    np.testing.assert_allclose(out[201:401], -out[401:601], rtol=0, atol=1e-13)


@given(u=commands, beta=st.floats(1e-3, 3), gamma=number(-0.99, 3), exponent=st.sampled_from([1, 2]))
def test_bouc_wen_never_leaves_its_bound(u: list[float], beta: float, gamma: float, exponent: Any) -> None:
    stage = BoucWen(beta=beta, gamma=gamma * beta if gamma < 0 else gamma, exponent=exponent)
    _, states = walk(stage, u)
    assert abs(states[0][0]) <= stage.limit * (1 + 1e-14)


def test_bouc_wen_s_steepest_place_is_at_zero_where_gamma_is_the_larger() -> None:
    """z rises by a at zero and by a 2 beta / (beta + gamma) = a / 2 after the turn: -1.2 times the first outweighs the slope."""
    assert not BoucWen(slope=1.0, hysteresis=-1.2, a=1.0, beta=0.5, gamma=1.5).monotone
    assert BoucWen(slope=1.0, hysteresis=-0.9, a=1.0, beta=0.5, gamma=1.5).monotone


@given(beta=st.floats(0.1, 3), gamma=number(-0.9, 3), weight=number(-2, 0), exponent=st.sampled_from([1, 2]))
def test_bouc_wen_is_monotone_exactly_where_it_says_so(beta: float, gamma: float, weight: float, exponent: Any) -> None:
    """The steepest z: at z = 0, or just after the turn at the limit. Both are tried with a small step."""
    stage = BoucWen(hysteresis=weight, beta=beta, gamma=gamma * beta if gamma < 0 else gamma, exponent=exponent)
    margin = 1 + weight * max(1.0, 2 * stage.beta / (stage.beta + stage.gamma))
    tries = ([0.0, 1e-6], [1e4, 1e4 - 1e-6])
    falls = min((b - a) / (v - u) for u, v in tries for a, b in pairwise(respond(stage, [u, v])))
    assert stage.monotone == (margin >= 0)
    assert falls == pytest.approx(margin, abs=1e-4 * (1 + stage.beta + stage.gamma) * (1 + abs(weight)))


def test_a_bouc_wen_that_is_not_monotone_may_only_follow_a_held_command() -> None:
    case = scenario("task.trials=1", "task.trial_duration=0.01", "numerics.modes=10", "output.every=1")
    steep = dataclasses.replace(case, actuators={"tip_w": (BoucWen(hysteresis=-3.0),)})
    with pytest.raises(dampen.ArgumentError, match=r"`actuator.tip_w` has a BoucWen whose output can fall as its command rises"):
        dampen.simulate(steep, compile=False)
    assert dampen.simulate(steep.with_controller(dampen.NoControl()), compile=False).status == "complete"


# Lag, rate limit, effectiveness


@pytest.mark.parametrize("h", [1e-12, 1e-6, 1e-3, 0.1, 0.5, 0.99, 1.0, 1.5, 3.0, 3.9, 10.0, 100.0])
def test_the_lag_s_share_of_a_step_has_no_cancellation(h: float) -> None:
    exact = 1 - (1 - (-Decimal(h)).exp()) / Decimal(h)
    with np.errstate(all="raise"):
        got = FirstOrderLag(1.0).feedthrough(h)
    if h < 1e-9:  # 28 digits are too few there
        exact = Decimal(h) / 2
    assert got == pytest.approx(float(exact), rel=1e-12 if h < 1e-9 else 4e-16)


def test_the_lag_is_the_textbook_exponential() -> None:
    tau = 0.05
    out, states = walk(FirstOrderLag(tau), [2.0] * 10)
    t = np.arange(11) * DT
    b = 2 * (1 - np.exp(-t / tau))
    np.testing.assert_allclose(out, 2 - tau / DT * np.diff(b)[::1], rtol=1e-13)
    assert states[0][0] == pytest.approx(b[-1], rel=1e-14)


def test_the_lag_converges_at_second_order_under_a_smooth_command() -> None:
    tau, end = 0.3, 2.0

    def error(n: int) -> float:
        dt = end / n
        _, states = walk(FirstOrderLag(tau), np.sin((np.arange(n) + 0.5) * dt).tolist(), dt)
        exact = (math.sin(end) - tau * math.cos(end) + tau * math.exp(-end / tau)) / (1 + tau**2)
        return abs(states[0][0] - exact)

    orders = [math.log2(error(n) / error(2 * n)) for n in (20, 40, 80)]
    np.testing.assert_allclose(orders, 2, atol=0.02)


def test_the_rate_limit_is_a_ramp_then_the_command() -> None:
    out, states = walk(RateLimit(rate=10.0), [0.25, 0.25, 0.25, 0.25, -0.02])  # 0.1 N a step of 0.01 s
    np.testing.assert_allclose(out, [0.05, 0.15, 0.25 - 0.5 * 0.05 * 0.5, 0.25, 0.2], rtol=1e-14)
    assert states[0][0] == pytest.approx(0.15, rel=1e-14)


def test_effectiveness_runs_through_its_knots_at_the_steps_middles() -> None:
    stage = Effectiveness(times=(0.02, 0.06, 0.06, 0.08), values=(1.0, 0.5, 0.0, 0.2))
    shares = [1, 1, 0.9375, 0.8125, 0.6875, 0.5625, 0.05, 0.15, 0.2, 0.2]
    np.testing.assert_allclose(respond(stage, [2.0] * 10), 2 * np.array(shares), rtol=1e-12)
    assert (Effectiveness((0.0,), (0.3,)).gain, Effectiveness((0.0,), (0.0,)).gain) == (0.3, 1.0)


def test_effectiveness_is_on_its_slope_while_it_stays_what_it_was() -> None:
    assert Effectiveness((0.0, 1.0), (0.5, 0.5)).deviation == (0.0, 0.0)
    assert Effectiveness((0.0, 1.0), (0.5, 0.4)).deviation == (-math.inf, math.inf)
    assert Effectiveness((0.0, 1.0), (0.0, 0.4)).deviation == (-math.inf, math.inf)


def test_effectiveness_counts_time_through_all_trials() -> None:
    fault = {"tip_w": (Effectiveness((0.0, 0.6, 0.6), (1.0, 1.0, 0.0)),)}
    case = scenario("task.trials=4", "task.trial_duration=0.25", "numerics.modes=10", "numerics.step=0.01", "output.every=1")
    result = dampen.simulate(dataclasses.replace(case, actuators=fault), compile=False)
    force = np.concatenate(np.asarray(result["delivered"]))[:, 0]
    assert np.all(force[60:] == 0)
    assert np.all(force[:60] != 0)


# Compensation


def play_sums(cls: Any) -> st.SearchStrategy[Any]:
    plays = st.lists(st.tuples(number(0, 2), st.floats(0.05, 1)), max_size=15)
    return st.builds(
        lambda linear, plays: {
            "linear": linear,
            "weights": tuple(w for w, _ in plays),
            "radii": tuple(np.cumsum([r for _, r in plays]).tolist()),
        },
        st.floats(0.2, 3),
        plays,
    ).map(lambda values: (PrandtlIshlinskiiInverse(**values), cls(**values)))


gaps = st.fixed_dictionaries({"slope": st.floats(0.2, 3), "right": number(0, 2), "left": st.floats(-2, -0.01)})
pairs = st.one_of(
    gaps.map(lambda values: (DeadZoneInverse(**values), DeadZone(**values))),
    gaps.map(lambda values: (BacklashInverse(**values), Backlash(**values))),
    play_sums(PrandtlIshlinskii),
)


@settings(max_examples=400)
@given(pair=pairs, u=commands)
def test_exact_compensation_then_the_actuator_is_the_identity(pair: tuple[Stage, Stage], u: list[float]) -> None:
    np.testing.assert_allclose(respond(pair, u), u, rtol=0, atol=5e-14)


@given(gap=gaps)
def test_where_nothing_is_commanded_the_inverse_of_a_dead_zone_asks_for_nothing(gap: dict[str, float]) -> None:
    assert respond([DeadZoneInverse(**gap)], [0.0, -0.0, 0.0]) == [0.0, 0.0, 0.0]


@given(u=commands)
def test_with_wrong_estimates_the_error_is_what_the_estimates_miss(u: list[float]) -> None:
    out = respond([DeadZoneInverse(1.0, 0.1, -0.1), DeadZone(1.0, 0.3, -0.2)], u)
    expected = [max(v - 0.2, 0.0) + min(v + 0.1, 0.0) for v in u]
    np.testing.assert_allclose(out, expected, rtol=0, atol=2e-15)


@pytest.mark.parametrize(
    "stage",
    [
        Ideal(), dampen.Absent(), Backlash(0.3, 0.1, -0.2), DeadZone(0.7, 0.4, -0.1), PrandtlIshlinskii(),
        DeadZoneInverse(0.7, 0.4, -0.1), BacklashInverse(0.3, 0.1, -0.2), PrandtlIshlinskiiInverse(),
        FlankInverse(AssumedBacklash(0.3, 0.1, -0.2)),
    ],
    ids=repr,
)  # fmt: skip
def test_how_far_a_stage_says_it_can_be_off_its_slope_is_how_far_it_gets(stage: Stage) -> None:
    """Over a wide loop, up, down and up again, both ends are reached and not passed."""
    u = np.concatenate([np.linspace(0, 5, 50), np.linspace(5, -5, 101), np.linspace(-5, 5, 101)])
    off = np.array(respond(stage, list(u))) - stage.gain * u
    assert (off.min(), off.max()) == pytest.approx(stage.deviation, abs=1e-12)


# Inside the closure

CHAINS: list[tuple[Stage, ...]] = [
    *((stage,) for stage in STAGES),
    (DeadZoneInverse(1.0, 0.5, -0.4), DeadZone(1.0, 0.3, -0.2)),  # jumps: too much compensation
    (BacklashInverse(0.3, 0.3, -0.4), Backlash()),
    (PrandtlIshlinskiiInverse(weights=(0.9, 0.5)), PrandtlIshlinskii()),
    (Backlash(), FirstOrderLag(0.05), Saturation(), BoucWen(), RateLimit(30.0)),
]


@pytest.mark.parametrize("chain", CHAINS, ids=repr)
@settings(max_examples=150, deadline=None)
@example(history=[], law=(2.0, 0.0, 2.0, 0.1), motion=(3.7e-06, 0.1, 0.0), last=0.0)
@example(history=[1.0, -0.11146047505083123], law=(0.0, 1e-09, 0.0, 0.0), motion=(0.0, 0.001, 0.0), last=0.0)
@given(
    history=st.lists(st.floats(-2, 2), max_size=6),
    law=st.tuples(st.floats(-3, 3), st.floats(0, 5), st.sampled_from([0.0, 0.1, 2.0]), st.sampled_from([0.0, 0.1])),
    motion=st.tuples(st.floats(-2, 2), st.sampled_from([1e-3, 0.1, 2.0]), st.floats(-0.19, 0.19)),
    last=st.sampled_from([0.0, -1.0, 1.0]),
)
def test_the_closure_finds_a_force_that_law_and_actuator_agree_on(
    chain: tuple[Stage, ...],
    history: list[float],
    law: tuple[float, ...],
    motion: tuple[float, ...],
    last: float,
) -> None:
    """The command is one the law allows at the velocity found; the force lies within what the chain delivers around it."""
    port, stages = at_port(chain, walk(chain, history)[1])
    port.feedforward, port.damping, port.coulomb, port.barrier = law
    v_free, g, port.y = motion
    port.low, port.high, port.soft, port.v_law = -0.2, 0.2, g, last
    port.memo = -math.log1p(-((port.y / 0.2) ** 2))

    def stage_step(code: int, *rest: Any) -> float:
        return type(chain[code]).step(*rest)

    solve, through = bind(closure.port_force, stage_step=stage_step), bind(closure.through, stage_step=stage_step)
    solve(port, stages, v_free, g, DT)

    force, command, v = float(port.force), float(port.command), float(port.v_law)
    barrier = closure.potential_force(port, v_free + g * force, DT)
    scale = 1e-300 + abs(v_free) / g + sum(law) + abs(law[0]) * 2 + abs(command) + abs(barrier)
    assert v == pytest.approx(v_free + 2 * g * force, abs=1e-12 * (abs(v_free) + g * scale))
    beyond = command - (port.feedforward - port.damping * v - barrier)
    rounding = 1e-15 * (abs(v_free) + 2 * g * abs(force))  # a force within a jump holds the port but for that: no sign is left
    sign = 0.0 if abs(v) <= rounding else math.copysign(1.0, v)
    near = 1e-9 * scale * (1 + barrier_slope(port, v_free + g * force)) + 1e-15 * abs(force)
    if sign:
        assert beyond == pytest.approx(-sign * port.coulomb, abs=near)
    else:
        assert abs(beyond) <= port.coulomb + near
    assert through(port, command - near, stages) - near <= force <= through(port, command + near, stages) + near


def barrier_slope(port: Any, v: float) -> float:
    """How steeply the barrier term rises with the port's force there, seen over a relative step of 1e-6."""
    step = 1e-6 * (abs(v) + 1e-3)
    return abs(closure.potential_force(port, v + step, DT) - closure.potential_force(port, v - step, DT)) / step


def at_port(chain: Sequence[Stage], states: Sequence[np.ndarray]) -> tuple[Any, Any]:
    """Records of one port and its chain, in the given states."""
    port, stages = np.zeros(1, PORT).view(np.recarray)[0], np.zeros(len(chain), STAGE).view(np.recarray)
    port.first, port.last, port.gain, port.feedthrough = 0, len(chain), 1.0, 1.0
    for s, stage in enumerate(chain):
        row = stage.row(DT)
        stages[s].code, stages[s].states = s, stage.states
        stages[s].parameters[: len(row)] = row
        stages[s].state[: stage.states] = states[s][: stage.states]
        port.feedthrough *= stage.feedthrough(DT)
    return port, stages


# In the paper's scenario

BOTH = tuple[tuple[Stage, ...], tuple[Stage, ...]]
RUNS: dict[str, BOTH] = {
    "saturation": ((), (Saturation(1.0, -0.3, 0.2),)),
    "dead-zone": ((), (DeadZone(1.0, 0.3, -0.2),)),
    "dead-zone, compensated": ((DeadZoneInverse(1.0, 0.3, -0.2),), (DeadZone(1.0, 0.3, -0.2),)),
    "dead-zone, compensated too much": ((DeadZoneInverse(1.0, 0.5, -0.4),), (DeadZone(1.0, 0.3, -0.2),)),
    "backlash, compensated": ((BacklashInverse(),), (Backlash(),)),
    "backlash, compensated too much": ((BacklashInverse(0.3, 0.2, -0.3),), (Backlash(),)),
    "plays": ((), (PrandtlIshlinskii(),)),
    "plays alone": ((), (PrandtlIshlinskii(0.0, (0.5, 0.4), (0.05, 0.3)),)),
    "plays, compensated": ((PrandtlIshlinskiiInverse(),), (PrandtlIshlinskii(),)),
    "plays, compensated wrongly": ((PrandtlIshlinskiiInverse(0.8, (0.3, 0.2), (0.15, 0.2)),), (PrandtlIshlinskii(),)),
    "bouc-wen 1": ((), (BoucWen(),)),
    "bouc-wen 2": ((), (BoucWen(exponent=2),)),
    "bouc-wen, negative": ((), (BoucWen(hysteresis=-0.6),)),
    "lag": ((), (FirstOrderLag(0.01),)),
    "fast lag": ((), (FirstOrderLag(1e-6),)),
    "rate-limit": ((), (RateLimit(100.0),)),
    "effectiveness": ((), (Effectiveness((0.0, 0.5, 1.0, 1.5, 1.5), (1.0, 0.5, 0.5, 0.0, 1.0)),)),
    "all in a row": ((), (Saturation(), FirstOrderLag(0.002), RateLimit(50.0), BoucWen(), DeadZone(1.0, 0.01, -0.02))),
}
LOST: dict[str, BOTH] = {
    "saturation": ((), (Saturation(1.0, -0.02, 0.02),)),
    "rate-limit": ((), (RateLimit(1e-3),)),
    "slow lag": ((), (FirstOrderLag(10.0),)),
    "no effect": ((), (Effectiveness((0.0,), (0.0,)),)),
}


@pytest.fixture(scope="session")
def bench() -> Bench:
    """A bench whose kernel knows every shipped stage, so that all runs on it share one."""
    case = scenario("task.trials=3", "numerics.modes=40")
    bench = Bench(case)
    bench.kernel(dataclasses.replace(case, actuators={"tip_w": tuple(cls() for cls in SHIPPED)}))
    return bench


def run_with(bench: Bench, stages: BOTH, compensate: bool, **options: Any) -> dampen.Result:
    case, ports = bench.scenario, ("tip_w", "tip_phi")
    chains = {"compensation": dict.fromkeys(ports, stages[0]), "actuators": dict.fromkeys(ports, stages[1])}
    law = dataclasses.replace(case.controller, compensate=compensate)
    return dampen.simulate(dataclasses.replace(case, controller=law, **chains), bench=bench, **options)


def test_every_actuator_runs_settles_and_closes_its_energy_account(bench: Bench) -> None:
    for name, stages in RUNS.items():
        for compensate in (False, True):
            result = run_with(bench, stages, compensate)
            assert (result.status, result.warnings) == ("complete", []), name
            assert energy_account(result).error < 1e-12, name
            assert np.abs(result["y"]).max() < 0.2, name


def test_exactly_compensated_runs_are_the_run_with_an_ideal_actuator(bench: Bench) -> None:
    ideal = run_with(bench, ((), ()), False)
    for name in ("dead-zone, compensated", "backlash, compensated", "plays, compensated"):
        np.testing.assert_allclose(run_with(bench, RUNS[name], False)["y"], ideal["y"], rtol=0, atol=1e-10, err_msg=name)


def test_an_actuator_that_loses_the_constraint_goes_on_to_the_end_and_says_where(bench: Bench) -> None:
    for name, stages in LOST.items():
        result = run_with(bench, stages, False)
        assert (result.status, result.trials) == ("constraint_lost", 3), name
        assert any("The constraint of tip_w was lost, first at t = 0.6" in line for line in result.warnings), name
        assert not any("did not settle" in line for line in result.warnings), name
        assert energy_account(result).error < 1e-12, name


def test_far_too_slow_a_lag_pumps_but_never_to_nothing_finite(bench: Bench) -> None:
    """Beyond the barrier's edge forces of 1e13 N meet a feedthrough of 5e-5: chaotic, so many neighbours are tried."""
    for k in range(12):
        result = run_with(bench, ((), (FirstOrderLag(10.0 * (1 + 1e-4 * k)),)), False)
        assert not result.broke_off, k
        assert not any("did not settle" in line for line in result.warnings), k


def test_a_compiled_run_equals_the_plain_one_through_every_kind_of_stage() -> None:
    case = scenario("task.trials=2", "task.trial_duration=0.05", "numerics.modes=10", "output.every=1")
    chain = (
        PrandtlIshlinskii(),
        BoucWen(),
        FirstOrderLag(),
        RateLimit(),
        Effectiveness((0, 1), (1, 0.5)),
        Saturation(),
        DeadZone(),
    )
    case = dataclasses.replace(
        case,
        compensation={"tip_w": (PrandtlIshlinskiiInverse(), DeadZoneInverse(), BacklashInverse())},
        actuators={"tip_w": chain, "tip_phi": (Backlash(), Ideal())},
    )
    fast, plain = dampen.simulate(case), dampen.simulate(case, compile=False)
    for name in ("y", "command", "delivered", "energy"):
        np.testing.assert_allclose(fast[name], plain[name], rtol=0, atol=1e-10, err_msg=name)
    assert fast.warnings == plain.warnings == []


# In scenario files


def test_chains_of_every_kind_written_out_read_back_the_same() -> None:
    case = dataclasses.replace(
        scenario(),
        actuators={"tip_w": tuple(cls() for cls in KINDS["actuator"]), "tip_phi": (BoucWen(exponent=2), RateLimit(3.0))},
        compensation={"tip_w": tuple(cls() for cls in KINDS["compensation"])},
    )
    assert build(parse(to_toml(case), "written")) == case


def test_compensation_stands_between_the_controllers_own_and_the_actuator() -> None:
    case = scenario("compensation.all.chain=[{kind='dead-zone-inverse'}]", "compensation.tip_phi.chain=[]")
    assert [type(stage).__name__ for stage in case.chain(0)] == ["FlankInverse", "DeadZoneInverse", "Backlash"]
    assert [type(stage).__name__ for stage in case.chain(1)] == ["FlankInverse", "Backlash"]


def bad(table: str, stage: str) -> str:
    return f"{table}.all.chain=[{stage}]"


BAD = {
    bad("actuator", "{kind='saturation', low=1.0}"): "`actuator.all.chain[0].low` must be < `high`, but is 1 where `high` is 1.",
    bad("actuator", "{kind='saturation', slope=0}"): "`actuator.all.chain[0].slope` must be > 0, but is 0.",
    bad("actuator", "{kind='dead-zone', right=-1}"): "`actuator.all.chain[0].right` must be >= 0 N, but is -1.",
    bad("actuator", "{kind='prandtl-ishlinskii', weights=[1]}"): "`actuator.all.chain[0].radii` must have as many members as",
    bad(
        "actuator", "{kind='prandtl-ishlinskii', radii=[2, 1]}"
    ): "`actuator.all.chain[0].radii` must increase, but is [2.0, 1.0].",
    bad("actuator", "{kind='prandtl-ishlinskii', weights=[-1, 1]}"): "`actuator.all.chain[0].weights[0]` must be >= 0, but is -1",
    bad(
        "actuator", "{kind='prandtl-ishlinskii', linear=0, weights=[0, 0]}"
    ): "`actuator.all.chain[0].linear` must be > 0 where no",
    bad("actuator", "{kind='bouc-wen', exponent=3}"): "`actuator.all.chain[0].exponent` must be 1 or 2, but is 3.",
    bad(
        "actuator", "{kind='bouc-wen', gamma=-2}"
    ): "`actuator.all.chain[0].gamma` must be > -beta = -1.5, or z has no bound, but is",
    bad("actuator", "{kind='bouc-wen', beta=1e-9}"): "`actuator.all.chain[0].beta` must be >= 1e-06 gamma = 5e-07, but is 1e-09.",
    bad("actuator", "{kind='lag', time_constant=0}"): "`actuator.all.chain[0].time_constant` must be > 0 s, but is 0.",
    bad("actuator", "{kind='rate-limit', rate=-1}"): "`actuator.all.chain[0].rate` must be > 0 N/s, but is -1.",
    bad(
        "actuator", "{kind='effectiveness', times=[0, 1]}"
    ): "`actuator.all.chain[0].values` must have as many members as `times`",
    bad(
        "actuator", "{kind='effectiveness', times=[1, 0], values=[1, 1]}"
    ): "`actuator.all.chain[0].times` must be in order, but is",
    bad("actuator", "{kind='effectiveness', values=[-0.1]}"): "`actuator.all.chain[0].values[0]` must be >= 0, but is -0.1.",
    bad(
        "actuator", "{kind='effectiveness', times=[], values=[]}"
    ): "`actuator.all.chain[0].times` must have 1 to 15 members, but",
    bad(
        "actuator", "{kind='backlash-inverse'}"
    ): "`actuator.all.chain[0].kind` must be a known kind of actuator, but is 'backlash-inv",
    bad(
        "compensation", "{kind='backlash'}"
    ): "`compensation.all.chain[0].kind` must be a known kind of compensation, but is 'backlash'",
    bad(
        "compensation", "{kind='prandtl-ishlinskii-inverse', linear=0}"
    ): "`compensation.all.chain[0].linear` must be > 0, but is 0",
    bad(
        "compensation", "{kind='backlash-inverse', left=0, right=0}"
    ): "`compensation.all.chain[0].left` must be < `right`, but is 0",
    "compensation.tip.chain=[]": "Argument `compensation.tip` is not a port of this plant; known here: tip_w, tip_phi.",
}


@pytest.mark.parametrize("override", BAD)
def test_a_bad_stage_is_told_in_one_line(override: str) -> None:
    with pytest.raises(dampen.ArgumentError) as caught:
        scenario(override)
    assert BAD[override] in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


def test_radii_that_are_equal_do_not_increase() -> None:
    for cls in (PrandtlIshlinskii, PrandtlIshlinskiiInverse):
        with pytest.raises(dampen.ArgumentError, match="`radii` must increase"):
            cls(weights=(0.1, 0.1), radii=(0.2, 0.2))


@pytest.mark.parametrize(("numbers", "states", "fits"), [(32, 16, True), (33, 16, False), (32, 17, False)])
def test_a_stage_begins_in_its_own_state_and_is_refused_where_there_is_no_room(numbers: int, states: int, fits: bool) -> None:
    class Wide(Ideal):
        def row(self, dt: float) -> tuple[float, ...]:
            return tuple(range(numbers))

        def start(self) -> tuple[float, ...]:
            return tuple(0.5 + k for k in range(states))

    Wide.states = states
    step = Step(DT, 1 / DT, np.zeros((1, 1)), np.eye(1), np.eye(1))
    if not fits:
        with pytest.raises(ValueError, match="Wide must have at most 32 parameters and 16 states, but has"):
            port_records([(Wide(),)], step, [Wide])
        return
    _, stages = port_records([(Ideal(), Wide())], step, [Wide, Ideal])
    np.testing.assert_array_equal(stages[1].state, 0.5 + np.arange(16))
    np.testing.assert_array_equal(stages[1].parameters, np.arange(32))
    assert list(stages.code) == [1, 0]


def test_sixteen_plays_are_one_too_many() -> None:
    with pytest.raises(dampen.ArgumentError, match="`weights` must have at most 15 members, but has 16"):
        PrandtlIshlinskii(weights=(1.0,) * 16, radii=tuple(range(1, 17)))


def test_the_cache_tells_functions_apart_that_differ_only_in_the_names_they_use() -> None:
    def made(text: str) -> Any:
        space: dict[str, Any] = {"math": math}
        exec(text, space)
        return space["f"]

    assert _key(made("def f(x): return math.sin(x)")) != _key(made("def f(x): return math.cos(x)"))
