"""The joints' servos: each follows its controller's reference as an ideal velocity drive with limited effort.

A motor is a constraint on the joint's speed in the physics' own solver, so gravity is carried without a
model of it, up to the joint's effort, and a blocked joint pushes with no more than that.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from tandem.sim.joints import GroupController

if TYPE_CHECKING:
    from tandem.sim.body import JointReading, RobotBody
    from tandem.skills.ports.robot_description import JointGroup

SERVO_GAIN: Final = 0.5
"""Part of a position error that is made up for in one period."""
SPEED_RESERVE: Final = 1.2
"""How far above its nominal limit a servo may go to catch up."""


class GroupServos:
    """A group's controller with its motors."""

    def __init__(self, body: RobotBody, group: JointGroup) -> None:
        self._body = body
        self._joints = group.joints
        self._efforts = [limit.effort for limit in group.limits]
        self._fastest = SPEED_RESERVE * np.array([limit.velocity for limit in group.limits])
        self.controller = GroupController(group, [r.position for r in body.read(group.joints)])

    def advance(self, period: float, readings: list[JointReading]) -> None:
        """Move the controller on by a period and set the motors for it."""
        position = np.array([reading.position for reading in readings])
        velocity = np.array([reading.velocity for reading in readings])
        controller = self.controller
        controller.advance(period, position, velocity)
        # The reference is where the joints shall be when the next period ends.
        feed = controller.velocity_to_reference
        lag = controller.last_position - position
        speed = np.clip(feed + SERVO_GAIN * lag / period, -self._fastest, self._fastest)
        self._body.drive_velocities(self._joints, speed.tolist(), self._efforts)
