"""Structures given by matrices: against the beam they approximate, from every kind of file, and what is refused."""

from __future__ import annotations

import hashlib
from pathlib import Path

import numpy as np
import pytest
from scipy.io import mmwrite
from scipy.sparse import csr_array, save_npz

import dampen
from dampen import Assembled, AssembledPort, AssembledShape, EulerBernoulliBeam
from dampen.analysis.energy import energy_account
from dampen.plants.eigen import rigid_modes, solve_modes
from dampen.scenarios.read import build, parse
from dampen.toml import to_toml

PORTS = (AssembledPort("tip_w", "force", 1.0, "w"), AssembledPort("tip_phi", "torque", 1.0, "phi"))
BEAM = EulerBernoulliBeam()


def hermite(elements: int, held: int = 2) -> tuple[np.ndarray, np.ndarray]:
    """Mass and stiffness of BEAM by cubic elements, nodes (w, phi); `held` degrees of freedom at x = 0 are left out."""
    h, rho, ei = 1.0 / elements, 0.47, 4.2
    units = np.outer([1, h, 1, h], [1, h, 1, h])
    bend = np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]])
    move = np.array([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]])
    k, m = ei / h**3 * units * bend, rho * h / 420 * units * move
    size = 2 * elements + 2
    mass, stiffness = np.zeros((size, size)), np.zeros((size, size))
    for e in range(elements):
        at = slice(2 * e, 2 * e + 4)
        mass[at, at] += m
        stiffness[at, at] += k
    mass[-2, -2] += 0.1
    mass[-1, -1] += 1e-4
    return mass[held:, held:], stiffness[held:, held:]


def cantilever(elements: int, **more: object) -> Assembled:
    mass, stiffness = hermite(elements)
    return Assembled(mass=mass, stiffness=stiffness, port_vectors=np.eye(2 * elements)[-2:], port=PORTS, **more)  # type: ignore[arg-type]


def shapes(elements: int) -> tuple[AssembledShape, ...]:
    x, rows = np.linspace(0, 1, elements + 1), np.vstack([np.zeros((2, 2 * elements)), np.eye(2 * elements)])
    return (AssembledShape("w", x, rows[::2]), AssembledShape("phi", x, rows[1::2], "rad"))  # type: ignore[arg-type]


def test_cubic_elements_tend_to_the_beam_at_fourth_order() -> None:
    exact = BEAM.modes(40).omega[:5]
    errors = [cantilever(n).modes(5).omega / exact - 1 for n in (8, 16, 32)]
    assert np.all(np.array(errors) > 0), "elements are too stiff, never too soft"
    np.testing.assert_allclose(np.log2(np.array(errors[:-1]) / np.array(errors[1:])), 4, atol=0.25)


def test_cubic_elements_give_the_beams_ports_compliance_and_fields() -> None:
    plant, beam, x = cantilever(40, shape=shapes(40)), BEAM.modes(40), np.linspace(0, 1, 41)
    modes = plant.modes(6)
    assert plant.fields == BEAM.fields
    assert plant.span == 1.0
    signs = np.sign(modes.b[0] * beam.b[0, :6])
    np.testing.assert_allclose((modes.b * signs)[:, :4], beam.b[:, :4], rtol=1e-5)
    np.testing.assert_allclose(modes.compliance, beam.compliance, rtol=1e-9)
    np.testing.assert_allclose(modes.field("w").shapes(x) * signs, beam.field("w").shapes(x)[:, :6], atol=1e-4)
    between = modes.field("w").shapes(np.array([0.0125]))
    np.testing.assert_allclose(between, modes.field("w").shapes(np.array([0.0, 0.025])).mean(axis=0)[None], atol=1e-14)


def test_a_load_on_the_fields_of_matrices_is_the_beams_load() -> None:
    modes, beam = cantilever(80, shape=shapes(80)).modes(4), BEAM.modes(40)
    both = []
    for m in (modes, beam):
        x, matrix = m.load_rule("w", 0.5)
        both.append(np.abs(np.cos(4 * x) @ matrix)[:4])
    np.testing.assert_allclose(*both, rtol=2e-3)


def test_translation_of_the_base_is_the_beams() -> None:
    rigid = np.tile([1.0, 0.0], 60)
    ours, beam = cantilever(60, translation=rigid).modes(5).translation, BEAM.modes(40).translation
    assert ours is not None
    assert beam is not None
    np.testing.assert_allclose(np.abs(ours), np.abs(beam[:5]), rtol=1e-3)
    assert cantilever(4).modes(2).translation is None


def test_the_free_beam_has_two_rigid_modes_of_zero_frequency() -> None:
    """cos(b) cosh(b) = 1 for its elastic ones."""
    for n in (4, 40, 120):
        mass, stiffness = hermite(n, held=0)
        mass[-2, -2] -= 0.1
        mass[-1, -1] -= 1e-4
        vectors = np.eye(2 * n + 2)[-2:]
        modes = Assembled(mass=mass, stiffness=stiffness, port_vectors=vectors, port=PORTS).modes(6)  # type: ignore[arg-type]
        np.testing.assert_array_equal(modes.omega[:2], 0.0)
        assert modes.compliance is None
        np.testing.assert_allclose(np.sum(modes.b[0, :2] ** 2), 4 / 0.47, rtol=1e-8)  # 1/m + (L/2)^2/I
        exact = np.array([4.730040744862704, 7.853204624095838])
        error = modes.omega[2:4] / (exact**2 * np.sqrt(4.2 / 0.47)) - 1
        assert np.all(error > 0)
        assert np.all(error < 1.02 * (exact / n) ** 4 / 1440), "the elements' own error, (b h)^4 / 1440"


def test_elastic_frequencies_do_not_lose_digits_to_rigid_modes() -> None:
    """A free chain of 400 equal masses, omega = 2 sin(k pi / 2n): closed form, over three decades."""
    n = 400
    chain = np.diag(np.full(n, 2.0)) - np.eye(n, k=1) - np.eye(n, k=-1)
    chain[0, 0] = chain[-1, -1] = 1.0
    omega, vectors = solve_modes(np.eye(n), chain, 50)
    assert rigid_modes(chain) == 1
    assert omega[0] == 0.0
    np.testing.assert_allclose(omega[1:], 2 * np.sin(np.arange(1, 50) * np.pi / (2 * n)), rtol=1e-11)
    np.testing.assert_allclose(vectors.T @ vectors, np.eye(50), atol=1e-11)
    heavy, _ = solve_modes(1e6 * np.eye(n), 1e-3 * chain, 50)
    np.testing.assert_allclose(heavy, omega * np.sqrt(1e-9), rtol=1e-11)


def test_a_structure_without_any_stiffness_is_rigid() -> None:
    omega, vectors = solve_modes(np.diag([4.0, 1.0]), np.zeros((2, 2)), 2)
    np.testing.assert_array_equal(omega, 0.0)
    np.testing.assert_allclose(np.sort(np.abs(vectors).sum(axis=0)), [0.5, 1.0])


def write(folder: Path) -> None:
    """The six-element cantilever in every kind of file."""
    mass, stiffness = hermite(6)
    mmwrite(folder / "mass.mtx", csr_array(mass), symmetry="symmetric", precision=17)
    mmwrite(folder / "stiffness.mtx", stiffness, precision=17)
    save_npz(folder / "mass.npz", csr_array(mass))
    np.save(folder / "stiffness.npy", stiffness)
    np.save(folder / "ports.npy", np.eye(12)[-2:])
    x, rows = np.linspace(0, 1, 7), np.vstack([np.zeros((2, 12)), np.eye(12)])
    np.savez(
        folder / "all.npz", mass=mass, stiffness=stiffness, port_vectors=np.eye(12)[-2:], port_names=["tip_w", "tip_phi"],
        port_efforts=["force", "torque"], port_x=[1.0, 1.0], port_fields=["w", "phi"], translation=np.tile([1.0, 0.0], 6),
        shape_names=["w", "phi"], shape_units=["m", "rad"], shape_x=x, shape_w=rows[::2], shape_phi=rows[1::2],
    )  # fmt: skip


def test_every_form_of_the_matrices_is_the_same_structure(tmp_path: Path) -> None:
    write(tmp_path)
    exact, path = cantilever(6).modes(12), lambda name: str(tmp_path / name)
    mass, stiffness = hermite(6)
    everything = Assembled(file=path("all.npz"))
    forms = [
        Assembled(mass=path("mass.mtx"), stiffness=path("stiffness.mtx"), port_vectors=path("ports.npy"), port=PORTS),
        Assembled(mass=path("mass.npz"), stiffness=path("stiffness.npy"), port_vectors=path("ports.npy"), port=PORTS),
        Assembled(mass=csr_array(mass), stiffness=stiffness.tolist(), port_vectors=np.eye(12)[-2:], port=PORTS),  # type: ignore[arg-type]
        everything,
        Assembled(file=path("all.npz"), mass=path("all.npz"), port=PORTS),
    ]
    for plant in forms:
        np.testing.assert_allclose(plant.modes(12).omega, exact.omega, rtol=1e-9)
        assert plant.ports == cantilever(6).ports
    assert everything.fields == BEAM.fields
    assert everything.modes(3).translation is not None
    assert forms[2] == cantilever(6)
    assert hash(forms[2]) == hash(cantilever(6))
    assert forms[2].fields == ()


def test_a_files_hash_is_recorded_and_compared(tmp_path: Path) -> None:
    write(tmp_path)
    plant = Assembled(file=str(tmp_path / "all.npz"))
    expected = hashlib.sha256((tmp_path / "all.npz").read_bytes()).hexdigest()
    assert plant.sha256 == expected
    assert f'sha256 = "{expected}"' in to_toml(dampen.Scenario(plant, dampen.NoControl(), dampen.NoDisturbance()))
    assert Assembled(file=plant.file, sha256=expected) == plant
    with pytest.raises(dampen.ArgumentError, match=r"`sha256` must be .*, the files' hash \(have they changed\?\), but is 'abc'"):
        Assembled(file=plant.file, sha256="abc")
    assert cantilever(6).sha256 == ""


def test_a_scenario_file_means_matrices_relative_to_its_folder(tmp_path: Path) -> None:
    write(tmp_path)
    port = [{"name": "tip_w", "x": 1.0}, {"name": "tip_phi", "effort": "torque", "x": 1.0}]
    table = {"kind": "assembled", "mass": "mass.mtx", "stiffness": "stiffness.npy", "port_vectors": "ports.npy", "port": port}
    case = build({"plant": table}, tmp_path)
    assert [p.name for p in case.plant.ports] == ["tip_w", "tip_phi"]
    assert build(parse(to_toml(case), "x")) == case
    inline = dampen.Scenario(cantilever(3, shape=shapes(3)), dampen.NoControl(), dampen.NoDisturbance())
    assert build(parse(to_toml(inline), "x")) == inline


GOOD = {
    "mass": [[2.0, 0.0], [0.0, 1.0]],
    "stiffness": [[2.0, -1.0], [-1.0, 1.0]],
    "port_vectors": [[0.0, 1.0]],
    "port": [AssembledPort("tip")],
}
WRONG = {
    "`mass` must be given, here or in `file`": {"mass": ()},
    "`mass` must be a square matrix, but is [1, 2]": {"mass": [[1.0, 0.0]]},
    "`mass` must have rows of one length": {"mass": [[1.0, 0.0], [0.0]]},
    "`mass` must be symmetric, but [0, 1] and [1, 0] differ by 0.5": {"mass": [[2.0, 0.5], [0.0, 1.0]]},
    "`mass` must be positive definite, but its least eigenvalue is -1": {"mass": [[2.0, 0.0], [0.0, -1.0]]},
    "`stiffness` must be of shape (2, 2), like the mass, but is [1, 1]": {"stiffness": [[1.0]]},
    "`stiffness` must be positive semidefinite, but its least eigenvalue against the mass is -1 (rad/s)^2": {
        "stiffness": [[4.0, 0.0], [0.0, -1.0]]
    },
    "`port_vectors` must be of shape (ports, 2), one row for each port, but is [1, 3]": {"port_vectors": [[0.0, 1.0, 0.0]]},
    "`port` must name 1 ports, one for each port vector, but is 2": {"port": [AssembledPort("a"), AssembledPort("b")]},
    "`translation` must be of shape (2,), one value for each degree of freedom, but is [3]": {"translation": [1.0, 1.0, 1.0]},
    "`shape` must have at least 2 points x, ascending, for `w`": {"shape": [AssembledShape("w", (0.0, 0.0), ((0.0, 0.0),))]},
    "`shape` must be of shape (2, 2), (points, dof), for `w`": {"shape": [AssembledShape("w", (0.0, 1.0), ((0.0, 1.0),))]},
    "`mass` names `/nowhere.mtx`, which cannot be read: No such file": {"mass": "/nowhere.mtx"},
    "`file` names `/dev/null`, which is no .npz, .npy or .mtx file": {"file": "/dev/null"},
    "`sha256` must be left out, since no file is named": {"sha256": "12"},
}


@pytest.mark.parametrize("words", WRONG)
def test_matrices_that_cannot_be_get_one_clear_line(words: str) -> None:
    with pytest.raises(dampen.ArgumentError) as error:
        Assembled(**{**GOOD, **WRONG[words]})  # type: ignore[arg-type]
    assert len(error.value.lines) == 1
    assert error.value.lines[0].startswith(f"Argument {words}")


@pytest.mark.parametrize(
    ("key", "value", "words"),
    [
        ("port_x", 3.0, "`file` has ports, shapes or a translation of a wrong kind"),
        ("port_efforts", ["push", "force"], '`file` must have port_efforts ("force" or "torque"), port_x and port_fields'),
        ("shape_x", ["a"] * 7, "`file` has ports, shapes or a translation of a wrong kind"),
        ("shape_names", ["w", "v"], "`file` must have shape_v"),
        ("port_vectors", 3.0, "`file` has ports, shapes or a translation of a wrong kind"),
        ("stiffness", [[1.0, np.nan], [0.0, 1.0]], "`stiffness` must hold finite numbers only"),
    ],
)
def test_files_with_wrong_keys_get_one_clear_line(tmp_path: Path, key: str, value: object, words: str) -> None:
    write(tmp_path)
    np.savez(tmp_path / "bad.npz", **{**dict(np.load(tmp_path / "all.npz")), key: value})  # type: ignore[arg-type]
    with pytest.raises(dampen.ArgumentError) as error:
        Assembled(file=str(tmp_path / "bad.npz"))
    assert len(error.value.lines) == 1
    assert error.value.lines[0].startswith(f"Argument {words}")


def test_two_ports_of_one_name_are_refused() -> None:
    two = {"port_vectors": [[0.0, 1.0], [1.0, 0.0]], "port": [AssembledPort("a"), AssembledPort("a")]}
    with pytest.raises(dampen.ArgumentError, match="`port` must give each its own name"):
        Assembled(**{**GOOD, **two})  # type: ignore[arg-type]


def test_without_shapes_there_are_no_fields_and_no_loads() -> None:
    plant = Assembled(**GOOD)  # type: ignore[arg-type]
    assert plant.fields == ()
    with pytest.raises(dampen.ArgumentError, match="needs a plant with that field; known here: none"):
        plant.modes(2).load_rule("w", 1.0)
    with pytest.raises(dampen.ArgumentError, match="cannot start from a shape: its inertia along x is not known"):
        cantilever(3, shape=shapes(3)).modes(2).project("w", np.ones_like)
    with pytest.raises(dampen.ArgumentError, match="`modes` must be <= 2, the number of modes"):
        plant.modes(3)


class Push(dampen.Disturbance):
    def at_ports(self, trial: int, t: np.ndarray, site: object) -> np.ndarray:
        return np.outer(np.sin(5 * t), np.eye(len(site.ports))[0])  # type: ignore[attr-defined]


@pytest.mark.parametrize("shaped", [True, False])
def test_matrices_run_like_the_beam_and_their_energy_closes(shaped: bool, tmp_path: Path) -> None:
    from dampen.simulation.stores import FileStore

    more = {"task": dampen.Task(trials=2, trial_duration=1.0), "numerics": dampen.Numerics(modes=8, step=1e-3)}
    plant = cantilever(30, shape=shapes(30)) if shaped else cantilever(30)
    case = dampen.Scenario(plant, dampen.NoControl(), Push(), **more)  # type: ignore[arg-type]
    result = dampen.simulate(case)
    beam = dampen.simulate(dampen.Scenario(BEAM, dampen.NoControl(), Push(), **more))  # type: ignore[arg-type]
    assert energy_account(result).error < 1e-11
    np.testing.assert_allclose(result["y"], beam["y"], atol=1e-3 * np.abs(beam["y"]).max())
    stored = dampen.simulate(case, store=FileStore(tmp_path / "result.nc"))
    np.testing.assert_array_equal(stored["y"][:], result["y"])
    assert result.dataset["y"].dims == ("trial", "time", "port")
