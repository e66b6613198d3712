"""Frames: a JSON header and arrays as one piece of bytes, the way page and workers take them."""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Mapping
from typing import Any

import numpy as np

Array = np.ndarray
ALIGNED = 8


def framed(header: Mapping[str, Any], arrays: Mapping[str, Array]) -> bytes:
    """The header with `arrays`, where each array lies, and the arrays after it.

        uint32  length of the header, little-endian
        header  JSON, padded with spaces so that the arrays begin at a multiple of 8 bytes
        arrays  float32 or float64, little-endian

    Arrays are sent in single precision unless they are in double precision by purpose: those named "peaks".
    """
    ready = {name: np.ascontiguousarray(values, "<f8" if name == "peaks" else "<f4") for name, values in arrays.items()}
    places, at = {}, 0
    for name, values in ready.items():
        places[name] = {"type": values.dtype.str[1:], "shape": list(values.shape), "at": at}
        at += padded(values.nbytes)
    text = json.dumps(finite({**header, "arrays": places}), allow_nan=False).encode()
    text += b" " * (padded(4 + len(text)) - 4 - len(text))
    parts = [struct.pack("<I", len(text)), text]
    for values in ready.values():
        parts += [values.tobytes(), bytes(padded(values.nbytes) - values.nbytes)]
    return b"".join(parts)


def finite(value: Any) -> Any:
    """The value as JSON can have it: numbers that are not finite are null."""
    if isinstance(value, dict):
        return {key: finite(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [finite(inner) for inner in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def unframed(frame: bytes) -> tuple[dict[str, Any], dict[str, Array]]:
    """Header and arrays of a frame."""
    (length,) = struct.unpack_from("<I", frame)
    header = json.loads(frame[4 : 4 + length])
    found = {}
    for name, place in header["arrays"].items():
        count = int(np.prod(place["shape"]))
        found[name] = np.frombuffer(frame, f"<{place['type']}", count, 4 + length + place["at"]).reshape(place["shape"])
    return header, found


def padded(size: int) -> int:
    """`size`, up to the next multiple of 8."""
    return -(-size // ALIGNED) * ALIGNED
