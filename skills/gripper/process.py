"""The nodes of a gripper."""

from __future__ import annotations

from tandem.skills.gripper.grip import Gripping
from tandem.skills.gripper.hand_watch import HandWatch
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.node import Node
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.server import ActionServer


def nodes(
    bus: Bus, clocks: Clocks, description: RobotDescription, side: str, *, charge: bool = False
) -> tuple[Node, ...]:
    """Return the server of ``gripper_<side>/grip`` and the watch over the hand.

    Raises:
        KeyError: when the robot has no such hand.
    """
    hand = description.end_effector(side)
    return (ActionServer(bus, clocks, Gripping(bus, clocks, hand), charge=charge), HandWatch(bus, hand))
