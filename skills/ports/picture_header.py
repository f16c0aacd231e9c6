"""The header of an RGB-D picture's payload: how to find it without numpy, which the pixels need."""

from __future__ import annotations

import struct
from typing import Final

from tandem.skills.ports.hardware import RgbdHeader

LENGTH: Final = struct.Struct("<I")
BYTES_A_PIXEL: Final = 5
"""Three of colour, two of depth."""


def split(payload: bytes) -> tuple[RgbdHeader, int]:
    """Return the header and where the pixels begin.

    Raises:
        ValueError: when the payload has no header, or its length is not what its header says.
    """
    if len(payload) < LENGTH.size:
        raise ValueError(f"expected an RGB-D payload, got {len(payload)} bytes")
    (size,) = LENGTH.unpack_from(payload)
    start = LENGTH.size + size
    header = RgbdHeader.model_validate_json(payload[LENGTH.size : start])
    expected = start + header.width * header.height * BYTES_A_PIXEL
    if len(payload) != expected:
        raise ValueError(f"expected an RGB-D payload of {expected} bytes, got {len(payload)}")
    return header, start
