"""Would it help to do the same once more?"""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind

KINDS: Final = frozenset(
    (
        FailureKind.GRIPPER_STUCK,
        FailureKind.NO_IK,
        FailureKind.NO_PATH,
        FailureKind.PATH_IN_COLLISION,
        FailureKind.ARM_STOPPED,
        FailureKind.ARM_OFF_GOAL,
    )
)


def trying_again_helps(failure: Failure) -> bool:
    """Say whether a gripper or an arm failed that may do it at the next try."""
    return failure.kind in KINDS
