"""An RGB-D picture as arrays: the one hardware message that is not JSON."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from skills.ports.hardware import RgbdHeader

ENCODING: Final = "application/vnd.tandem.rgbd"
_LENGTH: Final = struct.Struct("<I")


@dataclass(frozen=True)
class RgbdImage:
    """Header and pixels: ``colour`` (height, width, 3) uint8 RGB; ``depth`` (height, width) uint16 mm."""

    header: RgbdHeader
    colour: NDArray[np.uint8]
    depth: NDArray[np.uint16]


def encode(image: RgbdImage) -> bytes:
    """Return header length (4 bytes, little-endian), header as JSON, colour, depth."""
    head = image.header.model_dump_json().encode()
    return b"".join((_LENGTH.pack(len(head)), head, image.colour.tobytes(), image.depth.tobytes()))


def decode(payload: bytes) -> RgbdImage:
    """Return the picture; its arrays are views of the payload.

    Raises:
        ValueError: when the payload's length is not what its header says.
    """
    (size,) = _LENGTH.unpack_from(payload)
    start = _LENGTH.size + size
    header = RgbdHeader.model_validate_json(payload[_LENGTH.size : start])
    pixels = header.width * header.height
    if len(payload) != start + pixels * 5:
        raise ValueError(f"an RGB-D payload of {start + pixels * 5} bytes was expected, got {len(payload)}")
    colour = np.frombuffer(payload, np.uint8, pixels * 3, start).reshape(header.height, header.width, 3)
    depth = np.frombuffer(payload, np.uint16, pixels, start + pixels * 3).reshape(header.height, header.width)
    return RgbdImage(header=header, colour=colour, depth=depth)
