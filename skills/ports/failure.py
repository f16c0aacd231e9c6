"""Failures are data: a closed set of kinds, each with who can help and whether to try again."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import Final

from pydantic import Field

from tandem.skills.ports.message import Message, Whole


class FailureKind(StrEnum):
    """What can go wrong. Every failure of a skill or a task is one of these."""

    INVALID_GOAL = "INVALID_GOAL"
    BUSY = "BUSY"
    NOT_READY = "NOT_READY"
    NOT_STORED = "NOT_STORED"
    TIMED_OUT = "TIMED_OUT"
    SKILL_LOST = "SKILL_LOST"
    SKILL_CRASHED = "SKILL_CRASHED"
    HARDWARE_LOST = "HARDWARE_LOST"
    HARDWARE_STOPPED = "HARDWARE_STOPPED"
    CAMERA_SILENT = "CAMERA_SILENT"
    CAMERA_BLIND = "CAMERA_BLIND"
    LASER_SILENT = "LASER_SILENT"
    NOT_LOCALISED = "NOT_LOCALISED"
    ITEM_UNKNOWN = "ITEM_UNKNOWN"
    ITEM_NOT_FOUND = "ITEM_NOT_FOUND"
    ITEM_AMBIGUOUS = "ITEM_AMBIGUOUS"
    ITEM_GONE = "ITEM_GONE"
    ITEM_HIDDEN = "ITEM_HIDDEN"
    ITEM_UNREACHABLE = "ITEM_UNREACHABLE"
    DESTINATION_UNKNOWN = "DESTINATION_UNKNOWN"
    DESTINATION_FULL = "DESTINATION_FULL"
    DESTINATION_UNREACHABLE = "DESTINATION_UNREACHABLE"
    SLOT_TAKEN = "SLOT_TAKEN"
    HAND_FULL = "HAND_FULL"
    HAND_EMPTY = "HAND_EMPTY"
    BASE_NO_PATH = "BASE_NO_PATH"
    BASE_BLOCKED = "BASE_BLOCKED"
    BASE_OFF_GOAL = "BASE_OFF_GOAL"
    BASE_HELD = "BASE_HELD"
    NO_IK = "NO_IK"
    NO_PATH = "NO_PATH"
    PATH_IN_COLLISION = "PATH_IN_COLLISION"
    ARM_STOPPED = "ARM_STOPPED"
    ARM_OFF_GOAL = "ARM_OFF_GOAL"
    GRASP_EMPTY = "GRASP_EMPTY"
    GRASP_LOST = "GRASP_LOST"
    GRIPPER_STUCK = "GRIPPER_STUCK"
    ARMS_CROSSING = "ARMS_CROSSING"
    FORCE_MISSING = "FORCE_MISSING"
    TILTED = "TILTED"
    OTHER_ARM_FAILED = "OTHER_ARM_FAILED"
    INTERRUPTED = "INTERRUPTED"
    SUPERSEDED = "SUPERSEDED"
    OVERRIDDEN = "OVERRIDDEN"
    OTHER = "OTHER"

    @classmethod
    def _missing_(cls, value: object) -> FailureKind | None:
        """Read a kind of another release, or of somebody else's skill, as ``OTHER``."""
        return cls.OTHER if isinstance(value, str) else None


class Helper(StrEnum):
    """Who can help with a failure."""

    CLIENT = "client"
    AGAIN = "again"
    LOOK = "look"
    BASE = "base"
    LET_GO = "let_go"
    OPERATOR = "operator"


@dataclass(frozen=True)
class KindFacts:
    """What holds for all failures of a kind."""

    meaning: str
    retryable: bool
    helper: Helper


_K = FailureKind
KINDS: Final = MappingProxyType(
    {
        _K.INVALID_GOAL: KindFacts("the goal contradicts itself or the robot", False, Helper.CLIENT),
        _K.BUSY: KindFacts("the skill is busy with another goal", True, Helper.AGAIN),
        _K.NOT_READY: KindFacts("something the skill needs has not arrived yet", True, Helper.AGAIN),
        _K.NOT_STORED: KindFacts("the skill's host can't write to its disk", True, Helper.OPERATOR),
        _K.TIMED_OUT: KindFacts("no result within the time allowed", True, Helper.AGAIN),
        _K.SKILL_LOST: KindFacts("the process of the skill is gone", True, Helper.AGAIN),
        _K.SKILL_CRASHED: KindFacts(
            "the skill raised an error; see its log for the traceback", True, Helper.AGAIN
        ),
        _K.HARDWARE_LOST: KindFacts("the hardware is silent or was restarted", True, Helper.OPERATOR),
        _K.HARDWARE_STOPPED: KindFacts("the hardware's stop is set", False, Helper.OPERATOR),
        _K.CAMERA_SILENT: KindFacts("no picture arrived in time", True, Helper.AGAIN),
        _K.CAMERA_BLIND: KindFacts("pictures arrive, but they are dark or frozen", True, Helper.AGAIN),
        _K.LASER_SILENT: KindFacts("no scan arrived in time", True, Helper.AGAIN),
        _K.NOT_LOCALISED: KindFacts("the robot does not know where it is", True, Helper.AGAIN),
        _K.ITEM_UNKNOWN: KindFacts("the site file has no such item", False, Helper.CLIENT),
        _K.ITEM_NOT_FOUND: KindFacts("the item was not found from any search spot", False, Helper.OPERATOR),
        _K.ITEM_AMBIGUOUS: KindFacts(
            "several items have this number; choose one with `near`", False, Helper.CLIENT
        ),
        _K.ITEM_GONE: KindFacts("the item is not where it was last seen", True, Helper.LOOK),
        _K.ITEM_HIDDEN: KindFacts("something stands between the camera and the item", True, Helper.BASE),
        _K.ITEM_UNREACHABLE: KindFacts("seen, but out of reach or fallen over", False, Helper.OPERATOR),
        _K.DESTINATION_UNKNOWN: KindFacts("the site file has no such depot", False, Helper.CLIENT),
        _K.DESTINATION_FULL: KindFacts("no slot of the depot is free", False, Helper.OPERATOR),
        _K.DESTINATION_UNREACHABLE: KindFacts(
            "the item is in the hand, but no arm can put it into a slot", False, Helper.OPERATOR
        ),
        _K.SLOT_TAKEN: KindFacts("something stands where the item should go", True, Helper.LOOK),
        _K.HAND_FULL: KindFacts("the hand holds another item", False, Helper.LET_GO),
        _K.HAND_EMPTY: KindFacts("no hand holds what is to be put down", False, Helper.CLIENT),
        _K.BASE_NO_PATH: KindFacts("no free path to any of the goal's poses", True, Helper.BASE),
        _K.BASE_BLOCKED: KindFacts("something stands in the way", True, Helper.BASE),
        _K.BASE_OFF_GOAL: KindFacts("at rest, but outside the goal's tolerance", True, Helper.AGAIN),
        _K.BASE_HELD: KindFacts(
            "an arm is stretched out or moving; the base must not move", True, Helper.AGAIN
        ),
        _K.NO_IK: KindFacts("no collision-free joint positions reach the pose", True, Helper.BASE),
        _K.NO_PATH: KindFacts("reachable, but no collision-free path was found", True, Helper.BASE),
        _K.PATH_IN_COLLISION: KindFacts("the planned motion failed its last check", True, Helper.LOOK),
        _K.ARM_STOPPED: KindFacts("the arm was stopped on the way", True, Helper.LOOK),
        _K.ARM_OFF_GOAL: KindFacts("at rest, but not where the plan ended", True, Helper.LOOK),
        _K.GRASP_EMPTY: KindFacts("the gripper closed on nothing", True, Helper.LOOK),
        _K.GRASP_LOST: KindFacts("the hand was full and is empty", True, Helper.LOOK),
        _K.GRIPPER_STUCK: KindFacts("the gripper did not move as commanded", True, Helper.OPERATOR),
        _K.ARMS_CROSSING: KindFacts("the arms got in each other's way and were stopped", True, Helper.AGAIN),
        _K.FORCE_MISSING: KindFacts("two hands closed in but did not feel the object", True, Helper.LOOK),
        _K.TILTED: KindFacts("the object between two hands is not level", False, Helper.LET_GO),
        _K.OTHER_ARM_FAILED: KindFacts("the other arm failed before both could act", True, Helper.AGAIN),
        _K.INTERRUPTED: KindFacts(
            "the executive ended during the task; its progress is unknown", True, Helper.OPERATOR
        ),
        _K.SUPERSEDED: KindFacts(
            "another process has the sender's role; the command was refused", False, Helper.OPERATOR
        ),
        _K.OVERRIDDEN: KindFacts(
            "a reflex took what the goal moved; its cause says what the reflex saw", True, Helper.AGAIN
        ),
        _K.OTHER: KindFacts(
            "a kind that this version does not know; see the message", False, Helper.OPERATOR
        ),
    }
)
"""The facts of each kind; complete, which a test checks."""


class Failure(Message):
    """One failure: its kind, a message, and the evidence.

    ``evidence`` holds what was measured (which joint, which pose, how far), by name with the unit in the
    name (``distance_m``); ``causes`` is the chain below it, nearest first.
    """

    kind: FailureKind
    message: str
    where: str = ""
    evidence: dict[str, str | float | Whole | bool] = Field(default_factory=dict)
    causes: tuple[Failure, ...] = ()

    @property
    def reason(self) -> Failure:
        """Return what counts for who can help: of a goal that was overridden, what the reflex saw."""
        return self.causes[0] if self.kind is FailureKind.OVERRIDDEN and self.causes else self

    def chain(self) -> tuple[Failure, ...]:
        """Return this failure and all below it, depth first."""
        return (self, *(each for cause in self.causes for each in cause.chain()))
