"""Where the robot is: odometry predicts, each scan corrects. Owner of ``world/robot``.

What is estimated is the drift, odom in map; base_in_map is odometry seen through it. While the base is at
rest the estimate settles over a few scans and then stays as it is, so that what was seen a moment ago and
what is done about it now share one frame.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.floor import BoolArray, FloatArray, compose, invert, points_in
from tandem.skills.base.map import SiteMap
from tandem.skills.base.matcher import Match, carried, diagonal, match, share_behind, share_near
from tandem.skills.base.odometry import OdometryBuffer, ahead
from tandem.skills.base.odometry_drift import OdometryDrift
from tandem.skills.base.scan import ScanGeometry, ScanPoints
from tandem.skills.geometry.poses import floor_distance, wrap
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.hardware import Odometry
from tandem.skills.ports.keys import ODOMETRY, Latest, laser
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.sensors import LaserScan
from tandem.skills.ports.world import ROBOT_POSE, RobotPose

PERIOD: Final = 0.05
"""Seconds between two messages."""
SILENCE: Final = 0.5
"""Robot seconds without a scan after which the laser is said to be silent."""
POOR_FIT: Final = 0.45
"""Share of beams explained below which a scan does not confirm the pose."""
HOPELESS_FIT: Final = 0.25
"""Share below which it does not even correct it."""
LOST_AFTER: Final = 30
"""Hopeless scans in a row after which the robot does not know where it is."""
LOST_ON_THE_WAY: Final = 8
"""The same while the base moves."""
LEAP: Final = (0.08, 0.15)
"""Metres and radians by which odometry may go on more than twice the drive's limits: beyond, it jumped."""
LOST_WAY: Final = 2.0
"""Metres and radians on poor scans after which it doesn't either; before, something may just hide the map."""
SETTLED_AFTER: Final = 8
"""Scans at rest after which the estimate stays as it is."""
STILL: Final = (0.0015, 0.002)
"""Metres and radians of odometry between two scans that are no motion."""
TINY: Final = 1e-6
"""Marks a poor scan at rest as unconfirmed."""
THROUGH_WALLS: Final = 0.06
"""Share of beams that end behind what is mapped, from which on something has pushed the base: people hide
walls, but make no hole in them."""
PUSHED: Final = (0.15, 0.15)
"""Metres and radians, one sigma, by which a base may have been pushed that odometry has not noticed."""
LATE: Final = 0.06
"""Seconds for which a scan waits for the odometry of its moment before odometry is carried on to it."""
UNMAPPED: Final = 0.10
"""Metres from everything mapped at which a hit is something else; grows with the range."""
UNMAPPED_GROWTH: Final = 0.02
"""Metres a metre: a heading that is off by 1.1 degrees moves a hit by as much."""


@dataclass(frozen=True)
class PlacedScan:
    """A scan and the pose at which it was matched: what else looks at scans takes it from here."""

    number: int
    points: ScanPoints
    base_in_map: FloorPose
    points_in_map: FloatArray
    residual: FloatArray
    """Signed distance of each point to what is mapped (m)."""
    fit: float

    def unmapped(self, bounds: tuple[float, float, float, float], farthest: float) -> BoolArray:
        """Return which points no map explains, shape (n,): in ``bounds`` and nearer than ``farthest`` (m).

        ``bounds`` is x_min, y_min, x_max and y_max in map (m).
        """
        ranges = self.points.ranges
        x_min, y_min, x_max, y_max = bounds
        x, y = self.points_in_map.T
        strange = (self.residual > UNMAPPED + UNMAPPED_GROWTH * ranges) & (ranges < farthest)
        inside: BoolArray = (x > x_min) & (x < x_max) & (y > y_min) & (y < y_max)
        return strange & inside


class Localiser(OdometryDrift):
    """The monitor of the robot's pose; a ``Node``.

    Args:
        bus: where odometry and scans come from and the pose goes to.
        clocks: robot time.
        description: the laser.
        site_map: what the laser should see.
    """

    def __init__(self, bus: Bus, clocks: Clocks, description: RobotDescription, site_map: SiteMap) -> None:
        super().__init__()
        self._bus, self._clocks, self._map = bus, clocks, site_map
        self._geometry = ScanGeometry(description.laser, site_map.laser_in_base)
        self._odometry_in = Latest(bus, ODOMETRY)
        self._scans_in = Latest(bus, laser(description.laser.name), depth=4)
        self._drive = description.driven
        self._waiting: LaserScan | None = None
        self._recent: deque[ScanPoints] = deque(maxlen=10)
        self._covariance = diagonal(10.0, math.pi)
        self._matched_at: FloorPose | None = None
        self._scans_at_rest = 0
        self._hopeless = 0
        self._unconfirmed = 0.0
        self._number = 0
        self._published_at = -math.inf
        self._told: tuple[RobotTime | None, bool, str] | None = None
        self.localised = False
        self.reason = "not initialised: localise first"
        self.placed: PlacedScan | None = None

    @property
    def name(self) -> str:
        """The node's name."""
        return "base/localiser"

    @property
    def recent(self) -> tuple[ScanPoints, ...]:
        """The last scans, oldest first, for the global search."""
        return tuple(self._recent)

    def silence(self, now: RobotTime, where: str) -> Failure | None:
        """Return LASER_SILENT when no scan has come for too long, or None."""
        silent = now.since(self._recent[-1].stamp) if self._recent else None
        if silent is None:
            return Failure(kind=FailureKind.LASER_SILENT, message="no scan has been heard", where=where)
        if silent <= SILENCE:
            return None
        return Failure(
            kind=FailureKind.LASER_SILENT,
            message=f"no scan for {silent:.1f} s",
            where=where,
            evidence={"silent_s": silent},
        )

    def initialise(self, base_in_map: FloorPose, at: RobotTime, sigma: tuple[float, float]) -> bool:
        """Start from a pose that held at a moment, known to ``sigma`` (m, rad).

        Returns False when there is no odometry of that time.
        """
        base_in_odom = self._buffer.at(at)
        if base_in_odom is None and self._buffer.last is not None and not self.moving:
            base_in_odom = self._buffer.last.base_in_odom
        if base_in_odom is None:
            return False
        self._odom_in_map = compose(base_in_map, invert(base_in_odom))
        self._covariance = diagonal(*sigma)
        self._matched_at = base_in_odom
        self._scans_at_rest = self._hopeless = 0
        self._unconfirmed = 0.0
        self.localised, self.reason = True, ""
        self._publish(robot_seconds(self._clocks))
        return True

    def step(self) -> bool:
        """Take odometry and at most one scan; publish when it is time."""
        for odometry in self._odometry_in.take():
            self._forget_another_boot(odometry)
            self._notice_a_leap(odometry)
            self._buffer.add(odometry)
        scans = self._scans_in.take()
        if scans:
            self._waiting = scans[-1]
        if self._waiting is not None:
            self._try_scan(self._waiting)
        now = robot_seconds(self._clocks)
        last = self._buffer.last
        told = (None if last is None else last.stamp, self.localised, self.reason)
        if told != self._told and now - self._published_at >= PERIOD - 1e-6:
            self._told = told
            self._publish(now)
        return False

    def close(self) -> None:
        """End the subscriptions."""
        self._odometry_in.close()
        self._scans_in.close()

    def _forget_another_boot(self, odometry: Odometry) -> None:
        last = self._buffer.last
        if last is not None and odometry.stamp.since(last.stamp) is None:
            self.localised, self.reason = False, "the hardware started anew: localise first"
            self._recent.clear()
            self._matched_at = self._waiting = self.placed = None

    def _notice_a_leap(self, odometry: Odometry) -> None:
        """Where odometry goes on as no drive can, nobody knows where the base is."""
        last = self._buffer.last
        seconds = None if last is None else odometry.stamp.since(last.stamp)
        if last is None or seconds is None or seconds <= 0.0:
            return
        metres = floor_distance(last.base_in_odom, odometry.base_in_odom)
        radians = abs(wrap(odometry.base_in_odom.yaw - last.base_in_odom.yaw))
        if (
            metres > 2.0 * self._drive.forward * seconds + LEAP[0]
            or radians > 2.0 * self._drive.turn * seconds + LEAP[1]
        ):
            self._matched_at, self._waiting = None, None
            self._buffer = OdometryBuffer()  # nothing of before says anything about now
            if self.localised:
                self.localised = False
                self.reason = f"odometry jumped by {metres:.2f} m and {radians:.2f} rad"

    def _try_scan(self, scan: LaserScan) -> None:
        base_in_odom = self._buffer.at(scan.stamp)
        if base_in_odom is None:
            last, now = self._buffer.last, self._clocks.robot()
            age = None if now is None else now.since(scan.stamp)
            onward = None if last is None else scan.stamp.since(last.stamp)
            if last is None or onward is None or age is None or age < LATE:
                return
            base_in_odom = ahead(last, onward)
        self._waiting = None
        points = self._geometry.points(scan)
        if points is None:
            return
        self._recent.append(points)
        if self.localised:
            self._correct(points, base_in_odom)

    def _correct(self, points: ScanPoints, base_in_odom: FloorPose) -> None:
        predicted = compose(self._odom_in_map, base_in_odom)
        still = self._is_still(base_in_odom)
        before = compose(self._odom_in_map, self._matched_at or base_in_odom)
        if not still:
            self._covariance = carried(self._covariance, before, predicted)
            self._scans_at_rest = 0
        self._matched_at = base_in_odom
        residual = self._map.laser.at(points_in(predicted, points.in_base))
        if share_behind(residual) > THROUGH_WALLS:
            pushed = np.diag(diagonal(*PUSHED))
            self._covariance = np.diag(np.maximum(np.diag(self._covariance), pushed))
            self._scans_at_rest = 0
        if still and self._scans_at_rest >= SETTLED_AFTER and self._unconfirmed == 0.0:
            if share_near(residual) < POOR_FIT:
                self._scans_at_rest = 0
            self._place(points, predicted, residual)
            return
        found = match(self._map.laser, points.in_base, predicted, self._covariance)
        self._judge(found, before, predicted)
        used = found.fit >= HOPELESS_FIT
        if used:
            self._scans_at_rest += still
            self._odom_in_map = compose(found.pose, invert(base_in_odom))
            self._covariance = found.covariance
        self._place(points, found.pose if used else predicted, found.residual)

    def _is_still(self, base_in_odom: FloorPose) -> bool:
        before = self._matched_at
        if before is None or self.moving:
            return False
        moved = math.hypot(base_in_odom.x - before.x, base_in_odom.y - before.y)
        return moved < STILL[0] and abs(wrap(base_in_odom.yaw - before.yaw)) < STILL[1]

    def _judge(self, found: Match, before: FloorPose, predicted: FloorPose) -> None:
        """Count how long, and how far, the scans have not confirmed the pose."""
        if found.fit >= POOR_FIT:
            self._hopeless, self._unconfirmed = 0, 0.0
            return
        self._hopeless = self._hopeless + 1 if found.fit < HOPELESS_FIT else 0
        self._unconfirmed += floor_distance(before, predicted) + abs(wrap(predicted.yaw - before.yaw)) + TINY
        moving = self.moving and self._hopeless >= LOST_ON_THE_WAY
        if moving or self._hopeless >= LOST_AFTER or self._unconfirmed > LOST_WAY:
            self.localised = False
            self.reason = (
                f"the scans do not fit the map (the last by {found.fit:.2f}), "
                f"since {self._hopeless} scans or {self._unconfirmed:.1f} m"
            )

    def _place(self, points: ScanPoints, pose: FloorPose, residual: FloatArray) -> None:
        self._number += 1
        self.taken_in = points.stamp
        placed = points_in(pose, points.in_base)
        self.placed = PlacedScan(self._number, points, pose, placed, residual, share_near(residual))

    def _publish(self, now: float) -> None:
        last, stamp = self._buffer.last, self._clocks.robot()
        if last is None or stamp is None:
            return
        self._published_at = now
        spread = self._covariance
        ROBOT_POSE.publish(
            self._bus,
            RobotPose(
                stamp=last.stamp,
                localised=self.localised,
                base_in_map=compose(self._odom_in_map, last.base_in_odom),
                odom_in_map=self._odom_in_map,
                position_sigma=math.sqrt(max(spread[0, 0] + spread[1, 1], 0.0)),
                yaw_sigma=math.sqrt(max(spread[2, 2], 0.0)),
                moving=self.moving,
                reason=self.reason,
            ),
        )
