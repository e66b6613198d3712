# Runs first in the kernel of every page: into the page's folder, figures as reports have them.
import os

from IPython import get_ipython

os.chdir(os.environ["DAMPEN_DOCS_SCRATCH"])
get_ipython().history_manager.enabled = False
get_ipython().run_line_magic("matplotlib", "inline")

from pictures import inline_style

inline_style()
