"""Would it help to put the item into another slot?"""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind

KINDS: Final = frozenset((FailureKind.SLOT_TAKEN,))


def another_slot_helps(failure: Failure) -> bool:
    """Say whether the slot is taken."""
    return failure.kind in KINDS
