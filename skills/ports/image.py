"""An RGB-D picture as arrays: the one hardware message that is not JSON."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.picture_header import LENGTH, split

ENCODING: Final = "application/vnd.tandem.rgbd"


@dataclass(frozen=True)
class RgbdImage:
    """Header and pixels: ``colour`` (height, width, 3) uint8 RGB; ``depth`` (height, width) uint16 mm."""

    header: RgbdHeader
    colour: NDArray[np.uint8]
    depth: NDArray[np.uint16]


def header_of(payload: bytes) -> RgbdHeader:
    """Return the header of a payload that is a picture; ValueError when it is none."""
    return split(payload)[0]


def encode(image: RgbdImage) -> bytes:
    """Return header length (4 bytes, little-endian), header as JSON, colour, depth."""
    head = image.header.model_dump_json().encode()
    return b"".join((LENGTH.pack(len(head)), head, image.colour.tobytes(), image.depth.tobytes()))


def decode(payload: bytes) -> RgbdImage:
    """Return the picture; its arrays are views of the payload.

    Raises:
        ValueError: when the payload has no header, or its length is not what its header says.
    """
    header, start = split(payload)
    pixels = header.width * header.height
    colour = np.frombuffer(payload, np.uint8, pixels * 3, start).reshape(header.height, header.width, 3)
    depth = np.frombuffer(payload, np.uint16, pixels, start + pixels * 3).reshape(header.height, header.width)
    return RgbdImage(header=header, colour=colour, depth=depth)
