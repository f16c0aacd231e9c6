"""Follow a path with a differential drive: regulated pure pursuit (Macenski et al. 2023).

The base steers at a point ahead on the path. It drives as fast as the drive allows and as it can still brake
for: the path's end, its corners, tight places and what stands in the way.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from tandem.skills.base.ending import LATENCY, swerve
from tandem.skills.base.floor import FloatArray
from tandem.skills.base.path import Path
from tandem.skills.base.planner import Clearances
from tandem.skills.base.wheels import stopping_speed
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import Drive

NEAREST_AIM: Final = 0.18
"""Metres ahead of the base: the least distance of the point that is steered at."""
AIM_TIME: Final = 0.45
"""Seconds of way by which the point lies farther ahead at speed."""
LAST: Final = 0.04
"""Metres before the end from which on the heading stays: steering at a point so near is wild."""
LAST_TURN: Final = 0.12
"""Radians off the wished heading up to which it is turned to on these last centimetres."""
LAST_GAIN: Final = 2.5
"""rad/s for each radian of them."""
DRIFT: Final = 0.005
"""Metres that the base may get aside because it turns and rolls at once: a sixth of what a goal may be
missed by, and as much as it is missed by anyway (2 to 6 mm on the planar fake)."""
HALTED: Final = 0.3
"""Share of the speed from which it could just stop: as slow, the base is held up, by people for one. One that
brakes for its end keeps to 0.9 and more."""
EARLIEST: Final = 0.6
"""Metres before the end from which on it is asked whether to turn: more than that takes (0.36 m)."""
SWUNG: Final = 0.03
"""Radians off its aim from which on a base that sets off steers like one on its way."""
TURN_FIRST: Final = 0.5
"""Radians off the path from which on the base turns on the spot."""
CORNER_TURN: Final = 0.4
"""m/s times rad: the speed at a corner is this over its angle."""
SHARP: Final = 1.2
"""Radians: at a sharper corner the base stops and turns."""
TURN_SHARE: Final = 0.85
"""Share of the drive's turning speed that steering may take."""
TIGHT: Final = (0.20, 0.35)
"""Metres of spare clearance below which the base slows down, and the speed (m/s) without any."""
STOP_SHORT: Final = 0.08
"""Metres before what stands in the way."""
CUT: Final = 0.03
"""Metres of spare clearance that cutting a corner may take away."""


@dataclass
class Follower:
    """Steers along one path; ``way`` is how far along it the base is (m)."""

    path: Path
    drive: Drive
    clearances: Clearances
    goal: FloorPose | None = None
    """The pose wished at the end: the turn to its heading begins on the last centimetres (``ending``)."""
    way: float = 0.0
    turns_on: bool = False
    """Whether the turn at the end has begun: a base that stops for it would have to begin anew."""
    _sets_off: bool = True
    _turning: float = 0.0
    """rad/s asked for last."""

    @property
    def remaining(self) -> float:
        """Metres left to drive."""
        return self.path.length - self.way

    @property
    def swing(self) -> float:
        """Radians before a turn's end from which on the base may roll."""
        return self.drive.turn_acceleration * self._overlap**2 / 2

    @property
    def _overlap(self) -> float:
        """Seconds for which the base rolls and turns at once, at the beginning and at the end.

        With the acceleration a from rest, and b of the turn down to rest, it gets aside by the integral of
        a t b (T - t)^2 / 2, which is a b T^4 / 24; braking and turning up, the same the other way round.
        """
        return math.sqrt(math.sqrt(24.0 * DRIFT / (self.drive.acceleration * self.drive.turn_acceleration)))

    def speeds(self, pose: FloorPose, speed: float, blocked_at: float | None) -> tuple[float, float]:
        """Return the speeds to command (m/s, rad/s).

        Args:
            pose: base_in_map.
            speed: m/s now.
            blocked_at: metres along the path at which something stands in the way.
        """
        linear, self._turning = self._speeds(pose, speed, blocked_at)
        return linear, self._turning

    def _speeds(self, pose: FloorPose, speed: float, blocked_at: float | None) -> tuple[float, float]:
        self.way = self.path.project(pose.x, pose.y, self.way)
        if self.goal is not None and self._turns_early(pose, speed):
            off = wrap(self.goal.yaw - pose.yaw)
            return min(self._allowed(pose, blocked_at), self.drive.forward), self._turn(off)
        if self.remaining < LAST:
            return min(self._allowed(pose, blocked_at), self.drive.forward), self._last_turn(pose)
        x, y = self._aim(pose, speed)
        off = wrap(math.atan2(y - pose.y, x - pose.x) - pose.yaw)
        if abs(off) > TURN_FIRST:
            return 0.0, self._turn(off)
        curvature = 2.0 * math.sin(off) / max(math.hypot(x - pose.x, y - pose.y), NEAREST_AIM / 2)
        allowed = self._allowed(pose, blocked_at)
        if abs(curvature) > 1e-6:  # noqa: PLR2004 - straight ahead
            allowed = min(allowed, TURN_SHARE * self.drive.turn / abs(curvature))
        ahead = max(min(allowed, self.drive.forward), 0.0)
        angular = curvature * max(min(ahead, speed + 0.05), 0.0)
        self._sets_off = (
            self._sets_off and abs(off) > SWUNG and speed < self.drive.acceleration * self._overlap
        )
        if self._sets_off and abs(self._turn(off)) > abs(angular):
            angular = self._turn(off)  # so slow, steering alone would take long to face the way
        return ahead, angular

    def off(self, pose: FloorPose) -> float:
        """Return the angle (rad) by which the base has to turn before it can set off."""
        x, y = self.path.at(min(self.way + NEAREST_AIM, self.path.length))
        if math.hypot(x - pose.x, y - pose.y) < 0.01:  # noqa: PLR2004 - as good as there
            return 0.0
        return wrap(math.atan2(y - pose.y, x - pose.x) - pose.yaw)

    def _turn(self, off: float) -> float:
        """Return the speed (rad/s) of a turn by ``off`` that ends at rest."""
        return math.copysign(stopping_speed(abs(off), self.drive.turn_acceleration, LATENCY), off)

    def _turns_early(self, pose: FloorPose, speed: float) -> bool:
        """Say whether the turn at the end goes on already, while the base brakes on its last centimetres."""
        goal, braking = self.goal, stopping_speed(self.remaining, self.drive.acceleration, LATENCY)
        if goal is None or speed < HALTED * braking:
            self.turns_on = False  # held up: the turn would be over before the way is
        elif not self.turns_on:
            self.turns_on = self._carries_over(goal, pose, speed)
        return self.turns_on

    def _carries_over(self, goal: FloorPose, pose: FloorPose, speed: float) -> bool:
        """Say whether the turn to the goal's heading, begun now, ends in the goal or a hair before it."""
        angle = wrap(goal.yaw - pose.yaw)
        if abs(angle) < LAST_TURN or self.remaining > EARLIEST or self._bends_ahead:
            return False
        heading, side = self.path.heading_at(self.path.length), math.copysign(1.0, angle)
        over = side * (math.cos(heading) * (goal.y - pose.y) - math.sin(heading) * (goal.x - pose.x))
        off = side * wrap(pose.yaw - heading)
        return swerve(self.remaining, speed, angle, self.drive, off=off, rate=side * self._turning) < max(
            over, DRIFT
        )

    @property
    def _bends_ahead(self) -> bool:
        return any(at > self.way for at, _ in self.path.corners)

    def _last_turn(self, pose: FloorPose) -> float:
        off = 0.0 if self.goal is None else wrap(self.goal.yaw - pose.yaw)
        return LAST_GAIN * off if abs(off) < LAST_TURN else 0.0

    def _aim(self, pose: FloorPose, speed: float) -> tuple[float, float]:
        """Return the point ahead that is steered at; nearer where the straight line to it would cut in."""
        distance = NEAREST_AIM + AIM_TIME * max(speed, 0.0)
        here = (pose.x, pose.y)
        while True:
            point = self.path.at(min(self.way + distance, self.path.length))
            if distance <= NEAREST_AIM or self._clear(here, point, self.way + distance):
                return point
            distance = max(NEAREST_AIM, 0.7 * distance)

    def _clear(self, a: tuple[float, float], b: tuple[float, float], until: float) -> bool:
        if not any(self.way < at < until for at, _ in self.path.corners):
            return True
        spare = self.clearances.spare_between(a, b)
        along = self.clearances.spare(self.path.sampled(self.way, until, 0.05)[1])
        return spare >= min(along, CUT) - 0.01

    def _allowed(self, pose: FloorPose, blocked_at: float | None) -> float:
        """Return the speed (m/s) from which the base can still do what lies ahead."""
        brake = self.drive.acceleration
        allowed = stopping_speed(self.remaining, brake, LATENCY)
        if blocked_at is not None:
            allowed = min(allowed, stopping_speed(blocked_at - self.way - STOP_SHORT, brake, LATENCY))
        for at, angle in self.path.corners:
            if at <= self.way or angle < 0.1:  # noqa: PLR2004 - as good as straight
                continue
            there = corner_speed(angle)
            slow = stopping_speed(max(at - self.way, 0.0) + there * there / (2 * brake), brake, LATENCY)
            allowed = min(allowed, max(slow, 0.05))
        return min(allowed, self.tight(pose))

    def tight(self, pose: FloorPose) -> float:
        """Return the speed (m/s) for how near things are."""
        spare = self.clearances.field.at(np.array([[pose.x, pose.y]])) - self.clearances.needed
        return float(tight_speeds(spare, self.drive)[0])


def corner_speed(angle: float) -> float:
    """Return the speed (m/s) at a corner of so many radians, more than none; 0 where the base stops."""
    return 0.0 if angle > SHARP else CORNER_TURN / angle


def tight_speeds(spare: FloatArray, drive: Drive) -> FloatArray:
    """Return the speeds (m/s) for spare clearances (m), each of shape (n,)."""
    share = np.clip(spare / TIGHT[0], 0.0, 1.0)
    return np.asarray(np.where(share < 1.0, TIGHT[1] + share * (drive.forward - TIGHT[1]), drive.forward))
