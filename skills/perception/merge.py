"""Sightings of several pictures as one for each thing: averaged only where they can be of one thing.

Two tags of one number are two things, and a thing that was moved between two pictures was never halfway. So
sightings are first put together by where their thing would be, and only then averaged.

**The gate.** Two sightings of one resting thing differ by the errors of both: with 3 coordinates, d^2 over
the variance along each axis is chi-square distributed with 3 degrees of freedom. They are taken for one thing
up to the quantile 0.999 (Bar-Shalom and Fortmann, Tracking and Data Association, 1988: validation gate).
Quantiles of 0.95 to 0.999 are usual; at 0.99 one in a hundred pairs of the *same* thing would be torn apart.

**In one picture** nothing moves. There two sightings are of two things, unless these would stand inside each
other: their sigmas say too little. Two faces of one cube gave middles 26 mm apart at 0.7 m, the second face
barely readable, and 12 mm apart at 2 m, with sigmas of 0.7 and 2 mm (fetch campaign, seed 1, runs 9 and 18).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from tandem.skills.geometry.poses import angle_between, rotate, scale
from tandem.skills.ports.message import Quaternion, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.world import Sighting

SAME_FACE: Final = math.radians(40.0)
"""Sightings of an item that look less apart than this are of one face; its faces are 90 degrees apart."""
CHI_SQUARE: Final = 16.27
"""Quantile 0.999 with 3 degrees of freedom."""
SYSTEMATIC: Final = 0.01
"""Metres that two sightings of one resting thing may differ by, whatever their sigmas. Those are of the tag
in the camera alone; the robot's pose in the map, through which each is told, moves a little from picture to
picture. The tag's own part is small: 0.95 mm at 1.5 m in 95 of 100 pictures (docs/benchmarks.md)."""


@dataclass
class _Thing:
    """What may be one thing: its sightings, and the numbers of the first and last picture that show it."""

    sightings: list[Sighting]
    first: int
    last: int


def merge(sightings: Sequence[Sighting], sizes: Mapping[int, Vector3]) -> tuple[Sighting, ...]:
    """Return one sighting for each thing, by item and best first: the face best seen, averaged.

    Two of one number that were there at the same time are told as two. Of one that was moved meanwhile only
    the place where it was seen last is told.

    Args:
        sightings: of all pictures, in the pictures' order.
        sizes: full edges (m) of the things, by item.
    """
    merged: list[Sighting] = []
    for item in sorted({each.item for each in sightings}):
        own = [each for each in sightings if each.item == item]
        things = [_average(thing.sightings) for thing in _still_there(_things(own, sizes[item]), sizes[item])]
        merged += sorted(things, key=lambda each: -each.quality)
    return tuple(merged)


def centre(sighting: Sighting, size: Vector3) -> Vector3:
    """Return the middle of the thing behind a tag in the map; to within half the difference of its edges."""
    depth = (size[0] + size[1]) / 4.0
    x, y, z = sighting.tag_in_map.position
    dx, dy, dz = rotate(sighting.tag_in_map.orientation, (0.0, 0.0, -depth))
    return (x + dx, y + dy, z + dz)


def may_be_one(one: Sighting, other: Sighting, size: Vector3) -> bool:
    """Say whether two sightings of a number can be of one thing that rests."""
    apart = math.dist(centre(one, size), centre(other, size))
    if one.stamp == other.stamp:
        return not _both_fit(apart, size)
    # ``position_sigma`` is that of the distance: along each axis it is less by the root of 3.
    variance = (one.position_sigma**2 + other.position_sigma**2) / 3.0
    uneven = 0.0 if _same_face(one, other) else abs(size[0] - size[1]) / 2.0
    return apart - uneven <= max(SYSTEMATIC, math.sqrt(CHI_SQUARE * variance))


def _both_fit(apart: float, size: Vector3) -> bool:
    """Say whether two things of a size can stand so near each other (m, between their middles)."""
    return apart >= min(size[:2]) - SYSTEMATIC


def _same_face(one: Sighting, other: Sighting) -> bool:
    return angle_between(one.tag_in_map.orientation, other.tag_in_map.orientation) < SAME_FACE


def things(sightings: Sequence[Sighting], size: Vector3) -> list[list[Sighting]]:
    """Return the sightings of one number in one picture, by the things that they are of."""
    return [thing.sightings for thing in _things(sightings, size)]


def _things(sightings: Sequence[Sighting], size: Vector3) -> list[_Thing]:
    """Put each sighting to the nearest thing that it can be of, by its newest; else begin another."""
    things: list[_Thing] = []
    pictures = list(dict.fromkeys(each.stamp for each in sightings))
    for each in sightings:
        picture = pictures.index(each.stamp)
        middle = centre(each, size)
        near = [thing for thing in things if _fits(each, thing, size)]
        if near:
            nearest = min(near, key=lambda thing: math.dist(centre(thing.sightings[-1], size), middle))
            nearest.sightings.append(each)
            nearest.last = picture
        else:
            things.append(_Thing([each], picture, picture))
    return things


def _fits(sighting: Sighting, thing: _Thing, size: Vector3) -> bool:
    """Say whether it can be of the thing: near its newest sighting, and to those of the same picture."""
    together = [each for each in thing.sightings if each.stamp == sighting.stamp]
    return all(may_be_one(sighting, each, size) for each in (*together, thing.sightings[-1]))


def _still_there(things: list[_Thing], size: Vector3) -> list[_Thing]:
    """Drop what was seen only before another was, or stands where another does: that one was moved."""
    left: list[_Thing] = []
    for thing in sorted(things, key=lambda each: -each.last):
        moved = any(other.first > thing.last for other in things if other is not thing)
        place = centre(thing.sightings[-1], size)
        if not moved and all(
            _both_fit(math.dist(centre(other.sightings[-1], size), place), size) for other in left
        ):
            left.append(thing)
    return left


def _average(sightings: list[Sighting]) -> Sighting:
    """Return the mean of those of the best face.

    Its quality is their mean. Its sigma falls with the root of their number, but not below a half, since
    errors of pictures from one place are not independent; and it grows with what they differ by beyond their
    sigmas (the scale factor S of the Particle Data Group's averages, Review of Particle Physics, 5.2.2).
    """
    best = max(sightings, key=lambda each: each.quality)
    face = [each for each in sightings if _same_face(each, best)]
    if len(face) == 1:
        return best
    weights = [1.0 / max(each.position_sigma, 1e-5) ** 2 for each in face]
    total = sum(weights)
    mean = _mean([each.tag_in_map for each in face], weights)
    off = [math.dist(each.tag_in_map.position, mean.position) for each in face]
    chi_square = sum(w * d * d for w, d in zip(weights, off, strict=True))
    spread = max(1.0, math.sqrt(chi_square / (len(face) - 1)))
    return Sighting(
        item=best.item,
        stamp=face[-1].stamp,
        tag_in_map=mean,
        tag_in_base=_mean([each.tag_in_base for each in face], weights),
        tag_in_camera=_mean([each.tag_in_camera for each in face], weights),
        distance=sum(w * each.distance for w, each in zip(weights, face, strict=True)) / total,
        quality=sum(each.quality for each in face) / len(face),
        position_sigma=spread * max(total**-0.5, 0.5 * min(each.position_sigma for each in face)),
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
