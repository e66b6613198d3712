"""Every page has a scratch folder, empty when the page begins: its shell blocks, its files and its Python cells all run there."""

from __future__ import annotations

import os
import re
import shutil
import sys
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

from docutils import nodes

from dampen.report.style import PALETTES

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
SCRATCH = "DAMPEN_DOCS_SCRATCH"
COMMON = {
    "font-stack": "system-ui, 'Segoe UI', 'Helvetica Neue', 'DejaVu Sans', Arial, sans-serif",
    "font-stack--monospace": "ui-monospace, 'SF Mono', Menlo, Consolas, 'DejaVu Sans Mono', monospace",
}


def palette(scheme: str) -> dict[str, str]:
    """The project's colours as the theme's variables."""
    colours = PALETTES[scheme]
    brand = dict.fromkeys(("color-brand-primary", "color-brand-content", "color-brand-visited"), colours["displacement"])
    dark = {"color-background-primary": colours["paper"], "color-foreground-primary": colours["ink"]}
    return brand | (dark if scheme == "dark" else {})


def scratch() -> Path:
    """The folder of the page that is being read."""
    return Path(os.environ[SCRATCH])


def clean(text: str) -> str:
    """`text` without the places of this machine and without colours."""
    text = re.sub(r"\x1b\[[0-9;]*[A-Za-z]", "", text)
    for place in (scratch(), ROOT, Path.home()):
        text = text.replace(f"{place}/", "").replace(str(place), ".")
    return text


def _setup(app: Any) -> None:
    app.dampen_top = Path(mkdtemp(prefix="dampen-docs-")).resolve()
    startup = app.dampen_top / "ipython" / "profile_default" / "startup"
    startup.mkdir(parents=True)
    shutil.copy(HERE / "kernel_start.py", startup / "00-kernel_start.py")
    quiet = "c.IPKernelApp.log_level = 'ERROR'  # its ports are this machine's own\n"
    (startup.parent / "ipython_kernel_config.py").write_text(quiet, encoding="utf-8")
    beside = os.pathsep.join([str(HERE), str(HERE.parent / "validation"), os.environ.get("PYTHONPATH", "")])
    os.environ.update(
        {
            "IPYTHONDIR": str(app.dampen_top / "ipython"),
            "PYTHONPATH": beside.rstrip(os.pathsep),
            "PATH": os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]]),
            "MPLBACKEND": "agg",
            "OPENBLAS_NUM_THREADS": "1",
        }
    )


def _begin(app: Any, docname: str, source: list[str]) -> None:
    folder = app.dampen_top / f"pages-{os.getpid()}"  # pages may be read side by side
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    os.environ[SCRATCH] = str(folder)


def _name_pictures(app: Any, tree: nodes.document, docname: str) -> None:
    """A picture without words of its own is called after its section, for those who hear the page."""
    for image in tree.findall(nodes.image):
        section = image
        while section is not None and not isinstance(section, nodes.section):
            section = section.parent
        if section is not None and not image.get("alt"):
            image["alt"] = f"Figure: {section.next_node(nodes.title).astext()}"


def _end(app: Any, exception: Exception | None) -> None:
    shutil.rmtree(app.dampen_top, ignore_errors=True)


def setup(app: Any) -> dict[str, Any]:
    """Join the build."""
    app.connect("builder-inited", _setup)
    app.connect("source-read", _begin)
    app.connect("doctree-resolved", _name_pictures)
    app.connect("build-finished", _end)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
