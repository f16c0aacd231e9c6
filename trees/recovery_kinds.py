"""Which kinds of failure each recovery step takes: the one table behind the trees and the page of failures.

A condition over kinds asks one question: would this step help? A recovery step of a tree holds one of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind


@dataclass(frozen=True, eq=False)
class KindCondition:
    """Takes failures of some kinds: those with which a recovery step would help.

    Args:
        words: what the step does, as the page of failures tells it.
        kinds: the kinds that it takes.
    """

    words: str
    kinds: frozenset[FailureKind]

    def __call__(self, failure: Failure) -> bool:
        """Say whether the failure, or what made a reflex override the goal, is of one of the kinds."""
        return failure.reason.kind in self.kinds


_ARM_NOT_THERE: Final = frozenset(
    (
        FailureKind.NO_IK,
        FailureKind.NO_PATH,
        FailureKind.PATH_IN_COLLISION,
        FailureKind.ARM_STOPPED,
        FailureKind.ARM_OFF_GOAL,
    )
)
"""The hand can't get to its goal, or did not: the way there failed, not the grasp."""

waiting_helps: Final = KindCondition(
    "wait until it is back",
    frozenset(
        (
            FailureKind.BUSY,
            FailureKind.NOT_READY,
            FailureKind.NOT_STORED,
            FailureKind.TIMED_OUT,
            FailureKind.SKILL_LOST,
            FailureKind.SKILL_CRASHED,
            FailureKind.HARDWARE_LOST,
            FailureKind.CAMERA_SILENT,
            FailureKind.CAMERA_BLIND,
            FailureKind.LASER_SILENT,
            FailureKind.BASE_HELD,
            FailureKind.ARMS_CROSSING,
            FailureKind.OVERRIDDEN,
        )
    ),
)
"""Would it help to wait until the skill, the sensor or the hardware is back? The cause passes by itself."""
localising_helps: Final = KindCondition("find out where I am", frozenset((FailureKind.NOT_LOCALISED,)))
"""Would it help to find out anew where the robot is?"""
another_way_helps: Final = KindCondition(
    "another way: wait, then other stands",
    frozenset((FailureKind.BASE_NO_PATH, FailureKind.BASE_BLOCKED, FailureKind.BASE_OFF_GOAL)),
)
"""Would it help to take another way or stand? The base's failures in the order-picking paper, III-A.4."""
seeing_helps: Final = KindCondition(
    "look all around, where space is mapped",
    frozenset((FailureKind.BASE_NO_PATH, FailureKind.BASE_BLOCKED)),
)
"""Would it help to see what is in the way? The map of occupied space keeps what no picture shows."""
another_view_helps: Final = KindCondition(
    "look at it from another stand", frozenset((FailureKind.ITEM_HIDDEN,))
)
"""Would it help to look at the item from another stand? Something hides it from this one."""
looking_again_helps: Final = KindCondition("look around again", frozenset((FailureKind.ITEM_GONE,)))
"""Would it help to look around from here? The item is not where it was."""
another_grasp_helps: Final = KindCondition(
    "draw back, grasp another way",
    _ARM_NOT_THERE
    | {
        FailureKind.GRASP_EMPTY,
        FailureKind.GRASP_LOST,
        FailureKind.GRIPPER_STUCK,
        FailureKind.FORCE_MISSING,
    },
)
"""Would it help to draw back and grasp otherwise? The arm's failures in the order-picking paper, III-A.4."""
searching_again_helps: Final = KindCondition(
    "go home and search again",
    another_grasp_helps.kinds
    | {FailureKind.ITEM_GONE, FailureKind.ITEM_HIDDEN, FailureKind.ITEM_UNREACHABLE},
)
"""Would it help to go home and search anew? The recovery of the arm in the order-picking paper, III-A.4."""
another_slot_helps: Final = KindCondition("another slot", frozenset((FailureKind.SLOT_TAKEN,)))
"""Would it help to put the item into another slot?"""
another_stand_helps: Final = KindCondition(
    "with the item in the hand: another stand, then begin from home",
    _ARM_NOT_THERE | {FailureKind.DESTINATION_UNREACHABLE},
)
"""Would it help to hold the item out from somewhere else?"""
fetching_again_helps: Final = KindCondition(
    "lost on the way: fetch it again", frozenset((FailureKind.GRASP_LOST,))
)
"""Would it help to fetch the item from where it fell?"""
trying_again_helps: Final = KindCondition(
    "when letting go: once more",
    _ARM_NOT_THERE | {FailureKind.GRIPPER_STUCK},
)
"""Would it help to do the same once more?"""

STEPS: Final = (
    waiting_helps,
    localising_helps,
    another_way_helps,
    seeing_helps,
    another_view_helps,
    looking_again_helps,
    another_grasp_helps,
    searching_again_helps,
    another_slot_helps,
    another_stand_helps,
    fetching_again_helps,
    trying_again_helps,
)
"""In the order in which they are asked."""

_UNSEEN: Final = frozenset(
    (
        FailureKind.ITEM_NOT_FOUND,
        FailureKind.BASE_NO_PATH,
        FailureKind.BASE_BLOCKED,
        FailureKind.BASE_OFF_GOAL,
        FailureKind.BASE_HELD,
    )
)


def unseen(failure: Failure) -> bool:
    """Say whether a search may go on: the item was not in view, or the base did not get there."""
    return failure.reason.kind in _UNSEEN


def _of(kind: FailureKind) -> str:
    return "; ".join(step.words for step in STEPS if kind in step.kinds)


RECOVERIES: Final[Mapping[FailureKind, str]] = MappingProxyType({kind: _of(kind) for kind in FailureKind})
"""In words; empty where nothing is tried and the task ends, at home."""
