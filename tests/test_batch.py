"""Batches: members side by side give what single runs give, bit for bit, and keep nothing but figures."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
import pytest

import dampen
from dampen.analysis.merits import LATE, columns, merits
from dampen.analysis.metrics import error_peaks, largest
from dampen.analysis.sampling_cost import chatter, effort, margin
from dampen.controllers.pointwise import PointwiseLearning
from dampen.simulation.batch import Batch, Tally, alone
from dampen.simulation.bench import Bench
from dampen.simulation.compiled import bind
from dampen.simulation.kernel import Record
from dampen.simulation.lockstep import Lockstep, in_step
from dampen.simulation.passes import passes
from dampen.simulation.tally import BY_PORT, PEAK, WHOLE, tally
from tests.conftest import READINGS, scenario
from tests.test_contract import EXAMPLES, case

SHORT = ("task.trials=4", "numerics.modes=20", "numerics.step=0.002", "disturbance.base_frequency=0.5")


def varied(nominal: dampen.Scenario, count: int = 5) -> list[dampen.Scenario]:
    """Members that differ in gains, actuators, constraint and plant."""
    law: Any = nominal.controller
    plant: Any = nominal.plant
    members = [replace(nominal, controller=replace(law, alpha_4=0.3 * k + 0.2, alpha_9=0.05 * k + 0.01)) for k in range(count)]
    members.append(replace(nominal, actuators={p: (dampen.Backlash(0.3, 0.15, -0.1),) for p in nominal.ports}))
    members.append(replace(nominal, task=replace(nominal.task, constraint={"tip_w": (-0.19, 0.25), "tip_phi": 0.2})))
    members += [replace(nominal, plant=replace(plant, tip_mass=m, bending_stiffness=e)) for m, e in ((0.08, 40.0), (0.12, 31.0))]
    return members


def outcome(batch: Batch, member: dampen.Scenario) -> Tally:
    (found,) = batch.run([member])
    assert isinstance(found, Tally)
    return found


@pytest.mark.parametrize("reading", READINGS)
@pytest.mark.parametrize("threads", [1, 2])
def test_members_equal_single_runs_bit_for_bit(reading: str, threads: int) -> None:
    nominal = scenario(READINGS[reading], *SHORT)
    batch, members = Batch(nominal), varied(nominal)
    for member, found in zip(members, batch.run(members, threads), strict=True):
        assert isinstance(found, Tally)
        single = alone(member, batch.bench_of(member))
        np.testing.assert_array_equal(found.by_port, single.by_port)
        np.testing.assert_array_equal(found.whole, single.whole)
        assert found.status == single.status == "complete"


def test_what_a_member_learns_equals_a_single_run_bit_for_bit() -> None:
    nominal = scenario(*SHORT)
    bench = Bench(nominal)
    members = Lockstep([nominal, *varied(nominal, 2)[:2]], [bench] * 3)
    for p, _ in zip(passes(nominal, bench), members.trials(), strict=True):
        np.testing.assert_array_equal(members.members.learned_feedforward[0], p.memory["zeta"])
        np.testing.assert_array_equal(members.members.learned_coulomb[0], p.memory["d_hat"])


@pytest.mark.parametrize(
    "name",
    [
        "he2017",
        "he2017-sampled",
        "he2017-hysteresis",
        "euler-bernoulli-payload",
        "string-tip-mass",
        "flexible-arm-point-to-point",
    ],
)
def test_figures_are_those_of_the_analysis(name: str) -> None:
    nominal = dampen.read_scenario(name, ["task.trials=6"])
    found = merits(outcome(Batch(nominal), nominal))
    result = dampen.simulate(nominal)
    assert list(found) == columns(nominal)
    for port in nominal.ports:
        peaks = error_peaks(result, port)
        expected = {"peak": peaks[-LATE:].max(), "largest": peaks.max(), "effort": effort(result, port)}
        expected |= {"chatter": chatter(result, port)}
        if port in nominal.task.constraint:
            expected["margin"] = margin(result, port)
        p = nominal.ports.index(port)
        expected["stuck"] = float(np.mean(np.asarray(result["v"])[:, :, p] == 0))
        for figure, value in expected.items():
            assert found[f"{figure}.{port}"] == pytest.approx(value, rel=1e-9, abs=1e-13), (figure, port)
    assert found["energy"] == pytest.approx(np.mean(result["energy"][-LATE:]), rel=1e-12)


@pytest.mark.parametrize("kind", sorted(EXAMPLES["controller"]))
def test_every_controller_can_be_a_member(kind: str) -> None:
    nominal = case("controller", kind, trials=3)
    found, result = outcome(Batch(nominal), nominal), dampen.simulate(nominal)
    p = 0
    error = np.asarray(result["y"])[:, :, p]
    np.testing.assert_allclose(found.by_port[:, p, PEAK], np.abs(error).max(axis=1), rtol=1e-12)


def test_members_of_a_batch_start_anew_where_trials_are_reset() -> None:
    nominal = scenario(*SHORT, "task.start=reset", "task.reset_error={tip_w=0.001}")
    found, result = outcome(Batch(nominal), nominal), dampen.simulate(nominal)
    np.testing.assert_allclose(found.by_port[:, 0, PEAK], largest(result, "y", "tip_w"), rtol=1e-12)


def test_a_member_that_cannot_be_run_spoils_no_other() -> None:
    nominal = scenario(*SHORT)
    plant: Any = nominal.plant
    few = replace(nominal, numerics=replace(nominal.numerics, modes=1))
    heavy = replace(nominal, plant=replace(plant, tip_mass=0.2))
    first, refused, last = Batch(nominal).run([nominal, few, heavy])
    assert isinstance(refused, dampen.ArgumentError)
    assert "`numerics.modes`" in refused.lines[0]
    assert isinstance(first, Tally)
    assert isinstance(last, Tally)


def test_a_motion_that_diverges_is_an_outcome() -> None:
    nominal = dampen.read_scenario(
        "assembled-from-fe", ["plant.damping.ratio=0.0", "controller.modes=2", "actuator.all.chain=[]", "task.trials=40"]
    )
    assert not in_step(nominal)
    found = outcome(Batch(nominal), nominal)
    assert found.status in ("diverged", "constraint_lost")
    figures = merits(found)
    assert figures["margin"] < 0
    assert np.isnan(figures["peak"]) == (found.status == "diverged")


def test_a_lost_constraint_is_a_status() -> None:
    nominal = scenario(*SHORT, "controller.kind=none")
    found = outcome(Batch(nominal), nominal)
    assert found.status == "constraint_lost"
    assert merits(found)["margin"] < 0


def test_memory_does_not_grow_with_trials_nor_with_members() -> None:
    """Peak memory of its own process for 20 and for 400 members, and for ten times the trials."""
    code = """
import resource, sys
import dampen
from dampen.simulation.batch import Batch
members, trials = int(sys.argv[1]), int(sys.argv[2])
settings = ["numerics.modes=16", "task.trial_duration=0.5", "disturbance.frozen_at=0"]
case = dampen.read_scenario("he2017", [f"task.trials={trials}", *settings])
batch = Batch(case)
for _ in range(members // 20):
    batch.run([case] * 20)
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
"""

    def peak(members: int, trials: int) -> float:
        done = subprocess.run([sys.executable, "-c", code, str(members), str(trials)], capture_output=True, text=True, check=True)
        return float(done.stdout)

    few = peak(20, 10)
    assert peak(400, 10) < few + 20
    assert peak(20, 100) < few + 20


VARIANTS = {"log": "controller.barrier=log", "tan": "controller.barrier=tan", "damped": "plant.damping.ratio=0.05"}


def test_kernels_from_disk_do_not_take_each_other_s_place(tmp_path: Any) -> None:
    """Each variant compiled in a process of its own; then all in one, from the cache: whatever comes first, the same figures."""
    code = """
import sys
import dampen
from dampen.simulation.batch import Batch
for variant in sys.argv[1:]:
    case = dampen.read_scenario("he2017", ["task.trials=2", "task.trial_duration=0.5", "numerics.modes=8", variant])
    (found,) = Batch(case).run([case])
    print(variant, found.by_port.tobytes().hex()[:4000])
"""

    def figures(*variants: str) -> set[str]:
        environment = {**os.environ, "NUMBA_CACHE_DIR": str(tmp_path)}
        done = subprocess.run(
            [sys.executable, "-c", code, *variants], capture_output=True, text=True, check=True, env=environment
        )
        return set(done.stdout.splitlines())

    single = set().union(*(figures(variant) for variant in VARIANTS.values()))
    assert len({line.split()[1] for line in single}) == 3
    assert figures(*VARIANTS.values()) == single
    assert figures(*reversed(VARIANTS.values())) == single


def test_damped_and_undamped_members_in_any_order_are_single_runs() -> None:
    nominal = dampen.read_scenario("euler-bernoulli-payload", ["task.trials=2", "task.trial_duration=1.0", "numerics.modes=10"])
    plant: Any = nominal.plant
    dampings = [dampen.Damping(), dampen.Damping(ratio=0.05), dampen.Damping(kelvin_voigt=1e-3), dampen.Damping(viscous=0.5)]
    members = [replace(nominal, plant=replace(plant, damping=damping)) for damping in dampings]
    expected = [merits(alone(member, Bench(member))) for member in members]
    for order in (range(4), reversed(range(4))):
        chosen = list(order)
        for i, found in zip(chosen, Batch(nominal).run([members[i] for i in chosen]), strict=True):
            assert isinstance(found, Tally)
            assert merits(found) == pytest.approx(expected[i], rel=1e-6, abs=1e-12)


def test_a_shaken_base_moves_a_changed_plant_by_its_own_inertia() -> None:
    shaken = dampen.Sum(
        terms=(dampen.BaseShaking(frequencies=(0.5, 1.7), amplitudes=(0.05, 0.1)), dampen.MovingLoad(force=1.0, speed=9.0))
    )
    nominal = replace(dampen.read_scenario("string-tip-mass", ["task.trials=2"]), disturbance=shaken)
    plant: Any = nominal.plant
    batch = Batch(nominal)
    for mass in (0.6, 1.5):
        member = replace(nominal, plant=replace(plant, tip_mass=mass * plant.tip_mass))
        assert batch.bench_of(member).carried is not None
        expected = merits(alone(member, Bench(member)))
        assert merits(outcome(batch, member)) == pytest.approx(expected, rel=1e-5, abs=1e-9)


def test_a_law_that_learns_in_its_own_way_is_let() -> None:
    nominal = scenario(*SHORT)
    own = replace(nominal, controller=Forgetful())
    assert not in_step(own)
    result = dampen.simulate(own)
    np.testing.assert_allclose(outcome(Batch(own), own).by_port[:, 0, PEAK], largest(result, "y", "tip_w"), rtol=1e-12)
    assert outcome(Batch(nominal), nominal).by_port[3, 0, PEAK] != pytest.approx(largest(result, "y", "tip_w")[3], rel=1e-3)


@dataclass(frozen=True)
class Forgetful(dampen.DualLoopAILC):
    """Keeps a fifth of what it learns."""

    def learn(self, memory: Any, trial: Any, setting: Any) -> Any:
        return {name: 0.2 * value for name, value in super().learn(memory, trial, setting).items()}


def test_the_peak_of_all_ports_is_a_share_of_the_constraint_however_it_lies() -> None:
    uneven = dampen.read_scenario("string-tip-mass", ["task.trials=3"])
    found = merits(outcome(Batch(uneven), uneven))
    assert found["peak"] == pytest.approx(1 - found["margin"], rel=1e-12)  # all trials are late ones here
    free = scenario(*SHORT, "controller.barrier=none", "task.constraint={tip_w=10.0}")
    found = merits(outcome(Batch(free), free))
    assert found["peak"] == pytest.approx(found["peak.tip_w"] / 10, rel=1e-12)


def test_the_figures_of_a_trial_by_hand() -> None:
    """Two ports, four steps of which the third was the last that was done; limits that are neither even nor at rest."""
    nan, none = float("nan"), np.zeros((5, 2))
    record = Record(
        y=np.array([[0.1, 0.0], [-0.3, 0.0], [0.2, -0.4], [0.1, 0.2], [9.0, 9.0]]),
        slow=none,
        energy=np.array([1.0, 2.0, 4.0, 5.0, 99.0]),
        v=np.array([[0.0, 1.0], [-0.1, 0.0], [0.0, 1.0], [0.0, 0.0]]),
        command=np.array([[1.0, -1.0], [3.0, -1.0], [-2.0, -4.0], [50.0, 50.0]]),
        delivered=np.array([[3.0, 0.0], [0.0, 2.0], [-3.0, 1.0], [70.0, 70.0]]),
        work_load=none[:, 0],
        dissipated=none[:, 0],
        q=none,
        unsettled=np.array([2.0]),
    )
    low = np.array([[-1.0, -0.5], [-0.5, -0.5], [-0.1, -0.5], [-1.0, -0.5], [-1.0, -0.5]])
    high = np.array([[0.25, 1.0], [0.1, 1.0], [1.0, 1.0], [0.2, 0.4], [1.0, 1.0]])
    before, by_port, whole = np.array([nan, 4.0]), np.zeros((2, len(BY_PORT))), np.zeros(len(WHOLE))
    bind(tally, PORTS=2)(record, low, high, 3, before, by_port, whole)
    np.testing.assert_allclose(by_port[0], [0.3, 0.15 / 4, 0.3 / 0.5, 18 / 3, 2 + 5, 2 / 3], rtol=1e-14)
    np.testing.assert_allclose(by_port[1], [0.4, 0.2 / 4, 0.4 / 0.5, 5 / 3, 5 + 0 + 3, 1 / 3], rtol=1e-14)
    np.testing.assert_array_equal(whole, [12.0 / 4, 2, 3])
    np.testing.assert_array_equal(before, [-2.0, -4.0])


def test_members_that_follow_their_own_references_with_their_own_forces_are_single_runs() -> None:
    nominal = dampen.read_scenario("string-tip-mass", ["task.trials=3", "task.trial_duration=0.4", "numerics.modes=8"])
    law, task = nominal.controller, nominal.task
    paths = [dampen.Hold(0.05), dampen.Sinusoid(amplitude=0.04, frequency=2.0, phase=1.0)]
    members = [nominal, *(replace(nominal, task=replace(task, reference={"tip_w": path})) for path in paths)]
    closing = dampen.Constraint(high=dampen.Decay(0.3, 0.1, 0.1), low=dampen.Decay(-0.2, -0.06, 0.2))
    members.append(replace(nominal, task=replace(task, constraint={"tip_w": closing})))
    members += [replace(m, controller=replace(law, feedforward={"tip_w": 7.0 + 5 * i})) for i, m in enumerate(members)]
    batch = Batch(nominal)
    for member, found in zip(members, batch.run(members), strict=True):
        assert isinstance(found, Tally)
        single = alone(member, batch.bench_of(member))
        np.testing.assert_array_equal(found.by_port, single.by_port)
        np.testing.assert_array_equal(found.whole, single.whole)


@dataclass(frozen=True)
class LearnsFromAll(PointwiseLearning, dampen.AdaptiveBoundary):
    """Learns from everything that is seen of a step: error at its end, rate, command, and what was learned before."""

    kind: ClassVar[str] = "learns-from-all"
    relearn: ClassVar = staticmethod(
        lambda feedforward, coulomb, error, v, command, row: (
            0.9 * feedforward - row[0] * error - row[1] * v,
            0.5 * coulomb + row[2] * command * command,
        )
    )

    def learning_row(self, setting: Any) -> np.ndarray:
        return np.array([[0.5, 0.3], [0.3, 0.2], [0.01, 0.02]])


def test_a_member_learns_from_the_error_the_rate_and_the_command_of_every_step() -> None:
    own = replace(scenario(*SHORT), controller=LearnsFromAll())
    assert in_step(own)
    bench = Bench(own)
    stepped = Lockstep([own], [bench])
    for p, _ in zip(passes(own, bench), stepped.trials(), strict=True):
        np.testing.assert_allclose(stepped.members.learned_feedforward[0], p.memory["feedforward"], rtol=1e-13, atol=1e-16)
        np.testing.assert_allclose(stepped.members.learned_coulomb[0], p.memory["coulomb"], rtol=1e-13)
        assert p.memory["coulomb"].any()


@pytest.mark.parametrize("start", ["chained", "reset"])
def test_a_member_that_breaks_off_in_trial_1_has_two_trials_and_the_others_all(start: str) -> None:
    nominal = dampen.read_scenario(
        "string-tip-mass", ["task.trials=4", "task.trial_duration=0.4", "numerics.modes=8", f"task.start={start}"]
    )
    late = dampen.Impulse(impulse={"tip_w": 1e30}, duration=0.1, at=0.2, trial=1)
    members = [nominal, replace(nominal, disturbance=late), replace(nominal, disturbance=dampen.NoDisturbance())]
    batch = Batch(nominal)
    found = batch.run(members)
    for member, tally_of in zip(members, found, strict=True):
        assert isinstance(tally_of, Tally)
        single = alone(member, batch.bench_of(member))
        np.testing.assert_array_equal(tally_of.by_port, single.by_port)
        np.testing.assert_array_equal(tally_of.whole, single.whole)
    assert [len(f.whole) for f in found if isinstance(f, Tally)] == [4, 2, 4]
    assert [f.status for f in found if isinstance(f, Tally)] == ["complete", "diverged", "complete"]
