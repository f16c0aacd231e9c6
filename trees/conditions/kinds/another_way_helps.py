"""Would it help to take another way or stand? The base's failures in the order-picking paper, III-A.4."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind

KINDS: Final = frozenset(
    (
        FailureKind.BASE_NO_PATH,
        FailureKind.BASE_BLOCKED,
        FailureKind.BASE_OFF_GOAL,
    )
)


def another_way_helps(failure: Failure) -> bool:
    """Say whether the base failed."""
    return failure.kind in KINDS
