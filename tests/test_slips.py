"""Slips that newcomers make, and the line that sets each of them right."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

import dampen
from dampen.cli.run import perform
from dampen.cli.terminal import show_table
from dampen.component import suggestion
from dampen.listing import listing
from dampen.scenarios.read import parse
from dampen.simulation.bench import Bench
from dampen.toml import to_toml
from tests.conftest import scenario
from tests.test_scenarios import dampen_command

SETTINGS = {
    "plant.tip_mass=150g": "Argument `plant.tip_mass` must be a number in kg, without the unit, but is '150g'.",
    "plant.tip_mass=.15 kg": "Argument `plant.tip_mass` must be a number in kg, without the unit, but is '.15 kg'.",
    "task.trials=20x": "Argument `task.trials` must be a whole number, without the unit, but is '20x'.",
    "task.constraint.tip_w=5mm": "Argument `task.constraint.tip_w` must be a number or list of numbers or Constraint in m, rad, "
    "without the unit, but is '5mm'.",
    "plant.tip_mass=0,15": "Option `--set plant.tip_mass` must have a TOML value, but has '0,15'; did you mean "
    "--set 'plant.tip_mass=0.15'? Numbers have a decimal point.",
    "controller={kind=none}": "Option `--set controller` must have a TOML value, but has '{kind=none}'; did you mean "
    "--set 'controller={kind=\"none\"}'? Text needs quotes.",
    "task.constraint=0.05": "Argument `task.constraint` must be a table by port, such as {tip_w = 0.05} in m, rad, but is 0.05.",
    "task.constraint=[-1, 1]": "Argument `task.constraint` must be a table by port, such as {tip_w = [-1, 1]} in m, rad, but",
    "task.reference=x": "Argument `task.reference` must be a table by port, such as {tip_w = ...}, but is 'x'.",
    "disturbance={kind='constant', force=3}": "Argument `disturbance.force` must be a table by port, such as {tip_w = 3} in N, N",
}
LAW = ("controller.kind=boundary-damping", "controller.damping=3")


def refusal(*settings: str) -> str:
    with pytest.raises(dampen.ArgumentError) as error:
        scenario(*settings)
    (line,) = error.value.lines
    return line


@pytest.mark.parametrize("setting", SETTINGS)
def test_a_setting_that_slipped(setting: str) -> None:
    assert refusal(setting).startswith(SETTINGS[setting])


def test_what_goes_by_port_says_so() -> None:
    assert refusal(*LAW) == (
        "Argument `controller.damping` must be a table by port, such as {tip_w = 3} in N s/m, N m s, but is 3."
    )
    with pytest.raises(dampen.ArgumentError, match=r"`constraint` must be a table by port, such as \{tip_w = 0.005\} in m, rad"):
        dampen.Task(constraint=0.005)  # type: ignore[arg-type]


TEXTS = {
    "[controller]\nkind = boundary-damping": '(at line 2, column 8), `kind = boundary-damping`; did you mean `kind = "boundary-d',
    "title = My beam # long": '`title = My beam # long`; did you mean `title = "My beam" # long`? Text needs quotes.',
    "tip_mass = 0,15": "`tip_mass = 0,15`; did you mean `tip_mass = 0.15`? Numbers have a decimal point.",
    "damping = {tip_w = 0,5}\nx = 1": "`damping = {tip_w = 0,5}`; did you mean `damping = {tip_w = 0.5}`? Numbers have",
    "tip_mass = 150 g": "`tip_mass = 150 g`; numbers stand without their unit.",
    "[disturbance.terms]\n[disturbance.terms]\nx = 2": "`[disturbance.terms]`; each of a list of tables is written "
    "`[[disturbance.terms]]`.",
    "[actuator.all.chain]\n[actuator.all.chain]": "; each of a list of tables is written `[[actuator.all.chain]]`.",
    "[task]\ntrials = 2\n[task]\nstart = 1": ", `[task]`; merge the two `[task]` tables.",
    "[task\ntrials = 2": ", `[task`.",
    "a = 1\nb = '": ", `b = '`.",
    "x = " + "a" * 2000 + " !": f", `x = {'a' * 53}...`.",
}


@pytest.mark.parametrize("text", TEXTS)
def test_a_file_that_is_not_toml_is_told_by_its_line(text: str) -> None:
    with pytest.raises(dampen.ArgumentError) as error:
        parse(text, "mine.toml")
    (line,) = error.value.lines
    assert line.startswith("Scenario file `mine.toml` is not valid TOML: ")
    assert TEXTS[text] in line


@pytest.mark.parametrize(
    ("text", "named", "words"),
    [
        ('based_on = "he2018"', "mine.toml", "he2018` cannot be read: No such file or directory; did you mean `he2017`?"),
        ("", "mne.toml", "mne.toml` cannot be read: No such file or directory; did you mean `mine.toml`?"),
        ("", "quite-another.toml", "quite-another.toml` cannot be read: No such file or directory."),
    ],
)
def test_a_file_that_is_not_there_may_be_one_beside_it(text: str, named: str, words: str, tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(text)
    with pytest.raises(dampen.ArgumentError) as error:
        dampen.read_scenario(tmp_path / named)
    assert error.value.lines[0].endswith(words)


@pytest.mark.parametrize("name", ["boom", "he2018"])
def test_a_file_named_without_its_ending(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path(f"{name}.toml").touch()
    with pytest.raises(dampen.ArgumentError, match=rf"^Scenario `{name}` is neither .*; did you mean `{name}\.toml`\?$"):
        dampen.read_scenario(name)


def test_bounds_that_are_missing_are_told_together_with_their_units() -> None:
    assert refusal("bounds={}") == (
        "Argument `bounds` must be given, f in N/m, tip_w in N and tip_phi in N m: the controller relies on it."
    )
    assert refusal("bounds={f=0.1, tip_phi=0.2}").startswith("Argument `bounds` must be given, tip_w in N: ")


@pytest.mark.parametrize("table", ["bounds", "task", "sampling", "numerics", "output"])
def test_tables_without_kinds_are_listed(table: str) -> None:
    heading, *rows = listing(table).splitlines()
    assert heading.startswith(f"[{table}]    ")
    assert rows
    assert f"[{table}]" in listing()


@pytest.mark.parametrize("words", [("plant.tip_mass", "=", "0.2"), ("plant.tip_mass=", "0.2"), ("plant.tip_mass", "=0.2")])
def test_a_setting_that_the_shell_took_apart(words: tuple[str, ...], tmp_path: Path) -> None:
    done = dampen_command("run", "he2017", "--set", *words, cwd=tmp_path)
    assert (done.returncode, len(done.stderr.splitlines())) == (2, 1)
    assert "; leave out the spaces around =, or quote the whole: --set 'KEY = VALUE'." in done.stderr


RANGES: dict[str, Callable[[dampen.Scenario], object]] = {
    'Argument `search`, for `controller.alpha_4`, must have a range as text like "1:10", but has [1, 10].': (
        lambda case: dampen.tune(case, {"controller.alpha_4": (1, 10)})
    ),
    "Argument `search`, for `controller.alpha_4`, must have a range like LOW:HIGH or LOW:HIGH:log, but has '1,10'.": (
        lambda case: dampen.tune(case, ["controller.alpha_4=1,10"])
    ),
    "Argument `search` must be given at least once.": lambda case: dampen.tune(case, {}),
    "Argument `robust_over`, for `plant.tip_mass`, must have a range like +-30%": (
        lambda case: dampen.tune(case, {"controller.alpha_4": "1:10"}, robust_over={"plant.tip_mass": "x"})
    ),
    "Argument `uncertain`, for `plant.tip_mass`, must have a range as text like +-30%": (
        lambda case: dampen.robust(case, {"plant.tip_mass": [1, 2, 3]})
    ),
    "Argument `vary`, for `plant.tip_mass`, must have a range as text, or a list of values, but has 3.": (
        lambda case: dampen.sweep(case, {"plant.tip_mass": 3})  # type: ignore[dict-item]
    ),
}


@pytest.mark.parametrize("words", RANGES)
def test_python_is_told_of_arguments_not_of_options(words: str) -> None:
    with pytest.raises(dampen.ArgumentError) as error:
        RANGES[words](scenario("task.trials=1", "numerics.modes=4"))
    assert error.value.lines[0].startswith(words)


@pytest.mark.parametrize(("said", "told"), [('[controller]\nkind = "none"\n', 0), ("", 1)])
def test_a_scenario_without_a_controller_is_noted(
    said: str, told: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    free = scenario("task.trials=1", "task.trial_duration=0.02", "numerics.modes=4", "output.every=1", "controller.kind=none")
    text = to_toml(free)
    assert '[controller]\nkind = "none"\n' in text
    (tmp_path / "free.toml").write_text(text.replace('[controller]\nkind = "none"\n', said))
    perform(str(tmp_path / "free.toml"), None, tmp_path / "out", report=False)
    assert capsys.readouterr().err.count("Note: The scenario has no [controller]: nothing is controlled.") == told


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        (
            ["task.constraint.tip_w=5.0"],
            ["At tip_w 5 m are allowed, more than the 1 m of the structure: is the constraint in m?"],
        ),
        (["task.constraint.tip_w=[-0.9, 0.9]", "task.constraint.tip_phi=5.0"], []),
        (["plant.length=1e-4", "plant.tip_mass=0.0", "plant.tip_inertia=0.0"], ["The lowest mode is at ", "`numerics.step` = "]),
        (["plant.length=1000.0", "plant.initial={}"], ["of whose period the 2 s of the run are "]),
        (["plant.damping.ratio=4.0"], ["No mode swings", "4 times the critical damping"]),
        (["plant.damping.ratio=0.9"], []),
    ],
)
def test_what_may_be_in_other_units_is_noted(settings: list[str], words: list[str]) -> None:
    few = ("task.trials=1", "numerics.modes=4", "controller.kind=none", "disturbance.kind=none", "task.constraint={}")
    warnings = Bench(scenario(*few, *settings)).warnings
    assert all(word in " ".join(warnings) for word in words)
    assert bool(warnings) == bool(words)


@pytest.mark.parametrize(("width", "parts"), [(140, 1), (50, 2), (12, 3)])
def test_a_table_keeps_brackets_and_whole_words_and_goes_on_below(
    width: int, parts: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", str(width))
    headings = ("Contender", "Gains", "peak tip w [m]", "RMS tip phi [rad]")
    show_table(
        headings, [("boundary-damping", "none; constraint lost" + 20 * " and", "[red]0.1[/red]", "2")], headings[2:], headings[:1]
    )
    printed = capsys.readouterr().out
    assert sum("\N{BOX DRAWINGS LIGHT HORIZONTAL}" in line for line in printed.splitlines()) == parts
    assert max(map(len, printed.splitlines())) <= width
    if width > 12:
        assert all(word in printed for word in ("[m]", "[rad]", "[red]0.1[/red]", "constraint", "boundary-damping"))


@pytest.mark.parametrize(
    ("word", "known", "meant"),
    [
        ("noise", ["none", "band-noise"], "band-noise"),
        ("noises", ["none", "noise"], "noise"),
        ("tip_w_forse", ["tip_w", "tip_w_force"], "tip_w_force"),
        ("ilc", ["p-type-ilc", "impulse"], ""),
    ],
)
def test_a_word_that_is_part_of_a_known_one_is_meant(word: str, known: list[str], meant: str) -> None:
    assert suggestion(word, known) == (f"; did you mean `{meant}`?" if meant else f"; known here: {', '.join(known)}.")


DAMPED = ("controller.kind=boundary-damping", "controller.damping.tip_w=1.0")
ELSEWHERE: dict[str, Callable[[dampen.Scenario], object]] = {
    "search": lambda case: dampen.tune(case, {"damping.tip_w": "0.1:10"}),
    "vary": lambda case: dampen.sweep(case, {"damping.tip_w": [1.0, 2.0]}),
    "uncertain": lambda case: dampen.robust(case, {"damping.tip_w": "+-30%"}),
    "set": lambda case: scenario(*DAMPED, "damping.tip_w=1"),
}


@pytest.mark.parametrize("option", ELSEWHERE)
def test_a_parameter_without_its_table_is_told_with_it(option: str) -> None:
    with pytest.raises(dampen.ArgumentError, match=r"is not known; did you mean `controller\.damping\.tip_w`\?$"):
        ELSEWHERE[option](scenario(*DAMPED))


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        (("--modes", "20"), "--modes; did you mean --set numerics.modes=20?"),
        (("--tip-mass=0.2",), "--tip-mass; did you mean --set plant.tip_mass=0.2?"),
        (("--modes",), "--modes; did you mean --set numerics.modes=VALUE?"),
        (("--nonsense",), "--nonsense"),
    ],
)
def test_an_option_that_is_a_key_of_the_scenario(words: tuple[str, ...], hint: str, tmp_path: Path) -> None:
    done = dampen_command("run", "he2017", *words, cwd=tmp_path)
    assert (done.returncode, done.stderr) == (2, f"No such option: {hint}\n")


def test_a_table_of_any_width_says_every_word_and_number_whole(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    headings = ("Contender", "Gains", "residual", "the same, finer", "peak tip w [m]", "RMS tip phi [rad]", "settles in trial")
    rows = [("dual-loop-ailc", "as given", "1.69 %", "1.74 %", "2.8e-3", "3.4e-3", "2"), ("none", "none; lost", *"34567")]
    for width in range(30, 150):
        monkeypatch.setenv("COLUMNS", str(width))
        show_table(headings, rows, headings[2:], ("Contender",))
        printed = capsys.readouterr().out
        words = {word for row in (headings, *rows) for cell in row for word in cell.split()}
        assert words <= set(printed.split()), width
        assert max(map(len, printed.splitlines())) <= width
