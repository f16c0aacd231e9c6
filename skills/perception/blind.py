"""Is the camera blind? Dark pictures, and pictures that stay the same though the camera has moved."""

from __future__ import annotations

import zlib
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.geometry.poses import angle_between, distance
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.pose import Pose

THIN: Final = 4
"""Every fourth pixel of every fourth row is looked at: a millisecond would be much otherwise."""
DARK: Final = 12
"""Grey levels (of 255) below which a pixel is dark."""
LIT: Final = 0.005
"""Share of the pixels that must be lit, or have a depth, for a camera that sees."""
MOVED_METRES: Final = 0.02
MOVED_RADIANS: Final = 0.02
"""The camera has moved by more than its pose is uncertain: the picture can't be the same."""


@dataclass(frozen=True)
class Sight:
    """What is remembered of a camera's last picture: its print, and where it was first taken from."""

    print: int
    camera_in_map: Pose


class BlindCheck:
    """Judges one camera's pictures, one after the other, over many looks."""

    def __init__(self) -> None:
        self._last: Sight | None = None

    def wrong(self, image: RgbdImage, camera_in_map: Pose) -> str:
        """Return what is wrong with the picture in words, or nothing."""
        bright = float(np.mean(image.colour[::THIN, ::THIN].max(axis=2) >= DARK))
        measured = float(np.mean(image.depth[::THIN, ::THIN] > 0))
        if bright < LIT and measured < LIT:
            return "the picture is dark"
        self._last, wrong = judged(image, camera_in_map, self._last)
        return wrong


def judged(image: RgbdImage, camera_in_map: Pose, last: Sight | None) -> tuple[Sight, str]:
    """Return what to remember of a picture, and in words that it stands still though the camera has moved.

    Pictures that are the same while nothing moves are no sign: a camera without noise gives them. Nor is a
    picture of one colour.
    """
    colour, depth = image.colour[::THIN, ::THIN], image.depth[::THIN, ::THIN]
    plain = np.ptp(colour) == 0 and np.ptp(depth) == 0
    print_now = zlib.crc32(depth.tobytes(), zlib.crc32(colour.tobytes()))
    if last is None or plain or print_now != last.print:
        return Sight(print_now, camera_in_map), ""
    metres = distance(last.camera_in_map, camera_in_map)
    radians = angle_between(last.camera_in_map.orientation, camera_in_map.orientation)
    moved = metres > MOVED_METRES or radians > MOVED_RADIANS
    return last, "the picture stands still though the camera has moved" if moved else ""
