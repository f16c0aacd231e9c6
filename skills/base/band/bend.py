"""Speeds for the wheels from an elastic band, while people would make the base slow down on its path.

Nothing here makes the base move that may not: ``Ride`` stops it for people as ever, a watch looks along the
band, and where no band may be driven there are no speeds, and the path is followed as without one.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Final

import numpy as np

from tandem.skills.base.band.elastic import Elastic, Route
from tandem.skills.base.band.limits import Begin, Surroundings, Task
from tandem.skills.base.band.timed import motion
from tandem.skills.base.floor import FloatArray
from tandem.skills.base.path import Path
from tandem.skills.base.path_follower import Follower
from tandem.skills.base.people.caution import Caution
from tandem.skills.base.people.tracker import RADIUS
from tandem.skills.base.way_watch import Watch
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.pose import FloorPose

PERIOD: Final = 0.2
"""Robot seconds between two plans."""
LOOKS: Final = 2.0
"""Metres of way that are planned: what is driven while forecasts are worth something, three seconds."""
LEAST: Final = 0.45
"""Metres of way: what is left of a shorter one is followed, and ends where it should."""
FACES: Final = 1.0
"""Radians off its path up to which a band is of use; a base that looks elsewhere turns first."""
OFF: Final = 0.10
"""Metres off its path from which on the base needs the band to get back to it."""
LOST: Final = 0.6
"""Robot seconds off the path without a band, after which another path is looked for."""
STALE: Final = 0.5
"""Robot seconds for which a band is driven without a new one."""
ROOM: Final = 0.30
"""Metres between the two bodies: who is nearer is waited for, not squeezed past."""
ANSWERS: Final = 0.05
"""Seconds between a command and what the base does about it."""
GAINS: Final = (1.0, 3.0, 1.5)
"""m/s for each m behind; rad/s for each m/s and m aside, and for each radian (Kanayama et al. 1990)."""


class Bend:
    """The band along one path.

    Args:
        caution: who is about.
        radius: the footprint's (m).
        watch: makes something that looks along a way.
        follower: on the path; tells where on it the base is.
    """

    def __init__(
        self, caution: Caution, radius: float, watch: Callable[[], Watch], follower: Follower
    ) -> None:
        self._caution, self._watch, self._follower = caution, watch, follower
        self._apart = radius + RADIUS + ROOM
        self._elastic = Elastic()
        self._route: Route | None = None
        self._way: tuple[Path, Watch] | None = None
        self._asked = -math.inf
        self._off_since: float | None = None
        self.astray = False
        """Whether the base is off its path, and no band leads back."""

    def due(self, now: float, pose: FloorPose, *, slowed: bool) -> bool:
        """Say whether to plan now; without need (not ``slowed``, and on the path) the band is given up.

        Args:
            now: robot seconds.
            pose: base_in_map.
            slowed: whether people make the base slow down on its path.
        """
        off = self._off(pose)
        if self._follower.remaining < LEAST or not (slowed or off > OFF):
            self._route, self._off_since = None, None
            return False
        if self._route is None and off > OFF:
            self._off_since = now if self._off_since is None else self._off_since
            self.astray = now - self._off_since > LOST
        else:
            self._off_since = None
        return now - self._asked >= PERIOD - 1e-6

    def plan(self, now: float, pose: FloorPose, linear: float, angular: float) -> Iterator[None]:
        """Plan from a pose in map and speeds (m/s, rad/s); yields between slices."""
        self._asked, self._route = now, None
        points = self._ahead(pose)
        heading = math.atan2(*(points[min(3, len(points) - 1)] - points[0])[::-1])
        if abs(wrap(heading - pose.yaw)) > FACES:
            return
        task = self._task(Begin(pose, max(linear, 0.0), angular), points)
        route = yield from self._elastic.plan(task, points, now)
        if route is None:
            return
        path = Path(route.band.poses[0, :, :2])
        watch = self._watch()
        if path.length > LEAST / 2 and watch.block(path, 0.0) is not None:
            return
        self._route, self._way = route, (path, watch)

    def speeds(self, now: float, pose: FloorPose) -> tuple[float, float] | None:
        """Return the speeds (m/s, rad/s) to command; None to follow the path as without a band."""
        route = self._route
        if route is None:
            # Off the path the follower's straight way back to it is one that nobody has checked.
            return (0.0, 0.0) if self._off_since is not None else None
        passed = now - route.made
        if passed > STALE or not self._free():
            self._route = None
            return 0.0, 0.0
        linear, angular = _track(route, passed, pose)
        ahead = min(max(linear, 0.0), self._follower.tight(pose))
        return ahead, angular * (ahead / linear if linear > ahead > 0.0 else 1.0)

    def _free(self) -> bool:
        if self._way is None:
            return False
        path, watch = self._way
        return watch.block(path, 0.0) is None

    def _off(self, pose: FloorPose) -> float:
        return math.dist(self._follower.path.at(self._follower.way), (pose.x, pose.y))

    def _ahead(self, pose: FloorPose) -> FloatArray:
        """Return points from the base along the path."""
        path, way = self._follower.path, self._follower.way
        rejoin = way + min(0.15 + 1.5 * self._off(pose), max(path.length - way - 0.1, 0.05))
        _, points = path.sampled(rejoin, min(way + LOOKS, path.length), 0.1)
        start = np.array([[pose.x, pose.y]])
        return np.concatenate((start, (start + points[:1]) / 2, points))

    def _task(self, begin: Begin, points: FloatArray) -> Task:
        follower, caution = self._follower, self._caution
        path, end = follower.path, min(follower.way + LOOKS, follower.path.length)
        x, y = (float(value) for value in points[-1])
        clearances = replace(follower.clearances, start=begin.pose)
        around = Surroundings(clearances, caution.ahead(), caution.age(), self._apart)
        stops = end >= path.length - 1e-6
        return Task(begin, (x, y, path.heading_at(end - 0.01)), stops, follower.drive, around)


def _track(route: Route, passed: float, pose: FloorPose) -> tuple[float, float]:
    """Return the band's speeds, corrected by how far the base is off its pose."""
    band, how = route.band, motion(route.band)
    moments = band.moments[0]
    middles = (moments[1:] + moments[:-1]) / 2
    linear = float(np.interp(passed + ANSWERS, middles, how.linear[0]))
    angular = float(np.interp(passed + ANSWERS, middles, how.angular[0]))
    x, y, yaw = (float(np.interp(passed, moments, band.poses[0, :, axis])) for axis in range(3))
    c, s = math.cos(pose.yaw), math.sin(pose.yaw)
    behind, aside = c * (x - pose.x) + s * (y - pose.y), c * (y - pose.y) - s * (x - pose.x)
    off = wrap(yaw - pose.yaw)
    return (
        linear * math.cos(off) + GAINS[0] * behind,
        angular + GAINS[1] * linear * aside + GAINS[2] * off,
    )
