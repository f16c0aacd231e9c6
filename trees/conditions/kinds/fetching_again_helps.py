"""Would it help to fetch the item from where it fell?"""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind

KINDS: Final = frozenset((FailureKind.GRASP_LOST,))


def fetching_again_helps(failure: Failure) -> bool:
    """Say whether the hand has lost the item."""
    return failure.kind in KINDS
