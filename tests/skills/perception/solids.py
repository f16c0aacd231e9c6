"""Depth images of boxes on a floor, by casting a ray for each pixel: truth for clutter."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tandem.skills.geometry.poses import compose, invert
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Box
from tests.skills.perception.pictures import rotation


def scene(
    header: RgbdHeader,
    camera_in_map: Pose,
    boxes: Sequence[Box],
    rng: np.random.Generator,
    noise: float = 1.0,
) -> RgbdImage:
    """Return a grey picture with the depth of the boxes and of the floor, noisy like a Kinect's."""
    u, v = np.meshgrid(np.arange(header.width), np.arange(header.height))
    rays = np.stack(((u - header.cx) / header.fx, (v - header.cy) / header.fy, np.ones(u.shape)), axis=-1)
    floor = Box(size=(40, 40, 0.2), pose=Pose(position=(0, 0, -0.1)))
    depth = np.full(u.shape, np.inf)
    for box in (*boxes, floor):
        depth = np.minimum(depth, _hit(rays, compose(invert(camera_in_map), box.pose), box))
    depth = np.where(np.isfinite(depth), depth, 0.0)
    depth += noise * (0.0012 + 0.0019 * (depth - 0.4) ** 2) * rng.normal(size=depth.shape) * (depth > 0)
    return RgbdImage(
        header=header,
        colour=np.full((header.height, header.width, 3), 120, np.uint8),
        depth=np.clip(np.round(depth * 1000), 0, 60000).astype(np.uint16),
    )


def _hit(rays: NDArray[np.float64], box_in_camera: Pose, box: Box) -> NDArray[np.float64]:
    """Return the depth at which each ray enters the box (slab method), inf where it misses."""
    turn, at = rotation(box_in_camera), np.array(box_in_camera.position)
    local = rays @ turn
    start = -at @ turn
    half = np.array(box.size) / 2
    with np.errstate(divide="ignore", invalid="ignore"):
        one, two = (-half - start) / local, (half - start) / local
    enter = np.minimum(one, two).max(axis=-1)
    leave = np.maximum(one, two).min(axis=-1)
    return np.where((enter <= leave) & (enter > 0), enter, np.inf)
