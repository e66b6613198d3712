"""The look of every figure and of the page: colours, sizes, type, and how symbols, numbers and units are written."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from typing import Any
from unicodedata import lookup

# Colours have one meaning each (Okabe-Ito, safe for colour-blind readers); line style or a label always says it too.
DISPLACEMENT = "#0072B2"
ROTATION = "#D55E00"
UNCONTROLLED = "#8A8A8A"
CONSTRAINT = "#CC79A7"
LEARNED = "#009E73"
REFERENCE = "#333333"
INK = "#222222"
FAINT = "#9A9A9A"
DIVERGING = "RdBu_r"

# The same meanings on a screen: text in `faint` has to be read there, and on dark paper every colour is a lighter one.
PALETTES = {
    "light": {
        "displacement": DISPLACEMENT,
        "rotation": ROTATION,
        "uncontrolled": UNCONTROLLED,
        "constraint": CONSTRAINT,
        "learned": LEARNED,
        "reference": REFERENCE,
        "ink": INK,
        "faint": "#666666",
        "paper": "#FFFFFF",
    },
    "dark": {
        "displacement": "#56B4E9",
        "rotation": "#F0803C",
        "uncontrolled": "#9A9A9A",
        "constraint": "#E29CC3",
        "learned": "#2FBF95",
        "reference": "#DDDDDD",
        "ink": "#EDEDED",
        "faint": "#A8A8A8",
        "paper": "#14171A",
    },
}

DASHES, DOTS = (0, (4, 2)), (0, (1, 1.2))

SINGLE, DOUBLE = 3.5, 7.16
HEIGHT = 2.35
DPI = 300
COLUMNS = 800
SMALL = 7.0

RC: dict[Any, Any] = {
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "mathtext.fontset": "dejavusans",
    "font.size": 8.0,
    "axes.labelsize": 8.0,
    "xtick.labelsize": SMALL,
    "ytick.labelsize": SMALL,
    "legend.fontsize": SMALL,
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "axes.linewidth": 0.6,
    "axes.unicode_minus": True,
    "axes.formatter.limits": (-4, 5),
    "axes.formatter.use_mathtext": False,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "ytick.minor.width": 0.4,
    "xtick.major.size": 3.0,
    "ytick.major.size": 3.0,
    "ytick.minor.size": 1.8,
    "xtick.direction": "out",
    "lines.linewidth": 0.9,
    "lines.solid_joinstyle": "round",
    "hatch.linewidth": 0.4,
    "path.simplify": True,
    "agg.path.chunksize": 0,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
    "svg.fonttype": "path",
    "svg.hashsalt": "dampen",
    "text.usetex": False,
}

MINUS, TIMES, DASH = "\N{MINUS SIGN}", "\N{MULTIPLICATION SIGN}", "\N{EN DASH}"
_LETTERS = "alpha beta gamma delta epsilon zeta eta theta kappa lamda mu nu xi rho sigma tau phi psi omega"
GREEK = {name.replace("lamda", "lambda"): lookup(f"GREEK SMALL LETTER {name}") for name in _LETTERS.split()}
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def colour(unit: str) -> str:
    """The colour of a motion or effort with this unit: displacements and forces blue, angles and torques orange."""
    return ROTATION if unit in ("rad", "N m") else DISPLACEMENT


def tint(colour: str, share: float) -> str:
    """The colour, thinned with white: `share` = 1 is all of it."""
    parts = [int(colour[i : i + 2], 16) for i in (1, 3, 5)]
    return "#" + "".join(f"{round(255 + share * (part - 255)):02X}" for part in parts)


def plain_text(text: str) -> str:
    """A user's own word, safe in a figure: a dollar sign would begin a formula."""
    return text.replace("$", r"\$")


def symbol(name: str, arguments: str = "") -> str:
    """`name(arguments)` as mathtext, the paper's way: phi is a curly phi, single letters are italic, words upright."""
    if not re.fullmatch(r"[A-Za-z]\w*", name, re.ASCII):
        return plain_text(name) + (f"$({arguments})$" if arguments else "")
    if name == "phi":
        body = r"\varphi"
    elif name in GREEK:
        body = "\\" + name
    else:
        body = name if len(name) == 1 else r"\mathrm{" + name.replace("_", r"\_") + "}"
    inside = f"({arguments})" if arguments else ""
    return f"${body}{inside}$"


def number(value: float, digits: int = 3) -> str:
    """A number for reading, with `digits` significant digits and a true minus sign."""
    if value == 0:
        return "0"
    text = f"{value:.{digits}g}" if abs(value) >= 10**digits else f"{value:#.{digits}g}".removesuffix(".")
    mantissa, _, power = text.partition("e")
    if power:
        return f"{mantissa.replace('-', MINUS)} {TIMES} {ten_to(int(power))}"
    return text.replace("-", MINUS)


def quantity(value: float, unit: str, digits: int = 3) -> str:
    """A number and its unit."""
    return f"{number(value, digits)} {unit}".strip()


def ten_to(power: int) -> str:
    """10 with a raised power, in characters: tick labels set as mathtext would be three times as slow."""
    return "10" + str(power).translate(SUPERSCRIPTS)


def plain_number(value: float) -> str:
    """A parameter as its owner would write it: 0.2, not 0.200; a power of ten where it takes one."""
    mantissa, _, power = f"{value:g}".replace("-", MINUS).partition("e")
    if not power:
        return mantissa
    ten = ten_to(int(power.replace(MINUS, "-")))
    return ten if mantissa == "1" else f"{mantissa} {TIMES} {ten}"


def percent(ratio: float) -> str:
    """A ratio in percent, with as many digits as it deserves."""
    digits = 0 if abs(ratio) >= 0.0995 else 1
    if 0 < abs(ratio) < 0.00095:
        digits = 1 - math.floor(math.log10(abs(100 * ratio)))
    return f"{100 * ratio:.{digits}f} %".replace("-", MINUS)


def ranges(indices: Iterable[int]) -> str:
    """Trial numbers in words of ranges: 0-4, 7, 9-11."""
    runs: list[list[int]] = []
    for i in indices:
        if runs and i == runs[-1][-1] + 1:
            runs[-1] = [runs[-1][0], i]
        else:
            runs.append([i])
    return ", ".join(DASH.join(str(i) for i in run) for run in runs)


def typeset(text: str) -> str:
    """Plain text for reading: Greek letters for their names, raised powers, and the signs for minus, <= and >=."""
    text = re.sub(r"(?<![^\W_])(" + "|".join(GREEK) + r")(?![^\W_])", lambda m: GREEK[m[1]], text)
    text = re.sub(r"(?<=\w)\^([23])\b", lambda m: {"2": "²", "3": "³"}[m[1]], text)
    text = re.sub(r"(?<![\w.])-(?=\d)", MINUS, text)
    return text.replace("<=", "≤").replace(">=", "≥")
