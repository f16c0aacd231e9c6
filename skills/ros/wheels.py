"""Velocities of the base to ``cmd_vel``, with the dead-man: what is not renewed becomes zero."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from tandem.skills.ros import types

if TYPE_CHECKING:
    from tandem.skills.ports.hardware import BaseVelocity
    from tandem.skills.ports.robot_description import Drive
    from tandem.skills.ros.cdr import Codec
    from tandem.skills.ros.node import RosPublisher

EVERY: Final = 0.05
"""Seconds between two messages while a velocity holds: ROS bases stop by themselves after 0.2 to 0.5 s."""
ZEROS_FOR: Final = 1.0
"""Seconds for which zero is told after the last velocity; then others may use the topic."""
AT_THE_END: Final = 3
"""Zeros that are sent when the process ends: one may get lost."""
NANO: Final = 1e9
"""Nanoseconds of a second, as ROS counts time."""


class Wheels:
    """The base, as its topic moves it. Times are host seconds.

    Args:
        publisher: of ``cmd_vel``.
        codec: makes its messages.
        drive: limits, and the dead-man's time.
        frame: the base's frame, for TwistStamped.
        utc: UTC seconds, which ROS time is on a robot.
    """

    def __init__(
        self,
        publisher: RosPublisher,
        codec: Codec,
        drive: Drive,
        frame: str,
        utc: Callable[[], float],
    ) -> None:
        self._publisher, self._codec, self._drive = publisher, codec, drive
        self._frame, self._utc = frame, utc
        self._wish = (0.0, 0.0)
        self._asked_at: float | None = None
        self._zero_since: float | None = None
        self._told_at = float("-inf")

    def command(self, velocity: BaseVelocity, now: float) -> None:
        """Obey a velocity at once, within the drive's limits."""
        drive = self._drive
        linear = min(max(velocity.linear, -drive.backward), drive.forward)
        angular = min(max(velocity.angular, -drive.turn), drive.turn)
        self._wish, self._asked_at, self._zero_since = (linear, angular), now, None
        self._tell(*self._wish, now)

    def halt(self, now: float) -> None:
        """Forget the velocity, and tell zero."""
        self._asked_at, self._zero_since = None, now
        self._tell(0.0, 0.0, now)

    def step(self, now: float, *, stopped: bool) -> None:
        """Tell the velocity again while it holds, zero for a while after that, and while the stop is set."""
        if self._asked_at is not None and now - self._asked_at > self._drive.dead_man:
            self.halt(now)
        if now - self._told_at < EVERY:
            return
        if self._asked_at is not None:
            self._tell(*self._wish, now)
        elif stopped or (self._zero_since is not None and now - self._zero_since <= ZEROS_FOR):
            self._tell(0.0, 0.0, now)

    def close(self, now: float) -> None:
        """Leave the base standing."""
        for _ in range(AT_THE_END):
            self._tell(0.0, 0.0, now)

    def _tell(self, linear: float, angular: float, now: float) -> None:
        self._told_at = now
        nanoseconds = round(self._utc() * NANO)
        self._publisher.publish(self._message(linear, angular, nanoseconds), nanoseconds)

    def _message(self, linear: float, angular: float, nanoseconds: int) -> object:
        make = self._codec.message
        vector = "geometry_msgs/msg/Vector3"
        twist = make(
            types.TWIST,
            linear=make(vector, x=linear, y=0.0, z=0.0),
            angular=make(vector, x=0.0, y=0.0, z=angular),
        )
        if self._publisher.type_name == types.TWIST:
            return twist
        seconds, rest = divmod(nanoseconds, round(NANO))
        stamp = make("builtin_interfaces/msg/Time", sec=seconds, nanosec=rest)
        header = make("std_msgs/msg/Header", stamp=stamp, frame_id=self._frame)
        return make(types.TWIST_STAMPED, header=header, twist=twist)
