"""The limit: against brute force, against every shipped controller, and against what is known exactly."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from pydantic import TypeAdapter
from scipy.linalg import expm
from scipy.optimize import minimize

import dampen
from dampen.analysis.limit.curve import Limit, limit, limits
from dampen.analysis.limit.lifted import Lifted, effort_square, mean_square
from dampen.analysis.limit.measure import effort, measure, measured, measures, scales
from dampen.analysis.limit.riccati import solve
from dampen.analysis.limit.standing import Standing, standing
from dampen.scenarios.read import shipped
from dampen.simulation.bench import Bench

Array = np.ndarray
TINY = (
    "plant.tip_mass=0.3", "plant.damping.ratio=0.01", "numerics.modes=3", "numerics.step=0.02", "task.trials=2",
    "task.trial_duration=0.24", "output.every=3", "output.points=5", "disturbance.frozen_at=2",
)  # fmt: skip


def tiny(*overrides: str) -> dampen.Scenario:
    """A beam of three modes for two trials of twelve steps."""
    return dampen.read_scenario("he2017", [*TINY, *overrides])


def lifted_of(scenario: dampen.Scenario, of: str) -> Lifted:
    bench = Bench(scenario)
    return Lifted(scenario, bench, measure(scenario, of, bench))


class Dense:
    """The run as dense matrices, from the modes and matrix exponentials alone: e = free + P u, each weighted to its mean."""

    def __init__(self, scenario: dampen.Scenario, of: str):
        self.scenario, self.of, self.bench = scenario, of, Bench(scenario)
        modes, n = self.bench.modes, self.bench.modes.count
        generator = np.zeros((3 * n, 3 * n))  # q, q', and the modal force that is held
        generator[:n, n : 2 * n] = np.eye(n)
        generator[n : 2 * n, :n], generator[n : 2 * n, n : 2 * n] = -np.diag(modes.omega**2), -2 * np.diag(modes.decay)
        generator[n : 2 * n, 2 * n :] = np.eye(n)
        whole = expm(generator * scenario.numerics.step)
        self.a, self.b = whole[: 2 * n, : 2 * n], whole[: 2 * n, 2 * n :]
        self.ports = [p for p, port in enumerate(scenario.ports) if scenario.actuators.get(port) != (dampen.Absent(),)]
        self.free = self.run(lambda j, k: 0.0, disturbed=True)
        columns = [self._column(j, k, p) for j in range(scenario.task.trials) for k in range(scenario.steps) for p in self.ports]
        self.p = np.column_stack(columns) * math.sqrt(scenario.task.trials * scenario.steps)

    def _column(self, trial: int, step: int, port: int) -> Array:
        push = self.bench.modes.b[port] * scales(self.scenario)[port]
        return self.run(lambda j, k: push if (j, k) == (trial, step) else 0.0, disturbed=False)

    def run(self, push, disturbed: bool) -> Array:  # type: ignore[no-untyped-def]
        """All that is measured, divided by the root of its number."""
        scenario, modes = self.scenario, self.bench.modes
        field = self.of in dict(scenario.plant.fields)
        shapes = self.bench.shapes[self.of] if field else modes.b[scenario.ports.index(self.of)][None]
        found, z = [], np.zeros(2 * modes.count)
        for j in range(scenario.task.trials):
            if j == 0 or scenario.task.start == "reset":
                z = np.concatenate(self.bench.state(j)) * disturbed
            disturbance, load, _ = self.bench.shaking(j)
            reference = scenario.reference(j)[:, scenario.ports.index(self.of)] if not field else np.zeros(scenario.steps + 1)
            for k in range(scenario.steps + 1):
                if not field or k % scenario.output.every == 0:
                    found.append(shapes @ z[: modes.count] - reference[k] * disturbed)
                if k < scenario.steps:
                    force = push(j, k) + disturbed * (load[k, : modes.count] + disturbance[k] @ modes.b)
                    z = self.a @ z + self.b @ (np.zeros(modes.count) + force)
        values = np.concatenate(found)
        return np.asarray(values / math.sqrt(len(values)))


CASES = {
    "chained field": ("w", ()),
    "chained angle": ("phi", ()),
    "chained port": ("tip_phi", ()),
    "reset field": ("w", ("task.start=reset", "task.reset_error.tip_w=0.02")),
    "one port": ("w", ("actuator.tip_phi.chain=[{kind='absent'}]", "actuator.all.chain=[]", "controller.compensate=false")),
    "reference": ("tip_w", ("task.start=reset", "task.constraint={tip_phi=0.2}",
                            "task.reference.tip_w={kind='sinusoid',amplitude=0.1,frequency=2.0}",
                            "controller.kind=none")),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_least_squares_with_dense_matrices_finds_the_same_point(case: str) -> None:
    of, overrides = CASES[case]
    scenario = tiny(*overrides)
    dense = Dense(scenario, of)
    found = limit(scenario, of, weights=(1e-2, 1e-4, 1e-7))
    assert found.uncontrolled == pytest.approx(np.linalg.norm(dense.free), rel=1e-12)
    for point in found.points:
        stacked = np.vstack([dense.p, math.sqrt(point.weight) * np.eye(dense.p.shape[1])])
        u = np.linalg.lstsq(stacked, np.concatenate([-dense.free, np.zeros(dense.p.shape[1])]), rcond=None)[0]
        assert point.rms == pytest.approx(np.linalg.norm(dense.free + dense.p @ u), rel=1e-6)
        assert point.effort == pytest.approx(np.linalg.norm(u), rel=1e-6)


@pytest.mark.parametrize("case", ["chained field", "reset field"])
def test_a_general_optimiser_under_a_bound_on_the_effort_finds_the_same_limit(case: str) -> None:
    of, overrides = CASES[case]
    scenario = tiny(*overrides)
    dense, found = Dense(scenario, of), limit(scenario, of, weights=(1e-2, 1e-3, 1e-5))
    normal, side = dense.p.T @ dense.p, dense.p.T @ dense.free
    for point in found.points:
        best = minimize(
            lambda u: (dense.free @ dense.free + 2 * side @ u + u @ normal @ u) / found.uncontrolled**2,
            np.zeros(len(side)),
            jac=lambda u: 2 * (side + normal @ u) / found.uncontrolled**2,
            method="SLSQP",
            constraints={
                "type": "ineq",
                "fun": lambda u, most=point.effort: 1 - u @ u / most**2,
                "jac": lambda u, most=point.effort: -2 * u / most**2,
            },
            options={"ftol": 1e-14, "maxiter": 1000},
        )
        assert np.linalg.norm(dense.free + dense.p @ best.x) == pytest.approx(point.rms, rel=1e-6)
        assert found.bound(point.effort) == pytest.approx(point.rms, rel=1e-9)
        assert found.reached(point.effort) == pytest.approx(point.rms, rel=1e-12)


def test_from_rest_what_shakes_the_ports_alone_can_be_cancelled_to_nothing() -> None:
    scenario = dampen.read_scenario(
        "he2017",
        ["plant.initial={}", "disturbance.load_amplitude=0", "actuator.all.chain=[]", "controller.kind=none", "task.trials=2"],
    )
    for of in ("w", "phi"):
        found = limit(scenario, of, weights=[10.0**k for k in (0, -3, -6, -9, -12, -15, -17)])
        rms = [point.rms for point in found.points]
        assert all(later < earlier for earlier, later in pairwise(rms))
        assert rms[-1] < 5e-9 * found.uncontrolled
        bench = Bench(scenario)
        cancelling = np.concatenate([bench.shaking(j)[0] / scales(scenario) for j in range(2)])
        assert found.points[-1].effort == pytest.approx(math.sqrt(np.mean(np.sum(cancelling**2, axis=1))), rel=2e-3)


def others(scenario: dampen.Scenario) -> Iterator[dampen.Scenario]:
    """The scenario under its own controller, none, and the boundary controllers that run there."""
    yield scenario
    yield scenario.uncontrolled()
    by_kind = {"force": 5.0, "torque": 0.05}
    damping = {port.name: by_kind[port.kind] for port in scenario.plant.ports}
    yield replace(scenario.uncontrolled(), controller=dampen.BoundaryDamping(damping=damping))
    if set(scenario.ports) <= set(scenario.bounds) and set(scenario.ports) <= set(scenario.task.constraint):
        yield replace(scenario.uncontrolled(), controller=dampen.AdaptiveBoundary())


@cache
def short(name: str) -> tuple[dampen.Scenario, tuple[Limit, ...]]:
    """A shipped scenario for two trials, with its limits."""
    scenario = dampen.read_scenario(name, ["task.trials=2"])
    return scenario, limits(scenario)


@pytest.mark.parametrize("name", list(shipped()))
def test_no_controller_lies_below_it(name: str) -> None:
    scenario, found = short(name)
    bench = Bench(scenario)
    for run in others(scenario):
        result = dampen.simulate(run, bench=bench)
        for one in found:
            place = standing(one, result)
            assert not place.below, f"{type(run.controller).__name__}, {one.of}: {place}"
            assert place.bound <= place.reached
            assert place.rms > 1.001 * place.bound


@pytest.mark.parametrize("name", list(shipped()))
def test_it_falls_convexly_and_certifies_itself(name: str) -> None:
    for one in short(name)[1]:
        effort, rms, weight, gap = (np.array([getattr(p, key) for p in one.points]) for key in ("effort", "rms", "weight", "gap"))
        assert np.all(np.diff(effort) > 0)
        assert np.all(np.diff(rms) < 0)
        assert rms[0] < one.uncontrolled
        slopes = np.diff(rms**2) / np.diff(effort**2)
        assert np.all(np.diff(slopes) > 0), "the squares fall less and less"
        assert np.all(-weight[:-1] < slopes * (1 - 1e-9)), "each point's line supports the curve"
        assert np.all((gap >= 0) & (gap < 1e-9))
        between = np.linspace(effort[0], effort[-1], 200)
        low, high = np.array([(one.bound(e), one.reached(e)) for e in between]).T
        assert np.all(low <= high * (1 + 1e-12))


def test_a_run_is_what_its_own_forces_make_of_the_map() -> None:
    for name in ("he2017", "flexible-arm-point-to-point"):
        scenario = dampen.read_scenario(name, ["task.trials=3", "controller.kind=boundary-damping", "controller.damping.hub=1.0"]
                                        if "arm" in name else ["task.trials=3"])  # fmt: skip
        result = dampen.simulate(scenario)
        for of in measures(scenario):
            lifted = lifted_of(scenario, of)
            forces = (np.asarray(result["delivered"][:]) / scales(scenario))[:, :, lifted.usable]
            assert math.sqrt(effort_square(forces)) == pytest.approx(effort(result), rel=1e-12)
            error = lifted.under(forces)
            rms, peak = measured(result, of)
            assert math.sqrt(mean_square(error)) == pytest.approx(rms, rel=1e-6)
            assert np.abs(error).max() == pytest.approx(peak, rel=1e-5)


@pytest.mark.parametrize("overrides", [(), ("task.start=reset",), ("plant.damping.ratio=0.1",)])
def test_map_and_factors_are_exact(overrides: tuple[str, ...]) -> None:
    scenario = dampen.read_scenario("he2017", ["numerics.modes=20", "task.trials=3", "task.trial_duration=0.5", *overrides])
    rng = np.random.default_rng(1)
    for of in ("phi", "tip_w"):
        lifted = lifted_of(scenario, of)
        u = rng.standard_normal((3, scenario.steps, 2))
        e = rng.standard_normal(lifted.free.shape)
        there, back = np.mean(lifted.response(u) * e), np.sum(u * lifted.adjoint(e)) / (3 * scenario.steps)
        assert there == pytest.approx(back, rel=1e-10)
        weight = 1e-3 * effort_square(lifted.adjoint(lifted.free)) / mean_square(lifted.free)
        image = lifted.adjoint(lifted.response(u)) + weight * u
        for keep in (2**30, 0):  # all gains kept, or found twice
            assert np.abs(solve(lifted, weight, image, keep) - u).max() < 1e-9


def test_a_port_without_an_actuator_is_of_no_use() -> None:
    scenario = dampen.read_scenario("flexible-arm-point-to-point")
    assert lifted_of(scenario, "hub").usable == [list(scenario.ports).index("hub")]
    both = replace(scenario, actuators={})
    assert limit(both, "hub", [1e-3]).points[0].rms < limit(scenario, "hub", [1e-3]).points[0].rms
    with pytest.raises(dampen.ArgumentError, match="must have an actuator at some port"):
        limit(replace(scenario, actuators={port: (dampen.Absent(),) for port in scenario.ports}))


def test_what_is_measured_by_default() -> None:
    found = {
        name: tuple(one.of for one in short(name)[1]) for name in ("he2017", "flexible-arm-point-to-point", "string-tip-mass")
    }
    assert found == {"he2017": ("w", "phi"), "flexible-arm-point-to-point": ("hub", "tip_w"), "string-tip-mass": ("w",)}


def test_without_anything_to_cancel_there_is_one_point_at_zero() -> None:
    scenario = replace(tiny("plant.initial={}"), disturbance=dampen.NoDisturbance())
    found = limit(scenario, "w")
    assert (found.uncontrolled, [(p.effort, p.rms, p.gap) for p in found.points]) == (0.0, [(0.0, 0.0, 0.0)])


def test_it_goes_to_json_and_back() -> None:
    found = limit(tiny(), "tip_w", weights=(1e-3,))
    adapter = TypeAdapter(Limit)
    assert adapter.validate_json(adapter.dump_json(found)) == found


def test_progress_counts_all_weights_of_all_measures() -> None:
    told: list[tuple[int, int]] = []
    limits(tiny(), weights=(1e-2, 1e-3), progress=lambda done, every: told.append((done, every)))
    assert told == [(1, 4), (2, 4), (3, 4), (4, 4)]


def test_wrong_arguments_are_told_in_one_line() -> None:
    scenario = tiny()
    with pytest.raises(
        dampen.ArgumentError, match=r"^Argument `of` must be a field or a port of this plant, but is 'tip_v'; did you"
    ):
        limit(scenario, "tip_v")
    for weights in ((0.0,), (1.0, math.inf)):
        with pytest.raises(dampen.ArgumentError, match=r"^Argument `weights` must be finite numbers > 0, or None, but is"):
            limit(scenario, "w", weights=weights)
    found = limit(scenario, "w", weights=(1e-3,))
    with pytest.raises(dampen.ArgumentError, match=r"^Argument `result` must be a run of the limit's own experiment"):
        standing(found, dampen.simulate(tiny("plant.tip_mass=0.2")))
    with pytest.raises(dampen.ArgumentError, match=r"^Argument `result` must have finished all 2 trials, but has 1"):
        standing(found, dampen.simulate(tiny("task.trials=1")))


def test_its_figure_names_the_runs_below_the_curve_and_says_what_is_not_bounded() -> None:
    from dampen.report.review.limit import draw_limit

    scenario, (of_w, _) = short("he2017")
    runs = {"learning": scenario, "no control": scenario.uncontrolled()}
    figure, text = draw_limit(of_w, [(name, standing(of_w, dampen.simulate(run))) for name, run in runs.items()])
    figure.draw_without_rendering()
    axes = figure.axes[0]
    named = axes.get_legend()
    assert [entry.get_text().split(":")[0] for entry in named.get_texts()] == ["learning"], "without forces there is no effort"
    box, (bottom, _) = named.get_window_extent(), axes.get_ylim()
    assert box.y1 < axes.transData.transform((1.0, of_w.points[-1].rms))[1]
    assert box.x1 < axes.get_window_extent().x1
    assert 0 < bottom < of_w.points[-1].rms
    assert "Peaks are not bounded by it: learning 0.160 m" in text


def test_where_there_is_no_bound_the_effort_from_which_on_is_told() -> None:
    from dampen.report.review.tables import limit_rows
    from dampen.report.review.words import limited
    from dampen.studies.record import record

    scenario = tiny()
    found = limit(scenario, "w", weights=(1e-1, 1e-3))
    assert found.cancelled == max(math.sqrt(point.dual / point.weight) for point in found.points)
    assert found.bound(0.99 * found.cancelled) > 0 == found.bound(1.01 * found.cancelled)
    beyond = Standing("w", "m", 2 * found.cancelled, 0.1, 0.2, 0.0, found.reached(2 * found.cancelled), None, False)
    (text,) = limited([found], [beyond])
    assert f"From {found.cancelled:#.3g} N on the disturbance can be cancelled: there is no bound there; some forces" in text
    (row,) = limit_rows(record(scenario, limits=(found,), standings=(beyond,)))
    assert row[4:6] == ("no bound", "\N{EN DASH}")
