"""The nodes of a gripper."""

from __future__ import annotations

from tandem.skills.claimed import Claimed
from tandem.skills.gripper.grip import Gripping
from tandem.skills.gripper.hand_watch import HandWatch
from tandem.skills.pipeline import Pipeline
from tandem.skills.ports.bus import Bus
from tandem.skills.ports.clocks import Clocks
from tandem.skills.ports.node import Node
from tandem.skills.ports.reflex import hand_resource
from tandem.skills.ports.robot_description import RobotDescription
from tandem.skills.server import ActionServer


def nodes(
    bus: Bus,
    clocks: Clocks,
    description: RobotDescription,
    side: str,
    *,
    charge: bool = False,
    pipeline: Pipeline | None = None,
) -> tuple[Node, ...]:
    """Return the server of ``gripper_<side>/grip`` and the watch over the hand.

    Args:
        bus: the hardware and the clients.
        clocks: robot time.
        description: the robot.
        side: the hand's.
        charge: make a computation's slices cost their declared robot time (lockstep).
        pipeline: of the hand; unless given, one that no reflex takes.

    Raises:
        KeyError: when the robot has no such hand.
    """
    hand, has = description.end_effector(side), pipeline or Pipeline(hand_resource(side))
    skill = Claimed(Gripping(bus, clocks, hand), has)
    return (ActionServer(bus, clocks, skill, charge=charge, pipelines=(has,)), HandWatch(bus, hand))
