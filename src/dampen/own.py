"""What is the user's own: classes and functions named "module:name", and the place to blame when they fail."""

from __future__ import annotations

import importlib
import os
import re
import sys
import sysconfig
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from dampen.component import ArgumentError, near, own_name, shown, suggestion, wrong

HERE = str(Path(__file__).parent)
INSTALLED = tuple({sysconfig.get_path(name) for name in ("stdlib", "platstdlib", "purelib", "platlib")})
NO_PLACES = (HERE, "importlib", "<frozen ")
ROWS = re.compile(r"shapes \((\d{3,})\b.*\((\d{3,})\b")  # of arrays that NumPy cannot take together: as long as trials
NOT_FROZEN = "cannot inherit non-frozen dataclass from a frozen one"  # as Python has it


def own(cls: type) -> bool:
    """Whether a class is the user's."""
    return not cls.__module__.startswith("dampen.")


def own_object(name: str, argument: str, folder: Path | None = None) -> Any:
    """What "module:name" means, from a module in `folder`, in the current folder, or installed.

    Raises ArgumentError with the file and line of a module that fails.
    """
    module, _, attribute = name.partition(":")
    if module.endswith(".py"):
        raise wrong(argument, f"name a module without .py, {shown(f'{module[:-3]}:{attribute}')}", name)
    places = [str(place.resolve()) for place in (folder, Path()) if place is not None]
    sys.path[:0] = places
    try:
        found: Any = importlib.import_module(module)
        for part in attribute.split("."):
            found = getattr(found, part)
    except (Exception, SystemExit) as error:  # a program that is imported may want to end
        raise ArgumentError(f"Argument `{argument}` names {shown(name)}, which cannot be loaded: {complaint(error)}.") from None
    finally:
        for place in places:
            sys.path.remove(place)
    return found


def with_colon(name: str, folder: Path = Path()) -> str:
    """'; did you mean `module:Class`?' where a name has a dot for the colon, and `folder` or the current one has the module."""
    module, dot, attribute = name.rpartition(".")
    file = f"{module.replace('.', os.sep)}.py"
    there = dot and attribute and any(os.path.isfile(place / file) for place in (folder, Path()))
    return f"; did you mean `{module}:{attribute}`, with a colon?" if there else ""


def own_function(name: str, argument: str, folder: Path | None = None) -> Callable[..., Any]:
    """The function that "module:name" means; places and errors as with `own_object`."""
    found = own_object(name, argument, folder) if ":" in name else None
    if not callable(found):
        raise wrong(argument, 'name a function as "module:name"', name)
    return found


def complaint(error: BaseException, function: Callable[..., Any] | None = None) -> str:
    """An error in one line, with the line of the user's code that it came from: the innermost that was not installed.

    function: what could not even be called, where no line of it has run.
    """
    text = f"{type(error).__name__}: {error}"
    if str(error) == NOT_FROZEN:
        text = "a component must be a frozen dataclass, @dataclass(frozen=True)"
    elif isinstance(error, ArgumentError):
        text = str(error).rstrip(".")
    elif isinstance(error, AttributeError) and error.name and error.obj is not None:
        text += known_of(error.obj, error.name)
    elif (rows := ROWS.search(text)) and abs(int(rows[1]) - int(rows[2])) == 1:
        text = f"{text.strip()} (what is known at all grid times, such as `trial.error`, has steps + 1 rows)"
    frames = [f for f in traceback.extract_tb(error.__traceback__) if not any(part in f.filename for part in NO_PLACES)]
    theirs = [f for f in frames if not f.filename.startswith((*INSTALLED, "<string>"))]
    places = [(f.filename, f.lineno) for f in theirs or frames]
    code = getattr(function, "__code__", None)
    if not theirs and code is not None:
        places = [(code.co_filename, code.co_firstlineno)]
    return f"{text} ({Path(places[-1][0]).name}, line {places[-1][1]})" if places else text


def known_of(thing: object, name: str) -> str:
    """What the thing has instead of an attribute: the name that is near, or all names where the thing is the package's."""
    names = [known for known in dir(thing) if not known.startswith("_")]
    return f" ({hint})" if (hint := (near if own(type(thing)) else suggestion)(name, names).strip("; .")) else ""


@contextmanager
def blame(component: object, method: str, function: Callable[..., Any] | None = None) -> Iterator[None]:
    """Turn any error that the user's own class raises in here into one line with class, method and line of code.

    Errors of shipped classes pass: they are faults of the package. function: as for `complaint`.
    """
    try:
        yield
    except ArgumentError:
        raise
    except Exception as error:
        cls = component if isinstance(component, type) else type(component)
        if not own(cls):
            raise
        raise ArgumentError(f"{own_name(cls)}.{method} failed: {complaint(error, function)}.") from error
