"""The last seconds of odometry, to be asked for any moment between two messages."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections import deque
from typing import Final

from tandem.skills.base.floor import between, compose
from tandem.skills.ports.hardware import Odometry
from tandem.skills.ports.message import RobotTime
from tandem.skills.ports.pose import FloorPose

SAME: Final = 1e-9
"""Seconds between two moments that are one: stamps are rounded to 1e-6."""
KEPT: Final = 100
"""Messages: two seconds at 50 Hz."""


class OdometryBuffer:
    """Holds one boot's odometry in order of time; a new boot starts it afresh."""

    def __init__(self) -> None:
        """Start empty."""
        self._kept: deque[Odometry] = deque(maxlen=KEPT)

    def add(self, odometry: Odometry) -> None:
        """Take a message; one older than the last is dropped."""
        later = None if self.last is None else odometry.stamp.is_after(self.last.stamp)
        if later is None:
            self._kept.clear()
        elif not later:
            return
        self._kept.append(odometry)

    @property
    def last(self) -> Odometry | None:
        """The newest message."""
        return self._kept[-1] if self._kept else None

    def at(self, stamp: RobotTime) -> FloorPose | None:
        """Return base_in_odom at a moment, interpolated; None when it lies before or after what is held."""
        last = self.last
        if last is None or stamp.is_after(last.stamp) is not False:
            return None
        index = bisect_left(self._kept, 0.0, key=lambda each: _since(each, stamp))
        after = self._kept[index]
        left = _since(after, stamp)
        if left < SAME:
            return after.base_in_odom
        if index == 0:
            return None
        before = self._kept[index - 1]
        passed = -_since(before, stamp)
        return between(before.base_in_odom, after.base_in_odom, passed / (passed + left))


def _since(odometry: Odometry, stamp: RobotTime) -> float:
    passed = odometry.stamp.since(stamp)
    assert passed is not None, "what is kept is of one boot, and so is what is asked for"
    return passed


def ahead(odometry: Odometry, seconds: float) -> FloorPose:
    """Return base_in_odom ``seconds`` after the message, at its speeds."""
    turned = odometry.angular * seconds
    moved = FloorPose(
        x=odometry.linear * seconds * math.cos(turned / 2),
        y=odometry.linear * seconds * math.sin(turned / 2),
        yaw=turned,
    )
    return compose(odometry.base_in_odom, moved)
