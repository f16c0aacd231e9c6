"""AprilTags 36h11 in a picture: found fast by OpenCV, refined on their edges, posed with the depth."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Final

import cv2
import numpy as np
from numpy.typing import NDArray

from tandem.skills.geometry.poses import length
from tandem.skills.perception import corners as edges
from tandem.skills.perception import depth as depth_image
from tandem.skills.perception.detectors import Detection
from tandem.skills.perception.rigid import Matrix
from tandem.skills.perception.tag_pose import DepthPoints, Estimate, estimate
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.site import SiteItem

COST: Final = 0.06
"""Robot seconds that one picture is charged in lockstep."""
_ROUGH: Final = 0.03
"""Share of a tag's outline by which its corners may be off at first (OpenCV's own choice)."""
_CLOSE_ENOUGH: Final = 6.0
"""Pixels of that for which a tag is not looked at again."""
_CLOSE: Final = 3.0
"""Pixels by which they may be off then: edges are looked for within four."""
_MAX_SCATTER: Final = 0.5
"""Pixels: edges that are less straight are not a tag's."""
_MAX_VIEWING_ANGLE: Final = math.radians(75.0)
"""Between the face's normal and the line of sight: a tag is a quarter as wide as it is from there."""
_MAX_PIXEL_ERROR: Final = 1.0
"""Pixels, root mean square, by which corners may miss the pose that explains them."""
_DEPTH_POINTS: Final = 150
"""Of a face, at the most."""


def of_items(image: RgbdImage, items: tuple[SiteItem, ...], up_in_camera: Vector3) -> tuple[Detection, ...]:
    """Return the items whose tags a picture shows: the detector ``tags``."""
    return find(image, sizes_of(items), up_in_camera)


def sizes_of(items: tuple[SiteItem, ...]) -> dict[int, float]:
    """Return the edges (m) of the black squares of those items that bear a tag, by number."""
    return {each.item: each.tag_size for each in items if each.tag_size is not None}


def find(
    image: RgbdImage, tag_sizes: Mapping[int, float], up_in_camera: Vector3 | None = None
) -> tuple[Detection, ...]:
    """Return the known tags of a picture, by item and best first; an item may show two faces.

    Args:
        image: colour and depth.
        tag_sizes: edge of the black square in metres by tag; other tags are no items of ours.
        up_in_camera: the map's up in the camera's frame: items stand upright, as a rule.
    """
    grey = cv2.cvtColor(image.colour, cv2.COLOR_RGB2GRAY)
    up = None if up_in_camera is None else np.array(up_in_camera)
    seen = []
    for item, guess in detect(grey):
        if item not in tag_sizes:
            continue
        found = _pose(image, grey, guess, tag_sizes[item], up)
        if found is not None:
            seen.append(_rated(item, found))
    return tuple(sorted(seen, key=lambda each: (each.item, -each.quality)))


def detect(grey: NDArray[np.uint8]) -> list[tuple[int, Matrix]]:
    """Return tag numbers with (4, 2) rough corners, a few pixels off at the most."""
    return [(number, _closer(grey, number, quad)) for number, quad in _quads(grey, _ROUGH)]


def _quads(grey: NDArray[np.uint8], tolerance: float) -> list[tuple[int, Matrix]]:
    """Return tag numbers with corners; ``tolerance``: off a contour, in shares of its length."""
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11)
    parameters = cv2.aruco.DetectorParameters()
    parameters.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_NONE
    parameters.polygonalApproxAccuracyRate = tolerance
    quads, numbers, _ = cv2.aruco.ArucoDetector(dictionary, parameters).detectMarkers(grey)
    if numbers is None:
        return []
    return [
        (int(number), np.asarray(quad, np.float64).reshape(4, 2))
        for number, quad in zip(np.asarray(numbers).ravel(), quads, strict=True)
    ]


def _closer(grey: NDArray[np.uint8], number: int, quad: Matrix) -> Matrix:
    """Return a large tag's corners within a few pixels.

    A four-cornered outline may be off by a share of its length: small tags need that, but of one that fills
    half a picture a corner was 33 pixels off, where no edge can be refined.
    """
    length = float(np.hypot(*(np.roll(quad, -1, axis=0) - quad).T).sum())
    if length * _ROUGH <= _CLOSE_ENOUGH:
        return quad
    low, high = quad.min(axis=0), quad.max(axis=0)
    around = 0.25 * (high - low)
    x0, y0 = (int(value) for value in np.maximum(low - around, 0.0))
    x1, y1 = (int(value) for value in high + around)
    cut = np.ascontiguousarray(grey[y0:y1, x0:x1])
    corner = np.array([x0, y0], np.float64)
    found = [each + corner for tag, each in _quads(cut, _CLOSE / length) if tag == number]
    return min(found, key=lambda each: float(np.abs(each - quad).max()), default=quad)


def _pose(
    image: RgbdImage, grey: NDArray[np.uint8], guess: Matrix, tag_size: float, up: Matrix | None
) -> Estimate | None:
    refined = edges.refine(grey, guess)
    if refined is None or refined[1] > _MAX_SCATTER:
        return None
    corners, _ = refined
    points, pixels = depth_image.inside(image.header, image.depth, corners, shrink=0.15, limit=_DEPTH_POINTS)
    measured = DepthPoints(points, pixels) if len(points) else None
    found = estimate(image.header, corners, tag_size, measured, up)
    if found is None or found.pixel_error > _MAX_PIXEL_ERROR or found.viewing_angle > _MAX_VIEWING_ANGLE:
        return None
    return found


def _rated(item: int, found: Estimate) -> Detection:
    """Each doubt takes its share of the quality."""
    gap = 0.0 if found.depth_gap is None else found.depth_gap
    doubts = (
        (found.position_sigma / 0.01) ** 2,
        (found.pixel_error / 0.5) ** 2,
        (gap / 0.02) ** 2,
        0.25 if found.depth_gap is None else 0.0,
        0.0 if found.upright else 0.5,
    )
    return Detection(
        item=item,
        tag_in_camera=found.tag_in_camera,
        distance=length(found.tag_in_camera.position),
        quality=math.cos(found.viewing_angle) / (1.0 + sum(doubts)),
        position_sigma=found.position_sigma,
    )
