"""Would it help to look at the item from another stand? Something hides it from this one."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind

KINDS: Final = frozenset((FailureKind.ITEM_HIDDEN,))


def another_view_helps(failure: Failure) -> bool:
    """Say whether the item may be seen from elsewhere."""
    return failure.kind in KINDS
