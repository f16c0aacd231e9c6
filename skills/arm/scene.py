"""The planning scene as the arm's checks need it: boxes and occupied cells in the base's frame."""

from __future__ import annotations

import math

import numpy as np

from tandem.skills.geometry.poses import compose, invert, to_pose
from tandem.skills.kinematics.bodies import CellsShape, Obstacle
from tandem.skills.ports.lattice import centres_of
from tandem.skills.ports.occupancy import Occupancy
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.shapes import solid
from tandem.skills.ports.world import PlanningScene, SceneObject

PADDING = {"furniture": (0.015, 0.003), "clutter": (0.01, 0.004), "item": (0.004, 0.002)}
"""Metres, sideways and up: sideways the base's own pose is less well known than heights are."""


NO_PADDING = (0.0, 0.0)
OCCUPIED = "occupied_space"
"""The name of the obstacle that cells make."""


def obstacles(
    scene: PlanningScene, base_in_map: FloorPose, reach: float, *, padded: bool = True
) -> tuple[Obstacle, ...]:
    """Return what stands within ``reach`` metres, in plan, of the robot's axis."""
    map_in_base = invert(to_pose(base_in_map))
    found = []
    for each in scene.objects:
        if each.attached_to is None and _gap(base_in_map, each) < reach:
            pose = compose(map_in_base, each.box.pose)
            padding = PADDING[each.kind] if padded else NO_PADDING
            found.append(Obstacle(each.name, solid(each.box), pose, padding))
    return (*found, *_occupied(scene.occupied, base_in_map, map_in_base, reach))


def _occupied(
    cells: Occupancy | None, base_in_map: FloorPose, map_in_base: Pose, reach: float
) -> tuple[Obstacle, ...]:
    """Return the occupied cells within reach as one obstacle; their size is padding enough."""
    if cells is None:
        return ()
    centres = centres_of(cells)
    near = np.hypot(centres[:, 0] - base_in_map.x, centres[:, 1] - base_in_map.y) < reach + cells.resolution
    if not near.any():
        return ()
    shape, frame = CellsShape.of(centres[near], cells.resolution)
    return (Obstacle(OCCUPIED, shape, compose(map_in_base, Pose(position=frame))),)


def allowed(
    scene: PlanningScene, touch_item: int | None, touch_links: tuple[str, ...], *, every: bool = False
) -> tuple[tuple[str, str], ...]:
    """Return the pairs that may touch: the item that is grasped (or every one), and the links of the hand."""
    names = [
        each.name for each in scene.objects if each.item is not None and (every or each.item == touch_item)
    ]
    return tuple((name, link) for name in names for link in touch_links)


def to_base(pose: Pose, frame: str, base_in_map: FloorPose | None) -> Pose:
    """Return a goal's pose in the base's frame; one in the map needs the base's pose."""
    if frame == "base" or base_in_map is None:
        return pose
    return compose(invert(to_pose(base_in_map)), pose)


def _gap(base: FloorPose, each: SceneObject) -> float:
    """Return at least how far (m, in plan) the box is from the base's axis, roughly: by its half diagonal."""
    x, y, _ = each.box.pose.position
    width, depth, _ = each.box.size
    return math.hypot(x - base.x, y - base.y) - 0.5 * math.hypot(width, depth)
