"""A drawing of the world: a second pybullet client without physics, bodies put where a snapshot says.

It draws with the EGL plugin where that loads and with pybullet's own TinyRenderer otherwise. Nothing is
simulated here: states are set by hand because they are copies of those in the world.
"""

from __future__ import annotations

import importlib.util
import itertools
import math
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np
import pybullet

from tandem.sim.chatter import unheard
from tandem.sim.meshes import write_shape
from tandem.sim.tags import write_item, write_tin
from tandem.sim.things import BoxShape, CylinderShape
from tandem.skills.geometry.poses import from_axes, rotate
from tandem.skills.ports.packages import resolve
from tandem.skills.ports.pose import Pose

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from tandem.sim.scene import SceneBody
    from tandem.skills.ports.message import Vector3

NEAR: Final = 0.10
FAR: Final = 12.0
NOTHING: Final = 0.999 * FAR
"""Metres along the optical axis between which things are drawn."""

EGL_WINDOW: Final = (1024, 768)
"""Pixels that pybullet's EGL plugin draws at the most; what is larger it stretches, repeating columns."""

WARM_UP: Final = 2
"""Pictures that EGL draws without shadows before it draws the same thing each time."""

TINY_SHIFT: Final = (0.5, -0.5)
"""Pixels (right, down) by which TinyRenderer misplaces everything; measured, and taken back."""

FLOOR_EDGE: Final = 12.0
"""Metres: of the slab that is drawn as the floor, with its middle in the map's origin."""
FLOOR_COLOUR: Final = (0.58, 0.55, 0.50)
"""Red, green, blue from 0 to 1: neither black nor white, as tags are."""
LIGHT_FROM: Final = (2.0, -3.0, 6.0)
"""A direction in the map: from above and aside, so that the faces of a box differ in brightness."""


Part = tuple[int, int, int, int]
"""Pixels of a picture: from left to right, from top to bottom."""


@dataclass(frozen=True)
class View:
    """A pinhole camera with square pixels; the pose is optical: z forward, x right, y down."""

    camera_in_map: Pose
    width: int
    height: int
    horizontal_fov: float

    @property
    def focal(self) -> float:
        """Return the focal length in pixels."""
        return self.width / 2 / math.tan(self.horizontal_fov / 2)


@dataclass(frozen=True)
class Posed:
    """A robot at one moment; ``joints`` are those that can move."""

    base_in_map: Pose
    joints: tuple[tuple[str, float], ...]


@dataclass(frozen=True)
class Snapshot:
    """Where everything is at one moment; ``bodies`` are those that can move."""

    robots: tuple[Posed, ...]
    """In the order in which they were told to the painter; one that is left out stays where it was."""
    bodies: tuple[tuple[str, Pose], ...]


@dataclass(frozen=True)
class Picture:
    """``colour`` (height, width, 3) uint8 RGB; ``depth`` (height, width) metres along the axis or inf."""

    colour: NDArray[np.uint8]
    depth: NDArray[np.float32]


class RenderWorld:
    """A drawn copy of the world.

    Args:
        urdfs: the robots, with ``package://`` addresses; their visuals are drawn.
        folder: where textures and the like are written; it must exist and outlive the render world.
        hardware: try EGL first.
    """

    def __init__(self, urdfs: Sequence[str], folder: Path, *, hardware: bool = True) -> None:
        self._folder = folder
        self.client: int = pybullet.connect(pybullet.DIRECT)
        with unheard():
            # EGL tells what it loads, and once more what it has loaded, with the first picture.
            self._plugin = _load_egl(self.client) if hardware else -1
            if self._plugin >= 0:
                self._draw_part(View(looking_at((1.0, 0.0, 1.0), (0.0, 0.0, 0.0)), 8, 8, 1.0), (0, 8, 0, 8))
        self._ids: dict[str, int] = {}
        self._scene: tuple[SceneBody, ...] = ()
        self._written = 0
        self._add_floor()
        self._robots = tuple(
            _DrawnRobot(urdf, folder / f"robot_{number}.urdf", self.client)
            for number, urdf in enumerate(urdfs)
        )
        for _ in range(WARM_UP):
            self.draw(View(looking_at((1.0, 0.0, 1.0), (0.0, 0.0, 0.0)), 64, 36, math.pi / 3))

    @property
    def renderer(self) -> str:
        """``egl`` or ``tiny``."""
        return "egl" if self._plugin >= 0 else "tiny"

    def set_scene(self, bodies: tuple[SceneBody, ...]) -> None:
        """Draw these bodies from now on, each where it says until a snapshot tells otherwise."""
        old = {body.name: body for body in self._scene}
        new = {body.name: body for body in bodies}
        for name, body in old.items():
            if new.get(name) != body:
                pybullet.removeBody(self._ids.pop(name), physicsClientId=self.client)
        for name, body in new.items():
            if name not in self._ids:
                self._ids[name] = self._add(body)
        self._scene = bodies

    def follow(self, snapshot: Snapshot) -> None:
        """Put everything where the snapshot says."""
        for robot, posed in zip(self._robots, snapshot.robots, strict=False):
            robot.follow(posed)
        for name, pose in snapshot.bodies:
            pybullet.resetBasePositionAndOrientation(
                self._ids[name], pose.position, pose.orientation, physicsClientId=self.client
            )

    def draw(self, view: View) -> Picture:
        """Return what a camera sees. The light's shadows are drawn too."""
        tile = EGL_WINDOW if self._plugin >= 0 else (view.width, view.height)
        columns, rows = _cuts(view.width, tile[0]), _cuts(view.height, tile[1])
        colour = np.empty((view.height, view.width, 3), dtype=np.uint8)
        depth = np.empty((view.height, view.width), dtype=np.float32)
        for top, bottom in itertools.pairwise(rows):
            for left, right in itertools.pairwise(columns):
                part = self._draw_part(view, (left, right, top, bottom))
                colour[top:bottom, left:right] = part.colour
                depth[top:bottom, left:right] = part.depth
        return Picture(colour=colour, depth=depth)

    def _draw_part(self, view: View, part: Part) -> Picture:
        """Draw some of the pixels."""
        left, right, top, bottom = part
        width, height = right - left, bottom - top
        _, _, rgba, buffer, _ = pybullet.getCameraImage(
            width,
            height,
            _view_matrix(view.camera_in_map),
            _projection(view, part, (0.0, 0.0) if self._plugin >= 0 else TINY_SHIFT),
            shadow=1,
            lightDirection=LIGHT_FROM,
            lightAmbientCoeff=0.55,
            lightDiffuseCoeff=0.5,
            lightSpecularCoeff=0.05,
            renderer=pybullet.ER_BULLET_HARDWARE_OPENGL if self._plugin >= 0 else pybullet.ER_TINY_RENDERER,
            flags=pybullet.ER_NO_SEGMENTATION_MASK,
            physicsClientId=self.client,
        )
        colour = np.asarray(rgba, dtype=np.uint8).reshape(height, width, 4)[:, :, :3]
        z_buffer = np.asarray(buffer, dtype=np.float32).reshape(height, width)
        depth = np.float32(FAR * NEAR) / (np.float32(FAR) - np.float32(FAR - NEAR) * z_buffer)
        depth[depth >= NOTHING] = np.inf
        return Picture(colour=colour, depth=depth)

    def close(self) -> None:
        """End the client. Closing twice is allowed."""
        if self.client < 0:
            return
        with unheard():
            if self._plugin >= 0:
                pybullet.unloadPlugin(self._plugin, physicsClientId=self.client)
            pybullet.disconnect(physicsClientId=self.client)
        self.client = -1

    def _add_floor(self) -> None:
        slab = BoxShape(size=(FLOOR_EDGE, FLOOR_EDGE, 0.1))
        path = write_shape(self._folder, "floor", slab)
        self._add_mesh(path, Pose(position=(0.0, 0.0, -0.05)), FLOOR_COLOUR)

    def _add(self, body: SceneBody) -> int:
        label, edge = body.label, None if body.label is None else body.label.tag_size
        if label is not None and edge is not None and isinstance(body.shape, BoxShape):
            path = write_item(self._folder, label.item, body.shape.size, edge)
        elif label is not None and edge is not None and isinstance(body.shape, CylinderShape):
            path = write_tin(self._folder, label.item, body.shape, edge)
        else:
            path = write_shape(self._folder, f"body_{self._written}", body.shape)
            self._written += 1
        return self._add_mesh(path, body.pose, body.colour)

    def _add_mesh(self, path: Path, pose: Pose, colour: Vector3) -> int:
        shape = pybullet.createVisualShape(
            pybullet.GEOM_MESH,
            fileName=str(path),
            rgbaColor=(*colour, 1.0),
            specularColor=(0, 0, 0),
            physicsClientId=self.client,
        )
        body: int = pybullet.createMultiBody(
            0.0, -1, shape, pose.position, pose.orientation, physicsClientId=self.client
        )
        return body


def looking_at(eye: Vector3, target: Vector3) -> Pose:
    """Return the optical pose of a camera that looks from ``eye`` to ``target`` with map's z upwards.

    Raises:
        ValueError: when it would look straight up or down, where "upwards" says nothing.
    """
    forward = np.subtract(target, eye)
    right = np.cross(forward, (0.0, 0.0, 1.0))
    if np.linalg.norm(right) < 1e-9:
        raise ValueError("expected the eye and the target to differ in x or y")
    forward, right = forward / np.linalg.norm(forward), right / np.linalg.norm(right)
    down = np.cross(forward, right)
    columns = np.column_stack((right, down, forward))
    return Pose(position=eye, orientation=_quaternion(columns))


def _quaternion(matrix: NDArray[np.float64]) -> tuple[float, float, float, float]:
    x, y, z = ((float(column[0]), float(column[1]), float(column[2])) for column in matrix.T)
    return from_axes(x, y, z)


def _view_matrix(camera: Pose) -> list[float]:
    """Return OpenGL's view matrix (column by column) of an optical pose."""
    position, turn = camera.position, camera.orientation
    forward, down = rotate(turn, (0.0, 0.0, 1.0)), rotate(turn, (0.0, 1.0, 0.0))
    target = tuple(p + f for p, f in zip(position, forward, strict=True))
    up = tuple(-d for d in down)
    matrix: list[float] = pybullet.computeViewMatrix(position, target, up)
    return matrix


def _cuts(length: int, most: int) -> list[int]:
    """Return where to cut a length into equal parts of ``most`` pixels at the most, both ends with it."""
    parts = -(-length // most)
    return [length * part // parts for part in range(parts + 1)]


def _projection(view: View, part: Part, shift: tuple[float, float]) -> list[float]:
    """Return OpenGL's projection matrix of a part of the picture, shifted by parts of a pixel."""
    left, right, top, bottom = part
    metres = NEAR / view.focal
    centre_x, centre_y = view.width / 2 - shift[0], view.height / 2 - shift[1]
    matrix: list[float] = pybullet.computeProjectionMatrix(
        (left - centre_x) * metres,
        (right - centre_x) * metres,
        (centre_y - bottom) * metres,
        (centre_y - top) * metres,
        NEAR,
        FAR,
    )
    return matrix


def _load_egl(client: int) -> int:
    """Return the plugin's number, or -1 where EGL doesn't load."""
    found = importlib.util.find_spec("eglRenderer")
    if found is None or found.origin is None:
        return -1
    plugin: int = pybullet.loadPlugin(found.origin, "_eglRendererPlugin", physicsClientId=client)
    return plugin


class _DrawnRobot:
    """A robot in the drawing."""

    def __init__(self, urdf: str, path: Path, client: int) -> None:
        self._client, self._body = client, _load_robot(urdf, path, client)
        self._joints: dict[str, int] = {}
        for index in range(pybullet.getNumJoints(self._body, physicsClientId=client)):
            info = pybullet.getJointInfo(self._body, index, physicsClientId=client)
            self._joints[info[1].decode()] = index
        inertial = pybullet.getDynamicsInfo(self._body, -1, physicsClientId=client)
        self._mass_centre_in_root = (inertial[3], inertial[4])

    def follow(self, posed: Posed) -> None:
        """Put it where it is said to be."""
        base = posed.base_in_map
        at, turn = pybullet.multiplyTransforms(base.position, base.orientation, *self._mass_centre_in_root)
        pybullet.resetBasePositionAndOrientation(self._body, at, turn, physicsClientId=self._client)
        for name, position in posed.joints:
            pybullet.resetJointState(self._body, self._joints[name], position, physicsClientId=self._client)


def _load_robot(urdf: str, path: Path, client: int) -> int:
    """Load a robot; pybullet takes a path that it has read before for the same file, so each has its own."""
    for uri in sorted({part.split('"')[0] for part in urdf.split('filename="')[1:]}):
        urdf = urdf.replace(uri, str(resolve(uri)))
    path.write_text(urdf, encoding="utf-8")
    robot: int = pybullet.loadURDF(
        str(path), useFixedBase=1, flags=pybullet.URDF_MAINTAIN_LINK_ORDER, physicsClientId=client
    )
    return robot
