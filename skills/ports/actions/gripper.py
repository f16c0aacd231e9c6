"""Open, close and check a gripper."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

from pydantic import Field

from tandem.skills.ports.keys import Topic
from tandem.skills.ports.message import HandName, Message, RobotTime
from tandem.skills.ports.skill import ActionType


class Grip(StrEnum):
    """What the hand does."""

    OPEN = "open"
    CLOSE = "close"
    """Close on nothing: the hand is expected to be empty."""
    GRASP = "grasp"
    """Close on something ``width`` metres wide."""
    CHECK = "check"
    """Move nothing; say whether the hand is full."""


class GripGoal(Message):
    """Do ``grip``. ``width`` (m): for OPEN how far (0: all the way), for GRASP and CHECK what is expected."""

    grip: Grip
    width: Annotated[float, Field(ge=0.0)] = 0.0
    force: Annotated[float, Field(gt=0.0)] | None = None
    """Newtons; default: the gripper's limit."""


class GripFeedback(Message):
    """State of the gripper while it moves."""

    width: float
    force: float


class GripResult(Message):
    """The hand at the end. ``full``: it holds something of about the expected width."""

    width: float
    force: float
    full: bool


class HandState(StrEnum):
    """State of the hand, from the hand watch."""

    OPEN = "OPEN"
    """It squeezes nothing: opened, or moving."""
    HOLDING = "HOLDING"
    """It squeezes something."""
    EMPTY = "EMPTY"
    """It squeezes, and there is nothing between the pads, or no more what was."""


class HandStatus(Message):
    """At 10 Hz and on each change, also while no goal runs; width in metres, force in newtons."""

    stamp: RobotTime
    side: HandName
    state: HandState
    width: float
    force: float


def hand_status(side: str) -> Topic[HandStatus]:
    """Return the topic of what a hand is at."""
    return Topic(f"skill/gripper_{side}/state", HandStatus)


def grip(side: str) -> ActionType[GripGoal, GripFeedback, GripResult]:
    """Return the action of a side: ``gripper_left/grip``."""
    return ActionType(f"gripper_{side}/grip", GripGoal, GripFeedback, GripResult, timeout=15.0)
