"""What a base does, as atomic actions and macro-actions composed of them (RoCS paper, Table 2).

Atomic are ``SetWheelSpeed`` and ``TurnAngle``; ``TurnTo``, ``GoTo`` and ``AvoidCollision`` are made of these.
Each is a generator that is resumed once a cycle; ``doing`` names what is at work, the outermost first. A goal
of the tree and a reflex use the same ones: what differs is at which priority they have the wheels.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from typing import Final

from tandem.skills.base.wheels import CYCLE, Wheels, stopping_speed
from tandem.skills.base.whereabouts import Whereabouts, base_in_map
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.clocks import Clocks, robot_seconds
from tandem.skills.ports.pose import FloorPose

LATENCY: Final = 0.08
"""Seconds between a command and what odometry tells of it, with a period of a pose sensor's filter."""
AIM: Final = 0.03
"""Radians: a turn ends when as near. A pose sensor's heading is uncertain by as much as a third of it."""
SLOW: Final = 0.08
"""rad/s: a turn ends when as slow."""
OFF: Final = 0.5
"""Radians off the way to a place at which the base stops and turns to it again."""
BRAKES_FOR: Final = 5.0
"""Robot seconds of braking after which a base that still moves is nobody's to stop."""
HELD_FOR: Final = 2.0
"""Robot seconds without turning on after which something holds the base."""
STEER: Final = 1.5
"""rad/s for each radian off the way."""

Steps = Generator[None, None, None]
Advise = Callable[[float, float], tuple[float, float]]
"""Tells, on the way to a place (m), which direction to take in the map (rad) and which share of the speed."""


class Macros:
    """The actions of one base, through one set of wheels.

    Args:
        clocks: robot time.
        monitor: where the base is.
        wheels: under the claim, or the override, of whoever acts.
        speed: tells the m/s at the most, now.
    """

    def __init__(
        self, clocks: Clocks, monitor: Whereabouts, wheels: Wheels, speed: Callable[[], float]
    ) -> None:
        self._clocks, self._monitor, self.wheels = clocks, monitor, wheels
        self._speed = speed
        self.doing: tuple[str, ...] = ()

    @property
    def pose(self) -> FloorPose:
        """base_in_map, as of the newest odometry."""
        return base_in_map(self._monitor)

    @property
    def resting(self) -> bool:
        """Whether the base was told to stand, and does."""
        return self.wheels.resting and not self._monitor.moving

    def set_wheel_speed(self, linear: float, angular: float, until: Callable[[], bool]) -> Steps:
        """Atomic: go on at these speeds (m/s, rad/s), as the drive's limits allow, until something holds."""
        with self.named("SetWheelSpeed"):
            while not until():
                self.wheels.send(linear, angular)
                yield from self._cycle()

    def turn_angle(self, angle: float) -> Steps:
        """Atomic: turn on the spot by so many radians, as odometry tells.

        Something that holds the base ends it early: whoever wants to know looks at the heading.
        """
        with self.named("TurnAngle"):
            remaining, yaw = angle, self.pose.yaw
            nearest, since = math.inf, robot_seconds(self._clocks)
            while abs(remaining) > AIM or abs(self.wheels.angular) > SLOW:
                if abs(remaining) < nearest - AIM:
                    nearest, since = abs(remaining), robot_seconds(self._clocks)
                elif abs(remaining) > AIM and robot_seconds(self._clocks) - since > HELD_FOR:
                    return
                speed = stopping_speed(abs(remaining), self.wheels.drive.turn_acceleration, LATENCY)
                self.wheels.send(0.0, math.copysign(speed, remaining))
                yield from self._cycle()
                now = self.pose.yaw
                remaining, yaw = remaining - wrap(now - yaw), now

    def brake(self) -> Steps:
        """Bring the base to rest; given up after ``BRAKES_FOR``, when something else moves it."""
        until = robot_seconds(self._clocks) + BRAKES_FOR
        with self.named("SetWheelSpeed"):
            while not self.resting and robot_seconds(self._clocks) < until:
                self.wheels.send(0.0, 0.0)
                yield from self._cycle()

    def turn_to(self, heading: float) -> Steps:
        """Turn to a heading in the map (rad), towards a place for instance (the paper's TurnToOrigin)."""
        with self.named("TurnTo"):
            yield from self.turn_angle(wrap(heading - self.pose.yaw))

    def go_to(self, x: float, y: float, near: float, advice: Advise | None = None) -> Steps:
        """Turn to a place in the map and go there, until it is within ``near`` metres (GoToOrigin).

        Args:
            x: of the place (m).
            y: of the place (m).
            near: metres from it at which the way ends.
            advice: tells how to go on for now; None: straight.
        """
        asked = advice or self._straight
        with self.named("GoTo"):
            while self.distance(x, y) > near:
                way, _ = asked(x, y)
                if abs(wrap(way - self.pose.yaw)) > OFF:
                    yield from self.turn_to(way)
                yield from self._approach(x, y, near, asked)
            yield from self.brake()

    def bearing(self, x: float, y: float) -> float:
        """Return in which direction a place in the map lies, in radians to the left of the heading."""
        here = self.pose
        return wrap(math.atan2(y - here.y, x - here.x) - here.yaw)

    def distance(self, x: float, y: float) -> float:
        """Return how far a place in the map is (m)."""
        here = self.pose
        return math.hypot(x - here.x, y - here.y)

    def _straight(self, x: float, y: float) -> tuple[float, float]:
        return self.pose.yaw + self.bearing(x, y), 1.0

    def _approach(self, x: float, y: float, near: float, advice: Advise) -> Steps:
        with self.named("SetWheelSpeed"):
            while (left := self.distance(x, y)) > near:
                way, pace = advice(x, y)
                off = wrap(way - self.pose.yaw)
                if abs(off) > OFF:
                    return
                speed = stopping_speed(left, self.wheels.drive.acceleration, LATENCY)
                self.wheels.send(min(speed, pace * self._speed()), STEER * off)
                yield from self._cycle()

    def _cycle(self) -> Steps:
        until = robot_seconds(self._clocks) + CYCLE - 1e-6
        while True:
            yield
            if robot_seconds(self._clocks) >= until:
                return

    @contextmanager
    def named(self, name: str) -> Iterator[None]:
        """Tell the name of an action while it is at work."""
        self.doing = (*self.doing, name)
        try:
            yield
        finally:
            self.doing = self.doing[:-1]
