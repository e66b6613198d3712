"""What the code cells of a page need beside it: the files that its shell blocks write, the examples, the look of its figures."""

from __future__ import annotations

import os
import re
import sys
import tempfile
from pathlib import Path

DOCS = Path(__file__).resolve().parent
HEREDOC = re.compile(r"^cat > (?P<name>[\w.-]+) <<'EOF'\n(?P<text>.*?)^EOF$", re.M | re.S)


def enter(page: str) -> None:
    """Work in a fresh folder that has the files which the page writes by `cat > NAME <<'EOF'`; examples can be imported."""
    import matplotlib as mpl

    from dampen.report.style import RC

    folder = tempfile.mkdtemp(prefix="dampen-page-")
    for found in HEREDOC.finditer((DOCS / page).read_text(encoding="utf-8")):
        Path(folder, found["name"]).write_text(found["text"], encoding="utf-8")
    os.chdir(folder)
    sys.path[:0] = [folder, str(DOCS.parent / "examples")]
    mpl.rcParams.update(RC | {"figure.figsize": (7.0, 2.4), "figure.dpi": 110})
