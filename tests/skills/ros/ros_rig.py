"""A driver in memory, between a bus and a ROS side that a test speaks on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import cast

import numpy as np
from pydantic import JsonValue

from tandem.sim.robots.registry import robot_model
from tandem.skills.ports.hearing import Ear
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ros import types
from tandem.skills.ros.cdr import Codec
from tandem.skills.ros.driver import RosHardware, Times
from tandem.skills.ros.mapping import RosMap, mistakes_of
from tandem.skills.ros.messages import Twist
from tandem.skills.ros.node import RosNode, RosSubscription
from tandem.skills.wire.memory import MemoryBus
from tests.fakes.ros_link import MemoryLink, MemoryNet

ROS = 1_700_000_000.0
"""ROS seconds at robot second 0."""
CMD_VEL: Mapping[str, JsonValue] = {"topic": "/cmd_vel", "type": types.TWIST}
ODOM = {"topic": "/odom", "type": types.ODOMETRY, "to": "odometry"}
SONAR = {"topic": "/sonar", "type": types.RANGE, "to": "range"}
SCAN = {"topic": "/scan", "type": types.LASER_SCAN, "to": "laser", "sensor": "base"}
TF_POSE = {
    "topic": "/tf",
    "type": types.TF,
    "to": "pose",
    "sensor": "markers",
    "parent": "map",
    "child": "base_link",
}


@dataclass
class Host:
    """The host's clocks, as a test sets them."""

    seconds: float = 100.0

    def monotonic(self) -> float:
        return self.seconds

    def utc(self) -> float:
        return ROS + self.seconds - 100.0


@dataclass
class Rig:
    """The robot, and whoever speaks ROS to it."""

    robot: str
    inputs: Sequence[Mapping[str, JsonValue]]
    cmd_vel: Mapping[str, JsonValue] | None = field(default_factory=lambda: CMD_VEL)

    def __post_init__(self) -> None:
        self.host, self.net, self.bus, self.codec = Host(), MemoryNet(), MemoryBus(), Codec("jazzy")
        self.description: RobotDescription = robot_model(self.robot).description
        document = {"robot": self.robot, "inputs": list(self.inputs), "cmd_vel": self.cmd_vel}
        made = RosMap.model_validate(document)
        assert not list(mistakes_of(made, self.description))
        self.driver = RosHardware(
            self.bus,
            MemoryLink(self.net, "a1"),
            made,
            self.description,
            self.codec,
            boot="b",
            times=Times(self.host.monotonic, self.host.utc),
        )
        self.ros = RosNode(MemoryLink(self.net, "b2"), Ear(), 0, "robot", self.codec)
        self.cmd: RosSubscription = self.ros.subscription("/cmd_vel", types.TWIST)

    def tell(self, topic: str, type_name: str, **fields: object) -> None:
        """Publish a message of the robot."""
        publisher = self.ros.publisher(topic, type_name)
        publisher.publish(self.codec.message(type_name, **fields), round(self.host.utc() * 1e9))

    def step(self, seconds: float = 0.01) -> None:
        """Let host time pass, in periods of the robot."""
        for _ in range(max(1, round(seconds / self.description.period))):
            self.host.seconds += self.description.period
            self.driver.step()

    def velocities(self) -> list[tuple[float, float]]:
        """Return what cmd_vel has told since the last call."""
        told = [cast("Twist", each) for each in self.cmd.take()]
        return [(float(each.linear.x), float(each.angular.z)) for each in told]

    def header(self, frame: str = "", *, ago: float = 0.0) -> object:
        """Return a header that was stamped so many seconds ago."""
        seconds, rest = divmod(round((self.host.utc() - ago) * 1e9), 1_000_000_000)
        stamp = self.codec.message("builtin_interfaces/msg/Time", sec=seconds, nanosec=rest)
        return self.codec.message("std_msgs/msg/Header", stamp=stamp, frame_id=frame)

    def pose(self, x: float, y: float, yaw: float) -> object:
        point, turn = self.parts(x, y, yaw, "Point")
        return self.codec.message("geometry_msgs/msg/Pose", position=point, orientation=turn)

    def parts(self, x: float, y: float, yaw: float, kind: str) -> tuple[object, object]:
        """Return a place as ``Point`` or ``Vector3``, and a turn about z."""
        turn = {"x": 0.0, "y": 0.0, "z": float(np.sin(yaw / 2)), "w": float(np.cos(yaw / 2))}
        place = self.codec.message(f"geometry_msgs/msg/{kind}", x=x, y=y, z=0.0)
        return place, self.codec.message("geometry_msgs/msg/Quaternion", **turn)

    def transform(self, parent: str, child: str, at: tuple[float, float, float]) -> object:
        place, turn = self.parts(*at, "Vector3")
        moved = self.codec.message("geometry_msgs/msg/Transform", translation=place, rotation=turn)
        return self.codec.message(
            "geometry_msgs/msg/TransformStamped",
            header=self.header(parent),
            child_frame_id=child,
            transform=moved,
        )

    def odometry(self, x: float, y: float, yaw: float, linear: float) -> dict[str, object]:
        """Return the fields of an Odometry."""
        zero = {"x": 0.0, "y": 0.0, "z": 0.0}
        vector = "geometry_msgs/msg/Vector3"
        twist = self.codec.message(
            types.TWIST,
            linear=self.codec.message(vector, **(zero | {"x": linear})),
            angular=self.codec.message(vector, **zero),
        )
        covered = {"covariance": np.zeros(36)}
        posed = {"pose": self.pose(x, y, yaw), **covered}
        return {
            "header": self.header("odom"),
            "child_frame_id": "base_link",
            "pose": self.codec.message("geometry_msgs/msg/PoseWithCovariance", **posed),
            "twist": self.codec.message("geometry_msgs/msg/TwistWithCovariance", twist=twist, **covered),
        }
