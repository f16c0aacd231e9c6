"""What the wrist's force/torque sensors and the bumpers feel."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from collections.abc import Sequence

    from tandem.sim.body import RobotBody
    from tandem.skills.ports.message import Vector3

BUMPER_FORCE: Final = 1.0
"""N from which a bumper closes."""
GROUND: Final = 0.01
"""Metres: wheels that are bumpers, too, touch the floor below this."""


class WristSensor:
    """Force and torque that the hand, and what it holds, exert on the wrist: at rest their weight.

    In the frame of the hand's mount (x out of the hand, y along the closing), about its origin. Readings are
    smoothed over about 0.02 s, as a sensor's own filter does.
    """

    def __init__(self, body: RobotBody, joint: str) -> None:
        self._body = body
        self._joint = joint
        self._values = [0.0] * 6
        self._fresh = True

    def update(self) -> None:
        """Take the last step's reaction in."""
        force, torque = self._body.reaction(self._joint)
        share = 1.0 if self._fresh else 0.5
        self._fresh = False
        for index, value in enumerate((*force, *torque)):
            self._values[index] += share * (-value - self._values[index])

    @property
    def force(self) -> Vector3:
        """N."""
        x, y, z = self._values[:3]
        return (x, y, z)

    @property
    def torque(self) -> Vector3:
        """N m."""
        x, y, z = self._values[3:]
        return (x, y, z)


def pressed_bumpers(body: RobotBody, links: Sequence[str]) -> tuple[str, ...]:
    """Return the bumpers on whose side the base or torso touches something that is not the robot."""
    indices = [body.link_index[name] for name in links]
    hits = [
        contact
        for contact in body.physics.contacts(body.body, links=indices)
        if contact.body_b != body.body and contact.force > BUMPER_FORCE and contact.position[2] > GROUND
    ]
    if not hits:
        return ()
    position, orientation = body.base_pose()
    yaw = 2.0 * math.atan2(orientation[2], orientation[3])
    bearings = [math.atan2(c.position[1] - position[1], c.position[0] - position[0]) - yaw for c in hits]
    return tuple(each.name for each in body.model.bumpers if any(each.feels(at) for at in bearings))
