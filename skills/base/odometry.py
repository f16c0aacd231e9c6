"""The last seconds of odometry, to be asked for any moment between two messages."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections import deque
from typing import Final

from skills.base.floor import between, compose
from skills.ports.geometry import FloorPose
from skills.ports.hardware import Odometry

KEPT: Final = 100
"""Messages: two seconds at 50 Hz."""


class OdometryBuffer:
    """Holds one boot's odometry in order of time; a new boot starts it afresh."""

    def __init__(self) -> None:
        """Start empty."""
        self._kept: deque[Odometry] = deque(maxlen=KEPT)

    def add(self, odometry: Odometry) -> None:
        """Take a message; one older than the last is dropped."""
        last = self.last
        if last is not None and last.stamp.boot != odometry.stamp.boot:
            self._kept.clear()
        elif last is not None and odometry.stamp.seconds <= last.stamp.seconds:
            return
        self._kept.append(odometry)

    @property
    def last(self) -> Odometry | None:
        """The newest message."""
        return self._kept[-1] if self._kept else None

    def at(self, seconds: float) -> FloorPose | None:
        """Return base_in_odom at that time, interpolated; None when it lies before or after what is held."""
        times = [each.stamp.seconds for each in self._kept]
        index = bisect_left(times, seconds)
        if index == len(times):
            return None
        after = self._kept[index]
        if math.isclose(after.stamp.seconds, seconds, abs_tol=1e-9):
            return after.base_in_odom
        if index == 0:
            return None
        before = self._kept[index - 1]
        share = (seconds - before.stamp.seconds) / (after.stamp.seconds - before.stamp.seconds)
        return between(before.base_in_odom, after.base_in_odom, share)


def ahead(odometry: Odometry, seconds: float) -> FloorPose:
    """Return base_in_odom ``seconds`` after the message, at its speeds."""
    turned = odometry.angular * seconds
    moved = FloorPose(
        x=odometry.linear * seconds * math.cos(turned / 2),
        y=odometry.linear * seconds * math.sin(turned / 2),
        yaw=turned,
    )
    return compose(odometry.base_in_odom, moved)
