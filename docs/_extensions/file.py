"""{file}: a file that is shown and written to the page's folder, where the page's later blocks find it.

    ```{file} mine.toml
    :over: he2017
    [controller]
    kind = "boundary-damping"
    ```

A .toml file is read as a scenario at once, and a .py file is imported; a mistake in either ends the build.

:over: NAME    the text is only a part, laid over this scenario: what is written begins with `based_on = NAME`
:from: PATH    the text is that of a file of the project, such as examples/own_plant.py
:hide:         write, but do not show
"""

from __future__ import annotations

import runpy
import sys
from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from pages import ROOT, clean, scratch
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

import dampen

LOG = logging.getLogger(__name__)


class File(SphinxDirective):
    """Write, check, show."""

    required_arguments = 1
    has_content = True
    option_spec: ClassVar[dict[str, Any]] = {
        "over": directives.unchanged_required,
        "from": directives.unchanged_required,
        "hide": directives.flag,
    }

    def run(self) -> list[nodes.Node]:
        """The nodes of one block."""
        name = self.arguments[0]
        if "from" in self.options:
            source = ROOT / self.options["from"]
            self.env.note_dependency(str(source))
            text = source.read_text(encoding="utf-8").rstrip()
        else:
            text = "\n".join(self.content)
        target = scratch() / name
        target.parent.mkdir(parents=True, exist_ok=True)
        try:
            base = f'based_on = "{self.options["over"]}"\n\n' if "over" in self.options else ""
            target.write_text(f"{base}{text.rstrip()}\n", encoding="utf-8")
            check(target)
        except Exception as error:
            what = clean(f"{name}: {type(error).__name__}: {error}")
            LOG.warning("file %s", what, location=self.get_location(), type="file", subtype="wrong")
        if "hide" in self.options:
            return []
        language = {".toml": "toml", ".py": "python", ".c": "c", ".sh": "sh"}.get(target.suffix, "text")
        based = f', which begins with based_on = "{self.options["over"]}"' if "over" in self.options else ""
        caption = nodes.caption("", name + based)
        block = nodes.literal_block(text, text, language=language)
        return [nodes.container("", caption, block, literal_block=True, classes=["literal-block-wrapper"])]


def check(file: Path) -> None:
    """Raise what is wrong with a scenario or a module; modules of the page are forgotten, since others may have their names."""
    before = set(sys.modules)
    sys.path.insert(0, str(file.parent))
    try:
        if file.suffix == ".toml":
            dampen.read_scenario(str(file))
        elif file.suffix == ".py":
            runpy.run_path(str(file), run_name=file.stem)
    finally:
        sys.path.remove(str(file.parent))
        for name in set(sys.modules) - before:
            if str(getattr(sys.modules[name], "__file__", "")).startswith(str(scratch())):
                del sys.modules[name]


def setup(app: Any) -> dict[str, Any]:
    """Join the build."""
    app.add_directive("file", File)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
