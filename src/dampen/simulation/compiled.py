"""Composing and compiling: plain functions bound to one another by name, turned into one compiled function.

`bind` swaps the functions that a function calls by name; `compiled` compiles a function with all that it calls. The result is
cached on disk under a key made of everything it was compiled from, so an edit in any piece, shipped or a user's own, is seen.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator
from contextlib import suppress
from types import CodeType, FunctionType
from typing import Any

_COMPILED: dict[str, Any] = {}


def bind(function: Callable[..., Any], **names: Any) -> FunctionType:
    """A copy of `function` in which the given names mean the given things, in it and in the functions that it calls."""
    assert isinstance(function, FunctionType)
    inner = {n: bind(f, **names) for n, f in _callees(function) if n not in names and _reaches(f, set(names))}
    copy = FunctionType(
        function.__code__,
        {**function.__globals__, **inner, **names},
        function.__name__,
        function.__defaults__,
        function.__closure__,
    )
    copy.__module__, copy.__qualname__ = function.__module__, function.__qualname__
    copy.__dict__.update(function.__dict__)
    return copy


def compiled(function: Callable[..., Any]) -> Any:
    """`function` and all plain functions that it calls, compiled by numba; call it like the plain one."""
    assert isinstance(function, FunctionType)
    key = _key(function)
    if key not in _COMPILED:
        dispatcher = _jit(function, inline=False)(_with_compiled_callees(function, {}))
        _cache_under(dispatcher, key)
        _COMPILED[key] = dispatcher
    return _COMPILED[key]


def standalone(function: Callable[..., Any]) -> Callable[..., Any]:
    """Mark a function that is compiled by itself and called by others, not inlined: the same machine code for all callers."""
    function.__dict__["standalone"] = True
    return function


def is_cached(dispatcher: Any) -> bool:
    """Whether an earlier process has left this compiled function on disk."""
    with suppress(Exception):
        return bool(dispatcher._cache._cache_file._load_index())
    return False


def reassociated(function: Callable[..., Any]) -> Callable[..., Any]:
    """Mark a function whose sums may be taken in any order, and so in vector instructions; all others round as plain Python."""
    function.__dict__["reassociated"] = True
    return function


def _jit(function: FunctionType, inline: bool) -> Any:
    import numba

    options: dict[str, Any] = {"nogil": True, "error_model": "numpy", "_nrt": False}
    if function.__dict__.get("reassociated"):
        options["fastmath"] = {"reassoc", "contract", "nsz"}
    return numba.njit(**options, forceinline=True) if inline else numba.njit(**options)


def _with_compiled_callees(function: FunctionType, done: dict[str, Any]) -> FunctionType:
    compiled_callees = {}
    for name, f in _callees(function):
        key = _key(f)  # the same function, bound in several places, is compiled once
        if f.__dict__.get("standalone"):
            done[key] = compiled(f)
        elif key not in done:
            done[key] = _jit(f, inline=True)(_with_compiled_callees(f, done))
        compiled_callees[name] = done[key]
    named = bind(function, **compiled_callees)
    # the name becomes the linker's: two variants loaded from disk under one name would be taken for one another
    named.__name__ = named.__qualname__ = f"{function.__name__}_{_key(function)}"
    return named


def _callees(function: FunctionType) -> Iterator[tuple[str, FunctionType]]:
    for name in function.__code__.co_names:
        value = function.__globals__.get(name)
        if isinstance(value, FunctionType):
            yield name, value


def _reaches(function: FunctionType, names: set[str]) -> bool:
    return not names.isdisjoint(function.__code__.co_names) or any(_reaches(f, names) for _, f in _callees(function))


def _key(function: FunctionType) -> str:
    digest = hashlib.sha256()

    def add_code(code: CodeType) -> None:
        digest.update(code.co_code + repr(code.co_names).encode())
        for constant in code.co_consts:
            add_code(constant) if isinstance(constant, CodeType) else digest.update(repr(constant).encode())

    def add(f: FunctionType) -> None:
        digest.update(f.__qualname__.encode() + repr(f.__dict__).encode())
        add_code(f.__code__)
        for name in f.__code__.co_names:
            value = f.__globals__.get(name)
            if isinstance(value, FunctionType):
                add(value)
            elif isinstance(value, int | float):
                digest.update(f"{name}={value!r}".encode())

    add(function)
    return digest.hexdigest()[:16]


def _cache_under(dispatcher: Any, key: str) -> None:
    """Cache the compiled code on disk; a place for it that is missing, full or damaged means to compile anew in every process."""
    from numba.core import caching

    class Cache(caching.FunctionCache):
        def load_overload(self, sig: Any, target_context: Any) -> Any:
            try:
                return super().load_overload(sig, target_context)  # type: ignore[no-untyped-call]
            except Exception:  # whatever reading damaged files can end in
                with suppress(OSError):
                    self.flush()  # type: ignore[no-untyped-call]
                return None

        def save_overload(self, sig: Any, data: Any) -> None:
            with suppress(OSError):
                super().save_overload(sig, data)  # type: ignore[no-untyped-call]

    with suppress(RuntimeError, OSError, AttributeError):
        cache: Any = Cache(dispatcher.py_func)  # type: ignore[no-untyped-call]
        base = f"{cache._impl.filename_base}-{key}"
        cache._cache_file = caching.IndexDataCacheFile(cache_path=cache._cache_path, filename_base=base, source_stamp=key)  # type: ignore[no-untyped-call]
        dispatcher._cache = cache
