"""The contract that every component keeps, over the list of all kinds: a new kind without an example here fails the test."""

from __future__ import annotations

from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dampen
from dampen.analysis.energy import energy_account
from dampen.component import Component, parameters
from dampen.scenarios.kinds import KINDS
from dampen.scenarios.read import build, parse, shipped
from dampen.simulation.bench import Bench
from dampen.stage import Stage
from dampen.toml import to_toml

WING = str(shipped()["assembled-from-fe"].parent / "wing.npz")
EVERYWHERE = {"tip_w": 0.3, "tip_phi": 0.1}


def gust(t: np.ndarray) -> np.ndarray:
    return np.sin(20 * t)


EXAMPLES: dict[str, dict[str, Component]] = {
    "plant": {
        "timoshenko": dampen.TimoshenkoBeam(initial=dampen.BeamState(w_rate=(0.0, 0.1))),
        "euler-bernoulli": dampen.EulerBernoulliBeam(damping=dampen.Damping(kelvin_voigt=1e-4)),
        "flexible-arm": dampen.FlexibleArm(damping=dampen.Damping(viscous=0.1)),
        "string": dampen.String(),
        "assembled": dampen.Assembled(file=WING),
    },
    "actuator": {cls.kind: cls() for cls in KINDS["actuator"]},
    "compensation": {cls.kind: cls() for cls in KINDS["compensation"]},
    "disturbance": {
        "none": dampen.NoDisturbance(),
        "he2017": dampen.HarmonicFamilies(),
        "harmonics": dampen.Harmonics(frequencies=(1.0, 2.5), force={"tip_w": (0.2, 0.1)}),
        "band-noise": dampen.BandNoise(rms={"tip_w": 0.2}, low=0.5, high=20.0),
        "impulse": dampen.Impulse(duration=0.02, impulse={"tip_w": 0.05}),
        "constant": dampen.ConstantLoad(force={"tip_w": 0.2}, load_density=0.1),
        "moving-load": dampen.MovingLoad(force=0.3, speed=10.0),
        "base-shaking": dampen.BaseShaking(frequencies=(2.0,), amplitudes=(0.5,)),
        "function": dampen.FunctionDisturbance(highest_frequency=5.0, force={"tip_w": gust}),
        "sum": dampen.Sum(terms=(dampen.ConstantLoad(force={"tip_w": 0.1}), dampen.HarmonicFamilies())),
    },
    "signal": {
        "hold": dampen.Hold(0.01),
        "minimum-jerk": dampen.MinimumJerk(target=0.01, duration=0.02),
        "sinusoid": dampen.Sinusoid(amplitude=0.01, frequency=5.0),
        "decay": dampen.Decay(start=0.01, final=0.0, time_constant=0.02),
    },
    "controller": {
        "none": dampen.NoControl(),
        "open-loop": dampen.OpenLoop(command=EVERYWHERE),
        "boundary-damping": dampen.BoundaryDamping(damping=EVERYWHERE, stiffness={"tip_w": 3.0}),
        "adaptive-boundary": dampen.AdaptiveBoundary(),
        "dual-loop-ailc": dampen.DualLoopAILC(),
        "p-type-ilc": dampen.PTypeILC(learning=EVERYWHERE, damping=EVERYWHERE),
        "pd-type-ilc": dampen.PDTypeILC(learning=EVERYWHERE, rate_learning=EVERYWHERE, damping=EVERYWHERE),
        "norm-optimal-ilc": dampen.NormOptimalILC(damping=EVERYWHERE),
        "lqg": dampen.LQG(modes=3),
    },
}


@pytest.fixture(autouse=True)
def records(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Kinds that need a file get one."""
    file = tmp_path / "record.csv"
    file.write_text("time,value\n" + "\n".join(f"{t:.3f},{np.sin(9 * t):.6f}" for t in np.arange(0, 0.2, 0.004)) + "\n")
    monkeypatch.setitem(EXAMPLES["disturbance"], "recorded", dampen.Recorded(str(file), columns={"tip_w": "value"}))
    monkeypatch.setitem(EXAMPLES["signal"], "recorded", dampen.RecordedSignal(str(file), column="value", scale=0.01))


def kinds(table: str) -> list[str]:
    return [cls.kind for cls in KINDS[table]]


CASES = [(table, kind) for table in KINDS for kind in kinds(table)]


def case(table: str, kind: str, trials: int = 2, duration: float = 0.06) -> dampen.Scenario:
    """A short experiment around the component: the paper's beam, disturbance and law, but for what is tried."""
    component: Any = EXAMPLES[table][kind]
    parts: dict[str, Any] = {
        "plant": EXAMPLES["plant"]["timoshenko"],
        "controller": dampen.BoundaryDamping(damping=EVERYWHERE, feedforward={"tip_w": dampen.Sinusoid(1.5, 12.0)}),
        "disturbance": dampen.HarmonicFamilies(frozen_at=0),
        "task": dampen.Task(trials=trials, trial_duration=duration, constraint={"tip_w": 0.2, "tip_phi": 0.2}),
        "numerics": dampen.Numerics(modes=8, step=0.002),
        "output": dampen.Output(points=5, every=5),
        "bounds": {"f": 0.1, "tip_w": 0.2, "tip_phi": 0.2},
    }
    if table == "plant":
        names = [port.name for port in component.ports]
        law = dampen.BoundaryDamping(damping=dict.fromkeys(names, 0.5), stiffness=dict.fromkeys(names, 2.0))
        pushed = dampen.ConstantLoad(force={names[0]: 0.2})
        task = replace(parts["task"], constraint={})
        parts |= {"plant": component, "controller": law, "disturbance": pushed, "bounds": {}, "task": task}
    elif table in ("actuator", "compensation"):
        parts["actuators" if table == "actuator" else table] = {"tip_w": (component,)}
    elif table == "signal":
        parts["task"] = replace(parts["task"], reference={"tip_w": component}, constraint={})
    else:
        parts[table] = component
    if kind == "lqg":
        parts["numerics"] = replace(parts["numerics"], mode="sampled")
        parts["sampling"] = dampen.Sampling(period=0.004)
    return dampen.Scenario(**parts)


ALL_STAGES: tuple[Stage, ...] = tuple(cls() for table in ("actuator", "compensation") for cls in KINDS[table])  # type: ignore[misc]


def bench(scenario: dampen.Scenario, table: str) -> Bench:
    """A bench; for stages one whose kernel knows them all, so that it is compiled once."""
    made = Bench(scenario)
    if table in ("actuator", "compensation"):
        made.kernel(replace(scenario, actuators={"tip_w": ALL_STAGES}), compile=False)
    return made


def test_every_kind_has_an_example() -> None:
    for table in KINDS:
        assert set(EXAMPLES[table]) == set(kinds(table)), table


@pytest.mark.parametrize(("table", "kind"), CASES, ids=lambda value: str(value))
def test_the_contract(table: str, kind: str) -> None:
    scenario = case(table, kind)
    result = dampen.simulate(scenario, bench=bench(scenario, table))
    assert not result.broke_off
    for name, variable in result.layout.variables.items():  # shapes kept, everything finite
        assert result[name].shape == (2, *result.layout.shape(variable)), name
        assert np.all(np.isfinite(result[name])), name
    assert energy_account(result).error < 1e-11
    plain = dampen.simulate(scenario, bench=bench(scenario, table), compile=False)
    for name in result.layout.variables:  # compiled equals plain
        expected = np.asarray(plain[name], float)
        np.testing.assert_allclose(result[name], expected, atol=1e-9 * np.abs(expected).max() + 1e-15, rtol=0, err_msg=name)
    assert build(parse(to_toml(scenario), kind)) == scenario  # written and read back


@pytest.mark.parametrize(("table", "kind"), [c for c in CASES if c[0] in ("plant", "actuator", "compensation")])
def test_two_chained_trials_are_one_of_twice_the_length(table: str, kind: str) -> None:
    """State of structure and stages is carried on; nothing learns, and what shakes and feeds goes on."""
    steady = dampen.ConstantLoad(force={case(table, kind).ports[0]: 0.3})
    law = replace(case(table, kind).controller, feedforward={case(table, kind).ports[0]: 0.7})  # type: ignore[type-var]
    twice, once = (replace(case(table, kind, n, 0.06 * m), disturbance=steady, controller=law) for n, m in ((2, 1), (1, 2)))
    runs = [dampen.simulate(s, bench=bench(s, table)) for s in (twice, once)]
    for name in ("v", "command", "delivered"):
        a, b = (run[name].reshape(-1, len(once.ports)) for run in runs)
        np.testing.assert_allclose(a, b, atol=1e-10 * max(1.0, np.abs(b).max()), err_msg=name)


@pytest.mark.parametrize(("table", "kind"), [c for c in CASES if c[0] in ("actuator", "compensation", "controller")])
def test_numbers_change_without_compiling_anew(table: str, kind: str) -> None:
    scenario = case(table, kind)
    one = EXAMPLES[table][kind]
    numbers = [p.name for p in parameters(type(one)) if p.type == "number"]
    shared = bench(scenario, table)
    kernel, _ = shared.kernel(scenario)
    dampen.simulate(scenario, bench=shared)
    compiled = len(kernel.signatures)
    for name in numbers:
        other = replace(one, **{name: getattr(one, name) * 1.01 if getattr(one, name) else 0.01})
        if table == "controller":
            changed = replace(scenario, controller=other)  # type: ignore[arg-type]
        else:
            changed = replace(scenario, **{"actuators" if table == "actuator" else table: {"tip_w": (other,)}})  # type: ignore[arg-type]
        dampen.simulate(changed, bench=shared)
        assert shared.kernel(changed)[0] is kernel, name
    assert len(kernel.signatures) == compiled


@pytest.mark.parametrize(("table", "kind"), CASES, ids=lambda value: str(value))
def test_every_parameter_is_told_with_its_meaning(table: str, kind: str) -> None:
    one = EXAMPLES[table][kind]
    for parameter in parameters(type(one)):
        assert parameter.doc, f"{kind}.{parameter.name}"
    assert {p.name for p in parameters(type(one))} == {f.name for f in fields(one)}
    assert type(one).summary().endswith(".")


WRONG = {"number": "text", "whole number": 1.5, "true/false": "yes", "string": 7}


@pytest.mark.parametrize(("table", "kind"), CASES, ids=lambda value: str(value))
def test_every_parameter_refuses_the_wrong_type_and_range_in_one_line(table: str, kind: str) -> None:
    one = EXAMPLES[table][kind]
    for parameter in parameters(type(one)):
        wrong = [WRONG[parameter.type]] if parameter.type in WRONG else [object()]
        wrong += [float("nan")] if parameter.type == "number" else []
        for sign in (">= ", "> "):
            if parameter.type in ("number", "whole number") and sign in parameter.range:
                low = float(parameter.range.split(sign)[1].split()[0])
                wrong.append(type(one.__dict__[parameter.name] or 1.0)(low - 1))
        for value in wrong:
            with pytest.raises(dampen.ArgumentError) as error:
                replace(one, **{parameter.name: value})
            assert len(error.value.lines) == 1, parameter.name
            assert error.value.lines[0].startswith(f"Argument `{parameter.name}` must "), error.value.lines[0]
