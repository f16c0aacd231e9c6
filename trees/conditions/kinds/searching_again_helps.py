"""Would it help to go home and search anew? The recovery of the arm in the order-picking paper, III-A.4."""

from __future__ import annotations

from typing import Final

from tandem.skills.ports.failure import Failure, FailureKind
from tandem.trees.conditions.kinds import another_grasp_helps

KINDS: Final = another_grasp_helps.KINDS | {
    FailureKind.ITEM_GONE,
    FailureKind.ITEM_HIDDEN,
    FailureKind.ITEM_UNREACHABLE,
}


def searching_again_helps(failure: Failure) -> bool:
    """Say whether the item's pose or the approach may have been wrong."""
    return failure.kind in KINDS
