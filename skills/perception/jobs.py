"""What goes to a worker: a picture with all that is needed to read it. Module-level and picklable."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tandem.skills.geometry.poses import compose, conjugate, rotate, to_pose
from tandem.skills.grasping.item_frames import tag_of_item
from tandem.skills.perception import clutter, tags
from tandem.skills.perception.detectors import Detection, Detector
from tandem.skills.perception.open_view import in_the_open
from tandem.skills.perception.rigid import Matrix
from tandem.skills.ports.image import RgbdImage, decode
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.plugins import in_words
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.site import SiteItem
from tandem.skills.ports.world import Box, Sighting


@dataclass(frozen=True)
class Shot:
    """A picture, as it came over the bus, and where it was taken from."""

    payload: bytes
    camera_in_base: Pose
    base_in_map: FloorPose


@dataclass(frozen=True)
class TagJob:
    """Find these items, and which of them are not where they are believed to stand."""

    shot: Shot
    items: tuple[SiteItem, ...]
    believed: tuple[tuple[int, Box], ...] = ()
    detectors: tuple[Detector, ...] = (tags.of_items,)


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
    troubles: tuple[str, ...] = ()
    """What detectors raised, in words; the others have read the picture."""


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
    detections, troubles = _detect(job, image, up_in_camera)
    found = []
    for seen in detections:
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
    seen_items, sizes = {each.item for each in found}, {each.item: each.seen_edge for each in job.items}
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
    return TagsFound(tuple(found), absent, unread, hidden, troubles)


def _detect(job: TagJob, image: RgbdImage, up: Vector3) -> tuple[list[Detection], tuple[str, ...]]:
    """Return what the detectors find of the items, and what those raised that could not.

    Raises:
        Exception: what the first one raised, when none could read the picture.
    """
    found, raised = list[Detection](), list[Exception]()
    known = {each.item for each in job.items}
    for detector in job.detectors:
        try:
            found += [each for each in detector(image, job.items, up) if each.item in known]
        except Exception as error:  # noqa: BLE001 - a plug-in's mistake costs what it would have seen
            raised.append(error)
    if raised and len(raised) == len(job.detectors):
        raise raised[0]
    found.sort(key=lambda each: (each.item, -each.quality))
    return found, tuple(in_words(error) for error in raised)


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
