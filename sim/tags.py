"""Tagged items as pictures: one AprilTag 36h11 on all four upright sides of a box, as shipping labels are.

A cylinder has four flat labels that touch its side where the box about it does, so that a tag stays flat and
is as upright as on a box. They are paper, drawn but nothing to bump into; none comes out of the box about it.

The tag's frame: origin in its centre, z out of the face, y up, x to the right as seen from outside. What the
black square leaves of the face is white margin.

A texture set by ``changeVisualShape`` comes out wrong in EGL, so each box is an OBJ file whose MTL names its
own texture: an atlas with the sides that look along x, those that look along y, and the lid.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

import cv2
import numpy as np

from tandem.sim.meshes import cylinder
from tandem.skills.geometry.poses import from_axes
from tandem.skills.ports.pose import Pose

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tandem.sim.things import CylinderShape
    from tandem.skills.ports.message import Vector3

CELLS: Final = 8
"""Cells along the black square of a 36h11 tag: six of data and a border of one."""
PIXELS_PER_CELL: Final = 24
"""Of a texture: a camera of the shipped robots shows as many of a 7 cm tag from 0.4 m."""
MARGIN_GREY: Final = 245
"""Of 255: paper, a little less than white."""
LID_RGB: Final = (196, 160, 112)
"""The colour of cardboard."""


@dataclass(frozen=True)
class Face:
    """An upright side of a box: its normal, and the direction to the right as seen from outside."""

    normal: Vector3
    right: Vector3


FACES: Final = (
    Face((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
    Face((0.0, 1.0, 0.0), (-1.0, 0.0, 0.0)),
    Face((-1.0, 0.0, 0.0), (0.0, -1.0, 0.0)),
    Face((0.0, -1.0, 0.0), (1.0, 0.0, 0.0)),
)


LABEL: Final = 1.25
"""Edge of a cylinder's label by that of the tag's square: a cell of white on each side, which 36h11 needs."""
OFF: Final = 0.0002
"""Metres between a label and the side that it touches: where two faces are one, either is drawn."""
TIN_RGB: Final = (150, 156, 164)
"""The colour of tinplate."""


def tags_in_item(size: Vector3) -> tuple[Pose, ...]:
    """Return the poses of the four tags in the item's frame (its centre, z up), in the order of FACES."""
    up = (0.0, 0.0, 1.0)
    poses = []
    for face in FACES:
        n = face.normal
        centre = (n[0] * size[0] / 2, n[1] * size[1] / 2, n[2] * size[2] / 2)
        poses.append(Pose(position=centre, orientation=from_axes(face.right, up, face.normal)))
    return tuple(poses)


def tag_image(tag: int, pixels_per_cell: int = PIXELS_PER_CELL) -> NDArray[np.uint8]:
    """Return the black square of a 36h11 tag, (8 n, 8 n) uint8, row 0 at its top."""
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11)
    image = cv2.aruco.generateImageMarker(dictionary, tag, CELLS * pixels_per_cell, borderBits=1)
    return np.asarray(image, dtype=np.uint8)


def write_item(folder: Path, tag: int, size: Vector3, tag_size: float) -> Path:
    """Write OBJ, MTL and PNG of a tagged box and return the OBJ's path; the folder must exist.

    Args:
        folder: where the files go; the same tag and size write the same files.
        tag: 36h11 id, 0 to 586.
        size: edges in metres along the item's x, y, z.
        tag_size: edge in metres of the tag's black square.

    Raises:
        OSError: when the folder can't be written to.
    """
    stem = f"item_{tag}_{'x'.join(str(round(edge * 1e4)) for edge in (*size, tag_size))}"
    atlas, regions = _atlas(tag, size, tag_size, LID_RGB)
    _write_texture(folder, stem, atlas)
    path = folder / f"{stem}.obj"
    path.write_text(_obj(stem, size, regions), encoding="ascii")
    return path


def write_tin(folder: Path, tag: int, shape: CylinderShape, tag_size: float) -> Path:
    """Write OBJ, MTL and PNG of a cylinder with four labels and return the OBJ's path; the folder must exist.

    Args:
        folder: where the files go; the same tag and size write the same files.
        tag: 36h11 id, 0 to 586.
        shape: of the item.
        tag_size: edge in metres of the tag's black square.

    Raises:
        OSError: when the folder can't be written to.
    """
    measures = (2 * shape.radius, shape.height, tag_size)
    stem = f"item_{tag}_tin_{'x'.join(str(round(each * 1e4)) for each in measures)}"
    width, height = min(LABEL * tag_size, measures[0]), min(LABEL * tag_size, shape.height)
    atlas, (label, _, side) = _atlas(tag, (width, width, height), tag_size, TIN_RGB)
    _write_texture(folder, stem, atlas)
    reach = shape.radius + OFF
    lines = [f"mtllib {stem}.mtl", "usemtl label"]
    for face in FACES:
        half = (reach, width / 2, height / 2) if face.normal[0] else (width / 2, reach, height / 2)
        lines += _quad(face.normal, face.right, (0.0, 0.0, 1.0), label, half)
    lines += _faces(len(FACES))
    u, v = (side[0] + side[1]) / 2, (side[2] + side[3]) / 2
    for number, triangle in enumerate(cylinder(shape.radius, shape.height)):
        for point, normal in triangle:
            lines.append("v " + " ".join(f"{value:.6f}" for value in point))
            lines.append(f"vt {u:.6f} {v:.6f}")
            lines.append("vn " + " ".join(f"{value:.6f}" for value in normal))
        at, up = 4 * len(FACES) + 3 * number, len(FACES) + 3 * number
        lines.append("f " + " ".join(f"{at + k}/{at + k}/{up + k}" for k in (1, 2, 3)))
    path = folder / f"{stem}.obj"
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return path


def _write_texture(folder: Path, stem: str, atlas: NDArray[np.uint8]) -> None:
    if not cv2.imwrite(str(folder / f"{stem}.png"), atlas[:, :, ::-1]):
        raise OSError(f"{folder / stem}.png: can't be written")
    (folder / f"{stem}.mtl").write_text(
        f"newmtl label\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nNs 1\nmap_Kd {stem}.png\n", encoding="ascii"
    )


Region = tuple[float, float, float, float]
"""u from, u to, v from, v to: of the atlas, v upwards."""


def _atlas(
    tag: int, size: Vector3, tag_size: float, plain: tuple[int, int, int]
) -> tuple[NDArray[np.uint8], tuple[Region, Region, Region]]:
    """Return the picture (rows, columns, 3) and the regions of x sides, y sides and the plain rest in it."""
    scale = CELLS * PIXELS_PER_CELL / tag_size
    height = round(size[2] * scale)
    widths = (round(size[1] * scale), round(size[0] * scale), PIXELS_PER_CELL * 4)
    gap = PIXELS_PER_CELL
    total = sum(widths) + gap * (len(widths) - 1)
    atlas = np.full((height, total, 3), MARGIN_GREY, dtype=np.uint8)
    marker = tag_image(tag)
    regions: list[Region] = []
    left = 0
    for width in widths[:2]:
        row, column = (height - marker.shape[0]) // 2, left + (width - marker.shape[1]) // 2
        atlas[row : row + marker.shape[0], column : column + marker.shape[1]] = marker[:, :, np.newaxis]
        regions.append((left / total, (left + width) / total, 0.0, 1.0))
        left += width + gap
    atlas[:, left - gap // 2 :] = plain
    inset = PIXELS_PER_CELL
    regions.append(((left + inset) / total, (left + widths[2] - inset) / total, 0.3, 0.7))
    return atlas, (regions[0], regions[1], regions[2])


def _obj(stem: str, size: Vector3, regions: tuple[Region, Region, Region]) -> str:
    half = (size[0] / 2, size[1] / 2, size[2] / 2)
    lines = [f"mtllib {stem}.mtl", "usemtl label"]
    quads: list[tuple[Vector3, Vector3, Vector3, Region]] = [
        (face.normal, face.right, (0.0, 0.0, 1.0), regions[0] if face.normal[0] else regions[1])
        for face in FACES
    ]
    quads.append(((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), regions[2]))
    quads.append(((0.0, 0.0, -1.0), (1.0, 0.0, 0.0), (0.0, -1.0, 0.0), regions[2]))
    for normal, right, up, region in quads:
        lines += _quad(normal, right, up, region, half)
    return "\n".join([*lines, *_faces(len(quads))]) + "\n"


def _faces(quads: int) -> list[str]:
    """Return the lines of two triangles for each of the first quads of a file."""
    faces = []
    for index in range(quads):
        a, b, c, d = (4 * index + corner for corner in (1, 2, 3, 4))
        n = index + 1
        faces.append(f"f {a}/{a}/{n} {b}/{b}/{n} {c}/{c}/{n}")
        faces.append(f"f {a}/{a}/{n} {c}/{c}/{n} {d}/{d}/{n}")
    return faces


def _quad(normal: Vector3, right: Vector3, up: Vector3, region: Region, half: Vector3) -> list[str]:
    """Return the lines of four corners, counter-clockwise as seen from outside, and the normal."""
    u0, u1, v0, v1 = region
    lines = []
    for sr, su, u, v in ((-1, -1, u0, v0), (1, -1, u1, v0), (1, 1, u1, v1), (-1, 1, u0, v1)):
        corner = [half[i] * (normal[i] + sr * right[i] + su * up[i]) for i in range(3)]
        lines.append("v " + " ".join(f"{value:.6f}" for value in corner))
        lines.append(f"vt {u:.6f} {v:.6f}")
    lines.append("vn " + " ".join(f"{value:.1f}" for value in normal))
    return lines
