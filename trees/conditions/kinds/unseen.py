"""Was nothing worse the matter than that the item was not in view, or that the base did not get there?"""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind

KINDS: Final = frozenset(
    (
        FailureKind.ITEM_NOT_FOUND,
        FailureKind.BASE_NO_PATH,
        FailureKind.BASE_BLOCKED,
        FailureKind.BASE_OFF_GOAL,
        FailureKind.BASE_HELD,
    )
)


def unseen(failure: Failure) -> bool:
    """Say whether a search may go on."""
    return failure.kind in KINDS
