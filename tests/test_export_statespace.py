"""The plant as a state-space model: against receptances in closed form, against the simulation, and read back from files."""

from __future__ import annotations

import math
import subprocess
import sys
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, BinaryIO

import control
import numpy as np
import pytest
from scipy.io import loadmat
from scipy.linalg import expm

import dampen
from dampen.cli import main
from dampen.export.balanced import balanced
from dampen.export.files import write_model
from dampen.export.linear import linear_model
from dampen.plants.assembled import Assembled, AssembledPort
from dampen.simulation.stores import FileStore
from tests.conftest import scenario

DAMPED = dampen.Damping(viscous=0.3)
RULER = dampen.EulerBernoulliBeam(tip_mass=0.0, tip_inertia=0.0, damping=DAMPED)
LOADED = dampen.EulerBernoulliBeam(damping=DAMPED)
THICK = dampen.TimoshenkoBeam(damping=DAMPED)


def experiment(plant: dampen.Plant, **changes: object) -> dampen.Scenario:
    return replace(scenario("task.trials=1"), plant=plant, claims=None, **changes)


def complex_parts(damping: dampen.Damping, omega: float) -> tuple[complex, complex]:
    """What Kelvin-Voigt damping makes of stiffness, and viscous drag of mass, at a frequency."""
    return 1 + 1j * omega * damping.kelvin_voigt, 1 - 1j * damping.viscous / omega


def cantilever_tip(beam: dampen.EulerBernoulliBeam, omega: float) -> complex:
    """w(L)/F of a bare cantilever: L^3/(EI a^3) (sin a cosh a - cos a sinh a)/(1 + cos a cosh a), a^4 = rho omega^2 L^4/EI."""
    stiffer, heavier = complex_parts(beam.damping, omega)
    ei, rho, length = beam.bending_stiffness * stiffer, beam.mass_per_length * heavier, beam.length
    a = length * (rho * omega**2 / ei) ** 0.25
    shape = (np.sin(a) * np.cosh(a) - np.cos(a) * np.sinh(a)) / (1 + np.cos(a) * np.cosh(a))
    return complex(length**3 / (ei * a**3) * shape)


def receptance(beam: dampen.EulerBernoulliBeam | dampen.TimoshenkoBeam, omega: float) -> np.ndarray:
    """(2, 2) displacements at the tip per force and torque, by the exact solution of w, phi, shear force and moment along x."""
    stiffer, heavier = complex_parts(beam.damping, omega)
    thick = isinstance(beam, dampen.TimoshenkoBeam)
    shear = 1 / (beam.shear_stiffness * stiffer) if thick else 0.0
    rotary = beam.rotary_inertia * heavier * omega**2 if thick else 0.0
    ei = beam.bending_stiffness * stiffer
    rho = beam.mass_per_length * heavier * omega**2
    along = np.array([[0, 1, shear, 0], [0, 0, 0, 1 / ei], [-rho, 0, 0, 0], [0, -rotary, -1, 0]], complex)
    free = [1, 2] if not thick and beam.base == "pinned" else [2, 3]  # clamped: w = phi = 0 at x = 0
    end = expm(along * beam.length)[:, free]
    inertia = heavier * omega**2 * np.diag([beam.tip_mass, beam.tip_inertia])
    return np.asarray(end[:2] @ np.linalg.inv(end[2:] - inertia @ end[:2]))


def exported(plant: dampen.Plant, omega: float, modes: int, residual: bool) -> np.ndarray:
    model = dampen.state_space(experiment(plant), modes, residual=residual)
    return np.asarray(model(1j * omega))


@pytest.mark.parametrize("omega", [3.0, 60.0, 400.0])
def test_the_frequency_response_of_a_cantilever_is_the_one_of_the_textbook(omega: float) -> None:
    # What 30 modes and the residual leave is sum b^2 omega^2/omega_n^4 over the others: with b^2 = 4/(rho L) and omega_n ~
    # (pi n)^2 sqrt(EI/rho)/L^2 less than 5e-12 m/N at 400 rad/s, 1e-8 of the response there
    exact = cantilever_tip(RULER, omega)
    assert exported(RULER, omega, 30, True)[0, 0] == pytest.approx(exact, rel=1e-7)
    assert receptance(RULER, omega)[0, 0] == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize(("beam", "omega", "tolerance"), [(LOADED, 47.0, 1e-7), (THICK, 11.0, 1e-5)])
def test_the_frequency_response_between_all_ports_is_the_exact_one(beam: dampen.Plant, omega: float, tolerance: float) -> None:
    # of the largest entry; slow where waves are not dispersive: what 60 modes of a Timoshenko beam leave falls as n^-3
    exact = receptance(beam, omega)
    np.testing.assert_allclose(exported(beam, omega, 60, True), exact, atol=tolerance * np.abs(exact).max())


@pytest.mark.parametrize(
    ("beam", "omega", "few", "bare", "with_residual"),
    [(RULER, 20.0, 8, 3, 7), (replace(THICK, tip_mass=0.0, tip_inertia=0.0), 11.0, 24, 1, 3)],
)
def test_the_residual_compliance_makes_modes_converge_four_or_two_orders_faster(
    beam: dampen.Plant, omega: float, few: int, bare: int, with_residual: int
) -> None:
    # Frequencies grow as n^2 (Euler-Bernoulli) or n (Timoshenko), and mode n adds b^2/omega_n^2: the tail is n^-3 or n^-1.
    # With its static part given, b^2 omega^2/omega_n^4 is left: n^-7 or n^-3.
    exact = receptance(beam, omega)[0, 0]
    for residual, order in ((False, bare), (True, with_residual)):
        off = [abs(exported(beam, omega, n, residual)[0, 0] - exact) for n in (few, 2 * few)]
        assert np.log2(off[0] / off[1]) == pytest.approx(order, abs=0.4)


def test_under_kelvin_voigt_damping_the_modes_converge_to_the_exact_response_too() -> None:
    # Here the modes left out also answer with the drag omega kelvin_voigt of their stiffness, which no static part holds.
    beam = replace(LOADED, damping=dampen.Damping(kelvin_voigt=1e-4))
    exact = receptance(beam, 40.0)
    off = [np.abs(exported(beam, 40.0, n, True) - exact).max() / np.abs(exact).max() for n in (20, 80)]
    assert off[1] < 0.3 * off[0] < 1e-4


@pytest.mark.parametrize("discrete", [False, True])
@pytest.mark.parametrize("plant", [LOADED, THICK, dampen.EulerBernoulliBeam(base="pinned", damping=dampen.Damping(viscous=0.2))])
def test_the_step_response_is_the_simulations(plant: dampen.Plant, discrete: bool) -> None:
    force = {"tip_w": 0.4, "tip_phi": -0.05}
    run = dampen.simulate(
        experiment(
            plant, controller=dampen.OpenLoop(command=force), disturbance=dampen.NoDisturbance(), actuators={}, bounds={},
            numerics=dampen.Numerics(modes=12, step=1e-3), task=dampen.Task(trials=1, trial_duration=1.0),
        )
    )  # fmt: skip
    model = dampen.state_space(run.scenario, discrete=discrete)
    held = np.tile(np.array(list(force.values()))[:, None], len(run.time))
    answer = control.forced_response(model, run.time, held)
    np.testing.assert_allclose(answer.outputs.T, run["y"][0], atol=1e-6 * np.abs(run["y"][0]).max())


def test_the_rates_are_the_derivatives_of_the_displacements() -> None:
    response = np.asarray(dampen.state_space(experiment(LOADED), 10, rates=True)(7.0j))
    np.testing.assert_allclose(response[2:], 7.0j * response[:2], rtol=1e-12)


def test_the_discrete_model_is_the_kernels_own_step_to_the_last_digits() -> None:
    shaken = experiment(THICK, numerics=dampen.Numerics(modes=8))
    held, free = linear_model(shaken, dt=1e-3), linear_model(shaken)
    size, inputs = free.b.shape
    both = np.zeros((size + inputs,) * 2)
    both[:size, :size], both[:size, size:] = free.a, free.b
    moved = expm(1e-3 * both)
    np.testing.assert_allclose(held.a, moved[:size, :size], atol=1e-11)
    np.testing.assert_allclose(held.b, moved[:size, size:], atol=1e-14)


def test_the_base_and_the_modal_forces_are_inputs_where_they_are_asked_for() -> None:
    model = dampen.state_space(experiment(LOADED), 5, inputs=("ports", "modal", "base"))
    assert model.input_labels == ["tip_w_force", "tip_phi_torque", *(f"load_{i}" for i in range(1, 6)), "base_acceleration"]
    # a steady acceleration a bends the beam as its weight does: w(L) = -a (rho L^4/(8 EI) + M L^3/(3 EI))
    weight = LOADED.mass_per_length / 8 + LOADED.tip_mass / 3
    assert control.dcgain(model)[0, -1] == pytest.approx(-weight / LOADED.bending_stiffness, rel=1e-5)


def test_a_structure_that_is_free_to_turn_keeps_its_rigid_mode_and_its_residual() -> None:
    pinned = dampen.EulerBernoulliBeam(base="pinned", damping=DAMPED)
    assert np.sum(np.abs(control.poles(dampen.state_space(experiment(pinned), 4))) < 1) == 2
    exact = receptance(pinned, 30.0)
    bare, few, many = (np.abs(exported(pinned, 30.0, *how) - exact).max() for how in ((8, False), (8, True), (40, True)))
    assert few < 1e-3 * bare
    assert many < 1e-9 * np.abs(exact).max()


@dataclass(frozen=True)
class Loose(dampen.Plant):
    """A mass that nothing holds, known by its one mode."""

    @property
    def ports(self) -> tuple[dampen.Port, ...]:
        return (dampen.Port("block", "w", 0.0),)

    def modes(self, count: int, grid: int | None = None) -> dampen.Modes:
        return dampen.Modes(omega=np.zeros(1), b=np.array([[2.0]]), ports=self.ports)


def test_a_mass_known_by_its_mode_is_a_double_integrator_and_lacks_residual_and_base() -> None:
    loose = dampen.Scenario(
        plant=Loose(), controller=dampen.NoControl(), disturbance=dampen.NoDisturbance(), numerics=dampen.Numerics(modes=1)
    )  # fmt: skip
    assert dampen.state_space(loose)(2.0j) == pytest.approx(4 / -4.0)
    np.testing.assert_allclose(dampen.state_space(loose, discrete=0.1).B.ravel(), [2 * 0.1**2 / 2, 2 * 0.1])
    with pytest.raises(dampen.ArgumentError, match="`residual` must be false"):
        dampen.state_space(loose, residual=True)
    with pytest.raises(dampen.ArgumentError, match="cannot be shaken"):
        dampen.state_space(loose, inputs=("ports", "base"))


@pytest.mark.parametrize("dt", [0.0, 2e-3])
def test_balanced_truncation_is_off_by_no_more_than_its_bound(dt: float) -> None:
    whole = linear_model(experiment(dampen.EulerBernoulliBeam(damping=dampen.Damping(ratio=0.01))), 10, dt=dt)
    small, hankel = balanced(whole, 8)
    omega = np.geomspace(1, 1000, 200)
    points = np.exp(1j * omega * dt) if dt else 1j * omega
    response = [control.StateSpace(m.a, m.b, m.c, m.d, m.dt)(points) for m in (whole, small)]
    off = np.linalg.svd(np.moveaxis(response[0] - response[1], -1, 0), compute_uv=False).max()
    assert 0 < off <= 2 * hankel[8:].sum() * (1 + 1e-6)
    assert len(small.a) == 8


def test_a_mat_file_read_back_is_the_python_object(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("beam.mat", "beam.npz"):
        file = tmp_path / name
        arguments = ["dampen", "export", "statespace", "he2017", "--modes", "6", "--residual", "--discrete", "--out", str(file)]
        monkeypatch.setattr(sys, "argv", arguments)
        with pytest.raises(SystemExit) as done:
            main()
        assert done.value.code == 0
        back = loadmat(file, simplify_cells=True) if name.endswith("mat") else np.load(file)
        model = dampen.state_space(scenario(), 6, residual=True, discrete=True)
        for key in "ABCD":
            np.testing.assert_array_equal(back[key], getattr(model, key))
        assert float(back["dt"]) == model.dt == 0.001
        assert list(back["input_names"]) == model.input_labels
        assert list(back["output_names"]) == model.output_labels
        assert list(back["state_names"]) == model.state_labels
        assert list(back["input_units"]) == ["N", "N m"]
        assert dampen.version() == str(back["dampen_version"])
        (tmp_path / "again.toml").write_text(str(back["scenario"]))
        assert dampen.read_scenario(tmp_path / "again.toml") == scenario()


@pytest.mark.parametrize("name", ["beam.mat", "beam.npz"])
def test_a_file_that_is_there_stays_whole_where_the_new_one_cannot_be_written(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(file: BinaryIO, *_: object, **__: object) -> None:
        file.write(b"half")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("scipy.io.savemat", full)
    monkeypatch.setattr("numpy.savez_compressed", full)
    (tmp_path / name).write_bytes(b"the last one")
    with pytest.raises(dampen.ArgumentError, match=r"cannot be written: No space left on device\."):
        write_model(tmp_path / name, linear_model(scenario(), 3), scenario())
    assert [path.read_bytes() for path in tmp_path.iterdir()] == [b"the last one"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ({"discrete": "yes"}, "`discrete` must be true, false or a time step > 0 s, but is 'yes'"),
        ({"discrete": -0.1}, "`discrete` must be true, false or a time step > 0 s, but is -0.1"),
        ({"discrete": math.inf}, "`discrete` must be"),
        ({"modes": 6.0}, "`modes` must be a whole number from 1 to"),
        ({"modes": True}, "`modes` must be a whole number from 1 to"),
        ({"inputs": 3}, "`inputs` must be one or more of ports, base, modal, but is 3"),
        ({"modes": 6, "balanced": 2.5}, "`balanced` must be a whole number from 1 to the 12 states of the model, but is 2.5"),
    ],
)
def test_wrong_arguments_from_python_are_told_in_one_line(arguments: dict[str, Any], said: str) -> None:
    with pytest.raises(dampen.ArgumentError, match=said) as error:
        dampen.state_space(experiment(LOADED), **arguments)
    assert len(error.value.lines) == 1


@pytest.mark.parametrize("names", [("tip.w", "tip_w"), ("x", "x_rate")])
def test_every_signal_has_a_name_of_its_own_whatever_the_ports_are_called(names: tuple[str, str]) -> None:
    matrices = Assembled(
        mass=np.eye(2).tolist(), stiffness=np.eye(2).tolist(), port_vectors=np.eye(2).tolist(),
        port=tuple(AssembledPort(name) for name in names),
    )  # fmt: skip
    model = dampen.state_space(
        dampen.Scenario(
            plant=matrices, controller=dampen.NoControl(), disturbance=dampen.NoDisturbance(), numerics=dampen.Numerics(modes=2)
        ),
        rates=True,
    )
    assert len(model.output_labels) == model.noutputs == 4
    assert len(model.input_labels) == model.ninputs == 2


def test_a_name_in_the_place_of_a_scenario_is_told_in_one_line() -> None:
    with pytest.raises(dampen.ArgumentError, match=r"`scenario` must be a Scenario, as `dampen\.read_scenario` makes them"):
        dampen.state_space("he2017")  # type: ignore[arg-type]


def test_numbers_of_numpy_mean_what_pythons_mean() -> None:
    own = dampen.state_space(experiment(LOADED), np.int64(6), balanced=np.int64(4), discrete=np.True_)
    assert own.dt == 1e-3
    assert own.nstates == 4
    assert dampen.state_space(experiment(LOADED), 6, discrete=np.False_).dt == 0


def test_a_result_goes_to_a_mat_file_whole(tmp_path: Path) -> None:
    from dampen.export.files import write_result

    run = dampen.simulate(scenario("task.trials=2", "numerics.modes=10"))
    write_result(tmp_path / "run.mat", run)
    back = loadmat(tmp_path / "run.mat", simplify_cells=True)
    for name in run.layout.variables:
        np.testing.assert_array_equal(back[name], run[name])
    assert back["dims"]["y"] == "trial,time,port"
    assert list(back["at_port"]) == ["tip_w", "tip_phi"]
    np.testing.assert_array_equal(back["at_time"], run.time)
    assert back["run_status"] == run.status


def test_a_result_file_goes_to_a_mat_file_from_the_command_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    dampen.simulate(scenario("task.trials=1", "numerics.modes=10"), store=FileStore(Path("result.nc")))
    for name in ("run.mat", "run.npz"):
        monkeypatch.setattr(sys, "argv", ["dampen", "export", "result", "result.nc", "--out", name])
        with pytest.raises(SystemExit) as done:
            main()
        assert done.value.code == 0
    back = loadmat("run.mat", simplify_cells=True), np.load("run.npz")
    np.testing.assert_array_equal(back[0]["y"], back[1]["y"][0])
    assert back[0]["units"]["energy"] == back[1]["units_energy"] == "J"
    assert back[0]["scenario"] == back[1]["scenario"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["statespace", "he2017", "--out", "beam.txt"], "must end in .mat or .npz"),
        (["statespace", "he2017", "--out", "nowhere/beam.mat"], "cannot be written: No such file or directory."),
        (["statespace", "he2017", "--out", "beam.mat", "--modes", "0"], "Argument `modes` must be a whole number from 1 to"),
        (["statespace", "he2017", "--out", "beam.mat", "--balanced", "4"], "needs a plant whose every mode decays"),
        (["statespace", "he2017", "--out", "beam.mat", "--step", "0.1"], "`--step` must be > 0 s and go with `--discrete`"),
        (["statespace", "he2017", "--out", "beam.mat", "--discrete", "--step", "inf"], "`--step` must be > 0 s"),
        (["statespace", "he2018", "--out", "beam.mat"], "did you mean `he2017`?"),
        (["result", "none.nc", "--out", "run.mat"], "there is no such file"),
    ],
)  # fmt: skip
def test_bad_input_is_one_clear_line_and_status_2(
    arguments: list[str], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", ["dampen", "export", *arguments])
    with pytest.raises(SystemExit) as done:
        main()
    lines = capsys.readouterr().err.splitlines()
    assert done.value.code == 2
    assert len(lines) == 1
    assert said in lines[0]
    assert not list(tmp_path.iterdir())


def test_without_python_control_one_line_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "control", None)
    with pytest.raises(dampen.ArgumentError, match=r"pip install 'dampen\[export\]'"):
        dampen.state_space(scenario())


def test_importing_dampen_loads_neither_control_nor_gymnasium() -> None:
    code = "import sys, dampen; dampen.state_space; print([m for m in ('control', 'gymnasium', 'scipy.io') if m in sys.modules])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"
