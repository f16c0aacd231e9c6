"""Open, close and check a gripper."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated

from pydantic import Field

from skills.ports.message import Message
from skills.ports.skill import ActionType


class Grip(StrEnum):
    """What to do with the hand."""

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
    """Newtons; the gripper's own limit unless given."""


class GripFeedback(Message):
    """What the gripper tells while it moves."""

    width: float
    force: float


class GripResult(Message):
    """How the hand is now. ``full``: something of about the expected width is held."""

    width: float
    force: float
    full: bool


def grip(side: str) -> ActionType[GripGoal, GripFeedback, GripResult]:
    """Return the action of a side: ``gripper_left/grip``."""
    return ActionType(f"gripper_{side}/grip", GripGoal, GripFeedback, GripResult, timeout=15.0)
