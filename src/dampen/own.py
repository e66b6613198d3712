"""What is the user's own: classes and functions named "module:name", and the place to blame when they fail."""

from __future__ import annotations

import importlib
import sys
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from dampen.component import ArgumentError, own_name, shown, wrong


def own_object(name: str, argument: str, folder: Path | None = None) -> Any:
    """What "module:name" means, from a module in `folder`, in the current folder, or installed.

    Raises ArgumentError with the file and line of a module that fails.
    """
    module, _, attribute = name.partition(":")
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


def own_function(name: str, argument: str, folder: Path | None = None) -> Callable[..., Any]:
    """The function that "module:name" means; places and errors as with `own_object`."""
    found = own_object(name, argument, folder) if ":" in name else None
    if not callable(found):
        raise wrong(argument, 'name a function as "module:name"', name)
    return found


def complaint(error: BaseException) -> str:
    """An error in one line, with the innermost line of code outside this package that it came from."""
    here = str(Path(__file__).parent)
    frames = [f for f in traceback.extract_tb(error.__traceback__) if here not in f.filename and "importlib" not in f.filename]
    at = f" ({Path(frames[-1].filename).name}, line {frames[-1].lineno})" if frames else ""
    return f"{type(error).__name__}: {error}{at}"


@contextmanager
def blame(component: object, method: str) -> Iterator[None]:
    """Turn any error that the user's own class raises in here into one line with class, method and line of code.

    Errors of shipped classes pass: they are faults of the package.
    """
    try:
        yield
    except ArgumentError:
        raise
    except Exception as error:
        cls = component if isinstance(component, type) else type(component)
        if cls.__module__.startswith("dampen."):
            raise
        raise ArgumentError(f"{own_name(cls)}.{method} failed: {complaint(error)}.") from error
