"""Would it help to look around from here? The item is not where it was."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind

KINDS: Final = frozenset((FailureKind.ITEM_GONE,))


def looking_again_helps(failure: Failure) -> bool:
    """Say whether the item has to be found again."""
    return failure.kind in KINDS
