"""Where the base is, by whichever topic tells it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Protocol, cast

from tandem.skills.geometry.poses import to_floor, wrap
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ros.readings import UnfitError, floor_pose_of, seconds_of
from tandem.skills.ros.stamps import Stamps

if TYPE_CHECKING:
    from tandem.skills.ports.message import RobotTime
    from tandem.skills.ros.frames import Frames
    from tandem.skills.ros.messages import Header, PoseStamped, RosOdometry, TfMessage
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
        found: list[Placed] = []
        for message in self.topic.take():
            told = cast("RosOdometry", message)
            twist = told.twist.twist
            velocity = (float(twist.linear.x), float(twist.angular.z))
            try:
                pose = floor_pose_of(told.pose.pose)
            except UnfitError as error:
                self.topic.refuse(str(error))
                continue
            found.append(Placed(stamped(self.stamps, told.header, now), pose, velocity))
        return found


@dataclass(eq=False)
class StampedSource:
    """geometry_msgs/PoseStamped."""

    topic: RosSubscription
    stamps: Stamps = field(default_factory=Stamps)

    def take(self, now: RobotTime) -> Sequence[Placed]:
        """Return what has come."""
        found: list[Placed] = []
        for message in self.topic.take():
            told = cast("PoseStamped", message)
            try:
                pose = floor_pose_of(told.pose)
            except UnfitError as error:
                self.topic.refuse(str(error))
                continue
            found.append(Placed(stamped(self.stamps, told.header, now), pose))
        return found


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
                try:
                    placed = self.frames.learn(each)
                except UnfitError as error:
                    self.topic.refuse(str(error))
                    continue
                pose = self.frames.find(self.child, self.parent) if placed == self.child else None
                if pose is not None:
                    found.append(Placed(stamped(self.stamps, each.header, now), to_floor(pose)))
        return found


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
