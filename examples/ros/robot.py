"""A simulated robot that speaks ROS 2, for trying `tandem ros` without ROS (docs/ros.md).

It hears the simulated hardware on its keys and tells it as ROS topics, and drives it as ``/cmd_vel`` says:

    python examples/ros/robot.py tcp/127.0.0.1:7447 lab/sim

Topics: ``/odom``, ``/tf`` (odom to base_link), ``/mocap/pose``, ``/joint_states``, ``/scan/<laser>``,
``/sonar``, ``/bumper/<name>``.
"""
# ruff: noqa: INP001 - an example: a file of its own

from __future__ import annotations

import signal
import sys
import time
from collections.abc import Callable, Iterable
from typing import Final, cast

import numpy as np

from tandem.skills.geometry.poses import to_pose
from tandem.skills.ports import keys
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import BaseVelocity
from tandem.skills.ports.pose import FloorPose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ros import types
from tandem.skills.ros.cdr import Codec
from tandem.skills.ros.link import Link
from tandem.skills.ros.messages import Twist
from tandem.skills.ros.node import RosNode, RosPublisher
from tandem.skills.wire.foreign_session import ForeignSession
from tandem.skills.wire.zenoh_bus import ZenohBus, wait_until

VECTOR: Final = "geometry_msgs/msg/Vector3"
POINT: Final = "geometry_msgs/msg/Point"
QUATERNION: Final = "geometry_msgs/msg/Quaternion"
SWITCH_INTERVAL: Final = 0.0005
"""Seconds after which the loop lets zenoh's callbacks go on."""
WAIT: Final = 0.02
"""Seconds between two looks when nothing comes."""


class RosFace:
    """A node that is a robot's face in ROS.

    Args:
        bus: the simulated hardware's keys.
        link: ROS's side.
        robot: the description.
        utc: UTC seconds.
        domain: ``ROS_DOMAIN_ID``.
    """

    def __init__(
        self, bus: Bus, link: Link, robot: RobotDescription, utc: Callable[[], float], domain: int = 0
    ) -> None:
        self._bus, self._robot, self._utc = bus, robot, utc
        self._codec = Codec("jazzy")
        self._node = RosNode(link, bus.ear, domain, "robot", self._codec)
        self._cmd = self._node.subscription("/cmd_vel", types.TWIST)
        self._odometry = (keys.Latest(bus, keys.ODOMETRY), self._out("/odom", types.ODOMETRY))
        self._tf = self._out("/tf", types.TF)
        self._pose = (keys.Latest(bus, keys.POSE_READING), self._out("/mocap/pose", types.POSE_STAMPED))
        self._ranges = (keys.Latest(bus, keys.RANGES), self._out("/sonar", types.RANGE))
        self._joints = (keys.Latest(bus, keys.JOINT_STATES), self._out("/joint_states", types.JOINT_STATE))
        self._bumpers = keys.Latest(bus, keys.BUMPERS)
        self._bumper = {each.name: self._out(f"/bumper/{each.name}", types.BOOL) for each in robot.bumpers}
        self._lasers = [
            (keys.Latest(bus, keys.laser(each.name)), each, self._out(f"/scan/{each.name}", types.LASER_SCAN))
            for each in robot.lasers
        ]

    def step(self) -> bool:
        """Pass on what has come, both ways."""
        for velocity in self._cmd.each(_velocity_of):
            keys.BASE_VELOCITY.publish(self._bus, velocity)
        self._tell_poses()
        self._tell_sensors()
        return False

    def _tell_poses(self) -> None:
        heard, out = self._odometry
        for told in heard.take():
            pose = self._with("PoseWithCovariance", pose=self._posed(told.base_in_odom))
            twist = self._with("TwistWithCovariance", twist=self._twist(told.linear, told.angular))
            self._send(out, header=self._header("odom"), child_frame_id="base_link", pose=pose, twist=twist)
            self._send(self._tf, transforms=[self._transform(told.base_in_odom)])
        reading, posed = self._pose
        for each in reading.take():
            self._send(posed, header=self._header("map"), pose=self._posed(each.base_in_map))

    def _tell_sensors(self) -> None:
        heard, out = self._ranges
        cones = {each.name: each for each in self._robot.range_sensors}
        for ranges in heard.take():
            for each in ranges.readings:
                sensor = cones[each.sensor]
                self._send(
                    out,
                    header=self._header(sensor.frame),
                    radiation_type=0,
                    field_of_view=sensor.cone,
                    min_range=sensor.range_min,
                    max_range=sensor.range_max,
                    range=each.distance,
                    variance=0.0,
                )
        for bumpers in self._bumpers.take():
            for name, bumper in self._bumper.items():
                self._send(bumper, data=name in bumpers.pressed)
        joints, state = self._joints
        for told in joints.take() if self._robot.joints else ():
            self._send(
                state,
                header=self._header(""),
                name=list(told.names),
                position=np.array(told.positions),
                velocity=np.array(told.velocities),
                effort=np.array(told.efforts),
            )
        for scans, laser, scanned in self._lasers:
            for scan in scans.take():
                self._send(
                    scanned,
                    header=self._header(laser.frame),
                    angle_min=laser.angle_min,
                    angle_max=laser.angle_min + (laser.beams - 1) * laser.angle_step,
                    angle_increment=laser.angle_step,
                    time_increment=0.0,
                    scan_time=laser.period,
                    range_min=laser.range_min,
                    range_max=laser.range_max,
                    ranges=np.array(scan.ranges, np.float32),
                    intensities=np.array([], np.float32),
                )

    def _out(self, topic: str, type_name: str) -> RosPublisher:
        return self._node.publisher(topic, type_name)

    def _send(self, out: RosPublisher, **fields: object) -> None:
        out.publish(self._codec.message(out.type_name, **fields), round(self._utc() * 1e9))

    def _header(self, frame: str) -> object:
        seconds, rest = divmod(round(self._utc() * 1e9), 1_000_000_000)
        stamp = self._codec.message("builtin_interfaces/msg/Time", sec=seconds, nanosec=rest)
        return self._codec.message("std_msgs/msg/Header", stamp=stamp, frame_id=frame)

    def _with(self, name: str, **fields: object) -> object:
        return self._codec.message(f"geometry_msgs/msg/{name}", covariance=np.zeros(36), **fields)

    def _posed(self, at: FloorPose) -> object:
        position, orientation = self._parts(at, POINT)
        return self._codec.message("geometry_msgs/msg/Pose", position=position, orientation=orientation)

    def _transform(self, at: FloorPose) -> object:
        translation, rotation = self._parts(at, VECTOR)
        moved = self._codec.message("geometry_msgs/msg/Transform", translation=translation, rotation=rotation)
        return self._codec.message(
            "geometry_msgs/msg/TransformStamped",
            header=self._header("odom"),
            child_frame_id="base_link",
            transform=moved,
        )

    def _parts(self, at: FloorPose, kind: str) -> tuple[object, object]:
        x, y, z, w = to_pose(at).orientation
        return (
            self._codec.message(kind, x=at.x, y=at.y, z=0.0),
            self._codec.message(QUATERNION, x=x, y=y, z=z, w=w),
        )

    def _twist(self, linear: float, angular: float) -> object:
        return self._codec.message(
            types.TWIST,
            linear=self._codec.message(VECTOR, x=linear, y=0.0, z=0.0),
            angular=self._codec.message(VECTOR, x=0.0, y=0.0, z=angular),
        )


def _velocity_of(message: object) -> BaseVelocity:
    twist = cast("Twist", message)
    return BaseVelocity(linear=float(twist.linear.x), angular=float(twist.angular.z))


def main(arguments: Iterable[str]) -> None:
    """Be the robot until Ctrl-C."""
    endpoint, prefix = arguments
    sys.setswitchinterval(SWITCH_INTERVAL)
    ended: list[int] = []
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, lambda which, _: ended.append(which))
    bus = ZenohBus(endpoint, prefix)
    session = ForeignSession(endpoint, bus.waker, bus.strays)
    try:
        answer = wait_until(bus, keys.DESCRIPTION.query(bus, keys.Nothing(), timeout=10.0), 10.0)
        if answer is None:
            sys.exit(f"no simulated robot answers on {prefix} at {endpoint}")
        robot = keys.DESCRIPTION.decode_answer(answer)
        bus.ear.know(robot)
        face = RosFace(bus, session, robot, time.time)
        sys.stdout.write(f"{robot.name} speaks ROS\n")
        sys.stdout.flush()
        while not ended:
            bus.waker.wait(WAIT)
            face.step()
    finally:
        session.close()
        bus.close()


if __name__ == "__main__":
    main(sys.argv[1:])
