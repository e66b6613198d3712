"""Nothing on the pages of the documentation is shown that is not run or read when they are built."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
import typer

import dampen
from dampen.cli import app
from dampen.report.glossary import WORDS
from dampen.scenarios.schema import schema

DOCS = Path(__file__).parents[1] / "docs"
MADE = ("gallery/examples", "reference/generated")
PAGES = sorted(page for page in DOCS.rglob("*.md") if not page.relative_to(DOCS).as_posix().startswith(MADE))
FENCE = re.compile(r"^ *(?P<fence>`{3,}|~{3,}) *(?P<what>[^\s`]*)", re.MULTILINE)
NOT_RUN = 8  # blocks, on all pages


def openings(text: str) -> list[str]:
    """What each fenced block says it is."""
    found, inside = [], ""
    for match in FENCE.finditer(text):
        if not inside:
            found.append(match["what"])
            inside = match["fence"]
        elif match["fence"] == inside and not match["what"]:
            inside = ""
    assert not inside, "a block is never closed"
    return found


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(DOCS).as_posix())
def test_every_block_of_a_page_is_run_or_read_or_plain_text(page: Path) -> None:
    for what in openings(page.read_text(encoding="utf-8")):
        assert re.fullmatch(r"\{[\w:-]+\}|text", what), f"a block of {what or 'no language'}: use code-cell, shell, file or text"


def test_few_blocks_are_not_run_and_each_says_why() -> None:
    reasons = [why for page in PAGES for why in re.findall(r"^:not-run:(.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)]
    assert all(len(why.split()) >= 3 for why in reasons), reasons
    assert len(reasons) <= NOT_RUN, reasons


def test_a_block_in_plain_markdown_would_be_found() -> None:
    assert openings("```sh\nls\n```\ntext\n````{shell}\n```\n````\n") == ["sh", "{shell}"]


@pytest.fixture(scope="module")
def reference() -> Iterator[dict[str, str]]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "path", [str(DOCS / "_extensions"), *sys.path])
        from reference import pages

        yield dict(pages())


def test_the_reference_has_every_public_name(reference: dict[str, str]) -> None:
    shown = re.findall(r"^:+\{py:\w+\} dampen\.(\w+)", "\n".join(reference.values()), re.MULTILINE)
    assert set(dampen.__all__) <= set(shown)
    assert len(shown) == len(set(shown)) + 1, "two environments are both in `gym`"


def test_the_reference_has_every_command_with_its_options(reference: dict[str, str]) -> None:
    root = typer.main.get_command(app)
    for name, command in {**root.commands, **root.commands["export"].commands}.items():  # type: ignore[attr-defined]
        section = re.search(rf"^#+ dampen (export )?{name}$(.*?)(?=^#+ |\Z)", reference["commands"], re.MULTILINE | re.DOTALL)
        assert section, name
        assert all(f"`{option}`" in section[2] for one in command.params for option in one.opts if option.startswith("--"))


def test_the_reference_has_every_kind_and_key_of_scenarios(reference: dict[str, str]) -> None:
    for family, kinds in schema()["kinds"].items():
        for kind in kinds:
            section = reference[f"scenario-{family}"].partition(f"## {kind['kind']}\n")[2].partition("\n## ")[0]
            assert section, kind["kind"]
            assert all(re.search(rf"`{p['name']}[`.]", section) for p in kind["parameters"]), kind["kind"]


CONF = f"""
import sys
sys.path.insert(0, {str(DOCS / "_extensions")!r})
extensions = ["myst_parser", "pages", "shell", "file"]
"""
GOOD = """# A page

```{file} mine.toml
:over: he2017
[task]
trials = 2
```

```{shell}
dampen show mine.toml > copy.txt
```

```{shell}
:show: 1
:status: 2
cat copy.txt; pwd; exit 2
```
"""
BAD = """# A page

```{file} mine.toml
:over: he2017
[task]
trails = 2
```

```{shell}
exit 3
```

```{shell}
test ! -e copy.txt
```
"""


def test_blocks_find_what_earlier_ones_left_and_faults_are_warnings(tmp_path: Path) -> None:
    pytest.importorskip("sphinx")
    pytest.importorskip("myst_parser")
    (tmp_path / "conf.py").write_text(CONF)
    (tmp_path / "index.md").write_text(GOOD + "\n```{toctree}\nnext\n```\n")
    (tmp_path / "next.md").write_text(BAD)
    command = [sys.executable, "-m", "sphinx", "-q", "-b", "html", str(tmp_path), str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    warnings = [line for line in done.stderr.splitlines() if "WARNING" in line]
    assert [line.partition("WARNING: ")[2].split(":")[0] for line in warnings] == [
        "file mine.toml",
        "block ended with status 3, not 0",
    ], done.stderr
    assert "task.trails" in warnings[0]
    assert "based_on" in (tmp_path / "out" / "index.html").read_text()
    assert str(tmp_path.parent) not in (tmp_path / "out" / "index.html").read_text()


def test_the_page_of_words_says_what_reports_say() -> None:
    page, bar = (DOCS / "how-to" / "numbers.md").read_text(encoding="utf-8"), chr(92) + "|"
    for word, meaning in WORDS.items():
        assert f"| {word} | {meaning.replace('|', bar)} |" in page, word
