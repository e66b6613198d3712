"""The sampled controller as C: the same commands as the simulation's, clean under compilers' checks, safe whatever it reads."""

from __future__ import annotations

import math
import os
import subprocess
import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

import dampen
from dampen.component import ArgumentError
from dampen.export.c.blueprint import Guards, blueprint
from dampen.export.c.footprint import footprint
from dampen.export.c.recording import record
from dampen.export.c.rounding import linear_gains
from dampen.export.c.source import macros, source_of
from dampen.export.c.write import export_c
from dampen.scenarios.read import shipped
from dampen.signals.base import Signal
from dampen.simulation.bench import Bench
from dampen.simulation.compiled import bind
from dampen.simulation.digital import Sample
from tests.c_bench import CHECKED, COMPILERS, built, compile_c, recorded, stated_bound, written

pytestmark = pytest.mark.skipif(not COMPILERS, reason="no C compiler here")

SAMPLED = "numerics.mode=sampled"
LIMITS = "sampling.command_limit={tip_w=6.0,tip_phi=6.0}"
LEARNING = "controller.learning={tip_w=0.5,tip_phi=0.3}"
FEEDBACK = "controller.damping={tip_w=2.0,tip_phi=2.0}"
ARM = ("flexible-arm-point-to-point", SAMPLED, "task.trials=3", "sampling.period=0.004", "sampling.delay=0.004")
CASES: dict[str, tuple[str, ...]] = {
    "implicit": ("he2017-sampled",),
    "explicit": ("he2017-sampled", "sampling.switching=explicit"),
    "boundary-layer": ("he2017-sampled", "sampling.switching=boundary-layer"),
    "tuned": ("he2017-tuned", SAMPLED),
    "tuned-implicit": ("he2017-tuned", SAMPLED, "sampling.switching=implicit", "sampling.delay=0.001"),
    "observer": ("he2017-sampled", "sampling.rate=observer", "sampling.period=0.002", "task.trials=3", LIMITS),
    "adaptive-boundary": ("he2017-sampled", "controller.kind=adaptive-boundary", "task.trials=3"),
    "pd": (
        "he2017-sampled", "controller.kind=boundary-damping", FEEDBACK, "controller.stiffness={tip_w=5.0,tip_phi=3.0}",
        "sampling.command_limit={tip_w=0.6}", "task.trials=2",
        "controller.feedforward={tip_w={kind='sinusoid',amplitude=0.1,frequency=1.0}}",
    ),
    "p-type": (
        "he2017-sampled", "controller.kind=p-type-ilc", LEARNING, FEEDBACK, "controller.lead=0.005", "controller.forgetting=0.1",
        "task.trials=4",
    ),
    "p-type-filtered": (
        "he2017-sampled", "controller.kind=p-type-ilc", LEARNING, FEEDBACK, "controller.cutoff=20.0", "task.trials=4",
    ),
    "pd-type": (
        "he2017-sampled", "controller.kind=pd-type-ilc", LEARNING, FEEDBACK, "controller.lead=0.003", "controller.cutoff=30.0",
        "controller.rate_learning={tip_w=0.1,tip_phi=0.1}", "task.trials=4",
    ),
    "lqg": ("he2017-sampled", "controller.kind=lqg", "controller.error_weight={tip_w=10.0,tip_phi=10.0}", "task.trials=3"),
    "lqg-following": (*ARM, "controller.kind=lqg", "controller.error_weight={tip_w=10.0,hub=10.0}"),
    "norm-optimal": ARM,
    "string": ("string-tip-mass", SAMPLED, "task.trials=2"),
    "following": ("he2017-sampled", "task.reference={tip_w={kind='sinusoid',amplitude=0.02,frequency=1.0}}", "task.trials=2"),
    "p-type-of-four-samples": (
        "he2017-sampled", "controller.kind=p-type-ilc", "controller.learning={tip_w=0.5}", "sampling.period=0.5",
        "controller.cutoff=0.5", "task.trials=4",
    ),
    "one-sample": (
        "he2017-sampled", "sampling.period=2.0", "sampling.delay=2.0", "sampling.command_limit={tip_w=0.1,tip_phi=0.1}",
        "task.trials=3",
    ),
}  # fmt: skip
WHOLE = ("implicit", "explicit", "boundary-layer", "tuned", "tuned-implicit")
GOING = Guards(stop_at_constraint=False)


def case(name: str) -> dampen.Scenario:
    return dampen.read_scenario(CASES[name][0], CASES[name][1:])


def replayed(name: str, folder: Path, single: bool) -> tuple[list[int], np.ndarray, np.ndarray, tuple[np.ndarray, ...]]:
    """Worst statuses by trial, commands of the C controller and of the simulation, and both of its bounds and rates."""
    bench, trials = recorded(name, lambda: case(name))
    bare = built(case(name), folder, single, GOING, bench)
    ran = [bare.trial(trial.readings) for trial in trials]
    commands = np.array([commands for _, commands, _ in ran])
    expected = np.array([trial.commands for trial in trials])
    rates = np.array([trial.rates for trial in trials])
    return [status for status, _, _ in ran], commands, expected, (stated_bound(case(name), trials, bench), rates)


@pytest.mark.parametrize("name", [name for name in CASES if name != "norm-optimal"])
def test_in_double_replayed_readings_give_the_simulations_commands_bit_for_bit(name: str, tmp_path: Path) -> None:
    statuses, commands, expected, _ = replayed(name, tmp_path, single=False)
    assert set(statuses) == {0}
    assert len(commands) == (25 if name in WHOLE else case(name).task.trials)
    assert expected.any()
    np.testing.assert_array_equal(commands, expected)


def test_norm_optimal_learning_solves_for_the_simulations_commands_to_1e_8(tmp_path: Path) -> None:
    """The same equations by conjugate gradients, where the simulation may take factors of the matrix."""
    _, commands, expected, _ = replayed("norm-optimal", tmp_path, single=False)
    np.testing.assert_array_equal(commands[0], expected[0])
    np.testing.assert_allclose(commands, expected, atol=1e-8 * np.abs(expected).max())
    assert np.abs(commands[1] - commands[0]).max() > 0.01


@pytest.mark.parametrize("name", list(CASES))
def test_in_float_replayed_readings_give_commands_within_the_stated_bound(name: str, tmp_path: Path) -> None:
    _, commands, expected, (bound, _) = replayed(name, tmp_path, single=True)
    off = np.abs(commands - expected).max(axis=(0, 1))
    print(name, off / bound, bound)
    assert np.all(off <= bound)
    assert np.all(bound < 0.02 * np.abs(expected).max())


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("single", [False, True])
@pytest.mark.parametrize("name", ["implicit", "pd", "pd-type", "lqg", "norm-optimal"])
def test_the_files_compile_without_a_warning_and_the_selftest_passes_under_the_sanitizers(
    compiler: str, single: bool, name: str, tmp_path: Path
) -> None:
    export_c(case(name), tmp_path, single, GOING)
    done = subprocess.run(
        ["make", "-C", str(tmp_path), f"CC={compiler}", "controller.o", "test", "sanitize"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "warning" not in done.stderr
    assert done.stdout.count("stopped, commands 0") == 2


INVERSES = "compensation.all.chain=[{kind='dead-zone-inverse'},{kind='prandtl-ishlinskii-inverse'}]"


@pytest.mark.parametrize(
    "overrides", [(), ("controller.barrier=tan", INVERSES), ("controller.kind=open-loop",), (*CASES["pd"][1:],)]
)
@pytest.mark.parametrize("single", [False, True])
def test_an_engineers_stricter_warnings_are_silent_too(overrides: tuple[str, ...], single: bool, tmp_path: Path) -> None:
    written(dampen.read_scenario("he2017-sampled", overrides), tmp_path, single)
    for compiler in COMPILERS:
        flags = (
            "-c",
            "-O2",
            "-ffreestanding",
            "-Wconversion",
            "-Wdouble-promotion",
            "-Wstrict-prototypes",
            "-Wmissing-prototypes",
        )
        compile_c(compiler, flags, [tmp_path / "controller.c"], tmp_path / "controller.o")


@pytest.mark.parametrize("name", list(shipped()))
def test_every_shipped_scenario_leaves_as_c(name: str, tmp_path: Path) -> None:
    written(dampen.read_scenario(name, (SAMPLED,)), tmp_path)
    compile_c(COMPILERS[0], ("-c", "-O2"), [tmp_path / "controller.c"], tmp_path / "controller.o")


@pytest.mark.parametrize(
    "title",
    ["*/ int main(void) { return 1; } /* ??/", "why???/", "right to left \u202e", "**//* a /*/ b \\", "new\nline\tand tab"],
)
def test_a_title_cannot_end_the_comment_that_it_stands_in(title: str, tmp_path: Path) -> None:
    written(replace(case("implicit"), title=title), tmp_path)
    for compiler in COMPILERS:
        compile_c(compiler, ("-c", "-O2"), [tmp_path / "controller.c"], tmp_path / "controller.o")
    for name in ("controller.h", "controller.c"):
        assert "*/ int main" not in (tmp_path / name).read_text()


@dataclass(frozen=True)
class Renamed(dampen.TimoshenkoBeam):
    """The beam with other names of its ports."""

    names: tuple[str, ...] = ()

    @property
    def ports(self) -> tuple[dampen.Port, ...]:
        return tuple(replace(port, name=name) for port, name in zip(super().ports, self.names, strict=True))

    def modes(self, count: int, grid: int | None = None) -> dampen.Modes:
        return replace(super().modes(count, grid), ports=self.ports)


@pytest.mark.parametrize("names", [("tip-w", "tip.w"), ("x", "X"), ("\u00e4", "\u00f6"), ("tip*/w", "a|b ??/")])
def test_every_port_has_a_macro_of_its_own_whatever_its_name(names: tuple[str, str], tmp_path: Path) -> None:
    plain = case("implicit")
    renamed = replace(
        plain, plant=Renamed(names=names), controller=dampen.BoundaryDamping(damping={names[0]: 1.0}), claims=None,
        disturbance=dampen.NoDisturbance(), actuators={}, bounds={}, task=dampen.Task(trials=1, trial_duration=0.1),
        sampling=replace(plain.sampling, noise={}, quantum={}, command_limit={}), numerics=replace(plain.numerics, modes=6),
    )  # fmt: skip
    export_c(renamed, tmp_path)
    for compiler in COMPILERS:
        compile_c(compiler, ("-c", "-O2"), [tmp_path / "controller.c"], tmp_path / "controller.o")
    defined = [line.split()[1:3] for line in (tmp_path / "controller.h").read_text().splitlines() if "DAMPEN_PORT_" in line]
    assert [number for _, number in defined] == ["0", "1"]
    assert len({name for name, _ in defined}) == 2
    (row,) = [line for line in (tmp_path / "README.md").read_text().splitlines() if f"`{defined[1][0]}` = 1" in line]
    assert row.replace("\\|", "").count("|") == 8


def test_numbered_macros_do_not_run_into_names_that_look_like_them() -> None:
    assert macros(["tip_w", "tip_phi"]) == ["TIP_W", "TIP_PHI"]
    assert macros(["a-b", "a.b", "a_b_2", "a b"]) == ["A_B", "A_B_3", "A_B_2", "A_B_4"]


@pytest.mark.parametrize("compiler", COMPILERS)
def test_flags_that_would_blind_the_guards_are_refused_by_the_source(compiler: str, tmp_path: Path) -> None:
    written(case("implicit"), tmp_path)
    with pytest.raises(AssertionError, match="compile without -ffast-math"):
        compile_c(compiler, ("-c", "-O2", "-ffast-math"), [tmp_path / "controller.c"], tmp_path / "controller.o")


def test_what_no_float_can_hold_is_refused_for_float_and_goes_in_double(tmp_path: Path) -> None:
    steep = dampen.read_scenario("he2017-sampled", ["controller.kind=boundary-damping", "controller.damping={tip_w=1e45}"])
    written(steep, tmp_path)
    with pytest.raises(ArgumentError, match=r"`--float` must be left out: .* 1e\+45") as refused:
        written(steep, tmp_path, single=True)
    assert len(refused.value.lines) == 1


@pytest.mark.parametrize(
    ("guards", "said"),
    [
        (Guards(patience=2**31), "`patience` must be a whole number from 0 to 30000"),
        (Guards(patience=-1), "`patience` must be a whole number"),
        (Guards({"tip_w": (1.0, 0.0)}), "`--range tip_w` must have LOW < HIGH"),
        (Guards({"tip_w": (math.nan, 0.0)}), "`--range tip_w` must have LOW < HIGH"),
        (Guards({"nose": (0.0, 1.0)}), "`--range nose` is not a port"),
    ],
)
def test_guards_that_could_not_guard_are_refused_in_one_line(guards: Guards, said: str) -> None:
    with pytest.raises(ArgumentError, match=said) as refused:
        blueprint(case("implicit"), guards=guards)
    assert len(refused.value.lines) == 1


@pytest.mark.parametrize("name", ["norm-optimal", "pd-type", "p-type", "implicit"])
def test_a_trial_whose_first_readings_are_missing_learns_nothing_from_before_the_start(name: str, tmp_path: Path) -> None:
    """After a start, or a restart where learning is at the end of a trial, all is as in a controller that has just been made."""
    afresh = dampen.read_scenario(CASES[name][0], [*CASES[name][1:], "task.start=reset", "task.trials=1"])
    if name == "pd-type":
        afresh = replace(afresh, controller=replace(afresh.controller, lead=0.0))
    bench = Bench(afresh)
    (trial,) = record(afresh, bench)
    blind = trial.readings.copy()
    blind[:4] = np.nan
    found = []
    for used in (False, True):
        folder = tmp_path / str(used)
        folder.mkdir()
        bare = built(afresh, folder, guards=GOING, bench=bench)
        if used:
            for reading in trial.readings[:50]:
                bare.step(reading + 0.01)
            (bare.library.bench_restart if name == "norm-optimal" else bare.start)()
        assert bare.trial(blind)[0] == 1
        found.append(bare.trial(trial.readings)[1])
    np.testing.assert_array_equal(found[0], found[1])
    assert np.abs(found[0]).max() < 30


@pytest.mark.parametrize("delay", ["0.0015", "0.003"])
def test_the_float_bound_knows_that_a_late_law_carries_its_own_rounding_on(delay: str, tmp_path: Path) -> None:
    late = dampen.read_scenario(
        "he2017-sampled", [f"sampling.delay={delay}", "numerics.step=0.0005", "task.trials=2", "numerics.modes=40"]
    )
    bench = Bench(late)
    trials = tuple(record(late, bench))
    largest = np.abs([trial.commands for trial in trials]).max(axis=(0, 1))
    bare, bound = built(late, tmp_path, True, GOING, bench), stated_bound(late, trials, bench)
    off = np.abs(np.array([bare.trial(t.readings)[1] for t in trials]) - [t.commands for t in trials]).max(axis=(0, 1))
    assert np.all(off <= bound)
    if delay == "0.003":  # the factor is beyond 1: only the size of the commands is left
        np.testing.assert_array_equal(bound, 2 * largest)
    else:
        assert np.all(bound < 0.05 * largest)


def test_the_gains_of_a_linear_law_count_its_states_as_long_as_they_last() -> None:
    slow = dampen.read_scenario(
        "string-tip-mass", [SAMPLED, "controller.kind=lqg", "controller.error_weight={}", "task.trials=1"]
    )
    blue, one = blueprint(slow), np.zeros(1)
    state, command, total = np.zeros(len(blue.sampler.state)), np.zeros(1), 0.0
    for k in range(blue.samples):
        blue.law(Sample(np.array([float(k == 0)]), *(one,) * 7), state, np.ravel(blue.sampler.parameters), command)
        total += abs(command[0])
    assert linear_gains(blue)[0, 0] == pytest.approx(total, rel=1e-9)


def test_guards_that_do_not_act_change_no_bit(tmp_path: Path) -> None:
    bench, trials = recorded("implicit", lambda: case("implicit"))
    (tmp_path / "wide").mkdir()
    wide = Guards({"tip_w": (-1e3, 1e3), "tip_phi": (-1e3, 1e3)}, 100, False)
    guarded, free = built(case("implicit"), tmp_path, bench=bench), built(case("implicit"), tmp_path / "wide", False, wide, bench)
    for trial in trials[:3]:
        np.testing.assert_array_equal(guarded.trial(trial.readings)[1], free.trial(trial.readings)[1])


def test_the_record_is_as_large_as_the_readme_says(tmp_path: Path) -> None:
    for name in ("implicit", "pd-type", "lqg", "norm-optimal", "pd"):
        for single in (False, True):
            folder = tmp_path / f"{name}-{single}"
            folder.mkdir()
            bench, _ = recorded(name, lambda name=name: case(name))
            bare = built(case(name), folder, single, bench=bench)
            assert footprint(source_of(blueprint(case(name), single, bench=bench))).memory == bare.library.bench_size()


FUZZ = """
#include "controller.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
static dampen_controller c;
static uint64_t state = 88172645463325252u;
static uint64_t next(void) { state ^= state << 13; state ^= state >> 7; state ^= state << 17; return state; }
static dampen_real any(unsigned kind)
{
    union { uint64_t bits; double number; } wide;
    union { uint32_t bits; float number; } narrow;
    if (kind == 0) { wide.bits = next(); return (dampen_real)wide.number; }
    if (kind == 1) { narrow.bits = (uint32_t)(next() >> 13); return (dampen_real)narrow.number; }
    return (dampen_real)(((double)(next() >> 11) / 9007199254740992.0 - 0.5) * (kind == 2 ? 0.8 : 0.38));
}
int main(int argc, char **argv)
{
    const long steps = argc > 1 ? atol(argv[1]) : 1000000;
    const double limit = argc > 2 ? atof(argv[2]) : 0;
    long seen[7] = {0};
    dampen_init(&c);
    for (long i = 0; i < steps; i++) {
        dampen_real reading[DAMPEN_PORTS], command[DAMPEN_PORTS];
        const unsigned mood = (unsigned)(i / 5000 % 4); /* all garbage, mostly fine, ... */
        for (int p = 0; p < DAMPEN_PORTS; p++) reading[p] = any(next() % (mood == 0 ? 2 : 100) ? mood : (unsigned)(next() % 4));
        const dampen_status status = dampen_step(&c, reading, command);
        seen[status]++;
        for (int p = 0; p < DAMPEN_PORTS; p++) {
            if (!(fabs((double)command[p]) <= limit)) { printf("step %ld: %g\\n", i, (double)command[p]); return 1; }
        }
#ifdef DRIVEN
        dampen_drive(&c, command, command);
        for (int p = 0; p < DAMPEN_PORTS; p++) {
            if (!(fabs((double)command[p]) <= 4 * limit)) { printf("step %ld: drive %g\\n", i, (double)command[p]); return 1; }
        }
#endif
        if (status == DAMPEN_TRIAL_OVER) dampen_end_trial(&c, reading);
        if (status >= DAMPEN_STOPPED_SENSOR && next() % 4 == 0) dampen_restart(&c);
        if (status == DAMPEN_STOPPED_FAULT) dampen_init(&c);
        if (next() % 2000 == 0) dampen_end_trial(&c, reading); /* out of turn */
        if (next() % 8000 == 0) dampen_restart(&c);
    }
    for (int k = 0; k < 7; k++) printf("%ld ", seen[k]);
    return 0;
}
"""


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("single", [False, True])
@pytest.mark.parametrize("stop", [False, True])
@pytest.mark.parametrize("name", ["implicit", "explicit", "pd-type", "lqg"])
def test_any_bit_pattern_as_reading_gives_numbers_within_the_output_limit(
    name: str, stop: bool, single: bool, compiler: str, tmp_path: Path
) -> None:
    """With the guards as they are, and with guards that believe anything and do not stop, so that the law gets to see it; trials
    are ended and begun afresh out of turn now and then.

    More than a million readings in all; with DAMPEN_FUZZ_STEPS=10000000 ten million for each controller.
    """
    steps = int(os.environ.get("DAMPEN_FUZZ_STEPS", "100000"))
    wild = {"tip_w": (-1e30, 1e30), "tip_phi": (-1e30, 1e30)}
    limited = dampen.read_scenario(CASES[name][0], [*CASES[name][1:], LIMITS])
    bench, _ = recorded(name, lambda: case(name))
    source = written(limited, tmp_path, single, Guards({} if stop else wild, 5, stop), bench)
    driven = ("-DDRIVEN",) if source.stages else ()
    (tmp_path / "fuzz.c").write_text(FUZZ)
    compile_c(compiler, (*CHECKED, *driven), [tmp_path / "controller.c", tmp_path / "fuzz.c"], tmp_path / "fuzz")
    done = subprocess.run([tmp_path / "fuzz", str(steps), "6.0"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    seen = list(map(int, done.stdout.split()))
    assert seen[0] + seen[1] > steps / 100
    assert seen[2] > 0 or stop


def test_a_broken_sensor_is_bridged_then_latched(tmp_path: Path) -> None:
    bench, trials = recorded("implicit", lambda: case("implicit"))
    bare = built(case("implicit"), tmp_path, bench=bench)
    readings = trials[0].readings
    for k in range(50):
        bare.step(readings[k])
    gone = np.array([np.nan, readings[50, 1]])
    statuses = [bare.step(gone)[0] for _ in range(7)]
    assert statuses == [1] * 5 + [4] * 2
    assert bare.library.bench_replaced() == 6
    status, command, drive = bare.step(readings[60])
    assert status == 4
    assert not command.any()
    assert not drive.any()
    bare.library.bench_restart()
    assert bare.step(readings[60])[0] == 0


def test_a_single_bad_reading_changes_the_command_little(tmp_path: Path) -> None:
    bench, trials = recorded("implicit", lambda: case("implicit"))
    bare = built(case("implicit"), tmp_path, bench=bench)
    readings = trials[0].readings.copy()
    readings[1000, 0] = np.inf
    status, commands, _ = bare.trial(readings)
    assert status == 1
    assert np.abs(commands - trials[0].commands).max() < 0.1 * np.abs(trials[0].commands).max()


def test_crossing_the_constraint_stops_unless_told_to_keep_going(tmp_path: Path) -> None:
    (tmp_path / "going").mkdir()
    bench, trials = recorded("implicit", lambda: case("implicit"))
    careful, bold = (
        built(case("implicit"), tmp_path, bench=bench),
        built(case("implicit"), tmp_path / "going", False, GOING, bench),
    )
    for bare in (careful, bold):
        for k in range(20):
            bare.step(trials[0].readings[k])
    beyond = np.array([0.2, 0.0])
    assert careful.step(beyond)[0] == 5
    assert not careful.step(trials[0].readings[21])[1].any()
    assert bold.step(beyond)[0] == 0


def test_a_trial_ends_only_when_it_is_over(tmp_path: Path) -> None:
    bench, trials = recorded("implicit", lambda: case("implicit"))
    bare = built(case("implicit"), tmp_path, bench=bench)
    readings = trials[0].readings
    assert bare.end_trial(readings[0]) == 3
    bare.start()
    for k in range(2000):
        assert bare.step(readings[k])[0] == 0
    status, command, _ = bare.step(readings[0])
    assert status == 2
    assert not command.any()
    assert bare.end_trial(readings[-1]) == 0


def test_the_drive_is_what_goes_into_the_simulated_actuator(tmp_path: Path) -> None:
    """Of the flank inverse that belongs to the law, and of an inverse with memory that the scenario puts before the actuator."""
    jumping = "compensation.tip_phi.chain=[{kind='backlash-inverse'}]"
    both = dampen.read_scenario("he2017-sampled", [jumping, "controller.compensate=false"])
    for number, one in enumerate((case("implicit"), both)):
        folder = tmp_path / str(number)
        folder.mkdir()
        bench, trials = recorded("implicit", lambda: case("implicit"))
        bare = built(one, folder, bench=bench)
        _, commands, drives = bare.trial(trials[0].readings)
        for p in range(2):
            expected = commands[:, p]
            for stage in one.chain(p)[:-1]:
                expected = through(stage, expected)
            np.testing.assert_array_equal(drives[:, p], expected)


def test_in_closed_loop_with_a_quantiser_the_c_controller_reproduces_the_run(tmp_path: Path) -> None:
    """Called from the simulation's own loop in the place of the sampled law: plant, actuators, delay and sensors are the same.

    The loop is plain Python here: its sums round otherwise than the compiled one's, which the quantiser takes away again. With
    DAMPEN_WHOLE_LOOP set, all 25 trials as shipped: some minutes.
    """
    whole = "DAMPEN_WHOLE_LOOP" in os.environ
    one = dampen.read_scenario(
        "he2017-sampled", [] if whole else ["numerics.modes=24", "task.trials=2", "task.trial_duration=0.5"]
    )
    bench = Bench(one)
    expected = dampen.simulate(one, bench=bench)
    bare = built(one, tmp_path, bench=bench)
    statuses = []

    def reading_of(s, ports, sampler):  # type: ignore[no-untyped-def]
        exact = [ports[p].y + sampler.reference[s, p] + sampler.noise[s, p] for p in range(2)]
        return np.array([quantum * math.floor(y / quantum + 0.5) for y, quantum in zip(exact, sampler.quantum, strict=True)])

    def sample(k, ports, sampler):  # type: ignore[no-untyped-def]
        s, row = k // sampler.period, sampler.ahead + k // sampler.period
        if k == s * sampler.period:
            status, sampler.issued[row], _ = bare.step(reading_of(s, ports, sampler))
            statuses.append(status)
        for p in range(2):
            ports[p].feedforward = sampler.issued[sampler.ahead + (k - sampler.delay) // sampler.period, p]

    def measure(s, ports, sampler):  # type: ignore[no-untyped-def]
        statuses.append(bare.end_trial(reading_of(s, ports, sampler)))

    composition, classes = bench.composition(one)
    with_c = bind(composition.bind(), sample=sample, measure=measure)
    bench.kernel = lambda scenario, compile=True: (with_c, classes)  # type: ignore[method-assign]
    found = dampen.simulate(one, bench=bench)
    assert set(statuses) == {0}
    assert len(statuses) == one.task.trials * (one.law_grid[0] + 1)
    np.testing.assert_array_equal(found["issued"], expected["issued"])
    np.testing.assert_allclose(found["y"], expected["y"], atol=1e-12)


def through(stage: object, commands: np.ndarray) -> np.ndarray:
    """Commands through a stage's own function."""
    row, state = np.array(stage.row(0.001)), np.array(stage.start() or (0.0,))  # type: ignore[attr-defined]
    out = np.zeros_like(commands)
    for k, command in enumerate(commands):
        kept = np.zeros_like(state)
        out[k] = type(stage).step(command, state, row, kept)  # type: ignore[attr-defined]
        state = kept
    return out


@pytest.mark.parametrize(
    ("name", "overrides", "why"),
    [
        ("he2017", (), 'must be "sampled"'),
        ("he2017-sampled", ("controller.kind=none",), "nothing to export"),
    ],
)
def test_what_cannot_be_exported_is_refused_in_one_line(name: str, overrides: tuple[str, ...], why: str) -> None:
    with pytest.raises(ArgumentError, match=why) as refused:
        blueprint(dampen.read_scenario(name, overrides))
    assert len(refused.value.lines) == 1


@dataclass(frozen=True)
class Wandering(Signal):
    def sample(self, t: np.ndarray, trial: int) -> np.ndarray:
        return np.full(len(t), 0.01 * trial)


def test_a_reference_that_changes_from_trial_to_trial_is_refused() -> None:
    plain = case("implicit")
    with pytest.raises(ArgumentError, match="those of trial 1 are not those of trial 0"):
        blueprint(replace(plain, task=replace(plain.task, reference={"tip_w": Wandering()})))


def test_a_users_own_law_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "my_own_law.py").write_text(
        "from dataclasses import dataclass\nimport numpy as np\nimport dampen\n\n\n"
        "@dataclass(frozen=True)\nclass Mine(dampen.Controller):\n"
        "    def law(self, memory, setting):\n        return dampen.PortLaw(np.zeros((setting.steps, len(setting.ports))))\n"
    )
    monkeypatch.chdir(tmp_path)
    mine = dampen.read_scenario("he2017-sampled", ["controller.kind=my_own_law:Mine"])
    with pytest.raises(ArgumentError, match="Python of your own"):
        blueprint(mine)


def on_the_command_line(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "dampen.cli", "export", "c", *arguments], capture_output=True, text=True, timeout=300
    )


def test_the_shipped_sampled_experiment_has_limits_that_it_does_not_come_near(tmp_path: Path) -> None:
    _, trials = recorded("implicit", lambda: case("implicit"))
    limits = np.array(list(case("implicit").sampling.command_limit.values()))
    assert np.all(2.5 * np.abs([trial.commands for trial in trials]).max(axis=(0, 1)) < limits)
    done = on_the_command_line("he2017-sampled", "--out", str(tmp_path / "firmware"), "--set", "task.trials=1")
    assert done.returncode == 0
    assert not done.stderr
    assert "No output limit" not in (tmp_path / "firmware" / "README.md").read_text()


def test_the_command_line_writes_a_folder_that_tests_itself(tmp_path: Path) -> None:
    folder, limit = tmp_path / "firmware", "sampling.command_limit={tip_w=5.0,tip_phi=5.0}"
    done = on_the_command_line(
        "he2017-sampled", "--out", str(folder), "--float", "--set", limit, "--range", "tip_w=-0.3:0.25", "--patience", "2"
    )
    assert done.returncode == 0, done.stderr
    assert "memory (RAM)" in done.stdout
    assert "N at tip_w" in done.stdout
    assert not done.stderr
    assert sorted(path.name for path in folder.iterdir()) == [
        "Makefile", "README.md", "controller.c", "controller.h", "scenario.toml", "selftest.c", "sil.c",
    ]  # fmt: skip
    readme = (folder / "README.md").read_text()
    assert "-0.3 to 0.25 m" in readme
    assert "5 N m" in readme
    assert "more than 2 readings" in readme
    assert dampen.read_scenario(folder / "scenario.toml").sampling.command_limit == {"tip_w": 5.0, "tip_phi": 5.0}
    assert subprocess.run(["make", "-s", "-C", str(folder), "test"], capture_output=True, check=False).returncode == 0


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (("he2017",), 'Argument `numerics.mode` must be "sampled"'),
        (("he2017-sampled", "--range", "tip_w=1:0"), "Option `--range` must look like PORT=LOW:HIGH"),
        (("he2017-sampled", "--range", "tip_w=0:1", "--range", "tip_w=0:2"), "Option `--range` must be given once for a port"),
        (("he2017-sampled", "--range", "tip_w=5:6"), "Argument `plant.initial` starts outside the constraint, or the readings"),
        (("he2017-sampled", "--patience", "3000000000"), "Argument `patience` must be a whole number from 0 to 30000"),
        (("he2017-sampled", "--range", "nose=0:1"), "Option `--range nose` is not a port of this plant"),
    ],
)
def test_the_command_line_says_in_one_line_what_it_cannot_export(arguments: tuple[str, ...], line: str, tmp_path: Path) -> None:
    done = on_the_command_line(*arguments, "--out", str(tmp_path / "firmware"))
    assert done.returncode == 2
    assert done.stderr.startswith(line)
    assert len(done.stderr.strip().splitlines()) == 1
    assert not (tmp_path / "firmware").exists()
