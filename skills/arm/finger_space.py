"""The room between an empty hand's fingers, as a body: nothing may stand there while the arm goes somewhere.

A hand opens and closes beside its arm's way: it closes while the arm is tucked in, it opens on the way to the
item. A way through which a thing slips between open fingers is free for one width only, so it is none.
Approaches and retreats are another matter: there the hand stands still, and an item between its fingers is
what they are for.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Final

from tandem.skills.kinematics.bodies import BoxShape, Carried
from tandem.skills.kinematics.hulls import RobotHulls
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.robot_description import EndEffector

NARROW: Final = 0.005
"""Metres between the pads below which nothing that we plan with fits."""


class FingerSpace:
    """The box between the fingers of one hand, in its tool frame.

    As far ahead and as high as the fingers' bodies, with the pads on its sides.

    Args:
        hulls: the robot's bodies.
        hand: which hand.
    """

    def __init__(self, hulls: RobotHulls, hand: EndEffector) -> None:
        self._hand, self._links = hand, tuple(dict.fromkeys(hulls.links))
        corners = hulls.corners(hand.gripper.joints, hand.frame)
        self._low, self._high = corners.min(axis=0), corners.max(axis=0)

    def at(self, positions: Mapping[str, float], planned: float | None) -> tuple[Carried, ...]:
        """Return the box, or nothing if the hand is closed.

        Args:
            positions: metres that each finger has slid, by joint.
            planned: metres that the hand is opened to, if it is.
        """
        width = max(sum(positions.get(joint, 0.0) for joint in self._hand.gripper.joints), planned or 0.0)
        if width < NARROW:
            return ()
        middle, size = (self._low + self._high) / 2.0, self._high - self._low
        return (
            Carried(
                f"space between the fingers of {self._hand.side}",
                BoxShape(size=(float(size[0]), width, float(size[2]))),
                self._hand.frame,
                Pose(position=(float(middle[0]), 0.0, float(middle[2]))),
                self._links,
            ),
        )
