"""What each part of a law is worth: ablations are the experiments that they say they are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from typing import ClassVar

import numpy as np
import pytest

import dampen
from dampen.analysis.credit import Credit, Variant, credit, ideal_actuators, variants
from dampen.analysis.merits import merits
from dampen.controllers.base import Memory, PortLaw, Setting, Trial, total
from dampen.controllers.partial import PartialLaw, taken_apart
from dampen.controllers.pointwise import PointwiseLearning
from dampen.simulation.batch import Batch, Tally
from dampen.simulation.scenario import Scenario
from dampen.simulation.setting import setting_of

SHORT = ("task.trials=6", "numerics.modes=30")
ALPHAS = {f"alpha_{i}": value for i, value in enumerate((1.0, 1.5, 0.2, 2.0, 1.2, 0.3, 1.5, 0.4, 0.6), 1)}


def he2017(*sets: str) -> Scenario:
    scenario = dampen.read_scenario("he2017", [*SHORT, *sets])
    return scenario.with_controller(replace(scenario.controller, **ALPHAS))


@cache
def taken(*sets: str) -> Credit:
    return credit(he2017(*sets))


def same(variant: Variant | None, scenario: Scenario) -> bool:
    """Whether a variant has the figures of a scenario."""
    (tally,) = Batch(scenario).run([scenario])
    assert isinstance(tally, Tally)
    assert variant is not None
    found = merits(tally)
    pairs = [(one.residual, found[f"residual.{one.port}"]) for one in variant.ports]
    pairs += [(one.effort, found[f"effort.{one.port}"]) for one in variant.ports]
    return bool(np.allclose(*zip(*[*pairs, (variant.margin, found["margin"])], strict=True), rtol=1e-6, atol=1e-15))


@pytest.mark.parametrize("reading", ["true", "false"])
def test_ablations_of_the_papers_law_are_the_controllers_that_have_names(reading: str) -> None:
    scenario, found = he2017(f"controller.compensate={reading}"), taken(f"controller.compensate={reading}")
    law = scenario.controller
    assert isinstance(law, dampen.DualLoopAILC)
    common = {"compensate": law.compensate, "assumed_backlash": law.assumed_backlash, **ALPHAS}
    assert same(found.whole, scenario)
    assert same(found.get("no control"), scenario.uncontrolled())
    assert same(found.get("nothing learned"), scenario.with_controller(dampen.AdaptiveBoundary(**common)))
    assert same(found.get("without barrier"), scenario.with_controller(replace(law, barrier="none")))
    assert not same(found.get("without barrier"), scenario)


def test_damping_only_is_boundary_damping_through_the_same_compensation() -> None:
    scenario = he2017("controller.compensate=false")
    damping = dampen.BoundaryDamping(damping={"tip_w": ALPHAS["alpha_4"], "tip_phi": ALPHAS["alpha_7"]})
    assert same(taken("controller.compensate=false").get("damping only"), scenario.with_controller(damping))


def test_an_ideal_actuator_has_the_slope_and_nothing_else() -> None:
    designed, direct = he2017(), he2017("controller.compensate=false")
    bare = replace(designed, actuators={}, controller=replace(designed.controller, compensate=False))
    assert same(taken().get("ideal actuator"), bare)
    ideal = ideal_actuators(direct)
    assert ideal is not None
    assert [np.prod([stage.gain for stage in ideal.chain(p)]) for p in range(2)] == pytest.approx([0.3, 0.3])
    result = dampen.simulate(ideal)
    np.testing.assert_allclose(result["delivered"], 0.3 * np.asarray(result["command"]), atol=1e-12)
    assert ideal_actuators(bare) is None


def test_held_frequencies_are_those_of_trial_0() -> None:
    held = he2017("disturbance.frozen_at=0")
    assert same(taken().get("frequencies held"), held)
    assert same(taken().get("no control, frequencies held"), held.uncontrolled())
    assert "frequencies held" not in [name for name, *_ in variants(held)]


def test_a_law_is_the_sum_of_its_terms() -> None:
    scenario = he2017()
    setting, law = setting_of(scenario), scenario.controller
    random = np.random.default_rng(0)
    memory = {name: random.random((setting.steps, 2)) for name in law.begin(setting)}
    whole, summed = law.law(memory, setting), total(law.terms(memory, setting))
    for part in ("feedforward", "coulomb", "damping", "stiffness", "barrier"):
        np.testing.assert_allclose(getattr(summed, part), getattr(whole, part), rtol=1e-14)


@dataclass(frozen=True)
class Learner(PointwiseLearning, dampen.BoundaryDamping):
    """A law of one's own that learns on top of a shipped one."""

    kind: ClassVar[str] = "learner"
    relearn: ClassVar = staticmethod(lambda feedforward, coulomb, error, v, command, row: (feedforward - row[0] * v, coulomb))

    def learning_row(self, setting: Setting) -> np.ndarray:
        return np.full((1, len(setting.ports)), 0.3)


@dataclass(frozen=True)
class Odd(Learner):
    """A law whose terms do not add up to it: then its bare parts are what is left out."""

    kind: ClassVar[str] = "odd"

    def terms(self, memory: Memory, setting: Setting) -> dict[str, PortLaw]:
        return {"half": PortLaw(np.zeros((setting.steps, 2)), damping=np.array([0.1, 0.1]))}


@pytest.mark.parametrize(("law", "names"), [(Learner, {"damping", "learned feedforward"}), (Odd, {"damping", "feedforward"})])
def test_a_law_of_ones_own_is_taken_apart_too(law: type[Learner], names: set[str]) -> None:
    scenario = he2017().with_controller(law(damping={"tip_w": 1.0, "tip_phi": 1.0}))
    setting = setting_of(scenario)
    memory: Mapping[str, np.ndarray] = {name: np.ones((setting.steps, 2)) for name in ("feedforward", "coulomb")}
    terms = taken_apart(scenario.controller, {**memory, "coulomb": 0 * memory["coulomb"]}, setting)
    assert set(terms) == names
    without = PartialLaw(scenario.controller, leave_out=tuple(names - {"damping"}))
    assert not np.any(without.law(memory, setting).feedforward)


def test_a_law_through_samples_keeps_what_can_be_left_out_around_it() -> None:
    lqg = dampen.read_scenario("he2017-sampled", [*SHORT, "task.trials=2", "controller.kind=lqg"])
    names = [variant.name for variant in credit(lqg).variants]
    assert names == ["as it is", "no control", "frequencies held", "no control, frequencies held", "ideal actuator"]


def test_a_law_without_its_barrier_asks_for_no_constraint_and_one_that_forgets_begins_every_trial_anew() -> None:
    scenario = he2017()
    law, port = scenario.controller, scenario.plant.ports[0]
    beyond = replace(scenario.task, constraint={"tip_w": 0.01, "tip_phi": 0.01})
    for leave_out, shape in (((), "log"), (("barrier",), "none")):
        partial = PartialLaw(law, leave_out=leave_out)
        assert (partial.barrier_shape, partial.has_barrier(port)) == (shape, shape == "log")
    assert replace(scenario, controller=PartialLaw(law, leave_out=("barrier",)), task=beyond).task == beyond
    with pytest.raises(dampen.ArgumentError, match="constraint"):
        replace(scenario, controller=PartialLaw(law, leave_out=("damping",)), task=beyond)

    setting = setting_of(scenario)
    memory = {name: np.full((setting.steps, 2), 0.3) for name in law.begin(setting)}
    v = np.linspace(-1, 1, 2 * setting.steps).reshape(-1, 2)
    trial = Trial(0, np.zeros((setting.steps + 1, 2)), v, v)
    for forget in (False, True):
        learned = PartialLaw(law, forget=forget).learn(memory, trial, setting)
        for name, wanted in (law.begin(setting) if forget else law.learn(memory, trial, setting)).items():
            np.testing.assert_array_equal(learned[name], wanted)


def test_without_control_there_is_nothing_to_take_apart() -> None:
    with pytest.raises(dampen.ArgumentError, match="nothing to take apart"):
        credit(he2017().uncontrolled())
