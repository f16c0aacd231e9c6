"""Sightings of several pictures as one each: averaged over those of the same face."""

from __future__ import annotations

import math
from collections.abc import Sequence

from skills.ports.geometry import Pose, angle_between, scale
from skills.ports.message import Quaternion, Vector3
from skills.ports.world import Sighting

SAME_FACE = math.radians(40.0)
"""Sightings of an item that look less apart than this are of one face; its faces are 90 degrees apart."""


def merge(sightings: Sequence[Sighting]) -> tuple[Sighting, ...]:
    """Return one sighting for each item, by item: the face best seen, averaged over its pictures.

    An item's quality is that of its mean sighting; sigma falls with the root of the number, but not below a
    half, since errors of pictures from one place are not independent.
    """
    items = sorted({each.item for each in sightings})
    return tuple(_of_item([each for each in sightings if each.item == item]) for item in items)


def _of_item(sightings: list[Sighting]) -> Sighting:
    best = max(sightings, key=lambda each: each.quality)
    face = [
        each
        for each in sightings
        if angle_between(each.tag_in_map.orientation, best.tag_in_map.orientation) < SAME_FACE
    ]
    if len(face) == 1:
        return best
    weights = [1.0 / max(each.position_sigma, 1e-5) ** 2 for each in face]
    total = sum(weights)
    return Sighting(
        item=best.item,
        stamp=face[-1].stamp,
        tag_in_map=_mean([each.tag_in_map for each in face], weights),
        tag_in_base=_mean([each.tag_in_base for each in face], weights),
        tag_in_camera=_mean([each.tag_in_camera for each in face], weights),
        distance=sum(w * each.distance for w, each in zip(weights, face, strict=True)) / total,
        quality=sum(each.quality for each in face) / len(face),
        position_sigma=max(total**-0.5, 0.5 * min(each.position_sigma for each in face)),
    )


def _mean(poses: list[Pose], weights: list[float]) -> Pose:
    """Return the weighted mean: of quaternions that lie near each other, the normalised sum."""
    total = sum(weights)
    position: list[float] = [0.0, 0.0, 0.0]
    turned: list[float] = [0.0, 0.0, 0.0, 0.0]
    first = poses[0].orientation
    for pose, weight in zip(poses, weights, strict=True):
        near = math.copysign(weight, sum(a * b for a, b in zip(first, pose.orientation, strict=True)))
        position = [a + weight * b for a, b in zip(position, pose.position, strict=True)]
        turned = [a + near * b for a, b in zip(turned, pose.orientation, strict=True)]
    norm = math.sqrt(sum(part * part for part in turned))
    mean: Vector3 = (position[0], position[1], position[2])
    unit: Quaternion = (turned[0] / norm, turned[1] / norm, turned[2] / norm, turned[3] / norm)
    return Pose(position=scale(mean, 1.0 / total), orientation=unit)
