"""The fields of ROS messages that are read here. ``cdr`` gives objects that have them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32] | NDArray[np.float64]


class Time(Protocol):
    """builtin_interfaces/Time."""

    sec: int
    nanosec: int


class Header(Protocol):
    """std_msgs/Header."""

    stamp: Time
    frame_id: str


class Xyz(Protocol):
    """geometry_msgs/Point and Vector3."""

    x: float
    y: float
    z: float


class Xyzw(Protocol):
    """geometry_msgs/Quaternion."""

    x: float
    y: float
    z: float
    w: float


class RosPose(Protocol):
    """geometry_msgs/Pose."""

    position: Xyz
    orientation: Xyzw


class PoseStamped(Protocol):
    """geometry_msgs/PoseStamped."""

    header: Header
    pose: RosPose


class Twist(Protocol):
    """geometry_msgs/Twist."""

    linear: Xyz
    angular: Xyz


class WithPose(Protocol):
    """geometry_msgs/PoseWithCovariance."""

    pose: RosPose


class WithTwist(Protocol):
    """geometry_msgs/TwistWithCovariance."""

    twist: Twist


class RosOdometry(Protocol):
    """nav_msgs/Odometry."""

    header: Header
    pose: WithPose
    twist: WithTwist


class JointState(Protocol):
    """sensor_msgs/JointState."""

    header: Header
    name: Sequence[str]
    position: Floats
    velocity: Floats
    effort: Floats


class RosScan(Protocol):
    """sensor_msgs/LaserScan."""

    header: Header
    angle_min: float
    angle_increment: float
    range_min: float
    range_max: float
    ranges: Floats


class RosRange(Protocol):
    """sensor_msgs/Range."""

    header: Header
    range: float


class RosBool(Protocol):
    """std_msgs/Bool."""

    data: bool


class RosImage(Protocol):
    """sensor_msgs/Image."""

    header: Header
    height: int
    width: int
    encoding: str
    is_bigendian: int
    step: int
    data: NDArray[np.uint8]


class RosCameraInfo(Protocol):
    """sensor_msgs/CameraInfo."""

    header: Header
    height: int
    width: int
    k: Floats
    p: Floats


class RosTransform(Protocol):
    """geometry_msgs/Transform."""

    translation: Xyz
    rotation: Xyzw


class TransformStamped(Protocol):
    """geometry_msgs/TransformStamped."""

    header: Header
    child_frame_id: str
    transform: RosTransform


class TfMessage(Protocol):
    """tf2_msgs/TFMessage."""

    transforms: Sequence[TransformStamped]
