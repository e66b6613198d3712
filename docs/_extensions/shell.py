"""{shell}: commands that are run when the page is built, in its folder, where a later block finds what an earlier one wrote.

    ```{shell}
    :show: -8
    dampen run he2017
    ```

:show:         show what is printed; with a number N the first N lines of it, with -N the last N, with a:b those that Python means
:status: N     the exit status that is expected; 0 if left out; any other ends the build
:quick: ARGS   what is added to every line that begins with `dampen`, to have it done sooner; the reader is told
:needs: a b    programs that must be there: without them the block is shown and not run
:not-run: why  show the commands only; why is said to the reader
:hide:         run, but show neither commands nor output
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import time
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from pages import clean, scratch
from sphinx.util import logging
from sphinx.util.docutils import SphinxDirective

LOG = logging.getLogger(__name__)
LIMIT = 300  # s
WIDTH = 86  # characters that a page shows without being pushed aside


def part(text: str, lines: str) -> str:
    """The lines of `text` that `lines` names."""
    if not lines:
        return text
    found = text.splitlines()
    start, colon, end = lines.partition(":")
    if colon:
        return "\n".join(found[int(start or 0) : int(end) if end else None])
    return "\n".join(found[: int(lines)] if int(lines) > 0 else found[int(lines) :])


class Shell(SphinxDirective):
    """Run, check, show."""

    has_content = True
    option_spec: ClassVar[dict[str, Any]] = {
        "show": directives.unchanged,
        "status": directives.nonnegative_int,
        "quick": directives.unchanged_required,
        "needs": directives.unchanged_required,
        "not-run": directives.unchanged_required,
        "hide": directives.flag,
    }

    def run(self) -> list[nodes.Node]:
        """The nodes of one block."""
        commands = "\n".join(self.content)
        shown: list[nodes.Node] = [] if "hide" in self.options else [nodes.literal_block(commands, commands, language="sh")]
        if "quick" in self.options:
            text, quick = "Run here, to be quick, with ", self.options["quick"]
            shown.append(nodes.paragraph("", text, nodes.literal("", quick), nodes.Text("."), classes=["remark"]))
            commands = re.sub(r"^(dampen [^#\n]*?)[ ]*(#.*)?$", rf"\1 {quick}", commands, flags=re.MULTILINE)
        missing = [name for name in self.options.get("needs", "").split() if not shutil.which(name)]
        if missing:
            LOG.info("not run for want of %s: %s", ", ".join(missing), commands)
        if "not-run" in self.options:
            return [*shown, nodes.paragraph("", f"Not run here: {self.options['not-run']}.", classes=["remark"])]
        output = "" if missing else self._output(commands)
        wanted = part(output, self.options.get("show", "0:0")).rstrip()
        return [*shown, nodes.literal_block(wanted, wanted, language="text", classes=["output"])] if wanted else shown

    def _output(self, commands: str) -> str:
        plain = {"COLUMNS": str(WIDTH), "NO_COLOR": "1", "TERM": "dumb", "LC_ALL": "C.UTF-8", "PAGER": "cat"}
        began = time.perf_counter()
        done = subprocess.run(
            ["bash", "-euo", "pipefail", "-c", commands],
            cwd=scratch(),
            env=os.environ | plain,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=LIMIT,
            check=False,
        )
        LOG.info("%.1f s: %s", time.perf_counter() - began, commands.replace("\n", "; "))
        output, status = clean(done.stdout), self.options.get("status", 0)
        if done.returncode != status:
            what = f"ended with status {done.returncode}, not {status}:\n{commands}\n{output}"
            LOG.warning("block %s", what, location=self.get_location(), type="shell", subtype="status")
        return output


def setup(app: Any) -> dict[str, Any]:
    """Join the build."""
    app.add_directive("shell", Shell)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
