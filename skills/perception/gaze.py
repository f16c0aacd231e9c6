"""Where the head should look so that what is tracked stays in view, or is found again.

One measure for all: a view is worth a point for each item whose tag it shows, and two for showing every
place where an item that is lost may be. The head turns only when another view is worth clearly more than the
one it has; so it follows items that come near the picture's edge, and looks about for one that is gone. Items
that no picture shows together are looked at by turns: what is out of view for long is worth more. Where
something has just been looked for in vain, it need not be looked for again for a while. The camera sees
through nothing: an item that an arm hides is left where it was last seen, and looked for elsewhere only when
it has been hidden for long. No bus, no clock.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Final, TypeAlias

import numpy as np
import numpy.typing as npt

from tandem.skills.perception.rigid import Matrix, points_from, points_in, rotation_of
from tandem.skills.ports.message import Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.sensors import CameraSensor
from tandem.skills.ports.world import Box

GAIN: Final = 0.5
"""By how much more another view must be worth for the head to turn ..."""
LITTLE: Final = 0.1
"""... from one that is worth nothing: there is nothing to lose. From there on it rises with that worth."""
LONGING: Final = 0.5
"""Worth a second by which an item that is out of view is missed more."""
LOST: Final = 2.0
"""What it is worth to see all the places where a lost item may be."""
HIDDEN: Final = 1.5
"""Robot seconds for which an item may be hidden before it is looked for elsewhere, the more so the longer."""
AGAIN: Final = 4.0
"""Robot seconds after which a place where nothing was found is as good as new."""
EDGE: Final = 0.02
"""Share of the picture's half width and height in which nothing counts as seen: what is there soon is not."""
BORDER: Final = 1.25
"""The tag with its white border, as a multiple of the tag: it is not found without."""
AWAY: Final = 0.4
"""Metres from where it was last seen within which an item is looked for."""
LIKELY: Final = 0.15
"""Metres: how likely places are falls with their distance as a normal distribution of this deviation."""
APART: Final = 0.07
"""Metres between the places that are tried."""
LEAST: Final = 0.1
"""Likelihood, relative to the likeliest place's, from which on a place alone is worth a look."""
CENTRED: Final = 0.05
"""What it is worth that a tag is in the middle of the picture, not at its edge: decides between equals."""
NEAR: Final = 0.02
"""What a radian of the head's way costs: decides between equals, too."""
CLOSEST: Final = 0.3
"""Metres: nearer than this, the camera sees nothing."""

Mask = npt.NDArray[np.bool_]
Joints: TypeAlias = tuple[float, ...]
View: TypeAlias = tuple[Joints, Pose]
"""Head positions (rad), and where the camera then is in the map."""
_Cameras: TypeAlias = tuple[Matrix, Matrix]


@dataclass(eq=False)
class _Followed:
    """What is known of one item's whereabouts."""

    tag_in_map: Pose
    edge: float
    """Of the tag with its border (m)."""
    seen: float
    """Robot seconds: when its tag was last read."""
    in_view: float
    """When the place where it is believed was last in view."""
    gone: bool = False
    """Whether it was seen that it is not there."""
    places: Matrix = field(default_factory=lambda: np.zeros((0, 3)))
    """Where it may be (n, 3), in the map."""
    likely: Matrix = field(default_factory=lambda: np.zeros(0))
    looked: Matrix = field(default_factory=lambda: np.zeros(0))
    """When each place was last looked at."""

    def corners(self) -> Matrix:
        half = self.edge / 2.0
        square = np.array([(x, y, 0.0) for x in (-half, half) for y in (-half, half)])
        return points_in(self.tag_in_map, square)


class Gaze:
    """Remembers where the followed items are, and what views are worth.

    Args:
        camera: the head's.
        surfaces: furniture, on whose tops an item may be.
    """

    def __init__(self, camera: CameraSensor, surfaces: Sequence[Box]) -> None:
        across = math.tan(camera.horizontal_fov / 2.0)
        self._half = np.array([across, across * camera.height / camera.width])
        self._surfaces = tuple(surfaces)
        self._items: dict[int, _Followed] = {}

    def keep(self, items: Iterable[int]) -> None:
        """Forget all other items: they are in a hand."""
        kept = set(items)
        self._items = {item: each for item, each in self._items.items() if item in kept}

    def see(self, item: int, tag_in_map: Pose, edge: float, now: float) -> None:
        """Take in that an item was seen, or is believed there though it has not been seen here yet.

        ``edge``: of the square in its face's middle that has to be seen (m).
        """
        self._items[item] = _Followed(tag_in_map, BORDER * edge, now, now)

    def knows(self, item: int) -> bool:
        """Say whether it has been told where the item is."""
        return item in self._items

    def look(self, camera_in_map: Pose, gone: Iterable[int], now: float) -> None:
        """Take in what a picture from there showed, after what was seen in it; robot seconds."""
        missing, camera = set(gone), _stacked((camera_in_map,))
        for item, each in self._items.items():
            each.gone = each.gone or item in missing
            if self._shows(camera, each.corners()).all():
                each.in_view = now
            if each.seen < now and not len(each.places):
                self._spread(each)
            each.looked[self._shows(camera, each.places, each.edge)[0]] = now

    def lacks(self, camera_in_map: Pose, now: float) -> bool:
        """Say whether some view may be worth clearly more than that from there."""
        most = sum(_wanted(each, now) + _sought(each, now) for each in self._items.values())
        here = float(self._worth(_stacked((camera_in_map,)), now)[0])
        return most > here + _clearly(here)

    def clearly(self, camera_in_map: Pose, now: float) -> float:
        """Return by how much more than the view from there another one must be worth."""
        return _clearly(float(self._worth(_stacked((camera_in_map,)), now)[0]))

    def best(self, views: Sequence[View], here: View, now: float) -> tuple[float, Joints]:
        """Return the head positions of the best of some views, and by how much more it is worth than ours."""
        cameras = _stacked([camera for _, camera in views])
        ways = np.array([math.dist(head, here[0]) for head, _ in views])
        worth = self._worth(cameras, now) + self._centred(cameras, now) - NEAR * ways
        number = int(worth.argmax())
        gain = worth[number] - self._worth(_stacked((here[1],)), now)[0]
        return float(gain), views[number][0]

    def _worth(self, cameras: _Cameras, now: float) -> Matrix:
        total = np.zeros(len(cameras[0]))
        for each in self._items.values():
            wanted, sought = _wanted(each, now), _sought(each, now)
            if wanted:
                total += wanted * self._shows(cameras, each.corners()).all(axis=1)
            if sought:
                left = _unsearched(each, now)
                total += sought * (self._shows(cameras, each.places, each.edge) @ left) / left.sum()
        return total

    def _centred(self, cameras: _Cameras, now: float) -> Matrix:
        total = np.zeros(len(cameras[0]))
        for each in self._items.values():
            if _wanted(each, now):
                off, _ = self._in_picture(cameras, each.corners())
                total += CENTRED * np.maximum(0.0, 1.0 - np.abs(off).max(axis=(1, 2)))
        return total

    def _spread(self, each: _Followed) -> None:
        """Lay out the places where the item may be, about where it was last seen."""
        steps = np.arange(-AWAY, AWAY + APART / 2.0, APART)
        x, y = (each_way.ravel() for each_way in np.meshgrid(steps, steps))
        near = np.hypot(x, y) <= AWAY
        places = np.array(each.tag_in_map.position) + np.stack((x, y, np.zeros_like(x)), axis=1)[near]
        likely = np.exp(-(x[near] ** 2 + y[near] ** 2) / (2.0 * LIKELY**2))
        on = self._on_surface(places, each.tag_in_map.position)
        each.places, each.likely = places[on], likely[on]
        each.looked = np.full(len(each.places), -math.inf)

    def _on_surface(self, places: Matrix, last: Vector3) -> Mask:
        """Say which places are over what the item stood on; all of them when it stood on nothing known."""
        for box in self._surfaces:
            length, width, height = box.size
            low = points_from(box.pose, np.array([last]))[0]
            over = low[2] - height / 2.0
            if abs(low[0]) > length / 2.0 or abs(low[1]) > width / 2.0 or not 0.0 < over < AWAY:
                continue
            own = points_from(box.pose, places)
            return np.asarray((np.abs(own[:, 0]) <= length / 2.0) & (np.abs(own[:, 1]) <= width / 2.0))
        return np.ones(len(places), dtype=bool)

    def _shows(self, cameras: _Cameras, points: Matrix, size: float = 0.0) -> Mask:
        """Say for each camera which points (n, 3), or things of a size (m) there, are well in its picture."""
        off, depth = self._in_picture(cameras, points)
        room = size / 2.0 / np.maximum(depth, CLOSEST)[..., None] / self._half
        inside = np.all(np.abs(off) + room <= 1.0 - EDGE, axis=2)
        return np.asarray(inside & (depth > CLOSEST))

    def _in_picture(self, cameras: _Cameras, points: Matrix) -> tuple[Matrix, Matrix]:
        """Return where points (n, 3) are in each picture, from -1 to 1 both ways, and their depth (m)."""
        rotations, positions = cameras
        own = (points[None, :, :] - positions[:, None, :]) @ rotations
        depth = own[:, :, 2]
        return np.asarray(own[:, :, :2] / np.maximum(depth, CLOSEST)[..., None] / self._half), depth


def _stacked(cameras: Sequence[Pose]) -> _Cameras:
    """Return the rotations (v, 3, 3) and positions (v, 3) of cameras in the map."""
    rotations = np.array([rotation_of(each) for each in cameras])
    return rotations, np.array([each.position for each in cameras])


def _clearly(worth: float) -> float:
    return min(GAIN, LITTLE + worth)


def _wanted(each: _Followed, now: float) -> float:
    """Return what it is worth to see the place where the item is believed."""
    return 0.0 if each.gone else 1.0 + LONGING * (now - each.in_view)


def _sought(each: _Followed, now: float) -> float:
    """Return what it is worth to look for the item elsewhere: nothing where all has just been looked at."""
    freshest = float(np.max(_freshness(each, now)[each.likely >= LEAST], initial=0.0))
    if each.gone:
        return LOST * freshest
    # Out of view it is no wonder that it is not seen.
    return min(LOST, LONGING * max(0.0, each.in_view - each.seen - HIDDEN)) * freshest


def _unsearched(each: _Followed, now: float) -> Matrix:
    """Return how likely the item is at each place that was not looked at just now."""
    return np.asarray(each.likely * _freshness(each, now), np.float64)


def _freshness(each: _Followed, now: float) -> Matrix:
    return np.clip((now - each.looked) / AGAIN, 0.0, 1.0)
