"""All ports of a step together: what one does to another counts at once, and what is not found is said."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import dampen
from dampen.simulation import barrier, closure, kernel, ports
from dampen.simulation.bench import Bench
from dampen.simulation.compiled import bind
from dampen.simulation.kernel import Step
from dampen.simulation.passes import passes
from dampen.simulation.ports import close_ports
from dampen.simulation.records import port_records
from dampen.stage import Stage

DT = 0.01


def at_rest(g: np.ndarray, chain: tuple[Stage, ...] = ()) -> tuple[Any, Any]:
    """Records of two ports of a structure with this response, both at rest with nothing that acts, behind equal chains."""
    step = Step(DT, 1 / DT, np.zeros((2, 1)), g, g.copy())
    found, stages = port_records([chain] * 2, step, [type(stage) for stage in chain])
    found.low, found.high = -math.inf, math.inf
    return found, stages


def closed(found: Any, stages: Any, g: np.ndarray, chain: tuple[Stage, ...] = (), **names: Any) -> bool:
    def stage_step(code: int, *rest: Any) -> float:
        return type(chain[code]).step(*rest)

    return bool(bind(ports.close_ports, PORTS=2, stage_step=stage_step, **names)(found, stages, g, g.copy(), DT))


@pytest.mark.parametrize("held_by", ["barrier", "stiffness"])
@pytest.mark.parametrize("room", [0.25, 1e-9])
@pytest.mark.parametrize("share", [0.5, -0.5])
def test_a_port_that_another_moves_sticks_only_where_its_law_still_allows_it(held_by: str, room: float, share: float) -> None:
    """Moved by a thousandth of the way to its limit, it is pulled harder by all that Sgn can hold; half of that it held before,
    against the pull or along with it."""
    g, limit = np.array([[10.0, 4.0], [4.0, 10.0]]), 0.2
    found, stages = at_rest(g)
    first, second = found
    first.y = limit * (1 - room)
    moved = 1e-3 * limit * room
    if held_by == "barrier":
        first.low, first.high, first.barrier = -limit, limit, 1.0
        first.memo = barrier.fresh_memo(first.y, -limit, limit)
    else:
        first.stiffness = 1.0
    second.feedforward = 2 * moved / DT / g[0, 1]  # half of the velocity is taken by the compliance at the port that sticks

    def pull(v: float) -> float:
        return float(closure.potential_force(first, v, DT))

    scale, first.coulomb = 1 / (pull(moved / DT) - pull(0.0)), 1.0
    first.barrier, first.stiffness = first.barrier * scale, first.stiffness * scale
    first.feedforward = pull(0.0) + share
    assert closed(found, stages, g)
    v, rounding = float(g[0] @ found.force), 2e-16 * limit / moved  # of the displacement
    assert first.force == pytest.approx(first.command, rel=1e-12)
    assert first.v_law == pytest.approx(v + g[0, 0] * first.force, abs=1e-15)
    assert (first.v_law == 0.0) == (share > 0)
    assert abs(first.command - (first.feedforward - pull(v))) <= 1.0 + 2 * rounding


def test_where_nothing_settles_the_stages_are_led_to_where_the_commands_that_were_found_lead() -> None:
    """One round alone is seldom enough for two ports that all but move as one: what was tried last is then another command."""
    random, g, play = np.random.default_rng(1), np.array([[1.0, 0.9], [0.9, 1.0]]), (dampen.Backlash(0.5, 0.2, -0.1),)
    unsettled = 0
    for _ in range(300):
        found, stages = at_rest(g, play)
        found.v_free, found.feedforward = random.normal(size=(2, 2))
        found.damping, found.coulomb = random.uniform(0, 3, 2), random.uniform(0, 1, 2)
        stages.state[:, 0] = random.normal(size=2)
        if closed(found, stages, g, play, ROUNDS=1):
            continue
        unsettled += 1
        for port, stage in zip(found, stages, strict=True):
            led = np.zeros(1)
            dampen.Backlash.step(port.command, stage.state, stage.parameters, led)
            assert stage.new_state[0] == led[0]
    assert unsettled > 30


def test_a_barrier_so_stiff_that_rounding_decides_costs_no_rounds() -> None:
    """It answers as what it is, a port that is held; taken for soft, it would make plain sweeps of twenty rounds."""
    random, g, limit = np.random.default_rng(0), np.array([[1.0, 0.9], [0.9, 1.0]]), 0.2
    rounded = 0
    for _ in range(60):
        found, stages = at_rest(g)
        found.damping = random.uniform(0, 1, 2)
        found.v_free, found.feedforward = 3 * random.normal(size=2), 10 * random.normal(size=2)
        near = found[0]
        near.low, near.high, near.y, near.barrier = -limit, limit, limit * (1 - 10 ** random.uniform(-13, -6)), 1.0
        near.memo = barrier.fresh_memo(near.y, -limit, limit)
        assert closed(found, stages, g, ROUNDS=6)
        rounded += near.per_slope == -closure.LEAST
    assert rounded > 20


CALLS: list[int] = []


def settles_but_every_third_time(records, stages, g, coupling, dt):  # type: ignore[no-untyped-def]
    CALLS.append(0)
    return close_ports(records, stages, g, coupling, dt) and len(CALLS) % 3 > 0


def test_steps_that_did_not_settle_are_counted_trial_by_trial(monkeypatch: pytest.MonkeyPatch) -> None:
    case = dampen.read_scenario("he2017", ["task.trials=3", "task.trial_duration=0.01", "numerics.modes=4", "output.every=10"])
    assert case.steps == 10
    CALLS.clear()
    monkeypatch.setattr(kernel, "close_ports", settles_but_every_third_time)
    assert [int(p.record.unsettled[0]) for p in passes(case, Bench(case), compile=False)] == [3, 3, 4]
    warnings = dampen.simulate(case, compile=False).warnings
    assert [line for line in warnings if "did not settle in 3 steps of trial 0" in line] == warnings[-1:]


@pytest.mark.parametrize("last", [5, 10])
def test_a_motion_that_breaks_off_in_its_very_last_step_has_diverged_too(last: int) -> None:
    """From a run under a force of 1e10 N, whose energies are those of any other force but for its square."""
    case = dampen.read_scenario(
        "he2017", ["task.trials=2", "task.trial_duration=0.01", "numerics.modes=4", "output.every=10", "controller.kind=none"]
    )

    def under(force: float) -> dampen.Result:
        return dampen.simulate(replace(case, disturbance=dampen.ConstantLoad(force={"tip_w": force})), compile=False)

    energy = under(1e10)["energy"][0] / 1e20
    result = under(float(np.sqrt(kernel.ABSURD / np.sqrt(energy[last - 1] * energy[last]))))
    assert (result.status, result.trials, len(result["y"])) == ("diverged", 0, 0)
