"""Files that are written as a whole or not at all, and archives that are the same for the same content."""

from __future__ import annotations

import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from io import BytesIO
from pathlib import Path
from typing import BinaryIO

from dampen.component import ArgumentError

BEGINNING = (1980, 1, 1, 0, 0, 0)  # of time, in a zip file


@contextmanager
def whole_file(path: Path, what: str = "Output file") -> Iterator[BinaryIO]:
    """A file to write to that takes the place of `path` at the end: what was there before stays until then.

    Raises ArgumentError, naming `what` it is, where that cannot be done.
    """
    part = path.with_name(f".{path.name}.part")
    try:
        with part.open("wb") as file:
            yield file
        part.replace(path)
    except OSError as error:
        raise ArgumentError(f"{what} `{path}` cannot be written: {error.strerror or error}.") from None
    finally:
        with suppress(OSError):
            part.unlink(missing_ok=True)


def archive(content: Mapping[str, bytes]) -> bytes:
    """A zip file, in the order of `content`."""
    packed = BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as out:
        for name, data in content.items():
            info = zipfile.ZipInfo(name, BEGINNING)
            info.compress_type, info.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            out.writestr(info, data)
    return packed.getvalue()
