"""Which head positions show all furniture that is near: an arm goes only where something was looked for.

What stands beside the picture of an item is unknown, and an arm that takes it for free sweeps it away.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from tandem.skills.geometry.poses import compose, to_pose
from tandem.skills.perception.aim import Aim
from tandem.skills.perception.clutter import RANGE
from tandem.skills.perception.rigid import Matrix, points_from, points_in
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.sensors import CameraSensor
from tandem.skills.ports.world import Box

COST: Final = 0.05
"""Robot seconds that the choice is charged in lockstep; measured: 30 to 50 ms."""
APART: Final = 0.1
"""Metres between the points that are to be seen: what shows two of them shows a thing of 5 cm between."""
TALL: Final = 0.15
"""Metres above a surface up to which it is to be seen: most of what stands on a table is lower."""
SURFACES: Final = (0.4, 1.2)
"""Metres above the floor between which a top is a surface: below no arm reaches, above no camera sees it."""
EDGE: Final = 0.04
"""Share of the picture's half width and height in which nothing counts as seen: things are cut off there."""
LEAST: Final = 6
"""Points that a further view must add, of which two stand on each 0.01 m2: less is a rim."""
MOST: Final = 4
"""Further views, at the most. Picks from a table take 2 or 3, some 2 s each."""
LATTICE: Final = 0.2
"""Radians between the head positions that are tried: a sixth of the picture's height."""


@dataclass(frozen=True)
class ViewsJob:
    """What the choice needs. ``within``: metres about the base's axis; ``seen_from``: views that are taken.

    ``joints`` are all but the head's. Picklable.
    """

    aim: Aim
    camera: CameraSensor
    furniture: tuple[Box, ...]
    base_in_map: FloorPose
    joints: Mapping[str, float]
    within: float
    seen_from: tuple[tuple[float, ...], ...] = ()


def further_views(job: ViewsJob) -> tuple[tuple[float, ...], ...]:
    """Return the head positions that show what the views taken do not, the most telling first.

    Greedy: each shows the most points that no other one has shown. Places that no head position shows are
    left out.
    """
    points = surface_points(job.furniture, job.base_in_map, job.within)
    if not len(points):
        return ()
    heads = (*job.seen_from, *job.aim.lattice(LATTICE))
    shown = np.array([_shows(job, head, points) for head in heads])
    taken = len(job.seen_from)
    open_yet = ~shown[:taken].any(axis=0) & shown[taken:].any(axis=0)
    views: list[tuple[float, ...]] = []
    while len(views) < MOST:
        gains = (shown[taken:] & open_yet).sum(axis=1)
        if gains.max(initial=0) < LEAST:
            break
        last = (*job.seen_from, *views)[-1:] or ((0.0,) * len(heads[taken]),)
        way = np.abs(np.array(heads[taken:]) - np.array(last[0])).max(axis=1)
        best = int(np.lexsort((way, -gains))[0])
        views.append(heads[taken + best])
        open_yet &= ~shown[taken + best]
    return tuple(views)


def surface_points(furniture: Sequence[Box], base_in_map: FloorPose, within: float) -> Matrix:
    """Return (n, 3) points in the map on tops of furniture near the base, and above them, on a lattice."""
    found = []
    for box in furniture:
        top = box.pose.position[2] + box.size[2] / 2.0
        if not SURFACES[0] <= top <= SURFACES[1]:
            continue
        level = points_in(box.pose, _lattice(box))
        near = np.hypot(level[:, 0] - base_in_map.x, level[:, 1] - base_in_map.y) <= within
        level = level[near & ~_covered(level, furniture)]
        found += [level, level + np.array((0.0, 0.0, TALL))]
    return np.concatenate(found) if found else np.zeros((0, 3))


def _lattice(box: Box) -> Matrix:
    """Return points on the top of a box, in its frame."""
    x, y = (
        np.linspace(-edge / 2.0, edge / 2.0, 1 + math.ceil(edge / APART)) if edge > APART else np.zeros(1)
        for edge in box.size[:2]
    )
    columns, rows = np.meshgrid(x, y)
    return np.stack((columns.ravel(), rows.ravel(), np.full(columns.size, box.size[2] / 2.0)), axis=1)


def _covered(points: Matrix, furniture: Sequence[Box]) -> NDArray[np.bool_]:
    """Say which points of tops have other furniture right above: the legs of a table have its top there."""
    covered = np.zeros(len(points), np.bool_)
    above = points + np.array((0.0, 0.0, 0.01))
    for box in furniture:
        own = points_from(box.pose, above)
        covered |= np.all(np.abs(own) <= np.array(box.size) / 2.0, axis=1)
    return covered


def _shows(job: ViewsJob, head: tuple[float, ...], points: Matrix) -> NDArray[np.bool_]:
    """Say which points are well in the picture that is taken with the head there."""
    camera = compose(to_pose(job.base_in_map), job.aim.camera_in_base(head, job.joints))
    own, across = points_from(camera, points), math.tan(job.camera.horizontal_fov / 2.0)
    half = np.array((across, across * job.camera.height / job.camera.width)) * (1.0 - EDGE)
    depth = own[:, 2]
    inside = np.all(np.abs(own[:, :2]) <= depth[:, None] * half, axis=1)
    return np.asarray(inside & (depth > RANGE[0]) & (depth < RANGE[1]), np.bool_)
