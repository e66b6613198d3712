"""The version, from the installed package."""

from __future__ import annotations

from functools import cache


@cache
def version() -> str:
    """Version of the installed package."""
    from importlib.metadata import version as installed

    return installed("dampen")
