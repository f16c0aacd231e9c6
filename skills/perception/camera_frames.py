"""Where the camera was when a picture was taken: out of buffered joint states and robot poses."""

from __future__ import annotations

from bisect import bisect_left
from collections import deque
from collections.abc import Mapping, Sequence
from typing import Final

from tandem.skills.geometry.chain import Chain
from tandem.skills.geometry.poses import wrap
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.hardware import JointStates
from tandem.skills.ports.keys import JOINT_STATES, Latest
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose, Pose
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.ports.world import ROBOT_POSE, RobotPose

_KEPT: Final = 256
"""States of the joints, and poses of the robot: the last seconds, longer than a picture takes to come."""
_MAX_GAP: Final = 0.25
"""Seconds: what lies farther from a picture says nothing about it."""


class JointHistory:
    """The last seconds of joint states."""

    def __init__(self, bus: Bus) -> None:
        """Subscribe."""
        self._states = Latest(bus, JOINT_STATES, depth=_KEPT)
        self._kept: deque[JointStates] = deque(maxlen=_KEPT)

    @property
    def newest(self) -> JointStates | None:
        """The last joint states heard."""
        return self._kept[-1] if self._kept else None

    def refresh(self) -> None:
        """Take in what has arrived."""
        for state in self._states.take():
            if self._kept and self._kept[-1].stamp.is_after(state.stamp) is not False:
                self._kept.clear()
            self._kept.append(state)

    def positions(self, stamp: RobotTime) -> Mapping[str, float] | None:
        """Return the joints' positions (rad or m) at a moment, interpolated; None while not known."""
        at = _first_not_before(self._kept, stamp)
        if at is None or at == len(self._kept):
            return None
        after = self._kept[at]
        before = self._kept[max(at - 1, 0)]
        share = _share(before.stamp, after.stamp, stamp)
        if share is None or before.names != after.names:
            return None
        return {
            name: a + share * (b - a)
            for name, a, b in zip(after.names, before.positions, after.positions, strict=True)
        }

    def close(self) -> None:
        """End the subscription."""
        self._states.close()


class RobotPoseHistory:
    """The last seconds of the robot's pose in the map."""

    def __init__(self, bus: Bus) -> None:
        """Subscribe."""
        self._poses = Latest(bus, ROBOT_POSE)
        self._kept: deque[RobotPose] = deque(maxlen=_KEPT)

    @property
    def newest(self) -> RobotPose | None:
        """The last pose heard."""
        return self._kept[-1] if self._kept else None

    def refresh(self) -> None:
        """Take in what has arrived."""
        for pose in self._poses.take():
            if self._kept and self._kept[-1].stamp.is_after(pose.stamp) is not False:
                self._kept.clear()
            self._kept.append(pose)

    def base_in_map(self, stamp: RobotTime) -> FloorPose | None:
        """Return the base at a moment, interpolated; None when it is not known (yet) or not localised."""
        at = _first_not_before(self._kept, stamp)
        if at is None:
            return None
        if at == len(self._kept):
            last = self._kept[-1]
            still = not last.moving and last.stamp.is_fresh(stamp, _MAX_GAP)
            return last.base_in_map if still and last.localised else None
        after, before = self._kept[at], self._kept[max(at - 1, 0)]
        share = _share(before.stamp, after.stamp, stamp)
        if share is None or not (before.localised and after.localised):
            return None
        a, b = before.base_in_map, after.base_in_map
        return FloorPose(
            x=a.x + share * (b.x - a.x),
            y=a.y + share * (b.y - a.y),
            yaw=wrap(a.yaw + share * wrap(b.yaw - a.yaw)),
        )

    def close(self) -> None:
        """End the subscription."""
        self._poses.close()


class CameraMount:
    """The camera's optical frame in the base, by the joints between them."""

    def __init__(self, description: RobotDescription) -> None:
        """Read the chain out of the description."""
        self._chain = Chain.from_urdf(description.urdf, description.base_frame, description.camera.frame)

    def camera_in_base(self, positions: Mapping[str, float]) -> Pose:
        """Return the camera's pose at these joint positions."""
        return self._chain.pose(positions)


def _first_not_before(kept: Sequence[JointStates] | Sequence[RobotPose], stamp: RobotTime) -> int | None:
    """Return where the first that is no earlier than the stamp is (the end: none), or None: unknown."""
    if not kept or kept[-1].stamp.since(stamp) is None:
        return None

    def after_stamp(each: JointStates | RobotPose) -> float:
        passed = each.stamp.since(stamp)
        assert passed is not None, "what is kept is of one boot"
        return passed

    return bisect_left(kept, 0.0, key=after_stamp)


def _share(before: RobotTime, after: RobotTime, at: RobotTime) -> float | None:
    """Return how far ``at`` lies between two times (0 to 1), or None when they are too far from it."""
    span, passed = after.since(before), at.since(before)
    if span is None or passed is None:
        return None
    if span <= 0.0:
        return 1.0 if abs(passed) <= _MAX_GAP else None
    if span > 2 * _MAX_GAP:
        return None
    return min(max(passed / span, 0.0), 1.0)
