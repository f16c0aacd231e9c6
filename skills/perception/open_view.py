"""Is the place where a tag is believed to be open to the camera? Then a tag that is not read is not there.

Looking through that place proves that an item has gone, too (``clutter.seen_through``), but not where
something as near as the tag has come there instead: an item that is shifted along its own face covers its
old place.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from tandem.skills.geometry.poses import compose, invert
from tandem.skills.perception import depth
from tandem.skills.perception.gaze import BORDER, CLOSEST
from tandem.skills.perception.rigid import Matrix, points_in, rotation_of
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.pose import Pose

EDGE: Final = 8.0
"""Pixels that the tag must keep from the picture's edge: a robot's pose is some millimetres off."""
OBLIQUE: Final = math.radians(70.0)
"""Between the line of sight and the tag's normal: tags are read up to 75 degrees, surely up to this."""
LEAST: Final = 30.0
"""Pixels of the tag's shortest edge: nearly four for each of its eight cells."""
BEFORE: Final = 0.01
"""Metres nearer than the tag, beyond three deviations of the depth, from which on something is before it.

Fingers that close around a cube of 7 cm are 2 cm before its tag, and break its outline.
"""
COVERED: Final = 0.02
"""Share of the pixels that may be nearer: edges of depth images are frayed."""
MEASURED: Final = 0.8
"""Share of the pixels that must have a depth."""
SAMPLES: Final = 24
"""Points along an edge at which the depth is asked for."""


def in_the_open(image: RgbdImage, camera_in_map: Pose, tag_in_map: Pose, edge: float) -> bool:
    """Say whether a tag would be read for sure if it were there.

    The whole tag is in the picture, large enough and seen straight enough, and nothing is before it or before
    what the picture shows of its white border.

    Args:
        image: with its depth.
        camera_in_map: z along the line of sight.
        tag_in_map: z out of the tag.
        edge: metres of the tag's black square.
    """
    head, tag = image.header, compose(invert(camera_in_map), tag_in_map)
    line = np.array(tag.position)
    away = float(np.linalg.norm(line))
    facing = -float(rotation_of(tag)[:, 2] @ line) / max(away, 1e-9)
    if facing < math.cos(OBLIQUE):
        return False
    half = edge / 2.0
    square = np.array([(-half, -half, 0.0), (half, -half, 0.0), (half, half, 0.0), (-half, half, 0.0)])
    corners, z = _pixels(head, points_in(tag, square))
    if z.min() <= CLOSEST or not _inside(head, corners, EDGE).all():
        return False
    if float(np.hypot(*(np.roll(corners, -1, axis=0) - corners).T).min()) < LEAST:
        return False
    shares = np.linspace(-BORDER, BORDER, SAMPLES) * half
    x, y = (each.ravel() for each in np.meshgrid(shares, shares))
    pixels, z = _pixels(head, points_in(tag, np.stack((x, y, np.zeros_like(x)), axis=1)))
    shown = _inside(head, pixels, 0.0)
    columns, rows = np.round(pixels[shown]).astype(int).T
    measured = image.depth[rows, columns].astype(np.float64) / 1000.0
    known = measured > 0.0
    nearer = known & (measured < z[shown] - BEFORE - 3.0 * depth.sigma(away))
    return bool(known.mean() >= MEASURED and nearer.mean() <= COVERED)


def _pixels(head: RgbdHeader, points: Matrix) -> tuple[Matrix, Matrix]:
    """Return the pixels (n, 2) and depths (n,) of points (n, 3) in the camera's frame."""
    z = points[:, 2]
    return points[:, :2] / z[:, None] * (head.fx, head.fy) + (head.cx, head.cy), z


def _inside(head: RgbdHeader, pixels: Matrix, margin: float) -> NDArray[np.bool_]:
    """Say which pixels (n, 2) are in the picture, so many of them from its edge."""
    most = np.array((head.width, head.height)) - 1.0 - margin
    return np.asarray(((pixels >= margin) & (pixels <= most)).all(axis=1))
