"""Approach an item that may move: the improved potential field of the two-arm thesis, 2.4 and 4.2."""

from __future__ import annotations

import math
from enum import StrEnum
from typing import Annotated, Final

from pydantic import Field

from tandem.skills.ports.keys import Topic
from tandem.skills.ports.message import MOST, Count, HandName, Message, RobotTime, Vector3
from tandem.skills.ports.pose import Pose
from tandem.skills.ports.skill import ActionType

GOAL_RADIUS: Final = 0.10
"""Metres before the grasp at which the field ends: the "goal radius" of the two-arm thesis, 4.3."""


class ApproachGoal(Message):
    """Bring the hand to the proximity pose of ``item``, wherever it is by then.

    ``grasps`` are tool poses at the grasp in the item's frame (its centre, z up at rest), in order of
    preference, so they move with the item. The proximity pose is ``radius`` metres in front of a grasp,
    against the tool's x. The approach takes the first grasp that the arm can reach, and may change it while
    the item moves.
    """

    item: Annotated[int, Field(ge=0, le=MOST)]
    grasps: Annotated[tuple[Pose, ...], Field(min_length=1)]
    radius: Annotated[float, Field(gt=0.0, le=0.5)] = GOAL_RADIUS
    hand_width: Annotated[float, Field(ge=0.0)] | None = None
    """Metres between the pads to plan with; default: their current width."""
    turn: Annotated[float, Field(ge=0.0, le=math.pi)] = 0.0
    """Radians by which an arm of fewer than six joints may turn the grasps, to both sides, about the vertical
    through the item's centre; see TurnAbout."""
    tolerance: Annotated[float, Field(gt=0.0)] = 0.015
    """Metres from the proximity pose that count as reached."""
    speed: Annotated[float, Field(gt=0.0, le=1.0)] = 1.0
    """Fraction of the joints' speed limits."""


class ApproachPhase(StrEnum):
    """The phase of an approach."""

    FIELD = "FIELD"
    ESCAPING = "ESCAPING"
    """Drawn by an escape point rather than by the goal."""
    PLANNED = "PLANNED"
    """The field was stuck; the planner's motion is followed."""
    HELD = "HELD"
    """Stands, because the coordination says so."""
    BACK = "BACK"
    """Goes back along its own record, because the coordination says so."""
    STOPPING = "STOPPING"


class ApproachFeedback(Message):
    """How far the hand is from its proximity pose (m), and what it does."""

    phase: ApproachPhase
    distance: float


class ApproachResult(Message):
    """Where the approach ended: which grasp, the error, and the effort."""

    grasp: Count
    positions: tuple[float, ...]
    error: float
    turned: Annotated[float, Field(ge=-math.pi, le=math.pi)] = 0.0
    """Radians by which the grasp was turned (``ApproachGoal.turn``)."""
    item_in_map: Pose
    """The item's centre frame in which the grasp is told: another of its faces may have been seen since."""
    duration: float
    """Robot seconds."""
    escapes: Count = 0
    """How often an escape point was used."""
    planned: Count = 0
    """How often the planner took over from a stuck field."""
    stops: Count = 0
    """How often the coordination stopped the arm."""


class ApproachStatus(Message):
    """The state of an arm's approach; owner: the arm. 20 Hz while one runs, and on each change.

    The other arm takes ``goal_in_base`` for an obstacle (two-arm thesis, 4.3); the coordination compares the
    distances and counts the record.
    """

    stamp: RobotTime
    side: HandName
    active: bool
    phase: ApproachPhase = ApproachPhase.FIELD
    distance: float = 0.0
    """Metres from the hand to its proximity pose."""
    goal_in_base: Vector3 | None = None
    """The item's centre."""
    goal_positions: tuple[float, ...] = ()
    """Of the group's joints, in its order, where it will end as things are; none before that is known."""
    recorded: Count = 0
    """Samples of the record (two-arm thesis, Algorithm 3), thinned by phi: the safe start is sample 0."""
    at: Count = 0
    """The sample at which the arm stands or to which it goes back."""


def approach(group: str) -> ActionType[ApproachGoal, ApproachFeedback, ApproachResult]:
    """Return the action of a group with a hand: ``arm_left/approach``."""
    return ActionType(f"{group}/approach", ApproachGoal, ApproachFeedback, ApproachResult, timeout=60.0)


def approach_status(group: str) -> Topic[ApproachStatus]:
    """Return the topic of what a group's approach is at."""
    return Topic(f"skill/{group}/approach_state", ApproachStatus)
