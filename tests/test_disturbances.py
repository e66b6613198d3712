"""Disturbances and references: equations, trials, files, and what they do to the paper's beam."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import dampen
from dampen.analysis.energy import energy_account
from dampen.disturbances.lines import cosines
from dampen.recording import Recording
from dampen.scenarios.read import build, parse
from dampen.simulation.bench import Bench
from dampen.toml import to_toml
from tests.conftest import scenario

Array = np.ndarray
SITE = dampen.Site(scenario().plant.ports, 1.0, 2.0)
STEP = 1e-3
T = (np.arange(2000) + 0.5) * STEP
X = np.linspace(0, 1, 5)
SMALL = ("controller.kind=none", "plant.initial={}", "numerics.modes=24", "task.trials=1")


def case(disturbance: dampen.Disturbance, *overrides: str) -> dampen.Scenario:
    """The paper's beam at rest, without control, under another disturbance."""
    return replace(scenario(*SMALL, *overrides), disturbance=disturbance, claims=None)


def waves(t: Array) -> Array:
    return 0.1 * (np.cos(3 * np.pi * t) + np.cos(6 * np.pi * t) + np.cos(9 * np.pi * t))


def faster_waves(t: Array) -> Array:
    return 0.1 * (np.cos(6 * np.pi * t) + np.cos(12 * np.pi * t) + np.cos(18 * np.pi * t))


def standing(x: Array, t: Array) -> Array:
    b = 3 * np.pi * x * t
    return 0.05 * (np.sin(b) + np.sin(2 * b) + np.sin(3 * b))


def scalar_only(t: float) -> float:
    return math.cos(3 * t) if t > 1 else 0.0


def falls(t: Array) -> Array:
    return 1 / np.zeros(0)[0]


# Equations


def test_harmonics_are_their_sum_of_cosines() -> None:
    source = dampen.Harmonics((1.0, 3.5), {"tip_phi": (0.2, -0.1)}, phases=(0.3, 0.0))
    expected = 0.2 * np.cos(2 * np.pi * T + 0.3) - 0.1 * np.cos(7 * np.pi * T)
    np.testing.assert_allclose(source.at_ports(0, T, SITE), np.column_stack([0 * T, expected]), atol=1e-14)
    assert source.content(0, SITE).port_frequency == (0.0, 3.5)


def test_lines_on_an_even_grid_equal_lines_at_any_times() -> None:
    random = np.random.default_rng(0)
    lines = cosines(*(list(random.uniform(0, top, 300)) for top in (200, 1, 6)))
    shuffled = random.permutation(len(T))
    np.testing.assert_allclose(lines.at(T)[shuffled], lines.at(T[shuffled]), atol=1e-10)
    np.testing.assert_allclose(lines.at(T[:2]), lines.at(T)[:2], atol=1e-11)


@pytest.mark.parametrize("trial", [0, 3])
def test_noise_has_its_rms_and_nothing_outside_its_band_in_every_trial(trial: int) -> None:
    source = dampen.BandNoise({"tip_w": 0.3, "tip_phi": 0.1}, low=10, high=40, seed=5)
    noise = source.at_ports(trial, T, SITE)
    np.testing.assert_allclose(np.sqrt(np.mean(noise**2, axis=0)), [0.3, 0.1], rtol=1e-12)
    power, f = np.abs(np.fft.rfft(noise[:, 0])) ** 2, np.fft.rfftfreq(len(T), STEP)
    inside = (f > 9.9) & (f < 40.1)
    assert power[~inside].sum() < 1e-24 * power.sum()
    np.testing.assert_allclose(power[inside], power[inside][0], rtol=1e-9)
    assert abs(np.corrcoef(noise.T)[0, 1]) < 0.4, "ports are independent"


def test_noise_is_the_seed_s_and_fresh_in_every_random_trial() -> None:
    source = dampen.BandNoise({"tip_w": 0.3}, low=1, high=50, seed=5)
    again = dampen.BandNoise({"tip_phi": 1.0, "tip_w": 0.3}, low=1, high=50, seed=5)
    a, b = source.at_ports(0, T, SITE)[:, 0], source.at_ports(1, T, SITE)[:, 0]
    np.testing.assert_array_equal(a, again.at_ports(0, T, SITE)[:, 0])
    for other in (b, replace(source, seed=6).at_ports(0, T, SITE)[:, 0]):
        assert abs(np.corrcoef(a, other)[0, 1]) < 0.4
    repeated = replace(source, trials="repeat")
    np.testing.assert_array_equal(repeated.at_ports(2, T, SITE)[:, 0], a)


def test_noise_that_runs_on_is_continuous_never_repeats_and_keeps_its_rms() -> None:
    source = dampen.BandNoise({"tip_w": 0.3}, low=5, high=20, seed=1, trials="continue")
    trials = [source.at_ports(j, T, SITE)[:, 0] for j in range(60)]
    joined = np.concatenate(trials)
    assert np.abs(np.diff(joined)).max() < 0.3 * 5 * 2 * np.pi * 20 * STEP
    assert max(abs(np.corrcoef(trials[0], other)[0, 1]) for other in trials[1:]) < 0.7
    assert np.sqrt(np.mean(joined**2)) == pytest.approx(0.3, rel=0.02)
    power, f = np.abs(np.fft.rfft(joined * np.hanning(len(joined)))) ** 2, np.fft.rfftfreq(len(joined), STEP)
    assert power[(f < 4.9) | (f > 20.1)].sum() < 1e-9 * power.sum()


def test_a_band_between_two_multiples_of_the_trial_s_frequency_is_one_line() -> None:
    noise = dampen.BandNoise({"tip_w": 1.0}, low=10.1, high=10.3).at_ports(0, T, SITE)[:, 0]
    assert np.sqrt(2) * 0.99 < np.abs(noise).max() <= np.sqrt(2)


@pytest.mark.parametrize("at", [0.0, 0.5, 0.7003])
def test_a_pulse_delivers_its_stated_impulse(at: float) -> None:
    for steps in (10, 40):
        source = dampen.Impulse(duration=steps * STEP, impulse={"tip_w": 0.02}, blow=-0.03, x=0.25, at=at)
        force = source.at_ports(0, T, SITE)
        place, blow = source.point_load(0, T, SITE)
        np.testing.assert_allclose(force.sum(axis=0) * STEP, [0.02, 0], rtol=1 / steps**2)
        assert blow.sum() * STEP == pytest.approx(-0.03, rel=1 / steps**2)
        assert set(place) == {0.25}


def test_an_impulse_of_one_trial_comes_in_that_trial_alone() -> None:
    source = dampen.Impulse(0.01, {"tip_w": 0.02}, trial=2)
    assert [bool(source.at_ports(j, T, SITE).any()) for j in range(4)] == [False, False, True, False]
    assert [source.same_as(j) for j in range(4)] == [0, 0, 2, 0]
    assert [replace(source, trial=0).same_as(j) for j in range(4)] == [0, 1, 1, 1]
    assert [source.content(j, SITE).port_frequency for j in (1, 2)] == [(0.0, 0.0), (100.0, 0.0)]


def test_a_moving_load_is_its_force_times_the_shape_where_it_is() -> None:
    source = dampen.MovingLoad(force=-3.0, speed=0.8, start=-0.2)
    bench = Bench(case(source))
    x = -0.2 + 0.8 * bench.midpoints
    shapes = bench.modes.field("w").shapes(np.clip(x, 0, 1))
    expected = np.where((x >= 0) & (x <= 1), -3.0, 0.0)[:, None] * shapes
    np.testing.assert_allclose(bench.shaking(0)[1], expected, atol=1e-12)
    assert 0 < np.count_nonzero(expected.any(axis=1)) < len(x)


def test_a_slow_moving_load_bends_the_beam_as_a_standing_one() -> None:
    """w(L) under a force at x: cantilever in bending and shear, F x^2 (3 L - x) / (6 EI) + F x / K."""
    source = dampen.MovingLoad(force=0.5, speed=0.05)
    result = dampen.simulate(case(source, "task.trial_duration=10.0", "numerics.modes=40"))
    x = 0.05 * result.time
    static = 0.5 * (x**2 * (3 - x) / (6 * 35) + x / 15)
    assert np.abs(result["y"][0][:, 0] - static).max() < 0.03 * static.max()


# The base


def test_constant_base_acceleration_is_minus_rho_a_along_and_minus_m_a_at_the_tip() -> None:
    a, moments = 0.7, ("task.trials=2", "controller.kind=none")
    shaken = dampen.simulate(case(dampen.BaseShaking((0.0,), (a,)), *moments))
    loaded = dampen.simulate(case(dampen.ConstantLoad({"tip_w": -0.1 * a}, -1.0 * a), *moments))
    np.testing.assert_allclose(shaken["y"], loaded["y"], atol=1e-12)
    for result in (shaken, loaded):
        assert energy_account(result).error < 1e-11
    assert energy_account(shaken).disturbance == 0
    assert energy_account(loaded).disturbance != 0


def test_the_static_tip_deflection_under_base_acceleration_is_the_textbook_s() -> None:
    """-a [rho (L^4 / 8 EI + L^2 / 2 K) + M (L^3 / 3 EI + L / K)], approached as modes are added."""
    exact = -0.7 * ((1 / (8 * 35) + 1 / (2 * 15)) + 0.1 * (1 / (3 * 35) + 1 / 15))
    errors = []
    for modes in (10, 20, 40, 80):
        bench = Bench(case(dampen.BaseShaking((0.0,), (0.7,)), f"numerics.modes={modes}"))
        load = bench.shaking(0)[1][0]
        errors.append(abs(float(bench.modes.b[0] @ (load / bench.modes.omega**2)) / exact - 1))
    assert errors[-1] < 1e-5
    assert np.all(np.diff(errors) < 0)


def test_energy_closes_under_noise_and_sinusoids_at_the_base() -> None:
    source = dampen.BaseShaking((3.0, 7.0), (0.5, 0.2), (0.0, 1.0), rms=0.3, low=2, high=20, seed=3, trials="random")
    result = dampen.simulate(case(source, "task.trials=3"))
    assert energy_account(result).error < 1e-11
    expected = 0.5 * np.cos(6 * np.pi * T) + 0.2 * np.cos(14 * np.pi * T + 1)
    noise = [source.base_acceleration(j, T, SITE) - expected for j in range(3)]
    np.testing.assert_allclose([np.sqrt(np.mean(n**2)) for n in noise], 0.3, rtol=1e-12)
    assert abs(np.corrcoef(noise[0], noise[1])[0, 1]) < 0.4


# Records


def record(path: Path, rows: int = 401, end: float = 2.0) -> dict[str, Array]:
    """Columns of a record, written to a CSV or NetCDF file."""
    t = np.linspace(0, end, rows)
    table = {"time": t, "force": np.sin(6.6 * np.pi * t), "ground": np.cos(4.4 * np.pi * t)}
    if path.suffix == ".csv":
        np.savetxt(path, np.column_stack(list(table.values())), delimiter=",", header=",".join(table), fmt="%.17g")
        return table
    import netCDF4

    with netCDF4.Dataset(path, "w") as file:
        file.createDimension("row", rows)
        for name, values in table.items():
            file.createVariable(name, "f8", ("row",))[:] = values
    return table


@pytest.mark.parametrize("name", ["record.csv", "record.nc"])
def test_a_record_is_the_signal_it_was_written_from(tmp_path: Path, name: str) -> None:
    record(tmp_path / name)
    source = dampen.Recorded(str(tmp_path / name), {"tip_phi": "force"}, base="ground", scale=0.5)
    error = 0.5 * (6.6 * np.pi) ** 2 * 0.005**2 / 8
    force, ground = source.at_ports(0, T, SITE), source.base_acceleration(0, T, SITE)
    np.testing.assert_allclose(force[:, 1], 0.5 * np.sin(6.6 * np.pi * T), atol=1.01 * error)
    np.testing.assert_allclose(ground, 0.5 * np.cos(4.4 * np.pi * T), atol=1.01 * error)
    assert not force[:, 0].any()
    assert 3.3 <= source.content(0, SITE).port_frequency[1] < 5
    assert 2.2 <= source.content(0, SITE).load_frequency < 5
    assert energy_account(dampen.simulate(case(source))).error < 1e-11


def test_the_frequency_of_a_record_is_that_of_its_signal_or_little_more() -> None:
    """More by 50 over the length at most: what the ends of a cut sinusoid spread."""
    t = np.linspace(0, 20, 20001)
    for f in (1.0, 7.3, 60.0):
        for phase in (0.0, 1.0):
            wave = Recording(t, {"a": np.cos(2 * np.pi * f * t + phase) + 0.1 * t + 5})
            assert f * 0.99 <= wave.highest_frequency("a") <= f + 50 / t[-1]
    assert Recording(t, {"a": 3 * t + 1}).highest_frequency("a") == 0
    noise = dampen.BandNoise({"tip_w": 1.0}, 1, 20, trials="continue").at_ports(0, t, SITE)[:, 0]
    assert Recording(t, {"a": noise}).highest_frequency("a") == pytest.approx(20, rel=0.02)


def test_a_record_may_begin_at_any_time_and_have_rows_at_any_distance() -> None:
    wave = Recording(np.array([1.0, 2.0, 4.0]), {"a": np.array([0.5, 1.5, 3.5])})
    t = np.array([0.0, 1.0, 2.5, 4.0, 5.5, 7.0])
    np.testing.assert_allclose(wave.at("a", t), [0, 0.5, 2.0, 3.5, 0, 0])
    np.testing.assert_allclose(wave.at("a", t, "hold"), [0.5, 0.5, 2.0, 3.5, 3.5, 3.5])
    np.testing.assert_allclose(wave.at("a", t, "repeat"), [2.5, 0.5, 2.0, 0.5, 2.0, 0.5])


def test_a_short_burst_in_a_coarse_record_is_as_fast_as_it_is() -> None:
    """50 Hz for half a second, in rows of a millisecond, within a minute of rows that are a second apart."""
    burst = np.arange(30, 30.5, 1e-3)
    t = np.concatenate([np.arange(30), burst, np.arange(31, 61)])
    a = np.where((t >= 30) & (t <= 30.5), np.sin(2 * np.pi * 50 * (t - 30)) * np.sin(2 * np.pi * (t - 30)) ** 2, 0.0)
    assert 50 < Recording(t, {"a": a}).highest_frequency("a") < 60


HEADERS = {
    "tabs": "time\tforce\n0\t1\n1\t2\n",
    "semicolons": "time;force\n0;1\n1;2\n",
    "quotes": "\"time\", 'force'\n0,1\n1,2\n",
    "a hash": "# time, force\n0,1\n1,2\n",
    "a mark of the encoding": "\ufefftime,force\n0,1\n1,2\n",
    "blank lines": "\ntime,force\n\n0,1\n\n1,2\n\n",
}


@pytest.mark.parametrize("how", HEADERS)
def test_columns_are_found_as_spreadsheets_and_programs_write_them(tmp_path: Path, how: str) -> None:
    (tmp_path / "r.csv").write_text(HEADERS[how], encoding="utf-8")
    source = dampen.Recorded(str(tmp_path / "r.csv"), {"tip_w": "force"})
    np.testing.assert_allclose(source.at_ports(0, np.array([0.0, 0.25, 1.0]), SITE)[:, 0], [1.0, 1.25, 2.0])


def test_a_record_in_the_older_format_of_netcdf_is_one_too_and_rows_must_be_of_equal_number(tmp_path: Path) -> None:
    import netCDF4

    path = tmp_path / "r.nc"
    with netCDF4.Dataset(path, "w", format="NETCDF3_CLASSIC") as file:
        for name, values in {"time": [0.0, 1.0], "force": [1.0, 3.0], "long": [1.0, 2.0, 3.0]}.items():
            file.createDimension(name, len(values))
            file.createVariable(name, "f8", (name,))[:] = values
    source = dampen.Recorded(str(path), {"tip_w": "force"})
    np.testing.assert_allclose(source.at_ports(0, np.array([0.5]), SITE)[:, 0], 2.0)
    with pytest.raises(
        dampen.ArgumentError, match=r"must have rows of equal number in `r.nc`, but has `time` \(2,\), `long` \(3,\)"
    ):
        dampen.Recorded(str(path), {"tip_w": "long"})


def test_outside_a_record_there_is_nothing_or_the_record_again(tmp_path: Path) -> None:
    record(tmp_path / "r.csv", 201, 1.0)
    once = dampen.Recorded(str(tmp_path / "r.csv"), {"tip_w": "force"})
    assert not once.at_ports(0, T[1000:], SITE).any()
    again = replace(once, outside="repeat").at_ports(0, T, SITE)
    np.testing.assert_allclose(again[1000:], again[:1000], atol=1e-12)
    runs_on = replace(once, trials="continue")
    assert not runs_on.at_ports(1, T, SITE).any()


def test_the_hash_pins_a_record_s_content(tmp_path: Path) -> None:
    path = tmp_path / "r.csv"
    record(path)
    source = dampen.Recorded(str(path), {"tip_w": "force"})
    assert len(source.sha256) == 64
    kept = to_toml(case(source))
    path.write_text("time,force\n0,0\n2,1\n")
    changed = build(parse(kept, "kept"))
    with pytest.raises(dampen.ArgumentError, match=r"^Argument `disturbance.sha256` must be \w{12}..., that of `r.csv`, but is"):
        dampen.simulate(changed)
    path.unlink()
    assert build(parse(kept, "kept")).disturbance == source, "what a result keeps is read without the record"
    with pytest.raises(dampen.ArgumentError, match=r"^Argument `disturbance.file` names .*r.csv`, which cannot be read: No such"):
        dampen.simulate(changed)


BAD_RECORDS = {
    "time,forc\n0,0\n1,1\n": "Argument `columns.tip_w` names the column `force`, which `r.csv` has not; did you mean `forc`?",
    "t,force\n0,0\n1,1\n": "Argument `time` names the column `time`, which `r.csv` has not; known here: t, force.",
    "time,force\n0,0\n1,1\n1,2\n": "Argument `time` must name a column that increases from row to row, but row 3 does not.",
    "time,force\n0,0\n": "Argument `time` must name a column that increases from row to row, but there is one row.",
    "time,force\n0,0\n1,nan\n": "Argument `columns.tip_w` must name a column of finite numbers in `r.csv`, but row 2 of",
    "time,force\n": "Argument `time` must name a column of finite numbers in `r.csv`, but it is empty.",
    "time,force\n0,0\n1,much\n": "Argument `file` names `r.csv`, which is not a table of numbers: could not convert",
    "": "Argument `time` names the column `time`, which `r.csv` has not",
}


@pytest.mark.parametrize("text", list(BAD_RECORDS))
def test_a_bad_record_gets_one_clear_line(tmp_path: Path, text: str) -> None:
    path = tmp_path / "r.csv"
    path.write_text(text)
    with pytest.raises(dampen.ArgumentError) as error:
        dampen.Recorded(str(path), {"tip_w": "force"})
    assert len(error.value.lines) == 1
    assert error.value.lines[0].startswith(BAD_RECORDS[text])


def test_a_gap_in_a_netcdf_record_is_refused(tmp_path: Path) -> None:
    import netCDF4

    path = tmp_path / "r.nc"
    record(path)
    with netCDF4.Dataset(path, "a") as file:
        file["force"][7] = np.ma.masked
    with pytest.raises(dampen.ArgumentError, match="but row 8 of `force` is nan"):
        dampen.Recorded(str(path), {"tip_w": "force"})


def test_a_record_is_looked_for_beside_its_scenario(tmp_path: Path) -> None:
    record(tmp_path / "r.csv")
    text = to_toml(case(dampen.NoDisturbance())).replace(
        '[disturbance]\nkind = "none"', '[disturbance]\nkind = "recorded"\nfile = "r.csv"\ncolumns = { tip_w = "force" }'
    )
    (tmp_path / "mine.toml").write_text(text)
    source = dampen.read_scenario(tmp_path / "mine.toml").disturbance
    assert isinstance(source, dampen.Recorded)
    assert source == dampen.Recorded(str(tmp_path / "r.csv"), {"tip_w": "force"})


# Functions


def test_functions_with_the_paper_s_formulas_are_the_paper_s_families() -> None:
    own = dampen.FunctionDisturbance(
        13.5, {"tip_w": waves, "tip_phi": "tests.test_disturbances:faster_waves"}, standing, shortest_wave=1 / 9
    )
    ours, theirs = (Bench(case(s)).shaking(0) for s in (own, dampen.HarmonicFamilies(frozen_at=2)))
    for mine, other in zip(ours, theirs, strict=True):
        np.testing.assert_allclose(mine, other, atol=1e-13)


def test_functions_of_scalars_only_are_called_point_by_point() -> None:
    source = dampen.FunctionDisturbance(1.0, {"tip_w": scalar_only}, lambda x, t: math.sin(x) * t)
    np.testing.assert_allclose(source.at_ports(0, T, SITE)[:, 0], np.where(T > 1, np.cos(3 * T), 0))
    np.testing.assert_allclose(source.load(0, T, X, SITE), np.outer(T, np.sin(X)))


@pytest.mark.parametrize(("f", "expected"), [(lambda x, t: 2.0, 2.0), (lambda x, t: x, X[None, :]), (lambda x, t: t, T[:, None])])
def test_a_load_that_does_not_depend_on_both_is_spread(f: object, expected: Array) -> None:
    source = dampen.FunctionDisturbance(1.0, load_function=f)  # type: ignore[arg-type]
    np.testing.assert_array_equal(source.load(0, T, X, SITE), np.broadcast_to(expected, (len(T), len(X))))


def test_a_function_that_fails_is_named_with_its_line() -> None:
    line = falls.__code__.co_firstlineno + 1
    words = r"^Argument `disturbance.force.tip_w` is the function `tests.test_disturbances:falls`, which fails: "
    with pytest.raises(dampen.ArgumentError, match=words + rf"IndexError: .* \(test_disturbances.py, line {line}\)\.$"):
        dampen.simulate(case(dampen.FunctionDisturbance(1.0, {"tip_w": falls})))


def test_a_function_that_returns_the_wrong_shape_is_named() -> None:
    source = dampen.FunctionDisturbance(1.0, {"tip_w": lambda t: t[:3]}, load_function=lambda x, t: np.full_like(t, np.nan))
    with pytest.raises(dampen.ArgumentError, match=r"must return an array of shape \(2000,\) .* but returns \(3,\)"):
        source.at_ports(0, T, SITE)
    with pytest.raises(dampen.ArgumentError, match=r"`disturbance.load_function` .* must return finite numbers, but returns nan"):
        source.load(0, T, X, SITE)


# Sums


def sum_of_three() -> dampen.Sum:
    inner = dampen.Sum((dampen.Impulse(0.02, {"tip_w": 0.01}, blow=0.02, x=0.4, at=0.3), dampen.ConstantLoad({}, 0.2)))
    return dampen.Sum((dampen.Harmonics((2.0,), {"tip_phi": (0.1,)}), inner, dampen.HarmonicFamilies(frozen_at=1)))


def test_a_sum_is_its_parts_added() -> None:
    source = sum_of_three()
    assert len(source.parts) == 4
    whole = Bench(case(source)).shaking(0)
    parts = [Bench(case(part)).shaking(0) for part in source.parts]
    for k in range(3):
        np.testing.assert_allclose(whole[k], sum(part[k] for part in parts), atol=1e-13)


def test_motion_and_work_under_a_sum_are_the_sums_of_motion_and_work() -> None:
    """The structure is linear: motions add; and the account of the sum closes."""
    source = sum_of_three()
    whole = dampen.simulate(case(source))
    alone = [dampen.simulate(case(part)) for part in source.parts]
    np.testing.assert_allclose(whole["y"], sum(np.asarray(r["y"]) for r in alone), atol=1e-13)
    assert energy_account(whole).error < 1e-11


def test_a_sum_is_as_old_as_the_latest_of_its_terms() -> None:
    steady, early, late = dampen.ConstantLoad(), dampen.Impulse(1.0, trial=0), dampen.Impulse(1.0, trial=2)
    assert [dampen.Sum((steady,)).same_as(j) for j in range(4)] == [0, 0, 0, 0]
    assert [dampen.Sum((steady, early, late)).same_as(j) for j in range(5)] == [0, 1, 2, 1, 1]
    assert [dampen.Sum((steady, dampen.BandNoise({}, 1, 2))).same_as(j) for j in range(3)] == [0, 1, 2]
    assert dampen.Sum(()).same_as(3) == 0


# Trials


def clocked(trials: str, path: Path) -> list[dampen.Disturbance]:
    record(path, 1601, 8.0)
    return [
        dampen.Harmonics((0.7,), {"tip_w": (1.0,)}, trials=trials),  # type: ignore[arg-type]
        dampen.BandNoise({"tip_w": 1.0}, 1, 5, trials=trials),  # type: ignore[arg-type]
        dampen.BaseShaking((0.7,), (1.0,), rms=1.0, low=1, high=5, trials=trials),  # type: ignore[arg-type]
        dampen.MovingLoad(1.0, 0.2, trials=trials),  # type: ignore[arg-type]
        dampen.Recorded(str(path), {"tip_w": "force"}, trials=trials),  # type: ignore[arg-type]
        dampen.FunctionDisturbance(1.0, {"tip_w": np.cos}, lambda x, t: x * np.cos(t), trials=trials),  # type: ignore[arg-type]
    ]


def sampled(source: dampen.Disturbance, trial: int, t: Array) -> Array:
    """All that a disturbance has, side by side."""
    parts = [source.at_ports(trial, t, SITE), source.base_acceleration(trial, t, SITE)]
    parts += [source.load(trial, t, X, SITE)] if source.load_field else []
    parts += [np.column_stack(source.point_load(trial, t, SITE))] if source.point_field else []
    return np.column_stack([part for part in parts if part is not None])


def test_repeat_is_the_same_in_each_of_three_trials(tmp_path: Path) -> None:
    for source in clocked("repeat", tmp_path / "r.csv"):
        assert [source.same_as(j) for j in range(3)] == [0, 0, 0]
        for j in (1, 2):
            np.testing.assert_array_equal(sampled(source, j, T), sampled(source, 0, T))


def test_continue_goes_on_where_the_last_trial_ended(tmp_path: Path) -> None:
    for source in clocked("continue", tmp_path / "r.csv"):
        assert [source.same_as(j) for j in range(3)] == [0, 1, 2]
        for j in (0, 1):
            np.testing.assert_allclose(sampled(source, j, T + SITE.duration), sampled(source, j + 1, T), atol=1e-11)
        assert np.abs(sampled(source, 1, T) - sampled(source, 0, T)).max() > 0.1


def test_random_is_fresh_in_each_of_three_trials() -> None:
    source = dampen.BandNoise({"tip_w": 1.0}, 1, 20, trials="random")
    assert [source.same_as(j) for j in range(3)] == [0, 1, 2]
    result = dampen.simulate(case(source, "task.trials=3"))
    shaken = np.asarray(result["disturbance"])[..., 0]
    assert np.abs(np.corrcoef(shaken) - np.eye(3)).max() < 0.5
    np.testing.assert_allclose(np.sqrt(np.mean(shaken**2, axis=1)), 1, rtol=1e-12)


# Files and bad input


def every_kind(path: Path) -> list[dampen.Disturbance]:
    record(path)
    return [
        *clocked("continue", path),
        *sum_of_three().parts,
        sum_of_three(),
        dampen.BandNoise({"tip_w": 0.1, "tip_phi": 0.2}, 1, 5, seed=7, trials="random"),
        dampen.FunctionDisturbance(3.0, {"tip_w": waves}, standing, shortest_wave=0.2),
        dampen.Sum((dampen.FunctionDisturbance(3.0, {"tip_w": waves}), dampen.Recorded(str(path), {"tip_w": "force"}))),
        dampen.NoDisturbance(),
    ]


def test_every_disturbance_written_out_reads_back_the_same(tmp_path: Path) -> None:
    sources = every_kind(tmp_path / "r.csv")
    from dampen.scenarios.kinds import KINDS

    assert {type(source) for source in sources} == set(KINDS["disturbance"])
    for source in sources:
        if isinstance(source, dampen.FunctionDisturbance) and source.load_function is not standing:
            continue  # a lambda has no name to be found by
        original = case(source)
        assert build(parse(to_toml(original), "written")) == original


def test_a_result_file_with_a_sum_reads_back(tmp_path: Path) -> None:
    from dampen.simulation.stores import FileStore

    source = dampen.Sum((dampen.FunctionDisturbance(3.0, {"tip_w": waves}, standing), dampen.ConstantLoad({"tip_w": 0.1})))
    made = dampen.simulate(case(source), store=FileStore(tmp_path / "result.nc"))
    assert dampen.load(tmp_path / "result.nc").scenario == made.scenario


BAD = {
    "{kind='harmonics', frequencies=[1.0, 2.0], force={tip_w=[1.0]}}": (
        "Argument `disturbance.force.tip_w` must have one number for each of 2 frequencies, but is [1.0]."
    ),
    "{kind='harmonics', frequencies=[1.0], phases=[1.0, 2.0], force={}}": (
        "Argument `disturbance.phases` must have one number for each of one frequency, or none at all, but is [1.0, 2.0]."
    ),
    "{kind='harmonics', frequencies=[1.0], force={tipw=[1.0]}}": (
        "Argument `disturbance.force.tipw` is not a port of this plant; known here: tip_w, tip_phi."
    ),
    "{kind='band-noise', rms={tip_w=1.0}, low=5.0, high=2.0}": "Argument `disturbance.low` must be < `high`, 2 Hz, but is 5.",
    "{kind='band-noise', rms={tip_w=-1.0}, low=5.0, high=20.0}": (
        "Argument `disturbance.rms.tip_w` must be >= 0 N, N m, but is -1.0."
    ),
    "{kind='impulse', duration=0.1, blow=1.0}": "Argument `disturbance.x` must be given: the place of the `blow`.",
    "{kind='impulse', duration=0.1, blow=1.0, x=0.1, field='u'}": (
        "Argument `disturbance` loads `u`, which is not a field of this plant; known here: w, phi."
    ),
    "{kind='recorded', file='/nowhere/r.csv'}": (
        "Argument `disturbance.file` names `/nowhere/r.csv`, which cannot be read: No such file or directory."
    ),
    "{kind='function', highest_frequency=1.0, force={tip_w='waves'}}": (
        "Argument `disturbance.force.tip_w` must name a function as \"module:name\", but is 'waves'."
    ),
    "{kind='function', highest_frequency=1.0, force={tip_w='nowhere:waves'}}": (
        "Argument `disturbance.force.tip_w` names 'nowhere:waves', which cannot be loaded: ModuleNotFoundError"
    ),
    "{kind='function', force={}}": (
        "Argument `disturbance.highest_frequency` must be given: the highest frequency that there is in any of it."
    ),
    "{kind='sum', terms=[{kind='constant', force={tip_x=1.0}}]}": (
        "Argument `disturbance.terms[0].force.tip_x` is not a port of this plant; known here: tip_w, tip_phi."
    ),
    "{kind='sum', terms=[{kind='constnt'}]}": "Argument `disturbance.terms[0].kind` must be a known kind of disturbance",
    "{kind='moving-load', force=1.0, speed=1.0, trials='random'}": "Argument `disturbance.trials` must be 'repeat' or 'continue'",
}


@pytest.mark.parametrize("table", list(BAD))
def test_bad_input_gets_one_clear_line(table: str) -> None:
    with pytest.raises(dampen.ArgumentError) as error:
        scenario(f"disturbance={table}")
    assert len(error.value.lines) == 1
    assert error.value.lines[0].startswith(BAD[table])


def test_a_blow_beyond_the_structure_is_refused_before_the_run() -> None:
    with pytest.raises(dampen.ArgumentError, match=r"`disturbance.x` must be <= 1 m, the length of the structure, but is 1\.5"):
        Bench(case(dampen.Impulse(0.1, blow=1.0, x=1.5, trial=4)))


def test_what_shakes_too_fast_for_the_step_is_refused() -> None:
    for source in (
        dampen.Impulse(0.003, {"tip_w": 1.0}),
        dampen.BaseShaking((300.0,), (1.0,)),
        dampen.Sum((dampen.ConstantLoad(), dampen.BandNoise({"tip_w": 1.0}, 1, 400))),
        dampen.FunctionDisturbance(300.0, {"tip_w": waves}),
    ):
        with pytest.raises(dampen.ArgumentError, match=r"`numerics\.step` must be <"):
            Bench(case(source))


# References


def test_minimum_jerk_starts_and_ends_at_rest_and_is_held() -> None:
    reference = dampen.MinimumJerk(target=0.3, duration=1.0, start=0.1, begin=0.5)
    t = np.linspace(0, 2, 20001)
    r, h = reference.sample(t, 0), t[1]
    assert set(r[t < 0.5]) == {0.1}
    np.testing.assert_allclose(r[t > 1.5], 0.3, rtol=1e-15)
    assert r[10000] == pytest.approx(0.2)
    rate = np.gradient(r, h)
    assert rate.max() == pytest.approx(0.2 * 15 / 8, rel=1e-6)
    assert np.abs(np.diff(rate)).max() / h < 0.2 * 10 / np.sqrt(3) * 1.001


def test_a_sinusoid_with_a_ramp_starts_at_rest_and_is_then_the_sinusoid() -> None:
    plain = dampen.Sinusoid(amplitude=0.1, frequency=2.0, offset=0.05, phase=1.0)
    t = np.linspace(0, 2, 2001)
    np.testing.assert_allclose(plain.sample(t, 3), 0.05 + 0.1 * np.sin(4 * np.pi * t + 1))
    gentle = replace(plain, ramp=0.5).sample(t, 0)
    assert gentle[0] == 0.05
    assert abs(gentle[1] - gentle[0]) < 1e-8
    np.testing.assert_array_equal(gentle[t >= 0.5], plain.sample(t, 0)[t >= 0.5])


def test_a_recorded_reference_is_held_outside_the_record(tmp_path: Path) -> None:
    record(tmp_path / "r.nc", 401, 1.0)
    reference = dampen.RecordedSignal(str(tmp_path / "r.nc"), "ground", scale=0.1)
    r = reference.sample(T, 0)
    np.testing.assert_allclose(r[:1000], 0.1 * np.cos(4.4 * np.pi * T[:1000]), atol=0.1 * (4.4 * np.pi) ** 2 * 0.0025**2 / 8)
    np.testing.assert_allclose(r[1000:], 0.1 * np.cos(4.4 * np.pi))
    np.testing.assert_allclose(dampen.Hold(0.2).sample(T, 1), 0.2)
    with pytest.raises(dampen.ArgumentError, match=r"`column` names the column `grond`, .* did you mean `ground`"):
        replace(reference, column="grond", sha256="")
