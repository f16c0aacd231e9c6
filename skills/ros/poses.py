"""Where the base is, by whichever topic tells it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Protocol, cast

from tandem.skills.geometry.poses import to_floor, wrap
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ros.readings import floor_pose_of, measured, seconds_of
from tandem.skills.ros.stamps import Stamps

if TYPE_CHECKING:
    from tandem.skills.ports.message import RobotTime
    from tandem.skills.ros.frames import Frames
    from tandem.skills.ros.messages import Header, PoseStamped, RosOdometry, TfMessage, TransformStamped
    from tandem.skills.ros.node import RosSubscription


@dataclass(frozen=True)
class Placed:
    """The base in a frame; with its velocity (m/s ahead, rad/s) where the topic tells it."""

    stamp: RobotTime
    pose: FloorPose
    velocity: tuple[float, float] | None = None


class PoseSource(Protocol):
    """A topic that says where the base is."""

    def take(self, now: RobotTime) -> Sequence[Placed]:
        """Return what has come since the last call, oldest first."""
        ...


@dataclass(eq=False)
class OdometrySource:
    """nav_msgs/Odometry."""

    topic: RosSubscription
    stamps: Stamps = field(default_factory=Stamps)

    def take(self, now: RobotTime) -> Sequence[Placed]:
        """Return what has come."""
        return self.topic.each(lambda message: self._placed(cast("RosOdometry", message), now))

    def _placed(self, told: RosOdometry, now: RobotTime) -> Placed:
        twist = told.twist.twist
        linear, angular = measured("a velocity", twist.linear.x, twist.angular.z)
        pose = floor_pose_of(told.pose.pose)
        return Placed(stamped(self.stamps, told.header, now), pose, (linear, angular))


@dataclass(eq=False)
class StampedSource:
    """geometry_msgs/PoseStamped."""

    topic: RosSubscription
    stamps: Stamps = field(default_factory=Stamps)

    def take(self, now: RobotTime) -> Sequence[Placed]:
        """Return what has come."""
        return self.topic.each(lambda message: self._placed(cast("PoseStamped", message), now))

    def _placed(self, told: PoseStamped, now: RobotTime) -> Placed:
        pose = floor_pose_of(told.pose)
        return Placed(stamped(self.stamps, told.header, now), pose)


@dataclass(eq=False)
class TfSource:
    """tf: a child frame in another one, over as many links as there are.

    It tells when the link of the child itself is renewed: the links above it, such as a map's correction of
    odometry, come when they like.
    """

    topic: RosSubscription
    child: str
    parent: str
    frames: Frames
    stamps: Stamps = field(default_factory=Stamps)

    def take(self, now: RobotTime) -> Sequence[Placed]:
        """Return what has come."""
        found: list[Placed] = []
        for message in self.topic.take():
            for each in cast("TfMessage", message).transforms:
                placed = self.topic.tried(partial(self._placed, each, now))  # one wrong link spoils no other
                if placed is not None:
                    found.append(placed)
        return found

    def _placed(self, told: TransformStamped, now: RobotTime) -> Placed | None:
        placed = self.frames.learn(told)
        pose = self.frames.find(self.child, self.parent) if placed == self.child else None
        return None if pose is None else Placed(stamped(self.stamps, told.header, now), to_floor(pose))


def stamped(stamps: Stamps, header: Header, now: RobotTime) -> RobotTime:
    """Return a header's stamp in robot time."""
    seconds = stamps.robot_seconds(seconds_of(header), now.seconds)
    return now.model_copy(update={"seconds": round(seconds, 6)})


def velocity_between(before: FloorPose, after: FloorPose, passed: float) -> tuple[float, float]:
    """Return m/s ahead and rad/s to the left of a base that took so many seconds from one pose to another."""
    turn = wrap(after.yaw - before.yaw)
    heading = before.yaw + turn / 2.0
    way = (after.x - before.x) * math.cos(heading) + (after.y - before.y) * math.sin(heading)
    return way / passed, turn / passed
