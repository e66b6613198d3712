"""The documentation: `python -m sphinx -W --keep-going -b html docs build/docs`. It needs no network, and nor do its pages."""

from __future__ import annotations

import sys
from importlib.util import find_spec
from pathlib import Path

DOCS = Path(__file__).parent
sys.path[:0] = [str(DOCS / "_extensions"), str(DOCS / "validation")]

from logo import write_logos
from pages import COMMON, palette

import dampen

project = "dampen"
author = "the dampen developers"
copyright = author
release = version = dampen.version()

extensions = [
    "myst_nb",
    "sphinx.ext.mathjax",
    "sphinx_copybutton",
    "sphinx_design",
    "sphinx_gallery.gen_gallery",
    "pages",  # a scratch folder for each page, in which its blocks run
    "shell",  # {shell}: commands that are run
    "file",  # {file}: files that are written and read
    "reference",  # the pages under reference/, made from the code
]
exclude_patterns = ["_extensions", "_generated", "images", "gallery/examples/*.ipynb", "gallery/examples/*.py"]
nitpicky = False  # annotations name classes of other packages

smartquotes = False  # quotes on these pages are often code's

# Markdown: $ and $$ for formulas, ::: for admonitions, links to any heading of two levels.
myst_enable_extensions = ["amsmath", "colon_fence", "deflist", "dollarmath", "fieldlist"]
myst_heading_anchors = 4
nb_execution_mode = "inline"  # a page's blocks run from top to bottom, Python and shell alike
nb_execution_timeout = 120
nb_execution_show_tb = True
nb_merge_streams = True
nb_output_stderr = "remove-warn"
nb_number_source_lines = False
nb_render_markdown_format = "myst"

mathjax = find_spec("sphinx-mathjax-offline").submodule_search_locations[0] + "/static"

python_maximum_signature_line_length = 100
add_module_names = True
toc_object_entries_show_parents = "hide"

html_theme = "furo"
html_title = "dampen"
html_static_path = ["_static", mathjax]
html_css_files = ["dampen.css"]
html_favicon = "_static/logo.svg"
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
html_theme_options = {
    "light_logo": "logo.svg",
    "dark_logo": "logo-dark.svg",
    "sidebar_hide_name": False,
    "light_css_variables": COMMON | palette("light"),
    "dark_css_variables": palette("dark"),
}
pygments_style = "friendly"
pygments_dark_style = "github-dark"
copybutton_exclude = ".linenos, .gp, .go"
mathjax_path = "mathjax/tex-chtml.js"
mathjax3_config = {"chtml": {"displayAlign": "left", "displayIndent": "2em"}}
write_logos(DOCS / "_static")

sphinx_gallery_conf = {
    "examples_dirs": "../examples/gallery",
    "gallery_dirs": "gallery/examples",
    "filename_pattern": r"\.py$",
    "abort_on_example_error": True,
    "download_all_examples": False,
    "min_reported_time": 1e9,
    "show_memory": False,
    "show_signature": False,
    "write_computation_times": False,
    "reset_modules": ("pictures.reset_style",),
    "within_subsection_order": "pictures.Order",
    "reset_modules_order": "before",
    "image_scrapers": ("matplotlib",),
    "remove_config_comments": True,
    "copyfile_regex": "^$",
}
