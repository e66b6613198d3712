"""Mistakes in a user's own classes are told in one line, with class, method and what it must be."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import pytest
from annotated_types import Ge

import dampen
from dampen.analysis.rates import rates
from dampen.controllers.base import SampledLoop
from dampen.family import Family, _declared
from dampen.listing import listing
from dampen.report.compare.tables import how
from dampen.scenarios.kinds import FAMILIES
from dampen.scenarios.read import shipped
from dampen.simulation.bench import Bench, output_points
from dampen.simulation.memory import begun
from dampen.simulation.result import Layout
from dampen.simulation.setting import setting_of
from dampen.simulation.variables import TAKEN
from dampen.studies.compare.entries import Entry, entry_of

FEW = ["task.trials=2", "numerics.modes=8", "numerics.step=0.01"]
HOOKS = sorted(
    {(family, name) for family in set(FAMILIES.values()) for name in _declared(family)}, key=lambda h: (h[0].__name__, h[1])
)


@dataclass(frozen=True)
class Learner(dampen.Controller):
    """Learns from the rate; remembers under a name that is told."""

    name: str = "u"

    def begin(self, setting: Any) -> Any:
        return {self.name: np.zeros((setting.steps, len(setting.ports)))}

    def law(self, memory: Any, setting: Any) -> Any:
        return dampen.PortLaw(memory[self.name], damping=np.ones(len(setting.ports)))

    def learn(self, memory: Any, trial: Any, setting: Any) -> Any:
        return {self.name: memory[self.name] - 0.1 * trial.v}


def scenario_under(controller: dampen.Controller, name: str = "he2017", settings: list[str] = FEW) -> dampen.Scenario:
    return dampen.read_scenario(name, settings).with_controller(controller)


def own_class(family: type[Family], **members: Any) -> Any:
    """An instance of a new class of a family, whatever it leaves abstract."""
    return whole(type("Mine", (family,), {"__module__": "mine", **members}))


def whole(cls: Any) -> Any:
    cls.__abstractmethods__ = frozenset()
    return object.__new__(cls)


@pytest.fixture
def module(tmp_path: Path) -> Iterator[Any]:
    """Writes a module beside a scenario, and forgets it afterwards."""
    made = []

    def write(text: str) -> str:
        name = f"mistaken_{len(made)}_{tmp_path.name}"
        head = "import dampen\nimport numpy as np\nfrom dataclasses import dataclass\n\n"
        (tmp_path / f"{name}.py").write_text(head + text)
        made.append(name)
        return name

    yield write
    for name in made:
        sys.modules.pop(name, None)


@pytest.mark.parametrize(("family", "name"), HOOKS, ids=lambda v: v if isinstance(v, str) else v.__name__)
def test_whatever_a_class_overrides_blames_it(family: type[Family], name: str) -> None:
    is_property = isinstance(_declared(family)[name], property)

    def fails(self: Any, *given: Any) -> Any:
        raise RuntimeError("boom")

    mine = own_class(family, **{name: property(fails) if is_property else fails})
    with pytest.raises(dampen.ArgumentError, match=rf"mine:\w+\.{name} failed: RuntimeError: boom \(test_own_mistakes.py, line"):
        getattr(mine, name) if is_property else getattr(mine, name)(1, 2)


def test_a_hook_that_cannot_be_called_is_told_with_its_own_line() -> None:
    def begin() -> Any: ...

    line = begin.__code__.co_firstlineno
    with pytest.raises(dampen.ArgumentError, match=rf"begin failed: TypeError: .*\(test_own_mistakes.py, line {line}\)"):
        own_class(dampen.Controller, begin=begin).begin(None)


RETURNS: list[tuple[type[Any], str, Any, str]] = [
    (dampen.Controller, "begin", np.zeros(3), r"a dict of arrays, but returns an array of shape \(3,\)"),
    (dampen.Controller, "begin", {"u": "text"}, "a dict of arrays, but returns {'u': 'text'}"),
    (dampen.Controller, "law", None, "a PortLaw, but returns None"),
    (dampen.Controller, "terms", dampen.PortLaw(np.zeros((1, 1))), r"a dict of PortLaws, but returns PortLaw\(.*"),
    (dampen.Controller, "search", ["a"], r"a dict of texts, but returns \['a'\]"),
    (dampen.Controller, "search", {"a": (0, 1)}, r"a dict of texts, but returns {'a': \(0, 1\)}"),
    (dampen.Controller, "notes", "a note", "a list of texts, but returns 'a note'"),
    (dampen.Controller, "sampled_loop", np.eye(2), r"a SampledLoop or None, but returns an array of shape \(2, 2\)"),
    (dampen.Controller, "sampled_loop", SampledLoop("none", 1), r"a SampledLoop or None, but returns \['none', 1, 0\]"),  # type: ignore[arg-type]
    (dampen.Controller, "design_time", "long", "a number, but returns 'long'"),
    (dampen.Disturbance, "same_as", 0.5, "a whole number, but returns 0.5"),
    (dampen.Disturbance, "at_ports", {"tip": 1}, "an array or None, but returns {'tip': 1}"),
    (dampen.Disturbance, "point_load", 1.0, "a pair of arrays, but returns 1.0"),
    (dampen.Plant, "modes", 3, "Modes, but returns 3"),
    (dampen.Plant, "initial_state", [1.0], r"a pair of arrays, but returns \[1.0\]"),
    (dampen.Stage, "row", 1.0, "a list of numbers, but returns 1.0"),
    (dampen.Stage, "start", None, "a list of numbers, but returns None"),
    (dampen.Signal, "sample", "now", "an array, but returns 'now'"),
]


@pytest.mark.parametrize(("family", "name", "value", "words"), RETURNS)
def test_what_a_hook_returns_is_what_its_family_says(family: type[Any], name: str, value: Any, words: str) -> None:
    mine = own_class(family, **{name: lambda self, *given: value})
    with pytest.raises(dampen.ArgumentError, match=rf"{name} must return {words}\.$") as error:
        getattr(mine, name)(1)
    assert len(error.value.lines) == 1


ACCEPTED: list[tuple[type[Any], str, Any]] = [
    (dampen.Stage, "row", np.ones(3)),
    (dampen.Stage, "row", [1, np.float64(2)]),
    (dampen.Disturbance, "at_ports", None),
    (dampen.Signal, "sample", [0.0, 1.0]),
    (dampen.Disturbance, "same_as", np.int64(0)),
    (dampen.Controller, "notes", ()),
    (dampen.Plant, "discretise", "known to a type checker alone"),
]


@pytest.mark.parametrize(("family", "name", "value"), ACCEPTED)
def test_near_types_are_taken(family: type[Any], name: str, value: Any) -> None:
    assert getattr(own_class(family, **{name: lambda self, *given: value}), name)(1) is value


def test_properties_and_methods_are_not_mistaken_for_one_another() -> None:
    with pytest.raises(dampen.ArgumentError, match=r"mine:Mine.relies_on must be a property: write @property above it"):
        own_class(dampen.Controller, relies_on=lambda self: ())
    with pytest.raises(dampen.ArgumentError, match=r"mine:Mine.begin must be a method, but is \{\}"):
        own_class(dampen.Controller, begin={})
    with pytest.raises(dampen.ArgumentError, match=r'relies_on must return a list of "alignment", .* or "moving ports", but'):
        _ = own_class(dampen.Controller, relies_on=property(lambda self: ("luck",))).relies_on


def test_a_kept_property_and_a_mixin_are_watched_too() -> None:
    class Kept(dampen.Controller):
        @cached_property
        def needs_bounds(self) -> Any:
            return undefined  # type: ignore[name-defined]  # noqa: F821

    class Mixed:
        def notes(self, setting: Any) -> Any:
            return undefined  # type: ignore[name-defined]  # noqa: F821

    with pytest.raises(dampen.ArgumentError, match="needs_bounds failed: NameError"):
        _ = whole(Kept).needs_bounds
    with pytest.raises(dampen.ArgumentError, match="notes failed: NameError"):
        whole(type("Both", (Mixed, dampen.NoControl), {})).notes(None)


def test_a_shipped_class_keeps_its_own_errors() -> None:
    with pytest.raises(TypeError):
        dampen.NoControl().notes()  # type: ignore[call-arg]


@pytest.mark.parametrize("name", shipped())
def test_every_name_in_a_result_is_known_to_be_taken(name: str) -> None:
    scenario = dampen.read_scenario(name)
    layout = Layout.of(scenario, output_points(scenario), setting_of(scenario))
    free = {field for field, _ in scenario.plant.fields} | set(begun(scenario, setting_of(scenario)))
    assert {*layout.variables, *layout.coordinates, *layout.sizes} - free <= TAKEN


@pytest.mark.parametrize("experiment", ["he2017", "he2017-sampled"])
@pytest.mark.parametrize("name", [*sorted(TAKEN), "w", "phi"])
def test_a_memory_may_not_have_a_name_of_a_result(name: str, experiment: str) -> None:
    scenario = scenario_under(Learner(name), experiment, [])
    with pytest.raises(dampen.ArgumentError, match=rf"Learner.begin gives a memory `{name}`, which is .*none of .*command") as e:
        begun(scenario, setting_of(scenario))
    assert len(e.value.lines) == 1


@pytest.mark.parametrize("name", ["", "a/b", " u", "u\n"])
def test_a_memory_must_have_a_name_that_a_file_can_have(name: str) -> None:
    scenario = scenario_under(Learner(name))
    with pytest.raises(dampen.ArgumentError, match=r"begin gives a memory .* cannot stand in a file; give it another one"):
        begun(scenario, setting_of(scenario))


def test_a_memory_of_another_plants_field_is_free() -> None:
    scenario = dampen.Scenario(plant=dampen.String(), controller=Learner("phi"), disturbance=dampen.NoDisturbance())
    assert "phi" in begun(scenario, setting_of(scenario))


def test_a_run_refuses_memories_before_its_first_trial() -> None:
    with pytest.raises(dampen.ArgumentError, match="begin gives a memory `command`"):
        dampen.simulate(scenario_under(Learner("command")))


@dataclass(frozen=True)
class Lost(Learner):
    """Loses itself in its second trial."""

    def learn(self, memory: Any, trial: Any, setting: Any) -> Any:
        return {"u": memory["u"] * (np.nan if trial.index else 1.0)}


@dataclass(frozen=True)
class Wide(Learner):
    """Remembers a number too many."""

    def begin(self, setting: Any) -> Any:
        return {"u": np.zeros(setting.steps)}


@dataclass(frozen=True)
class Starting(dampen.Controller):
    """Has its `begin` under another name."""

    def law(self, memory: Any, setting: Any) -> Any:
        return dampen.PortLaw(memory["u"])

    def start(self, setting: Any) -> Any:
        return {"u": np.zeros((setting.steps, len(setting.ports)))}


@dataclass(frozen=True)
class Rowed(Learner):
    """Takes the error at all grid times for that of the steps."""

    def learn(self, memory: Any, trial: Any, setting: Any) -> Any:
        return {"u": memory["u"] - trial.error}


@pytest.mark.parametrize(
    ("law", "words"),
    [
        (Starting, r"Starting.law failed: KeyError: 'u' \(.*\): it defines no `begin`, only `start`\.$"),
        (Rowed, r"shapes \(200,2\) \(201,2\) \(what is known at all grid times, such as `trial.error`, has steps \+ 1 rows\) \("),
    ],
)
def test_what_a_law_of_the_users_lacks_is_said(law: type[dampen.Controller], words: str) -> None:
    with pytest.raises(dampen.ArgumentError, match=words) as error:
        dampen.simulate(scenario_under(law()))
    assert len(error.value.lines) == 1


def test_what_is_learned_must_be_finite() -> None:
    with pytest.raises(dampen.ArgumentError, match=r"Lost.learn must keep the memory `u` finite, but does not after trial 1\."):
        dampen.simulate(scenario_under(Lost(), settings=[*FEW, "task.trials=3"]))


def test_a_memory_must_fit_into_the_result() -> None:
    with pytest.raises(
        dampen.ArgumentError, match=r"Wide.begin must give the memory `u` in shape \(\d+, 2\), but gives \(\d+,\)"
    ):
        dampen.simulate(scenario_under(Wide()))


@dataclass(frozen=True)
class Misspelt(dampen.Controller):
    """Would learn."""

    def begin(self, setting: Any) -> Any:
        return {"u": np.zeros((setting.steps, len(setting.ports)))}

    def law(self, memory: Any, setting: Any) -> Any:
        return dampen.PortLaw(memory["u"])

    def lern(self, memory: Any, trial: Any, setting: Any) -> Any:
        return {"u": trial.v}


def test_memories_that_never_change_are_noted() -> None:
    result = dampen.simulate(scenario_under(Misspelt(), settings=[*FEW, "task.trials=1"]))
    assert result.warnings[0] == "tests.test_own_mistakes:Misspelt defines no `learn`, only `lern`: its memory `u` never changes."
    result = dampen.simulate(scenario_under(Learner(), settings=[*FEW, "task.trials=1"]))
    assert not any("never change" in line for line in result.warnings)


@dataclass(frozen=True)
class Searching(dampen.Controller):
    """A law whose `search` is put in."""

    gain: Annotated[float, Ge(0)] = 1.0
    many: int = 2
    by_port: dict[str, float] = field(default_factory=dict)

    def law(self, memory: Any, setting: Any) -> Any:
        return dampen.PortLaw(np.zeros((setting.steps, len(setting.ports))), damping=np.full(len(setting.ports), self.gain))


FORM = "LOW:HIGH or LOW:HIGH:log"
SEARCHES = {
    "form": ({"gain": "0.01-10"}, f"for `gain` must have a range like {FORM}, but has '0.01-10'"),
    "empty": ({"gain": ""}, f"for `gain` must have a range like {FORM}, but has ''"),
    "unknown": ({"gian": "0:1"}, "names `gian`, which is no parameter of it; did you mean `gain`?"),
    "tuple": ({"gain": (0, 1)}, "must return a dict of texts, but returns {'gain': (0, 1)}"),
    "list": (["gain"], "must return a dict of texts, but returns ['gain']"),
    "log": ({"gain": "-1:1:log"}, "for `gain` must have LOW > 0 for a logarithmic range, but has -1"),
    "order": ({"gain": "1:0"}, "for `gain` must have a range with LOW < HIGH, but has 1:0"),
    "end": ({"gain": "-1:2"}, "for `gain` cannot be -1.0: Argument `controller.gain` must be >= 0, but is -1.0"),
    "whole": ({"many": "0.2:0.8"}, "for `many` must have a range with a whole number in it, but has '0.2:0.8'"),
    "key": ({"gain.tip_w": "0:1"}, "for `gain`: Argument `gain` must be a number"),
    "table": ({"by_port": "0:1"}, "for `by_port`: Argument `by_port` must be a table, but is 0.5"),
}


def contender(monkeypatch: pytest.MonkeyPatch, search: Any) -> Entry:
    monkeypatch.setattr(Searching, "search", search, raising=False)
    scenario = dampen.read_scenario("he2017", FEW)
    return entry_of(scenario, "tests.test_own_mistakes:Searching", Bench(scenario))


@pytest.mark.parametrize("mistake", list(SEARCHES))
def test_a_mistake_in_search_names_it(mistake: str, monkeypatch: pytest.MonkeyPatch) -> None:
    returned, words = SEARCHES[mistake]
    watched = type("Watched", (Searching,), {"search": lambda self, setting: returned}).search  # type: ignore[attr-defined]
    with pytest.raises(dampen.ArgumentError, match=re.escape(words)) as error:
        contender(monkeypatch, watched)
    assert len(error.value.lines) == 1
    assert ":Searching.search " in str(error.value)


def test_a_law_without_search_is_not_said_to_be_in_the_middle_of_ranges(monkeypatch: pytest.MonkeyPatch) -> None:
    assert contender(monkeypatch, dampen.Controller.search).start.untuned == "defines no `search`"
    assert contender(monkeypatch, lambda self, setting: {}).start.untuned == "its `search` names no gains"
    assert contender(monkeypatch, lambda self, setting: {"gain": "0:2"}).start.untuned == ""
    scenario = dampen.read_scenario("he2017", FEW)
    found = dampen.compare(scenario, ["none", "tests.test_own_mistakes:Misspelt"], budget=0)
    assert [how(c).partition(";")[0] for c in found.contenders[1:]] == [
        "none", "as it is: defines no `search`, so it was not tuned",
    ]  # fmt: skip


def test_an_unknown_variable_is_told_with_those_that_there_are() -> None:
    result = dampen.simulate(scenario_under(Learner(), settings=[*FEW, "task.trials=1"]))
    with pytest.raises(dampen.ArgumentError, match=r"no variable `comand`; did you mean `command`\? Known here: y, .* u,"):
        result["comand"]
    with pytest.raises(KeyError) as error:
        result["feedforward"]
    assert "u" in str(error.value).partition("known here: ")[2].split(", ")
    assert str(error.value).startswith("This result has no variable `feedforward`; known here: y,")


OWN_LAW = """
from typing import Annotated
from annotated_types import Ge, Unit
from typing_extensions import Doc


@dataclass(frozen=True)
class Law(dampen.Controller):
    '''Pushes back.'''

    gain: Annotated[float, Ge(0), Unit("N s/m"), Doc("how hard")] = 2.0

    def law(self, memory, setting):
        return dampen.PortLaw(np.zeros((setting.steps, len(setting.ports))))
"""


def test_own_parameters_are_listed(module: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    name = module(OWN_LAW)
    monkeypatch.chdir(tmp_path)
    lines = listing(f"{name}:Law").splitlines()
    assert lines[0] == f'[controller] kind = "{name}:Law"    Pushes back.'
    assert lines[1].split() == ["gain", "2.0", "N", "s/m", ">=", "0,", "how", "hard"]
    with pytest.raises(dampen.ArgumentError, match=f"Argument `kind` names '{name}:Lew', which cannot be loaded: AttributeError"):
        listing(f"{name}:Lew")
    with pytest.raises(dampen.ArgumentError, match=r"must name a subclass of one of dampen.Plant, .* but '.*:np' is none"):
        listing(f"{name}:np")


def test_a_class_that_is_not_frozen_is_told_at_its_own_line(module: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    name = module(OWN_LAW.replace("(frozen=True)", ""))
    monkeypatch.chdir(tmp_path)
    line = OWN_LAW.splitlines().index("@dataclass(frozen=True)") + 5
    with pytest.raises(dampen.ArgumentError, match=rf"a component must be a frozen dataclass, .* \({name}.py, line {line}\)\.$"):
        listing(f"{name}:Law")


def test_annotations_that_mean_nothing_are_told(module: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    name = module(OWN_LAW.replace("Annotated[float,", "Annotated['flot',"))
    monkeypatch.chdir(tmp_path)
    with pytest.raises(dampen.ArgumentError, match="whose parameters cannot be read: NameError: name 'flot' is not defined"):
        listing(f"{name}:Law")


WRONG_SHAPES: list[tuple[str, type[Any], str, Any, str]] = [
    ("plant", dampen.TimoshenkoBeam, "initial_ports", (), "must give a number for each of 2 ports, but gives 0"),
    (
        "plant",
        dampen.TimoshenkoBeam,
        "initial_state",
        (np.zeros(3), np.zeros(8)),
        r"two arrays of shape \(8,\), but gives \(3,\)",
    ),
    ("disturbance", dampen.NoDisturbance, "at_ports", np.zeros(3), "failed: ValueError"),
    ("disturbance", dampen.NoDisturbance, "base_acceleration", np.zeros(3), "failed: ValueError"),
    ("actuator", dampen.Backlash, "start", (), "must give 1 numbers, but gives 0"),
    ("controller", dampen.DualLoopAILC, "learning_row", np.zeros((1, 1)), "learn failed: IndexError"),
    ("reference", dampen.Hold, "sample", 0.0, r"must give values of shape \(1,\), but gives \(\)"),
]


@pytest.mark.parametrize(("part", "cls", "name", "value", "words"), WRONG_SHAPES, ids=[row[2] for row in WRONG_SHAPES])
def test_wrong_shapes_are_told(part: str, cls: type[Any], name: str, value: Any, words: str) -> None:
    needed = (0.01,) if cls is dampen.Hold else ()
    mine = dataclass(frozen=True)(type("Mine", (cls,), {"__module__": "mine", name: lambda self, *given: value}))(*needed)
    case = dampen.read_scenario("he2017", FEW)

    def run() -> None:
        changed = {"actuator": {"actuators": {"tip_w": (mine,)}}}.get(part, {part: mine})
        if part == "reference":
            changed = {"task": replace(case.task, reference={"tip_w": mine})}
        dampen.simulate(replace(case, **changed))

    with pytest.raises(dampen.ArgumentError, match=f"mine:Mine.*{words}") as error:
        run()
    assert len(error.value.lines) == 1


def test_a_contender_is_refused_with_the_question_that_ends_its_complaint(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(dampen.ArgumentError, match=r"cannot be run here: .*; did you mean `gain`\?$"):
        contender(monkeypatch, lambda self, setting: {"gian": "0:1"})


KINDS_MISNAMED = {
    "{}.Law": "must be a known kind of controller, but is '{0}.Law'; did you mean `{0}:Law`, with a colon?",
    "{}.py:Law": "must name a module without .py, '{0}:Law', but is '{0}.py:Law'.",
    "{}:Lawn": "AttributeError: module '{0}' has no attribute 'Lawn' (did you mean `Law`?).",
}


@pytest.mark.parametrize("kind", KINDS_MISNAMED)
def test_the_name_of_an_own_kind_that_slipped(kind: str, module: Any, tmp_path: Path) -> None:
    name = module(OWN_LAW)
    (tmp_path / "mine.toml").write_text(f'based_on = "he2017"\n[controller]\nkind = "{kind.format(name)}"\n')
    with pytest.raises(dampen.ArgumentError) as error:
        dampen.read_scenario(tmp_path / "mine.toml")
    (line,) = error.value.lines
    assert line.endswith(KINDS_MISNAMED[kind].format(name))


def test_a_method_for_a_property_is_told_at_its_class(module: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    name = module(OWN_LAW + "    def relies_on(self):\n        return ()\n")
    monkeypatch.chdir(tmp_path)
    line = OWN_LAW.splitlines().index("@dataclass(frozen=True)") + 5
    with pytest.raises(dampen.ArgumentError, match=rf"write @property above it \({name}.py, line {line + 1}\)\.$"):
        listing(f"{name}:Law")


@pytest.mark.parametrize(
    ("read", "told"),
    [
        (lambda trial, setting: trial.e, "no attribute 'e' (known here: command, error, index, v) ("),
        (lambda trial, setting: trial.comand, "no attribute 'comand' (did you mean `command`?) ("),
        (lambda trial, setting: setting.step, "no attribute 'step' (did you mean `steps`?) ("),
        (lambda trial, setting: trial.v.shap, "no attribute 'shap' (did you mean `shape`?) ("),
    ],
)
def test_an_attribute_that_is_not_there_is_told_with_those_that_are(read: Any, told: str) -> None:
    case = dampen.read_scenario("he2017", FEW)
    mine = own_class(dampen.Controller, learn=lambda self, memory, trial, setting: read(trial, setting))
    with pytest.raises(dampen.ArgumentError, match=re.escape(told)):
        mine.learn({}, dampen.Trial(0, *(np.zeros((2, 2)),) * 3), setting_of(case))


@pytest.mark.parametrize("shape", ["foo", None, 3])
@pytest.mark.parametrize("as_field", [True, False])
def test_a_plain_value_for_a_property_is_checked(shape: Any, as_field: bool) -> None:
    hints = {"__annotations__": {"barrier_shape": Any}} if as_field else {}
    members = {"__module__": __name__, "barrier_shape": shape, **hints}
    mine = dataclass(frozen=True)(type("Mine", (dampen.NoControl,), members))
    with pytest.raises(dampen.ArgumentError, match=rf'barrier_shape must be "log", "tan" or "none", but is {shape!r}\.$'):
        mine()


@dataclass(frozen=True)
class Sampled(dampen.SampledFeedback):
    """A law of samples that does nothing, with a row and a loop that are put in."""

    loop: tuple[int, ...] = (24, 24)
    shape: tuple[int, ...] = (1,)

    def row(self, setting: Any) -> Any:
        return np.zeros(self.shape)

    def sampled_loop(self, setting: Any) -> Any:
        return SampledLoop(np.zeros(self.loop), 1)

    @staticmethod
    def step(sample: Any, state: Any, row: Any, command: Any) -> None:
        command[0] = row[0]


SAMPLED = ["numerics.mode=sampled", "sampling.period=0.01"]


@pytest.mark.parametrize("shape", [(2, 2, 2), (3, 3), (16, 17), ()])
def test_a_loop_of_another_shape_is_told(shape: tuple[int, ...]) -> None:
    with pytest.raises(
        dampen.ArgumentError, match=r"Sampled.sampled_loop must give a finite square matrix of at least 16 rows"
    ) as e:
        rates(scenario_under(Sampled(loop=shape), settings=[*FEW, *SAMPLED]))
    assert str(e.value).endswith(f"but gives one of shape {shape}.")


def test_a_row_must_be_one() -> None:
    with pytest.raises(dampen.ArgumentError, match=r"Sampled.row must give a row of numbers, but gives .* \(2, 2, 2\)\.$"):
        dampen.simulate(scenario_under(Sampled(shape=(2, 2, 2)), settings=[*FEW, *SAMPLED]))
