"""Units for co-simulation: valid, the sampled run in closed loop, and honest about what they cannot do."""

from __future__ import annotations

import os
import runpy
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import dampen
from dampen.archive import whole_file
from dampen.cli import main
from dampen.export.c.blueprint import Guards
from dampen.export.fmu import plant as plants
from dampen.export.fmu.building import compiler, platform_folder
from dampen.export.fmu.plant import adjustable
from dampen.export.linear import linear_model
from dampen.plants.assembled import AssembledPort
from dampen.scenarios.read import read_scenario
from dampen.simulation.bench import Bench
from dampen.simulation.scenario import Scenario

fmpy = pytest.importorskip("fmpy")
if compiler() is None:
    pytest.skip("no C compiler here", allow_module_level=True)

from fmpy.fmi2 import FMU2Slave  # noqa: E402
from fmpy.validation import validate_fmu  # noqa: E402

SHORT = ["task.trials=3", "task.trial_duration=0.4", "numerics.modes=12"]
QUIET = ["sampling.noise={}", "sampling.quantum={}"]
# The law takes Sgn within a layer where nothing quantises: what rounding does to a switching law grows from sample to sample.
CASES = {
    "paper": ("he2017-sampled", SHORT),
    "explicit": ("he2017-sampled", [*SHORT, "sampling.switching=explicit"]),
    "direct": ("he2017-sampled", [*SHORT, "controller.compensate=false"]),
    "no delay": ("he2017-sampled", [*SHORT, "sampling.delay=0", "sampling.switching=boundary-layer"]),
    "half a period": ("he2017-sampled", [*SHORT, "numerics.step=0.00025", "sampling.delay=0.0005"]),
    "three periods": ("he2017-sampled", [*SHORT, "numerics.step=0.0005", "sampling.delay=0.0025"]),
    "reset": ("he2017-sampled", [*SHORT, "task.start=reset", "task.reset_error={tip_w=1e-4,tip_phi=1e-4}"]),
    "quiet": ("he2017-sampled", [*SHORT, *QUIET, "sampling.switching=boundary-layer"]),
    "moving": (
        "flexible-arm-point-to-point",
        ["task.trials=3", "numerics.mode=sampled", "sampling.period=0.004", "sampling.delay=0.004"],
    ),
    "wing": ("assembled-from-fe", ["task.trials=2", "task.trial_duration=0.5"]),
    "hysteresis": ("he2017-hysteresis", [*SHORT, "numerics.mode=sampled", "sampling.quantum={tip_w=1e-6,tip_phi=1e-6}"]),
    "rope": ("string-tip-mass", ["task.trials=2", "numerics.mode=sampled", "sampling.quantum={tip_w=1e-6}"]),
    "boom": (
        "euler-bernoulli-payload",
        ["task.trials=2", "task.trial_duration=0.5", "numerics.mode=sampled", "sampling.quantum={tip_w=1e-7,tip_phi=1e-7}"],
    ),
}


@cache
def scenario(case: str) -> Scenario:
    name, changes = CASES[case]
    return read_scenario(name, changes)


@pytest.fixture(scope="module")
def units(tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Units of the cases, written once."""
    folder = tmp_path_factory.mktemp("units")

    @cache
    def unit(case: str, what: str) -> Path:
        return dampen.export_fmu(scenario(case), folder / f"{case.replace(' ', '-')}-{what}.fmu", what).file

    return unit


class Running:
    """A unit in FMPy, its variables by name."""

    def __init__(self, file: Path, folder: str, name: str = "unit"):
        about = fmpy.read_model_description(str(file))
        identifier = about.coSimulation.modelIdentifier
        self.slave = FMU2Slave(guid=about.guid, unzipDirectory=folder, modelIdentifier=identifier, instanceName=name)
        self.names = {v.name: v.valueReference for v in about.modelVariables}
        self.slave.instantiate()

    def begin(self, start: float = 0.0) -> None:
        self.slave.setupExperiment(startTime=start)
        self.slave.enterInitializationMode()
        self.slave.exitInitializationMode()

    def get(self, *names: str) -> np.ndarray:
        return np.array(self.slave.getReal([self.names[name] for name in names]))

    def put(self, values: dict[str, float]) -> None:
        self.slave.setReal([self.names[name] for name in values], list(values.values()))

    def whole(self, name: str) -> int:
        return int(self.slave.getInteger([self.names[name]])[0])

    def step(self, at: float, step: float) -> None:
        self.slave.doStep(at, step)


@contextmanager
def running(file: Path, begin: bool = True) -> Iterator[Running]:
    folder = fmpy.extract(str(file))
    unit = Running(file, folder)
    try:
        if begin:
            unit.begin()
        yield unit
    finally:
        unit.slave.freeInstance()
        shutil.rmtree(folder)


def each(name: str, case: Scenario) -> list[str]:
    return [f"{name}.{port}" for port in case.ports]


def displaced(result: Any) -> np.ndarray:
    """(steps of all trials, ports) as the run has them after each step."""
    return np.concatenate(np.asarray(result["y"])[:, 1:])


def without_ends(rows: np.ndarray, case: Scenario, length: int) -> np.ndarray:
    """Rows without the last of each trial where trials start anew: the unit has gone back to the start by then."""
    return rows if case.task.start == "chained" else np.delete(rows, np.s_[length - 1 :: length], 0)


def followed(unit: Running, case: Scenario, steps: int, names: Sequence[str]) -> np.ndarray:
    dt, seen = case.numerics.step, []
    for k in range(steps):
        unit.step(k * dt, dt)
        seen.append(unit.get(*names))
    return np.array(seen)


def together(plant: Running, controller: Running, case: Scenario, step: float, first: bool = False) -> np.ndarray:
    """Plant and controller side by side, as a master runs them; displacements at every communication point. first: the
    controller steps first, and the plant has what it puts out at once."""
    drives, readings = each("drive", case), each("reading", case)
    readings += [name for name in each("last_reading", case) if name in controller.names]
    count = round(case.steps * case.task.trials * case.numerics.step / step)
    seen = []
    for k in range(count):
        reading, drive = plant.get(*readings), controller.get(*drives)
        controller.put(dict(zip(readings, reading, strict=True)))
        if first:
            controller.step(k * step, step)
            drive = controller.get(*drives)
        plant.put(dict(zip(drives, drive, strict=True)))
        plant.step(k * step, step)
        if not first:
            controller.step(k * step, step)
        seen.append(plant.get(*each("displacement", case)))
    return np.array(seen)


@pytest.mark.parametrize("what", ["plant", "controller", "loop"])
@pytest.mark.parametrize("case", CASES)
def test_units_are_valid(case: str, what: str, units: Any) -> None:
    assert validate_fmu(str(units(case, what))) == []


@pytest.mark.parametrize("case", CASES)
def test_the_loop_is_the_sampled_run(case: str, units: Any) -> None:
    its = scenario(case)
    result = dampen.simulate(its)
    run = displaced(result)
    with running(units(case, "loop")) as unit:
        seen = followed(unit, its, len(run), [*each("displacement", its), "energy"])
        assert unit.whole("status") == 0
    expected = np.column_stack([run, np.concatenate(np.asarray(result["energy"])[:, 1:])])
    seen, expected = (without_ends(rows, its, its.steps) for rows in (seen, expected))
    assert np.all(np.abs(seen - expected).max(axis=0) < 1e-9 * np.abs(expected).max(axis=0))


@pytest.mark.parametrize(
    "case", ["explicit", "direct", "half a period", "three periods", "reset", "moving", "wing", "hysteresis"]
)
def test_plant_and_controller_together_are_the_sampled_run(case: str, units: Any) -> None:
    its = scenario(case)
    run = displaced(dampen.simulate(its))
    about = fmpy.read_model_description(str(units(case, "controller")))
    step = float(about.defaultExperiment.stepSize)
    with running(units(case, "plant")) as plant, running(units(case, "controller")) as controller:
        seen = together(plant, controller, its, step, first=its.sampling.delay == 0)
    every = round(step / its.numerics.step)
    seen, expected = (without_ends(rows, its, its.steps // every) for rows in (seen, run[every - 1 :: every]))
    assert np.abs(seen - expected).max() < 1e-9 * np.abs(run).max()


def test_all_trials_of_the_papers_experiment_by_the_example() -> None:
    example = runpy.run_path(str(Path(__file__).parents[1] / "examples" / "cosimulation.py"))
    assert example["main"]() < 1e-9


def test_without_delay_an_ordinary_master_adds_a_communication_step(units: Any) -> None:
    its = scenario("no delay")
    with running(units("no delay", "plant")) as plant, running(units("no delay", "controller")) as controller:
        at_once = together(plant, controller, its, 0.001, first=True)
    with running(units("no delay", "plant")) as plant, running(units("no delay", "controller")) as controller:
        late = together(plant, controller, its, 0.001)
    assert np.abs(at_once - displaced(dampen.simulate(its))).max() < 1e-9
    delayed = displaced(dampen.simulate(replace(its, sampling=replace(its.sampling, delay=0.001))))
    assert np.abs(late - delayed).max() < 1e-9
    assert np.abs(late - at_once).max() > 1e-6


def test_longer_communication_steps_make_no_difference_to_a_loop(units: Any) -> None:
    its = scenario("paper")
    run = displaced(dampen.simulate(its))
    with running(units("paper", "loop")) as unit:
        unit.step(0.0, 0.05)
        unit.step(0.05, 0.35)
        unit.step(0.4, 0.3)
        assert np.abs(unit.get(*each("displacement", its)) - run[699]).max() < 1e-9


def test_states_can_be_taken_and_given_back(units: Any) -> None:
    its = scenario("paper")
    names = [*each("displacement", its), *each("command", its)]
    with running(units("paper", "loop")) as unit:
        unit.step(0.0, 0.3)
        state = unit.slave.getFMUState()
        stored = unit.slave.serializeFMUstate(state)
        unit.step(0.3, 0.3)
        expected = unit.get(*names)
        unit.slave.setFMUState(state)
        unit.slave.freeFMUState(state)
        unit.step(0.3, 0.3)
        assert np.array_equal(unit.get(*names), expected)
        with running(units("paper", "loop")) as other:
            again = other.slave.deSerializeFMUstate(stored)
            other.slave.setFMUState(again)
            other.step(0.3, 0.3)
            assert np.array_equal(other.get(*names), expected)
        unit.slave.reset()
        unit.begin()
        unit.step(0.0, 0.6)
        assert np.array_equal(unit.get(*names), expected)


def test_a_state_given_back_is_the_whole_state(units: Any) -> None:
    its = scenario("paper")
    names = [*each("displacement", its), *each("command", its)]
    with running(units("paper", "loop"), begin=False) as unit:
        unit.slave.setupExperiment(startTime=7.0)
        unit.slave.enterInitializationMode()
        before = unit.slave.getFMUState()
        unit.slave.exitInitializationMode()
        unit.step(7.0, 0.1)
        running_state = unit.slave.getFMUState()
        unit.step(7.1, 0.1)
        expected = unit.get(*names)
        unit.slave.terminate()
        unit.slave.reset()
        unit.slave.setFMUState(running_state)  # at 7.1 s, and it steps
        unit.step(7.1, 0.1)
        assert np.array_equal(unit.get(*names), expected)
        unit.slave.setFMUState(before)  # not begun: fixed parameters can be set
        unit.put({"start.q[1]": 0.0})
        unit.slave.exitInitializationMode()
        unit.step(7.0, 0.2)
        assert not np.array_equal(unit.get(*names), expected)


@pytest.mark.parametrize("exact", [True, False])
def test_communication_points_are_rounded_far_from_zero(exact: bool, units: Any) -> None:
    its, start, step, count = scenario("paper"), 1e8, 0.001, 1000
    run = displaced(dampen.simulate(its))
    with running(units("paper", "loop"), begin=False) as unit:
        unit.begin(start)
        at = start
        for k in range(count):
            after = start + (k + 1) * step if exact else at + step
            unit.step(at, after - at if exact else step)
            at = after
        assert np.abs(unit.get(*each("displacement", its)) - run[count - 1]).max() < 1e-9
        with pytest.raises(fmpy.fmi1.FMICallException):
            unit.step(at + step, step)


def test_a_compensation_that_moves_in_time_is_seen_at_every_step(tmp_path: Path) -> None:
    changes = [*SHORT, "task.trial_duration=0.1", "controller.compensate=false", "sampling.period=0.002", "sampling.delay=0.002"]
    fading = dampen.Effectiveness(times=(0.05, 0.1), values=(1.0, 0.2))
    chain = {"tip_w": (fading, dampen.FirstOrderLag(0.005))}
    its = replace(read_scenario("he2017-sampled", changes), compensation=chain)
    run = displaced(dampen.simulate(its, compile=False))
    plant, controller = (dampen.export_fmu(its, tmp_path / f"{what}.fmu", what) for what in ("plant", "controller"))
    assert controller.step == plant.step == 0.001
    with running(plant.file) as one, running(controller.file, begin=False) as other:
        other.get(*each("drive", its))  # to look at it changes nothing
        other.begin()
        assert np.abs(together(one, other, its, 0.001) - run).max() < 1e-9 * np.abs(run).max()


def test_three_ports_of_odd_names(tmp_path: Path) -> None:
    names = ('a"<b>', "b & c", "d */ \N{GREEK SMALL LETTER PI}")
    stiffness = 2000 * (2 * np.eye(4) - np.eye(4, k=1) - np.eye(4, k=-1))
    plant = dampen.Assembled(
        mass=0.5 * np.eye(4), stiffness=stiffness, port_vectors=np.eye(4)[1:],
        port=tuple(AssembledPort(name) for name in names),
    )  # fmt: skip
    gains, quantum = dict.fromkeys(names, 0.3), dict.fromkeys(names, 1e-7)
    its = Scenario(
        plant=plant,
        controller=dampen.PTypeILC(learning=gains),
        disturbance=dampen.ConstantLoad(force={names[0]: 0.2}),
        task=dampen.Task(trials=3, trial_duration=0.1),
        sampling=dampen.Sampling(delay=0.001, quantum=quantum, switching="boundary-layer"),
        numerics=dampen.Numerics(mode="sampled", modes=4),
        title="bell \a and <quotes>",
    )
    run = displaced(dampen.simulate(its, compile=False))
    assert np.abs(run).max() > 1e-5
    files = [dampen.export_fmu(its, tmp_path / f"{what}.fmu", what).file for what in ("plant", "controller", "loop")]
    assert [validate_fmu(str(file)) for file in files] == [[], [], []]
    with running(files[0]) as one, running(files[1]) as other:
        assert np.abs(together(one, other, its, 0.001) - run).max() < 1e-9 * np.abs(run).max()


def test_a_loop_stops_where_the_constraint_is_crossed_and_can_be_told_not_to(tmp_path: Path) -> None:
    load = "disturbance={kind='constant',force={tip_w=40.0}}"
    its = read_scenario("string-tip-mass", [*CASES["rope"][1], "task.trial_duration=0.5", "controller.barrier=none", load])
    result = dampen.simulate(its)
    run = displaced(result)
    assert result.status == "constraint_lost"
    for going, status in ((False, 5), (True, 0)):
        file = dampen.export_fmu(its, tmp_path / "unit.fmu", "loop", Guards(stop_at_constraint=not going)).file
        with running(file) as unit:
            seen = followed(unit, its, len(run), each("displacement", its))
            assert unit.whole("status") == status
        assert (np.abs(seen - run).max() < 1e-9) == going


def test_initial_values_of_a_plant_depend_on_its_parameters_and_on_no_input(units: Any) -> None:
    with zipfile.ZipFile(units("reset", "plant")) as packed:
        root = ElementTree.fromstring(packed.read("modelDescription.xml"))
    variables = {str(i): v.attrib for i, v in enumerate(root.iter("ScalarVariable"), 1)}
    known = {
        variables[unknown.attrib["index"]]["name"]: {variables[i]["name"] for i in unknown.attrib["dependencies"].split()}
        for unknown in root.iterfind("ModelStructure/InitialUnknowns/Unknown")
    }
    assert {"start.q[1]", "quantum.tip_w"} <= known["reading.tip_w"]
    assert known["trial"] == set()
    inputs = {v["name"]: float(k) for k, v in enumerate(variables.values(), 1) if v["causality"] == "input"}
    outputs = [name for name in known if name not in ("trial", "sample")]
    with running(units("reset", "plant"), begin=False) as unit:
        unit.slave.setupExperiment(startTime=0.0)
        unit.slave.enterInitializationMode()
        before = unit.get(*outputs)
        unit.put(inputs)
        assert np.array_equal(unit.get(*outputs), before)
        unit.put({"start.q[1]": 1.0})
        assert unit.get("reading.tip_w") != before[outputs.index("reading.tip_w")]


def test_parameters_do_what_the_scenarios_do(units: Any) -> None:
    changes = {
        "actuator.tip_w.backlash.right": "actuator.tip_w.chain=[{kind='backlash',slope=0.3,right=0.15,left=-0.2}]",
        "law.tip_phi.limit": "sampling.command_limit={tip_phi=0.3}",
        "quantum.tip_w": "sampling.quantum={tip_w=1e-4,tip_phi=1e-6}",
    }
    values = {"actuator.tip_w.backlash.right": 0.15, "law.tip_phi.limit": 0.3, "quantum.tip_w": 1e-4}
    for name, change in changes.items():
        its = read_scenario("he2017-sampled", [*SHORT, "controller.compensate=false", change])
        assert its != scenario("direct")
        run = displaced(dampen.simulate(its))
        with running(units("direct", "loop"), begin=False) as unit:
            unit.put({name: values[name]})
            unit.begin()
            seen = followed(unit, its, len(run), each("displacement", its))
        assert np.abs(seen - run).max() < 1e-9, name
        assert np.abs(run - displaced(dampen.simulate(scenario("direct")))).max() > 1e-6


def test_gains_can_be_turned_while_it_runs(units: Any) -> None:
    its = scenario("direct")
    with running(units("direct", "loop")) as unit, running(units("direct", "loop")) as other:
        for one in (unit, other):
            one.step(0.0, 0.2)
        before = unit.get("law.tip_w.damping")
        assert before > 0
        other.put({"law.tip_w.damping": 3.0})
        for one in (unit, other):
            one.step(0.2, 0.2)
        apart = unit.get(*each("displacement", its)) - other.get(*each("displacement", its))
        assert np.abs(apart).max() > 1e-6
        assert unit.get("law.tip_w.damping") == before


def test_loads_can_be_taken_away_and_given_from_outside(units: Any) -> None:
    plain = ["task.trials=1", "controller={kind='none'}"]
    pushed = read_scenario("string-tip-mass", [*plain, "disturbance={kind='constant',force={tip_w=0.3}}"])
    run = displaced(dampen.simulate(pushed))
    with running(units("rope", "plant"), begin=False) as unit:
        unit.put({"disturbance": 0.0, "force.tip_w": 0.3})
        unit.begin()
        seen = followed(unit, pushed, pushed.steps, each("displacement", pushed))
    assert np.abs(seen - run).max() < 1e-9 * np.abs(run).max()


def test_the_base_can_be_shaken_from_outside(units: Any) -> None:
    its = scenario("rope")
    model = linear_model(its, inputs=("base",), dt=its.numerics.step)
    state, expected = np.zeros(len(model.a)), []
    for _ in range(500):
        state = model.a @ state + model.b @ [0.7]
        expected.append(model.c @ state)
    with running(units("rope", "plant"), begin=False) as unit:
        unit.put({"disturbance": 0.0, "base_acceleration": 0.7})
        unit.put({name: 0.0 for name in unit.names if name.startswith("start.")})
        unit.begin()
        seen = followed(unit, its, 500, each("displacement", its))
    assert np.abs(seen - expected).max() < 1e-9 * np.abs(expected).max()


@pytest.mark.parametrize("what", ["plant", "controller", "loop"])
def test_bad_calls_are_refused(what: str, units: Any) -> None:
    with running(units("paper", what)) as unit:
        for at, step in ((0.0, 0.00015), (0.5, 0.001), (0.0, -0.001), (0.0, float("nan")), (0.0, 1e30)):
            with pytest.raises(fmpy.fmi1.FMICallException):
                unit.step(at, step)
        unit.step(0.0, 0.001)
        with pytest.raises(fmpy.fmi1.FMICallException):
            unit.step(0.0, 0.001)
        with pytest.raises(fmpy.fmi1.FMICallException):
            unit.slave.setupExperiment(startTime=5.0)
        with pytest.raises(fmpy.fmi1.FMICallException):
            unit.slave.setReal([10_000], [0.0])
        with pytest.raises(fmpy.fmi1.FMICallException):
            unit.slave.getReal([10_000])
        shown = "drive.tip_w" if what == "controller" else "displacement.tip_w"
        with pytest.raises(fmpy.fmi1.FMICallException):
            unit.put({shown: 0.0})
        fixed = {"plant": "start.q[1]", "loop": "start.q[1]", "controller": None}[what]
        if fixed:
            with pytest.raises(fmpy.fmi1.FMICallException):
                unit.put({fixed: 0.0})
        if what == "controller":
            with pytest.raises(fmpy.fmi1.FMICallException):
                unit.step(0.001, 0.002)
            with pytest.raises(fmpy.fmi1.FMICallException):
                unit.put({"law.tip_w.edge": 1.0})
            with pytest.raises(fmpy.fmi1.FMICallException):
                unit.put({"law.tip_w.damping": float("nan")})


def test_a_controller_that_stops_says_so(units: Any) -> None:
    with running(units("paper", "controller")) as unit:
        unit.put({"reading.tip_w": float("nan"), "reading.tip_phi": 0.0})
        for k in range(20):
            unit.step(k * 0.001, 0.001)
        assert unit.whole("status") == 4
        assert np.array_equal(unit.get("drive.tip_w", "drive.tip_phi"), [0.0, 0.0])


def test_tables_and_description_must_belong_to_the_library(units: Any, tmp_path: Path) -> None:
    folder = Path(fmpy.extract(str(units("paper", "plant")), str(tmp_path / "unit")))
    file = units("paper", "plant")
    table = folder / "resources" / "tables.bin"
    whole = table.read_bytes()
    for bad in (whole[:-8], b"x" + whole[1:], b""):
        table.write_bytes(bad)
        with pytest.raises(Exception, match="instantiate"):
            Running(file, str(folder))
    table.unlink()
    with pytest.raises(Exception, match="instantiate"):
        Running(file, str(folder))
    table.write_bytes(whole)
    about = fmpy.read_model_description(str(file))
    slave = FMU2Slave(guid="other", unzipDirectory=str(folder), modelIdentifier=about.coSimulation.modelIdentifier)
    with pytest.raises(Exception, match="instantiate"):
        slave.instantiate()


def test_a_unit_is_the_same_file_again_and_carries_its_scenario(units: Any, tmp_path: Path) -> None:
    again = dampen.export_fmu(scenario("paper"), tmp_path / "again.fmu", "loop").file
    assert again.read_bytes() == units("paper", "loop").read_bytes()
    with zipfile.ZipFile(again) as packed:
        names = packed.namelist()
        (tmp_path / "scenario.toml").write_bytes(packed.read("resources/scenario.toml"))
        page = packed.read("documentation/index.html").decode()
    assert read_scenario(str(tmp_path / "scenario.toml")) == scenario("paper")
    assert any(name.startswith(f"binaries/{platform_folder()}/") for name in names)
    assert "actuator.tip_w.backlash.slope" in page


def test_sources_can_go_alone(tmp_path: Path) -> None:
    unit = dampen.export_fmu(scenario("paper"), tmp_path / "unit.fmu", "controller", build=False)
    assert not unit.built
    assert validate_fmu(str(unit.file)) == []
    with zipfile.ZipFile(unit.file) as packed:
        assert not [name for name in packed.namelist() if name.startswith("binaries/")]


@pytest.mark.parametrize("name", [name for name in ("gcc", "clang") if shutil.which(name)])
@pytest.mark.parametrize("what", ["plant", "controller", "loop"])
@pytest.mark.parametrize("case", ["paper", "wing", "moving", "rope", "three periods"])
def test_sources_are_clean_for_strict_compilers(case: str, what: str, name: str, units: Any, tmp_path: Path) -> None:
    with zipfile.ZipFile(units(case, what)) as packed:
        packed.extractall(tmp_path)
    files = sorted(map(str, (tmp_path / "sources").glob("*.c")))
    strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-DFMI2_FUNCTION_PREFIX=beam_"]
    done = subprocess.run([name, *strict, "-O1", "-c", *files], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


HARNESS = """
#include "fmi2.c"
static unsigned long seed = 1;
static double any(void) /* numbers of all sizes, and none */
{
    seed = seed * 6364136223846793005ul + 1442695040888963407ul;
    const unsigned long bits = seed ^ seed >> 29;
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}
int main(int count, char **arguments)
{
    fmi2FMUstate kept = NULL;
    char bytes[sizeof(struct state)];
    fmi2CallbackFunctions none = {NULL, NULL, NULL, NULL, NULL};
    struct unit *u = fmi2Instantiate("unit", fmi2CoSimulation, arguments[count - 2], arguments[count - 1], &none, 0, 0);
    if (!u) return 2;
    if (fmi2Instantiate("unit", fmi2CoSimulation, "other", arguments[count - 1], &none, 0, 0)) return 3;
    const char *bad[] = {"", "%", "%2", "file:", "file:%2", "file:///no%", "file://no", "file:///%zz%00"};
    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++)
        fmi2FreeInstance(fmi2Instantiate("unit", fmi2CoSimulation, arguments[count - 2], bad[i], &none, 0, 0));
    fmi2FreeInstance(fmi2Instantiate(NULL, fmi2CoSimulation, arguments[count - 2], NULL, NULL, 0, 0));
    for (int round = 0; round < 3; round++) {
        fmi2SetupExperiment(u, 0, 0, 0, 0, 0);
        fmi2EnterInitializationMode(u);
        fmi2ExitInitializationMode(u);
        for (int k = 0; k < 3000; k++) {
            for (unsigned i = 0; i < REALS; i++) {
                const double value = k % 7 ? 0.0 : any();
                if (REAL[i].kind == INPUT) fmi2SetReal(u, &i, 1, &value);
            }
            const double step = MODEL_SECONDS;
            if (fmi2DoStep(u, k * step, step, 1)) return 4;
            if (k == 1000 && (fmi2GetFMUstate(u, &kept) || fmi2SerializeFMUstate(u, kept, bytes, sizeof bytes))) return 5;
        }
        if (fmi2DeSerializeFMUstate(u, bytes, sizeof bytes, &kept) || fmi2SetFMUstate(u, kept)) return 6;
        fmi2FreeFMUstate(u, &kept);
        fmi2DoStep(u, 0.5, 1e300, 1);
        fmi2Reset(u);
    }
    fmi2FreeInstance(u);
    return 0;
}
"""


@pytest.mark.parametrize("name", [name for name in ("gcc", "clang") if shutil.which(name)])
@pytest.mark.parametrize("what", ["plant", "controller", "loop"])
@pytest.mark.parametrize("case", ["reset", "rope", "three periods"])
def test_units_run_clean_under_the_compilers_checks(case: str, what: str, name: str, units: Any, tmp_path: Path) -> None:
    with zipfile.ZipFile(units(case, what)) as packed:
        packed.extractall(tmp_path / "a unit")  # a blank in the path, as URIs have it
    sources = tmp_path / "a unit" / "sources"
    (sources / "harness.c").write_text(HARNESS)
    files = [str(file) for file in sorted(sources.glob("*.c")) if file.name != "fmi2.c"]
    checked = ["-std=c99", "-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
    subprocess.run([name, *checked, *files, "-o", str(tmp_path / "harness"), "-lm"], check=True)
    about = fmpy.read_model_description(str(units(case, what)))
    uri = (tmp_path / "a unit" / "resources").as_uri()
    done = subprocess.run([str(tmp_path / "harness"), about.guid, uri], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_only_parameters_that_stand_as_they_are_can_be_changed() -> None:
    assert dict(adjustable(dampen.Backlash(), 1e-3)) == {"slope": 0, "right": 1, "left": 2}
    assert dict(adjustable(dampen.FirstOrderLag(), 1e-3)) == {}
    assert set(dict(adjustable(dampen.Saturation(low=-1.0, high=2.0), 1e-3))) == {"slope", "low", "high"}


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["he2017-sampled", "--out", "unit.zip"], "must end in .fmu"),
        (["he2017-sampled", "--out", "unit.fmu", "--what", "all"], "`--what` must be plant, controller or loop, but is 'all'"),
        (["he2017", "--out", "unit.fmu"], '`numerics.mode` must be "sampled"'),
        (["he2017-sampled", "--out", "no/such/unit.fmu"], "cannot be written: there is no folder no/such."),
        (["he2017-sampled", "--out", "unit.fmu", "--range", "tip_w"], "PORT=LOW:HIGH"),
        (["he2017-sampled", "--out", "unit.fmu", "--what", "plant", "--range", "tip_w=0:1"], "`--range` is for a controller"),
    ],
)
def test_bad_input_is_one_line(
    arguments: list[str], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert command(monkeypatch, arguments) == 2
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1
    assert said in lines[0]
    assert list(tmp_path.iterdir()) == []


def test_the_command_writes_a_unit(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "beam.fmu"
    assert command(monkeypatch, ["he2017", "--what", "plant", "--set", "task.trials=1", "--out", str(out)]) == 0
    assert "Communication points at multiples of 0.001 s" in capsys.readouterr().out.replace("\n", " ")
    assert validate_fmu(str(out)) == []


def test_the_compiler_is_what_the_environment_says(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    found = compiler()
    assert found is not None
    monkeypatch.setenv("CC", f"{found[0]} -DA='a b'")
    assert compiler() == [found[0], "-DA=a b"]
    blank = tmp_path / "my cc"
    blank.write_text("#!/bin/sh\nprintf 'warning\\n\\377 error: no\\n' >&2\nexit 1\n")
    blank.chmod(0o755)
    out = tmp_path / "unit.fmu"
    for named, said in (
        (str(blank), "could not build the unit; it said: \ufffd error: no"),
        ("nowhere -m64", "`CC` must name a C compiler, but is 'nowhere -m64'"),
        ("'", "`CC` must name a C compiler"),
    ):
        monkeypatch.setenv("CC", named)
        with pytest.raises(dampen.ArgumentError, match=said):
            dampen.export_fmu(scenario("paper"), out, "controller")
    monkeypatch.delenv("CC")
    monkeypatch.setattr("dampen.export.fmu.building.TemporaryDirectory", lambda: (_ for _ in ()).throw(OSError("no room")))
    with pytest.raises(dampen.ArgumentError, match=r"cannot be built by .*: no room"):
        dampen.export_fmu(scenario("paper"), out, "controller")
    assert list(tmp_path.iterdir()) == [blank]


def test_a_file_is_written_whole_or_not_at_all(tmp_path: Path) -> None:
    out = tmp_path / "unit.fmu"
    with whole_file(out) as file:
        file.write(b"old")

    def cut_short() -> None:
        with whole_file(out) as file:
            file.write(b"newer"[:2])
            raise OSError(28, os.strerror(28))

    with pytest.raises(dampen.ArgumentError, match="cannot be written: No space left"):
        cut_short()
    assert [file.read_bytes() for file in tmp_path.iterdir()] == [b"old"]


def test_tables_beyond_the_limit_are_refused(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    its = scenario("paper")
    numbers = sum(table.size for table in plants.Plant(its, Bench(its)).tables.values())
    assert numbers > its.steps * len(its.ports) * its.task.trials  # what is spread along the structure counts too
    monkeypatch.setattr(plants, "LARGEST", 8 * numbers - 8)
    with pytest.raises(dampen.ArgumentError, match="`task` must be shorter"):
        dampen.export_fmu(its, tmp_path / "unit.fmu", "plant")
    assert list(tmp_path.iterdir()) == []


def command(monkeypatch: pytest.MonkeyPatch, arguments: list[str]) -> int:
    monkeypatch.setattr(sys, "argv", ["dampen", "export", "fmu", *arguments])
    with pytest.raises(SystemExit) as done:
        main()
    return int(done.value.code or 0)
