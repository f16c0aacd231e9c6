"""What goes to a worker: a picture with all that is needed to read it. Module-level and picklable."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tandem.skills.geometry.poses import compose, conjugate, rotate, to_pose
from tandem.skills.grasping.item_frames import tag_of_item
from tandem.skills.perception import clutter, tags
from tandem.skills.perception.open_view import in_the_open
from tandem.skills.perception.rigid import Matrix
from tandem.skills.ports.image import decode
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.world import Box, Sighting


@dataclass(frozen=True)
class Shot:
    """A picture, as it came over the bus, and where it was taken from."""

    payload: bytes
    camera_in_base: Pose
    base_in_map: FloorPose


@dataclass(frozen=True)
class TagJob:
    """Find the tags of these sizes (m, by tag), and which items are not where they are believed to stand."""

    shot: Shot
    sizes: tuple[tuple[int, float], ...]
    believed: tuple[tuple[int, Box], ...] = ()


@dataclass(frozen=True)
class TagsFound:
    """The picture's tags, and the items believed in it that are not where they were.

    ``absent``: the depth shows that nothing is there. ``unread``: something is, but their tag, which would be
    in plain view, is not. ``hidden``: something nearer covers the place, which proves nothing.
    """

    sightings: tuple[Sighting, ...]
    absent: tuple[int, ...]
    unread: tuple[int, ...] = ()
    hidden: tuple[int, ...] = ()


@dataclass(frozen=True)
class ClutterJob:
    """Find what nothing known explains, and which of the believed boxes the picture shows wholly."""

    shot: Shot
    known: clutter.Known
    believed: tuple[Box, ...]
    earlier: Matrix
    """(n, 3) points in the map of the same look's earlier pictures."""


@dataclass(frozen=True)
class ClutterFound:
    """(n, 3) points in the map of all the look's pictures, boxes about them, and believed boxes shown."""

    points: Matrix
    boxes: tuple[Box, ...]
    shown: tuple[Box, ...]


def find_tags(job: TagJob) -> TagsFound:
    """Return the picture's tags; an item that shows two faces is told twice, the better face first."""
    image = decode(job.shot.payload)
    base_in_map = to_pose(job.shot.base_in_map)
    up_in_base = rotate(conjugate(base_in_map.orientation), (0.0, 0.0, 1.0))
    up_in_camera = rotate(conjugate(job.shot.camera_in_base.orientation), up_in_base)
    found = []
    for seen in tags.find(image, dict(job.sizes), up_in_camera):
        tag_in_base = compose(job.shot.camera_in_base, seen.tag_in_camera)
        found.append(
            Sighting(
                item=seen.item,
                stamp=image.header.stamp,
                tag_in_map=compose(base_in_map, tag_in_base),
                tag_in_base=tag_in_base,
                tag_in_camera=seen.tag_in_camera,
                distance=seen.distance,
                quality=seen.quality,
                position_sigma=seen.position_sigma,
            )
        )
    camera_in_map = compose(base_in_map, job.shot.camera_in_base)
    seen_items, sizes = {each.item for each in found}, dict(job.sizes)
    missing = [(item, box) for item, box in job.believed if item not in seen_items]
    absent = tuple(item for item, box in missing if clutter.seen_through(image, camera_in_map, box))
    unread = tuple(
        item
        for item, box in missing
        if item not in absent
        and in_the_open(image, camera_in_map, tag_of_item(box.pose, box.size[0]), sizes[item])
    )
    hidden = tuple(
        item
        for item, box in missing
        if item not in (*absent, *unread) and clutter.covered(image, camera_in_map, box)
    )
    return TagsFound(tuple(found), absent, unread, hidden)


def warm_up(edge: int) -> int:
    """Find no tag in a blank square of ``edge`` pixels: a worker that did this has loaded all it needs."""
    return len(tags.detect(np.zeros((edge, edge), np.uint8)))


def find_clutter(job: ClutterJob) -> ClutterFound:
    """Return what the picture shows that is not known."""
    image = decode(job.shot.payload)
    base_in_map = to_pose(job.shot.base_in_map)
    fresh = clutter.unexplained(image, job.shot.camera_in_base, base_in_map, job.known)
    # An item that was recognised only now explains what stood unexplained before.
    points = np.concatenate((clutter.without(job.earlier, job.known.items), fresh))
    camera_in_map = compose(base_in_map, job.shot.camera_in_base)
    return ClutterFound(
        points=points,
        boxes=clutter.boxes(points, job.known.furniture),
        shown=clutter.looked_through(image, camera_in_map, job.believed),
    )
