"""Pictures of tagged faces by ray casting with sub-samples: an independent truth for the estimator."""

from __future__ import annotations

import math
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from tandem.skills.geometry.poses import compose, from_rpy
from tandem.skills.ports.hardware import RgbdHeader
from tandem.skills.ports.image import RgbdImage
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import Pose

WIDTH, HEIGHT = 1280, 720
FOCAL = WIDTH / 2 / math.tan(math.radians(30.0))
# z of the tag looks at the camera, y of the tag is up in the picture.
FACING = Pose(orientation=(1.0, 0.0, 0.0, 0.0))


@dataclass(frozen=True)
class Face:
    """A white square with a tag on it."""

    item: int
    tag_in_camera: Pose
    tag_size: float


def header(seconds: float = 1.0) -> RgbdHeader:
    """Pixel centres have whole coordinates, as in OpenCV."""
    return RgbdHeader(
        stamp=RobotTime(boot="b", seconds=seconds),
        camera="head",
        width=WIDTH,
        height=HEIGHT,
        fx=FOCAL,
        fy=FOCAL,
        cx=(WIDTH - 1) / 2,
        cy=(HEIGHT - 1) / 2,
    )


def tag_at(
    distance: float, yaw: float, pitch: float, *, right: float = 0.0, down: float = 0.0, roll: float = 0.0
) -> Pose:
    """Return a tag ``distance`` ahead, turned about its y (yaw), its x (pitch) and its z (roll), radians."""
    turned = compose(FACING, Pose(orientation=from_rpy(pitch, yaw, roll)))
    return Pose(position=(right, down, distance), orientation=turned.orientation)


def rotation(pose: Pose) -> NDArray[np.float64]:
    """Return the 3x3 matrix, worked out by OpenCV from the axis and angle."""
    x, y, z, w = pose.orientation
    norm = math.sqrt(x * x + y * y + z * z)
    angle = 2 * math.atan2(norm, w)
    axis = np.array([x, y, z]) / max(norm, 1e-12)
    return np.asarray(cv2.Rodrigues(axis * angle)[0], dtype=np.float64)


def picture(
    faces: tuple[Face, ...],
    rng: np.random.Generator,
    *,
    grey_noise: float = 2.0,
    depth_noise: float = 1.0,
    background: float = 3.0,
    samples: int = 6,
    seconds: float = 1.0,
) -> RgbdImage:
    """Render the faces before a wall. ``depth_noise`` scales Kinect-like noise (Nguyen 2012)."""
    head = header(seconds)
    grey = np.full((HEIGHT, WIDTH), 120.0) + np.linspace(-20, 20, WIDTH)[None, :]
    depth = np.full((HEIGHT, WIDTH), background)
    for face in sorted(faces, key=lambda each: -each.tag_in_camera.position[2]):
        _draw(face, head, grey, depth, samples)
    grey = np.clip(grey + rng.normal(0.0, grey_noise, grey.shape), 0, 255)
    sigma = depth_noise * (0.0012 + 0.0019 * (depth - 0.4) ** 2)
    depth = depth + sigma * rng.normal(0.0, 1.0, depth.shape)
    return RgbdImage(
        header=head,
        colour=np.repeat(np.round(grey).astype(np.uint8)[:, :, None], 3, axis=2),
        depth=np.round(depth * 1000).astype(np.uint16),
    )


def _draw(
    face: Face, head: RgbdHeader, grey: NDArray[np.float64], depth: NDArray[np.float64], n: int
) -> None:
    turn, at = rotation(face.tag_in_camera), np.array(face.tag_in_camera.position)
    half = face.tag_size / 0.8 / 2
    corners = np.array([[-half, half, 0], [half, half, 0], [half, -half, 0], [-half, -half, 0]]) @ turn.T + at
    us = head.fx * corners[:, 0] / corners[:, 2] + head.cx
    vs = head.fy * corners[:, 1] / corners[:, 2] + head.cy
    left, right = max(int(us.min()) - 2, 0), min(int(us.max()) + 3, head.width)
    top, bottom = max(int(vs.min()) - 2, 0), min(int(vs.max()) + 3, head.height)
    offsets = (np.arange(n) + 0.5) / n - 0.5
    u = (np.arange(left, right)[:, None] + offsets).ravel()
    v = (np.arange(top, bottom)[:, None] + offsets).ravel()
    rays = np.stack(
        np.broadcast_arrays((u[None] - head.cx) / head.fx, (v[:, None] - head.cy) / head.fy, 1.0), -1
    )
    scale = (turn[:, 2] @ at) / (rays @ turn[:, 2])
    local = (rays * scale[..., None] - at) @ turn
    inside = (np.abs(local[..., 0]) <= half) & (np.abs(local[..., 1]) <= half)
    bits = _cells(face.item)
    column = np.floor((local[..., 0] / face.tag_size + 0.5) * 8).astype(int)
    row = np.floor((0.5 - local[..., 1] / face.tag_size) * 8).astype(int)
    on_tag = (column >= 0) & (column < 8) & (row >= 0) & (row < 8)
    value = np.where(on_tag, bits[np.clip(row, 0, 7), np.clip(column, 0, 7)], 1.0) * 220.0 + 20.0
    shape = (bottom - top, n, right - left, n)
    cover = inside.reshape(shape).mean(axis=(1, 3))
    shown = (value * inside).reshape(shape).sum(axis=(1, 3)) / n**2
    window = (slice(top, bottom), slice(left, right))
    grey[window] = shown + (1 - cover) * grey[window]
    centre = scale.reshape(shape).mean(axis=(1, 3))
    depth[window] = np.where(cover > 0.5, centre, depth[window])


def _cells(item: int) -> NDArray[np.float64]:
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11)
    return (np.asarray(cv2.aruco.generateImageMarker(dictionary, item, 8)) > 127).astype(np.float64)
