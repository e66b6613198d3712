"""Figures on pages: the style of the reports, large enough for a screen."""

from __future__ import annotations

from typing import Any, ClassVar

SCREEN_DPI = 200


def style() -> dict[str, Any]:
    """Matplotlib's settings."""
    from dampen.report.style import DOUBLE, HEIGHT, RC

    return {**RC, "figure.figsize": (DOUBLE * 0.85, HEIGHT), "figure.dpi": SCREEN_DPI, "savefig.dpi": SCREEN_DPI}


def inline_style() -> None:
    """For the cells of a page."""
    import matplotlib
    from matplotlib_inline.backend_inline import set_matplotlib_formats
    from matplotlib_inline.config import InlineBackend

    InlineBackend.instance().rc = {}
    InlineBackend.instance().print_figure_kwargs = {"bbox_inches": "tight", "pad_inches": 0.05, "metadata": {"Software": None}}
    set_matplotlib_formats("png")
    matplotlib.rcParams.update(style())


def reset_style(gallery_conf: dict[str, Any], name: str) -> None:
    """For an example of the gallery."""
    import matplotlib

    matplotlib.rcdefaults()
    matplotlib.use("agg")
    matplotlib.rcParams.update(style())


class Order:
    """The gallery's order: what it is about first, then what makes it up, what checks it, what goes beyond."""

    SCRIPTS: ClassVar = """
        paper_run heat_map learning_curves arm backlash_loop hysteresis barrier switching moving_load base_shaking
        timoshenko_euler bode decay_rates limit_curve gain_landscape payloads uncertain_learning
        own_learning_law own_disturbance gym_policy
    """

    def __init__(self, folder: str):
        self.folder = folder

    def __call__(self, file: str) -> int:
        return self.SCRIPTS.split().index(file.removesuffix(".py"))
