"""The nodes of a gripper."""

from __future__ import annotations

from skills.gripper.grip import Gripping
from skills.gripper.hand_watch import HandWatch
from skills.ports.bus import Bus
from skills.ports.clocks import Clocks
from skills.ports.hardware import RobotDescription
from skills.ports.node import Node
from skills.server import ActionServer


def nodes(
    bus: Bus, clocks: Clocks, description: RobotDescription, side: str, *, charge: bool = False
) -> tuple[Node, ...]:
    """Return the server of ``gripper_<side>/grip`` and the watch over the hand.

    Raises:
        KeyError: when the robot has no such hand.
    """
    hand = description.end_effector(side)
    return (ActionServer(bus, clocks, Gripping(bus, clocks, hand), charge=charge), HandWatch(bus, hand))
