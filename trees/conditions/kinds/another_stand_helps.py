"""Would it help to hold the item out from somewhere else?"""

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
        FailureKind.DESTINATION_UNREACHABLE,
    )
)


def another_stand_helps(failure: Failure) -> bool:
    """Say whether the arm failed with the item in the hand."""
    return failure.kind in KINDS
