"""Would it help to draw back and grasp otherwise? The arm's failures in the order-picking paper, III-A.4."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind

KINDS: Final = frozenset(
    (
        FailureKind.NO_IK,
        FailureKind.NO_PATH,
        FailureKind.PATH_IN_COLLISION,
        FailureKind.ARM_STOPPED,
        FailureKind.ARM_OFF_GOAL,
        FailureKind.GRASP_EMPTY,
        FailureKind.GRASP_LOST,
        FailureKind.GRIPPER_STUCK,
        FailureKind.FORCE_MISSING,
    )
)


def another_grasp_helps(failure: Failure) -> bool:
    """Say whether the arm or its gripper failed."""
    return failure.kind in KINDS
