"""A detector of one's own: tells upright boxes without a tag by their colour in the site file.

A project names it in its pyproject.toml::

    [project.entry-points."tandem.detectors"]
    by_colour = "my_robot_app.by_colour:by_colour"

The site file needs no number for such an item: a scenario, a request and a fault call it by its name::

    items:
      - {name: mug, size: [0.06, 0.06, 0.08], colour: [0.9, 0.1, 0.1]}

It imports nothing of Tandem but the public surface. What it can't tell: two items of one colour, and items
among other things of their colour.
"""
# ruff: noqa: INP001 - an example: a file of its own

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from tandem.api.detectors import Detection, Pose, RgbdImage, SiteItem, Vector3

CLOSE: Final = 0.1
"""Distance of two chromaticities (r, g, b over their sum) that are the same colour, lit or in shade."""
FEWEST: Final = 60
"""Pixels of an item: fewer don't tell how it is turned."""
LAYER: Final = 0.006
"""Metres from a face's plane that still belong to it: twice the noise of a depth camera at 1 m."""
ANGLES: Final = 90
"""Headings of a face that are tried, half a degree apart over a quarter turn, times two sides."""
Array = NDArray[np.float64]


def by_colour(image: RgbdImage, items: tuple[SiteItem, ...], up_in_camera: Vector3) -> tuple[Detection, ...]:
    """Return one face of each item whose colour the picture shows."""
    total = image.colour.sum(axis=2, dtype=np.float64)
    shares = image.colour / np.maximum(total, 1.0)[:, :, np.newaxis]
    found = []
    for item in items:
        if item.colour is None or item.tag_size is not None or item.shape != "box":
            continue
        share = np.array(item.colour) / max(sum(item.colour), 1e-9)
        mine = (np.linalg.norm(shares - share, axis=2) < CLOSE) & (total > 60.0) & (image.depth > 0)  # noqa: PLR2004
        points = _points(image, mine)
        if len(points) >= FEWEST and (seen := _face(points, item, np.array(up_in_camera))) is not None:
            found.append(seen)
    return tuple(found)


def _points(image: RgbdImage, mine: NDArray[np.bool_]) -> Array:
    """Return the pixels as (n, 3) points in the camera's frame: x right, y down, z forwards (m)."""
    rows, columns = np.nonzero(mine)
    head, z = image.header, image.depth[rows, columns] / 1000.0
    return np.stack(((columns - head.cx) / head.fx * z, (rows - head.cy) / head.fy * z, z), axis=1)


def _face(points: Array, item: SiteItem, up: Array) -> Detection | None:
    """Return the face that most of an item's points are on, told as its tag would be."""
    height = points @ up
    top = float(np.percentile(height, 98))
    side = points[height < top - 0.2 * item.size[2]]  # what is near its top may be the top itself
    if len(side) < FEWEST:
        return None
    ahead = np.array((0.0, 0.0, 1.0))
    ahead = ahead - (ahead @ up) * up
    ahead /= np.linalg.norm(ahead)
    right = np.cross(ahead, up)  # horizontal, as ahead is
    best, face = 0, None
    for angle in np.linspace(-math.pi / 2, math.pi / 2, 2 * ANGLES, endpoint=False):
        out = -math.cos(angle) * ahead + math.sin(angle) * right  # of the face, towards the camera
        away = side @ out
        plane = float(np.percentile(away, 98)) - LAYER / 2.0
        on = np.abs(away - plane) < LAYER
        if (count := int(on.sum())) > best:
            best, face = count, (out, plane, side[on])
    if face is None or best < FEWEST / 2:
        return None
    out, plane, there = face
    across = np.cross(up, out)
    along = there @ across
    middle = (float(np.percentile(along, 2)) + float(np.percentile(along, 98))) / 2.0
    centre = plane * out + middle * across + (top - item.size[2] / 2.0) * up
    far = float(np.linalg.norm(centre))
    axes = np.stack((across, up, out), axis=1)  # x, y and z of the face, as columns
    pose = Pose(position=_vector(centre), orientation=_quaternion(axes))
    return Detection(item.item, pose, far, quality=1.0 / (1.0 + far), position_sigma=0.004 * max(1.0, far))


def _vector(values: Array) -> Vector3:
    return (float(values[0]), float(values[1]), float(values[2]))


def _quaternion(axes: Array) -> tuple[float, float, float, float]:
    """Return the unit quaternion (x, y, z, w) of a rotation matrix: the eigenvector of Bar-Itzhack, 2000."""
    m = axes
    k = np.array(
        [
            [m[0, 0] - m[1, 1] - m[2, 2], m[0, 1] + m[1, 0], m[0, 2] + m[2, 0], m[2, 1] - m[1, 2]],
            [m[0, 1] + m[1, 0], m[1, 1] - m[0, 0] - m[2, 2], m[1, 2] + m[2, 1], m[0, 2] - m[2, 0]],
            [m[0, 2] + m[2, 0], m[1, 2] + m[2, 1], m[2, 2] - m[0, 0] - m[1, 1], m[1, 0] - m[0, 1]],
            [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], m[0, 0] + m[1, 1] + m[2, 2]],
        ]
    )
    x, y, z, w = np.linalg.eigh(k)[1][:, -1]
    return (float(x), float(y), float(z), float(w))
